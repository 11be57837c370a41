// Tests recorded frames: pixels that are read and copied within a frame, changed textures, and frames that do
// not fit.
#include <climits>

#include <spangle/message.hpp>
#include <spangle/reference.hpp>

#include "gl/egl/objects.hpp"
#include "tests/system/bands/banded.hpp"
#include "tests/system/bands/programs.hpp"

namespace spangle::test {
namespace {

constexpr EGLint ample = 1 << 20;
constexpr EGLBoolean yes = EGL_TRUE, no = EGL_FALSE;

/// Returns settings of the whole frame, and of records in bands of some heights.
std::vector<Setting> settings(EGLint samples) {
    std::vector<Setting> all = {{.samples = samples}};
    for (const std::int32_t height : {1, 8, 24, 80})
        all.push_back({.display_band = height, .record = ample, .samples = samples});
    return all;
}

using Bytes = std::vector<GLubyte>;

#if SPANGLE_FEATURE_MULTISAMPLE
constexpr EGLint sample_counts[] = {0, 4};
#else
constexpr EGLint sample_counts[] = {0};
#endif

/// `draw` draws frame f and appends what it has read to the bytes. These must be the same in all settings.
void expect_same_reads(const hal::Board& board, const std::function<void(int, Bytes&)>& draw,
                       EGLint samples = 0) {
    Bytes expected;
    std::vector<std::string> shown;
    for (Setting setting : settings(samples)) {
        setting.display_band = setting.display_band == 0
                                   ? 0
                                   : (setting.display_band + hal::band_unit(board.display) - 1) /
                                         hal::band_unit(board.display) * hal::band_unit(board.display);
        Bytes bytes;
        const Program program = {"reads", start_program, [&](int f) { draw(f, bytes); }};
        std::vector<std::string> hashes;
        for (const sim::Image& image : play(board, setting, program, 2))
            hashes.push_back(sim::hash(image));
        if (expected.empty()) {
            expected = bytes;
            shown = hashes;
        }
        EXPECT_FALSE(bytes.empty());
        EXPECT_TRUE(bytes == expected) << "bands of " << setting.display_band;
        EXPECT_EQ(hashes, shown) << "bands of " << setting.display_band;
    }
}

void read(Bytes& to, GLint x, GLint y, GLsizei w, GLsizei h, GLenum format, GLenum type, std::size_t bytes) {
    const std::size_t at = to.size();
    to.resize(at + static_cast<std::size_t>(w * h) * bytes, 0xAA);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, w, h, format, type, to.data() + at);
}

TEST(Records, ReadsInTheMidstOfAFrame) {
    hal::Board pages = boards::ssd1306_128x32;
    pages.display.wire = {};
    pages.display.format = PixelFormat::mono;
    for (const EGLint samples : sample_counts)
        for (const hal::Board& board : {boards::st7735_80x160, pages})
            expect_same_reads(
                board,
                [](int f, Bytes& bytes) {
                    programs()[6].draw(f); // the program with stencil values
                    read(bytes, 0, 0, 120, 30, GL_RGB, GL_UNSIGNED_BYTE, 3);
                    read(bytes, 13, 7, 50, 20, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4);
                    read(bytes, -3, -5, 60, 31, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1);
                    programs()[7].draw(f); // the program with blending
                    read(bytes, 5, 3, 100, 28, GL_RGBA, GL_UNSIGNED_BYTE, 4);
                    glClear(GL_DEPTH_BUFFER_BIT);
                    read(bytes, 5, 3, 10, 10, GL_DEPTH_COMPONENT, GL_FLOAT, 4);
                    programs()[1].draw(f + 1);
                },
                samples);
}

TEST(Records, CopiesInTheMidstOfAFrame) {
    hal::Board pages = boards::ssd1306_128x32;
    pages.display.wire = {};
    pages.display.format = PixelFormat::mono;
    for (const EGLint samples : sample_counts)
        for (const hal::Board& board : {boards::st7735_80x160, pages})
            expect_same_reads(
                board,
                [](int f, Bytes& bytes) {
                    programs()[6].draw(f);
                    glRasterPos2f(7.F, 5.F);
                    glCopyPixels(0, 0, 60, 20, GL_COLOR); // the copy overlaps its source
                    glPixelZoom(1.5F, -1.F);
                    glRasterPos2f(40.F, 29.F);
                    glCopyPixels(10, 2, 30, 25, GL_COLOR);
                    glPixelZoom(1.F, 1.F);
                    glRasterPos2f(3.F, 9.F);
                    glCopyPixels(20, 0, 40, 18, GL_STENCIL);
                    glEnable(GL_DEPTH_TEST);
                    glDepthFunc(GL_ALWAYS);
                    glCopyPixels(20, 0, 40, 18, GL_DEPTH);
                    glDepthFunc(GL_LESS);
                    glDisable(GL_DEPTH_TEST);
                    read(bytes, 0, 0, 120, 31, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1);
                    read(bytes, 0, 0, 120, 31, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2);
                    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
                },
                samples);
}

void textured_square(float x, float y) {
    glEnable(GL_TEXTURE_2D);
    glColor3f(1.F, 1.F, 1.F);
    glBegin(GL_TRIANGLE_FAN);
    for (const auto& [s, t] : {std::pair{0.F, 0.F}, {1.F, 0.F}, {1.F, 1.F}, {0.F, 1.F}}) {
        glTexCoord2f(s, t);
        glVertex2f(x + 31.F * s, y + 27.F * t);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
}

/// Returns 16 x 16 texels of one colour.
Bytes texels(GLubyte red, GLubyte green) {
    Bytes bytes;
    for (int i = 0; i < 256; ++i)
        bytes.insert(bytes.end(), {red, green, static_cast<GLubyte>(i)});
    return bytes;
}

/// Each change of a texture comes after a draw with it, and before the next draw with it.
TEST(Records, TexturesAreAsTheyWereWhenTheyWereDrawn) {
    expect_same_reads(boards::st7735_80x160, [](int f, Bytes& bytes) {
        glClearColor(0.F, 0.F, 0.F, 1.F);
        glClear(GL_COLOR_BUFFER_BIT);
        GLuint names[2];
        glGenTextures(2, names);
        glBindTexture(GL_TEXTURE_2D, names[0]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels(255, 0).data());
        textured_square(1.F, 3.F);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 5, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, texels(0, 255).data());
        textured_square(35.F, 13.F);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGB, GL_UNSIGNED_BYTE, texels(9, 99).data());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels(80, 120).data());
        textured_square(70.F, 43.F);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        textured_square(5.F, 48.F);
        glBindTexture(GL_TEXTURE_2D, names[1]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 10, 10, 16, 16, 0);
        textured_square(105.F, 5.F);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 3, 36, 14, 9, 9);
        textured_square(125.F, 40.F);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
        glGenerateMipmap(GL_TEXTURE_2D);
        textured_square(60.F, 5.F);
        glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 9, 9, GL_RGB, GL_UNSIGNED_BYTE, texels(200, 200).data());
        textured_square(90.F, 45.F);
        glDeleteTextures(2, names);
        read(bytes, 0, 0, 160, 80, GL_RGB, GL_UNSIGNED_BYTE, 3);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << f;
    });
}

TEST(Records, QueriesCountWhatWholeFramesCount) {
    expect_same_reads(boards::st7735_80x160, [](int f, Bytes& bytes) {
        GLuint names[3];
        glGenQueries(3, names);
        const auto count = [&](GLuint name, const std::function<void()>& draw) {
            glBeginQuery(GL_SAMPLES_PASSED, name);
            draw();
            glEndQuery(GL_SAMPLES_PASSED);
            GLuint passed = 0;
            glGetQueryObjectuiv(name, GL_QUERY_RESULT, &passed);
            for (int i = 0; i < 4; ++i)
                bytes.push_back(static_cast<GLubyte>(passed >> 8 * i));
        };
        programs()[1].draw(f);
        glEnable(GL_DEPTH_TEST);
        count(names[0], [] { glRectf(10.F, 10.F, 90.F, 70.F); });
        count(names[1], [] {
            glBegin(GL_TRIANGLES);
            glVertex3f(0.F, 0.F, 1.F);
            glVertex3f(150.F, 10.F, -1.F);
            glVertex3f(50.F, 75.F, 0.F);
            glEnd();
        });
        read(bytes, 0, 0, 4, 4, GL_RGB, GL_UNSIGNED_BYTE, 3);
        glDepthFunc(GL_EQUAL);
        count(names[2], [] { glRectf(0.F, 0.F, 160.F, 80.F); });
        glDepthFunc(GL_LESS);
        glDisable(GL_DEPTH_TEST);
        glDeleteQueries(3, names);
    });
}

int errors = 0;
void count_errors(unsigned code, const char*) {
    errors += code == GL_OUT_OF_MEMORY ? 1 : 0;
}

/// The primitive that does not fit raises GL_OUT_OF_MEMORY once. That frame is not shown, and the next one
/// is.
TEST(Records, AFrameThatDoesNotFitIsNotShown) {
    const Program small = program_of(scenes::two_triangles), large = programs()[0];
    Banded window(boards::st7735_80x160, {.display_band = 16, .record = 6000});
    window.set_up(small);
    const std::string good = sim::hash(window.show(small, 0));
    errors = 0;
    on_message(count_errors);
    large.setup(160, 80);
    large.draw(1);
    EXPECT_EQ(errors, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    GLubyte pixel = 77;
    glReadPixels(0, 0, 1, 1, GL_RED, GL_UNSIGNED_BYTE, &pixel); // the value is undefined
    EXPECT_EQ(pixel, 77);
    const std::uint64_t sent = window.sim.counters().pixel_bytes;
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
    on_message(nullptr);
    EXPECT_EQ(window.sim.counters().pixel_bytes, sent);
    EXPECT_EQ(sim::hash(window.sim.memory()), good);
    window.set_up(small);
    EXPECT_EQ(sim::hash(window.show(small, 0)), good);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// spangle::frame draws a frame that does not fit by callback, and other frames in one call.
TEST(Records, AFrameThatDoesNotFitIsDrawnByCallback) {
    const Program small = program_of(scenes::two_triangles), large = programs()[0];
    const std::vector<sim::Image> whole = play(boards::st7735_80x160, {}, large, 2);
    Banded window(boards::st7735_80x160, {.display_band = 16, .record = 6000});
    window.records = false; // Banded::show calls spangle::frame
    window.set_up(large);
    for (int f = 0; f < 2; ++f) {
        window.draws = 0;
        EXPECT_EQ(sim::hash(window.show(large, f)), sim::hash(whole[static_cast<std::size_t>(f)]));
        EXPECT_EQ(window.draws, 1 + 5);
        window.draws = 0;
        (void)window.show(small, f);
        EXPECT_EQ(window.draws, 1);
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// However small the record is, a frame is shown whole or not at all.
TEST(Records, EverySizeShowsAllOrNothing) {
    const Program program = programs()[2]; // the program with stipples
    const std::string whole = sim::hash(play(boards::st7735_80x160, {}, program, 1)[0]);
    int shown = 0, refused = 0;
    for (EGLint bytes = 8; bytes < 60000; bytes += bytes / 7 + 8) {
        Banded window(boards::st7735_80x160, {.display_band = 16, .record = bytes});
        const std::string black = sim::hash(window.sim.memory());
        window.set_up(program);
        program.draw(0);
        const bool good = eglSwapBuffers(window.display, window.surface) != no;
        ASSERT_TRUE(window.sim.display().finish().ok());
        EXPECT_EQ(sim::hash(window.sim.memory()), good ? whole : black) << bytes;
        ++(good ? shown : refused);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(good ? GL_NO_ERROR : GL_OUT_OF_MEMORY)) << bytes;
    }
    EXPECT_GT(shown, 3);
    EXPECT_GT(refused, 20);
}

/// There is no memory to copy a texture that was drawn with, so the change is refused.
TEST(Records, ATextureThatCannotBeCopiedStays) {
    const std::vector<sim::Image> expected = [] {
        const Program program = {"square", start_program, [](int) {
                                     glClear(GL_COLOR_BUFFER_BIT);
                                     glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
                                     glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB,
                                                  GL_UNSIGNED_BYTE, texels(255, 0).data());
                                     textured_square(1.F, 3.F);
                                     textured_square(50.F, 40.F);
                                 }};
        return play(boards::st7735_80x160, {}, program, 1);
    }();
    Banded window(boards::st7735_80x160, {.display_band = 16, .record = ample});
    start_program(160, 80);
    glClear(GL_COLOR_BUFFER_BIT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels(255, 0).data());
    textured_square(1.F, 3.F);
    std::vector<void*> blocks; // all blocks of the arena
    for (std::size_t bytes = 1 << 26; bytes >= 8;)
        if (void* const block = egl::arena().allocate(bytes); block != nullptr)
            blocks.push_back(block);
        else
            bytes /= 2;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, GL_RGB, GL_UNSIGNED_BYTE, texels(0, 255).data());
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels(0, 255).data());
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    textured_square(50.F, 40.F);
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), yes);
    ASSERT_TRUE(window.sim.display().finish().ok());
    EXPECT_EQ(sim::hash(window.sim.memory()), sim::hash(expected[0]));
    for (void* const block : blocks)
        egl::arena().free(block);
}

/// Copies of textures are freed with the frame.
TEST(Records, WhatAFrameHeldIsGivenBack) {
    Banded window(boards::st7735_80x160, {.display_band = 16, .record = ample});
    start_program(160, 80);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    std::size_t used = 0;
    for (int f = 0; f < 3; ++f) {
        for (GLubyte i = 0; i < 5; ++i) {
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels(i, 0).data());
            textured_square(1.F, 3.F);
        }
        EXPECT_GT(memory_use().used, used + 4 * 16 * 16 * 2);
        EXPECT_EQ(eglSwapBuffers(window.display, window.surface), yes);
        EXPECT_TRUE(used == 0 || memory_use().used == used) << f;
        used = memory_use().used;
    }
}

/// A frame continues when its context becomes current again. Objects of other contexts do not matter.
TEST(Records, ContextsComeAndGo) {
    const Program program = programs()[7]; // the program with a texture and many states
    const std::string whole = sim::hash(play(boards::st7735_80x160, {}, program, 1)[0]);
    Banded window(boards::st7735_80x160, {.display_band = 16, .record = ample});
    const std::string black = sim::hash(window.sim.memory());
    EGLint id = 0;
    ASSERT_EQ(eglQuerySurface(window.display, window.surface, EGL_CONFIG_ID, &id), yes);
    const EGLint wish[] = {EGL_CONFIG_ID, id, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint n = 0;
    ASSERT_EQ(eglChooseConfig(window.display, wish, &config, 1, &n), yes);
    const EGLContext other = eglCreateContext(window.display, config, EGL_NO_CONTEXT, nullptr);
    const auto none = [&] {
        return eglMakeCurrent(window.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    };
    const auto make = [&](EGLContext context) {
        return eglMakeCurrent(window.display, window.surface, window.surface, context);
    };

    window.set_up(program);
    program.draw(0);
    ASSERT_EQ(none(), yes);
    ASSERT_EQ(make(window.context), yes);
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), yes);
    ASSERT_TRUE(window.sim.display().finish().ok());
    EXPECT_EQ(sim::hash(window.sim.memory()), whole);
    EXPECT_NE(black, whole);

    program.draw(1);
    ASSERT_EQ(make(other), yes);
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), no); // this frame is lost
    EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
    EXPECT_EQ(sim::hash(window.sim.memory()), whole);
    glClearColor(0.F, 0.F, 0.F, 1.F);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), yes);
    ASSERT_TRUE(window.sim.display().finish().ok());
    EXPECT_EQ(sim::hash(window.sim.memory()), black);

    // The context whose textures were drawn with is destroyed before the frame is shown.
    ASSERT_EQ(make(window.context), yes);
    program.draw(0);
    ASSERT_EQ(none(), yes);
    ASSERT_EQ(eglDestroyContext(window.display, window.context), yes);
    ASSERT_EQ(make(other), yes);
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), no);
    program.draw(0);
    ASSERT_EQ(none(), yes);
}

TEST(Records, MemoryIsGivenBack) {
    const std::size_t before = memory_use().used;
    for (int i = 0; i < 2; ++i) {
        Banded window(boards::st7735_80x160, {.display_band = 16, .record = 5000});
        EGLint bytes = 0;
        EXPECT_EQ(eglQuerySurface(window.display, window.surface, EGL_BAND_RECORD_SPANGLE, &bytes), yes);
        EXPECT_EQ(bytes, 5000);
        window.set_up(programs()[7]);
        programs()[7].draw(0); // this frame is not shown
    }
    EXPECT_EQ(memory_use().used, before);
}

TEST(Records, WishesThatCannotBe) {
    use_reference_engines();
    hal::Board board = boards::st7735_80x160;
    board.display.band = 16;
    sim::SimBoard sim(board), whole(boards::st7735_80x160);
    const struct {
        sim::SimBoard& board;
        EGLint bytes, error;
    } cases[] = {{sim, -1, EGL_BAD_PARAMETER}, {sim, INT_MAX, EGL_BAD_ALLOC}, {whole, 1000, EGL_BAD_MATCH}};
    for (const auto& c : cases) {
        const EGLDisplay display = eglGetDisplay(native(c.board.display()));
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
        const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        ASSERT_EQ(eglChooseConfig(display, wish, &config, 1, &count), yes);
        const EGLint list[] = {EGL_BAND_RECORD_SPANGLE, c.bytes, EGL_NONE};
        EXPECT_EQ(eglCreateWindowSurface(display, config, 0, list), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), c.error);
        eglTerminate(display);
    }

    const EGLDisplay display = eglGetDisplay(native(sim.display()));
    ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
    for (const EGLint precision : {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_DOUBLE_SPANGLE}) {
        const EGLint wish[] = {EGL_RENDERABLE_TYPE,   EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_WINDOW_BIT,
                               EGL_PRECISION_SPANGLE, precision,      EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        ASSERT_EQ(eglChooseConfig(display, wish, &config, 1, &count), yes);
        const EGLint list[] = {EGL_BAND_RECORD_SPANGLE, 4000, EGL_NONE};
        const EGLint size[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
        const EGLSurface window = eglCreateWindowSurface(display, config, 0, list);
        const EGLSurface picture = eglCreatePbufferSurface(display, config, size);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        const bool fixed = precision == EGL_PRECISION_EXACT_SPANGLE;
        EXPECT_EQ(eglMakeCurrent(display, window, window, context), fixed ? yes : no);
        EXPECT_EQ(eglGetError(), fixed ? EGL_SUCCESS : EGL_BAD_MATCH);
        EXPECT_EQ(eglMakeCurrent(display, window, picture, context), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
        EXPECT_EQ(eglMakeCurrent(display, picture, window, context), no);
        EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
        eglDestroySurface(display, window);
    }
    eglTerminate(display);
}

/// A transfer fails within a frame: eglSwapBuffers reports it, and the next frame sends the pixels again.
TEST(Records, TransfersThatFail) {
    const Program program = program_of(scenes::hud);
    Banded window(boards::st7735_80x160, {.display_band = 16, .record = ample});
    window.set_up(program);
    const std::string good = sim::hash(window.show(program, 0));
    program.draw(1);
    window.sim.fail_next(hal::Fault::short_write);
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(sim::hash(window.show(program, 0)), good);
}

/// A record holds the vertices of a strip once, and equal states once, however often they are used.
TEST(Records, VerticesAreSharedAndStatesStoredOnce) {
    const auto fits = [](EGLint bytes, const std::function<void()>& draw) {
        Banded window(boards::st7735_80x160, {.display_band = 16, .record = bytes});
        start_program(160, 80);
        draw();
        const bool whole = glGetError() == GL_NO_ERROR;
        (void)eglSwapBuffers(window.display, window.surface);
        return whole;
    };
    const auto least = [&](const std::function<void()>& draw) {
        EGLint bytes = 256;
        while (!fits(bytes, draw))
            bytes += 64;
        return bytes;
    };
    const auto strip = [](int n) {
        return [n] {
            glBegin(GL_TRIANGLE_STRIP);
            for (int i = 0; i < n + 2; ++i)
                glVertex2f(static_cast<float>(i) * 1.25F, static_cast<float>(i % 2) * 70.F);
            glEnd();
        };
    };
    // Each triangle adds one vertex: position, 1 / w, exponents and colour take 32 bytes, and the rest that
    // snapping removed takes 4 in the exact tier. The triangle itself takes 16, and the sum is rounded up to
    // 8.
    const EGLint each = (least(strip(112)) - least(strip(16))) / 96;
    EXPECT_LE(each, (32 + 4 + 16 + 7) / 8 * 8 + 2);
    EXPECT_GE(each, 16);
    const auto states = [](int n) {
        return [n] {
            for (int i = 0; i < n; ++i) {
                (i % 2 == 0 ? glEnable : glDisable)(GL_BLEND);
                glRectf(0.F, 0.F, 9.F, 9.F);
            }
        };
    };
    EXPECT_LE((least(states(22)) - least(states(2))) / 20, 300); // far less than the size of a state
}

/// Two polygon stipples are used in one frame.
TEST(Records, StipplesChange) {
    expect_same_reads(boards::st7735_80x160, [](int, Bytes& bytes) {
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_POLYGON_STIPPLE);
        for (const GLubyte pattern : {GLubyte{0x5A}, GLubyte{0xF0}}) {
            glPolygonStipple(Bytes(128, pattern).data());
            glRectf(pattern == 0x5A ? 3.F : 80.F, 5.F, pattern == 0x5A ? 70.F : 150.F, 66.F);
        }
        glDisable(GL_POLYGON_STIPPLE);
        read(bytes, 0, 0, 160, 80, GL_RGB, GL_UNSIGNED_BYTE, 3);
    });
}

/// What is replayed for a read within a frame is not sent, and the panel is not sent again what it shows.
TEST(Records, ReadsCostTheBusNothing) {
    const Program still = {"still", start_program, [](int f) {
                               glClearColor(0.F, 0.F, 0.F, 1.F);
                               glClear(GL_COLOR_BUFFER_BIT);
                               glRectf(10.F, 10.F, 20.F, 20.F);
                               Bytes bytes;
                               if (f > 0)
                                   read(bytes, 0, 0, 160, 80, GL_RGB, GL_UNSIGNED_BYTE, 3);
                           }};
    Banded window(boards::st7735_80x160, {.display_band = 16, .record = ample});
    window.set_up(still);
    (void)window.show(still, 0);
    const std::uint64_t before = window.sim.counters().pixel_bytes;
    (void)window.show(still, 1);
    EXPECT_EQ(window.sim.counters().pixel_bytes - before, 10U * 10 * 2);
}

} // namespace
} // namespace spangle::test
