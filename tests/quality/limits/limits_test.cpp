// Tests what a build reports about its limits, and that lower limits change no picture. The same tests run in
// a build whose limits are as low as on a board with 8 KB of memory (CMakeLists.txt).
#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/format.hpp>
#include <spangle/native.hpp>

#include "gl/context/context.hpp"
#include "gl/context/limits.hpp"
#include "tests/support/headless_gl.hpp"
#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

constexpr int width = 96, height = 16;

/// Draws on the mono pixels of small OLEDs, a format that every one of these builds has.
struct Limits : ::testing::Test {
    HeadlessGl gl{width,
                  height,
                  {EGL_ALPHA_SIZE, 0, EGL_DEPTH_SIZE, 0, EGL_BUFFER_SIZE, 1, EGL_PRECISION_SPANGLE,
                   EGL_PRECISION_EXACT_SPANGLE, EGL_CONFIG_ID, mono_config()}};

    static EGLint mono_config() { return config_of(PixelFormat::mono); }
    /// Returns the id of the config of this format.
    static EGLint config_of(PixelFormat format) {
        const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        eglInitialize(display, nullptr, nullptr);
        std::vector<EGLConfig> configs(256);
        EGLint count = 0;
        eglGetConfigs(display, configs.data(), 256, &count);
        for (EGLint i = 0; i < count; ++i) {
            EGLint visual = 0, depth = 0, precision = 0, id = 0;
            eglGetConfigAttrib(display, configs[static_cast<std::size_t>(i)], EGL_NATIVE_VISUAL_ID, &visual);
            eglGetConfigAttrib(display, configs[static_cast<std::size_t>(i)], EGL_DEPTH_SIZE, &depth);
            eglGetConfigAttrib(display, configs[static_cast<std::size_t>(i)], EGL_PRECISION_SPANGLE,
                               &precision);
            eglGetConfigAttrib(display, configs[static_cast<std::size_t>(i)], EGL_CONFIG_ID, &id);
            if (visual == static_cast<EGLint>(format) && depth == 0 &&
                precision == EGL_PRECISION_EXACT_SPANGLE)
                return id;
        }
        return 0;
    }

    static GLint get(GLenum name) {
        GLint value = -1;
        glGetIntegerv(name, &value);
        return value;
    }

    /// Returns how many entries can be pushed until a stack overflows.
    static int pushes(GLenum mode) {
        glMatrixMode(mode);
        int entries = 1;
        while (entries < 100) {
            glPushMatrix();
            if (glGetError() != GL_NO_ERROR)
                break;
            ++entries;
        }
        for (int i = 1; i < entries; ++i)
            glPopMatrix();
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return entries;
    }

    /// FNV-1a of the picture's bytes.
    static std::uint32_t hash() {
        const raster::Surface& surface = gl::current_context()->drawable.surface;
        std::uint32_t h = 2166136261u;
        for (int y = 0; y < height; y += 8)
            for (int x = 0; x < width; ++x)
                h = (h ^ surface.color_row(y)[x]) * 16777619u;
        return h;
    }

    static void view() {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-0.6, 0.6, -0.1, 0.1, 0.5, 8.0);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glClear(GL_COLOR_BUFFER_BIT);
    }
};

TEST_F(Limits, QueriesSayThem) {
    EXPECT_EQ(get(GL_MAX_MODELVIEW_STACK_DEPTH), gl::modelview_stack_entries);
    EXPECT_EQ(get(GL_MAX_PROJECTION_STACK_DEPTH), gl::projection_stack_entries);
    EXPECT_EQ(get(GL_MAX_TEXTURE_STACK_DEPTH), gl::texture_stack_entries);
    EXPECT_EQ(get(GL_MAX_TEXTURE_UNITS), SPANGLE_TEXTURE_UNITS);
    EXPECT_EQ(get(GL_MAX_TEXTURE_SIZE), 1 << (SPANGLE_TEXTURE_LEVELS - 1));
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
#if SPANGLE_FEATURE_LIGHTING
    EXPECT_EQ(get(GL_MAX_LIGHTS), static_cast<GLint>(gl::max_lights));
#endif
}

/// The default display counts as one of the displays.
TEST_F(Limits, DisplaysAsManyAsItSays) {
    static FakeDisplay more[gl::most_displays];
    for (int i = 0; i < gl::most_displays; ++i)
        EXPECT_EQ(eglGetDisplay(native(more[i])) != EGL_NO_DISPLAY, i + 1 < gl::most_displays) << i;
}

/// No memory is handed over here. The arena keeps less than a page for itself at its ends.
TEST_F(Limits, AHostHasAsMuchMemoryOfItsOwn) {
    EXPECT_LE(memory_use().capacity, gl::host_memory_bytes);
    EXPECT_GT(memory_use().capacity + 4096, gl::host_memory_bytes);
}

TEST_F(Limits, StacksHoldAsMany) {
    EXPECT_EQ(pushes(GL_MODELVIEW), gl::modelview_stack_entries);
    EXPECT_EQ(pushes(GL_PROJECTION), gl::projection_stack_entries);
    EXPECT_EQ(pushes(GL_TEXTURE), gl::texture_stack_entries);
}

#if SPANGLE_FEATURE_LIGHTING
TEST_F(Limits, LightsBeyondTheLastHaveNoName) {
    for (unsigned i = 0; i < 8; ++i) {
        const GLenum expected = i < gl::max_lights ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_ENUM};
        glEnable(GL_LIGHT0 + i);
        EXPECT_EQ(glGetError(), expected) << i;
        EXPECT_EQ(glIsEnabled(GL_LIGHT0 + i), i < gl::max_lights ? GL_TRUE : GL_FALSE) << i;
        EXPECT_EQ(glGetError(), expected) << i;
        const GLfloat white[4] = {1, 1, 1, 1};
        glLightfv(GL_LIGHT0 + i, GL_DIFFUSE, white);
        EXPECT_EQ(glGetError(), expected) << i;
    }
}
#endif

TEST_F(Limits, TexturesAreAsLargeAndAsManyAsThereAre) {
    glEnable(GL_TEXTURE_2D);
    EXPECT_EQ(glGetError(), raster::has_textures ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_OPERATION});
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(raster::max_texture_units));
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    constexpr GLsizei most = 1 << (SPANGLE_TEXTURE_LEVELS - 1);
    const std::vector<GLubyte> texels(static_cast<std::size_t>(2 * most) * 2);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, most, 1, 0, GL_ALPHA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glTexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, 2 * most, 1, 0, GL_ALPHA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glTexImage2D(GL_TEXTURE_2D, SPANGLE_TEXTURE_LEVELS, GL_ALPHA, 1, 1, 0, GL_ALPHA, GL_UNSIGNED_BYTE,
                 texels.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
}

TEST_F(Limits, ConfigsAreThoseOfTheFormatsAndTiersThereAre) {
    std::vector<EGLConfig> configs(512);
    EGLint count = 0;
    ASSERT_TRUE(eglGetConfigs(eglGetCurrentDisplay(), configs.data(), 512, &count));
    ASSERT_LT(count, 512);
    const int formats = __builtin_popcount(raster::color_formats),
              depths = __builtin_popcount(raster::depth_formats);
    int of_product = 0;
    for (EGLint i = 0; i < count; ++i) {
        EGLint precision = 0, samples = 0;
        const EGLConfig config = configs[static_cast<std::size_t>(i)];
        eglGetConfigAttrib(eglGetCurrentDisplay(), config, EGL_PRECISION_SPANGLE, &precision);
        eglGetConfigAttrib(eglGetCurrentDisplay(), config, EGL_SAMPLE_BUFFERS, &samples);
        of_product += precision <= EGL_PRECISION_FAST_SPANGLE && samples == 0 ? 1 : 0;
    }
    EXPECT_EQ(of_product, formats * depths * __builtin_popcount(raster::tiers));
}

/// A fan is seen from within, so every triangle is clipped by some of near, left, right, bottom and top.
/// Entry points must read their numbers right, whichever way they do it.
TEST_F(Limits, ArgumentsArriveWhole) {
    using Values = std::vector<GLfloat>;
    const auto current = [](GLenum name, std::size_t count) {
        Values values(16);
        glGetFloatv(name, values.data());
        values.resize(count);
        return values;
    };
    glColor4f(.25F, .5F, .75F, .125F);
    EXPECT_EQ(current(GL_CURRENT_COLOR, 4), (Values{.25F, .5F, .75F, .125F}));
    const GLfloat three[] = {.5F, .25F, .125F};
    glColor3fv(three);
    EXPECT_EQ(current(GL_CURRENT_COLOR, 4), (Values{.5F, .25F, .125F, 1}));
    glClearColor(.125F, .25F, .5F, .75F);
    EXPECT_EQ(current(GL_COLOR_CLEAR_VALUE, 4), (Values{.125F, .25F, .5F, .75F}));
    glDepthRange(.25, .5);
    EXPECT_EQ(current(GL_DEPTH_RANGE, 2), (Values{.25F, .5F}));
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 3, -2, 2, 1, 5);
    const Values frustum = {.5F, 0, 0, 0, 0, .5F, 0, 0, .5F, 0, -1.5F, -1, 0, 0, -2.5F, 0};
    EXPECT_EQ(current(GL_PROJECTION_MATRIX, 16), frustum);
    const std::vector<GLdouble> doubles(frustum.begin(), frustum.end());
    glLoadIdentity();
    glLoadMatrixd(doubles.data());
    EXPECT_EQ(current(GL_PROJECTION_MATRIX, 16), frustum);
    glLoadIdentity();
    glLoadMatrixf(frustum.data());
    EXPECT_EQ(current(GL_PROJECTION_MATRIX, 16), frustum);
    glColor3fv(nullptr);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
    glLoadMatrixf(nullptr);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
}

#if SPANGLE_FEATURE_LISTS && SPANGLE_FEATURE_STIPPLE
/// Tests commands that a list records word by word, and commands with an encoder of their own.
TEST_F(Limits, ListsTakeAndRunEachKindOfCommand) {
    using Box = std::array<GLint, 4>;
    const std::array<GLubyte, 128> none{};
    std::array<GLubyte, 128> pattern;
    for (std::size_t i = 0; i < pattern.size(); ++i)
        pattern[i] = static_cast<GLubyte>(5 * i + 1);
    const auto box = [] {
        Box at{};
        glGetIntegerv(GL_SCISSOR_BOX, at.data());
        return at;
    };
    const auto stipple = [] {
        std::array<GLubyte, 128> bits{};
        glGetPolygonStipple(bits.data());
        return bits;
    };
    for (const GLenum mode : {GLenum{GL_COMPILE}, GLenum{GL_COMPILE_AND_EXECUTE}}) {
        glScissor(0, 0, 1, 1);
        glPolygonStipple(none.data());
        glNewList(1, mode);
        glScissor(3, 4, 5, 6);
        glPolygonStipple(pattern.data());
        glEndList();
        const bool ran = mode == GL_COMPILE_AND_EXECUTE;
        EXPECT_EQ(box(), (ran ? Box{3, 4, 5, 6} : Box{0, 0, 1, 1}));
        EXPECT_EQ(stipple(), ran ? pattern : none);
        glScissor(0, 0, 1, 1);
        glPolygonStipple(none.data());
        glCallList(1);
        EXPECT_EQ(box(), (Box{3, 4, 5, 6}));
        EXPECT_EQ(stipple(), pattern);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
    glBegin(GL_POINTS);
    glScissor(0, 0, 1, 1);
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glBegin(GL_POINTS);
    glPolygonStipple(none.data());
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(box(), (Box{3, 4, 5, 6}));
    EXPECT_EQ(stipple(), pattern);
    glDeleteLists(1, 1);
}
#endif

TEST_F(Limits, ClippedPictureIsTheSame) {
    view();
    glBegin(GL_TRIANGLE_FAN);
    for (int i = 0; i < 12; ++i) {
        glColor3f(static_cast<float>(i % 3) * 0.5f, static_cast<float>(i % 2), 0.25f);
        glVertex3f(static_cast<float>(i % 5 - 2) * 9.0f, static_cast<float>(i % 4) - 1.5f,
                   2.0f - static_cast<float>(i));
    }
    glEnd();
    EXPECT_EQ(hash(), 4245182621u);
}

/// Draws a quad that crosses every plane of the guard band, and a quad that crosses itself.
TEST_F(Limits, QuadsThroughEveryPlane) {
    view();
    glShadeModel(GL_FLAT);
    glBegin(GL_QUADS);
    glVertex3f(-60, -0.1f, -0.4f);
    glVertex3f(0, -30, -7);
    glVertex3f(60, 0.1f, -9);
    glVertex3f(0, 30, -0.6f);
    glColor3f(0, 0, 0);
    glVertex3f(-1, -0.1f, -0.4f);
    glVertex3f(1, 0.2f, -2);
    glVertex3f(1, -0.2f, -2);
    glVertex3f(-1, 0.1f, 1);
    glEnd();
    EXPECT_EQ(hash(), 2248777393u);
}

TEST_F(Limits, LinesAndPointsOfArraysAreTheSame) {
    view();
    std::vector<GLfloat> at;
    std::vector<GLubyte> order;
    for (int i = 0; i < 24; ++i) {
        at.insert(at.end(), {static_cast<float>(i * 7 % 11) - 5.0f,
                             static_cast<float>(i * 5 % 7) * 0.3f - 0.9f, -1.0f - static_cast<float>(i % 6)});
        order.push_back(static_cast<GLubyte>(i * 5 % 24));
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, at.data());
    glDrawElements(GL_LINE_STRIP, 24, GL_UNSIGNED_BYTE, order.data());
    glPointSize(3);
    glDrawArrays(GL_POINTS, 3, 9);
    glColor3f(0, 0, 0);
    glDrawElements(GL_TRIANGLE_STRIP, 8, GL_UNSIGNED_BYTE, order.data());
    EXPECT_EQ(hash(), 256275623u);
}

/// Strips of lines go into the view and out of it many times, by elements of any size.
TEST(LimitsOfWords, StripsOfLinesAreTheSame) {
    HeadlessGl gl(width, height,
                  {EGL_ALPHA_SIZE, 0, EGL_DEPTH_SIZE, 0, EGL_BUFFER_SIZE, 16, EGL_PRECISION_SPANGLE,
                   EGL_PRECISION_EXACT_SPANGLE, EGL_CONFIG_ID, Limits::config_of(PixelFormat::rgb565_be)});
    glDisable(GL_DITHER);
    Limits::view();
    std::vector<GLfloat> at;
    std::vector<GLushort> order;
    for (int i = 0; i < 90; ++i) {
        at.insert(at.end(), {static_cast<float>(i * 7 % 31) * 0.1f - 1.5f,
                             static_cast<float>(i * 5 % 17) * 0.03f - 0.24f, -1.0f});
        order.push_back(static_cast<GLushort>(i));
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, at.data());
    glColor3f(1, 0.5f, 0.25f);
    glDrawArrays(GL_LINE_STRIP, 0, 45);
    glColor3f(0.25f, 0.5f, 1);
    glDrawElements(GL_LINE_STRIP, 45, GL_UNSIGNED_SHORT, order.data() + 45);
    // All lines are in the view, so batches are as long as possible.
    glScalef(0.5f, 0.5f, 1);
    glColor3f(0.5f, 1, 0.25f);
    glDrawElements(GL_LINE_STRIP, 90, GL_UNSIGNED_SHORT, order.data());
    std::vector<GLubyte> seen(width * height * 3);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, seen.data());
    std::uint32_t h = 2166136261u;
    for (const GLubyte byte : seen)
        h = (h ^ byte) * 16777619u;
    EXPECT_EQ(h, 948143146u);
}

/// The lines are separate, each with a colour of its own, which shows where each ends and which element it
/// is.
TEST_F(Limits, LinesOfElementsEndAlikeAndHaveTheirColors) {
    view();
    glShadeModel(GL_FLAT);
    std::vector<GLfloat> at;
    std::vector<GLubyte> order, color;
    for (int i = 0; i < 24; ++i) {
        // Ends lie in the middle of pixels, where it shows that the last fragment is not drawn.
        at.insert(at.end(), {static_cast<float>(i) * 0.075f - 1.0875f,
                             static_cast<float>(i * 5 % 7) * 0.05f - 0.1375f, -1.0f});
        color.insert(color.end(), 3, static_cast<GLubyte>(i * 97 % 256));
        order.push_back(static_cast<GLubyte>(i * 5 % 24));
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, at.data());
    glColorPointer(3, GL_UNSIGNED_BYTE, 0, color.data());
    glDrawElements(GL_LINES, 24, GL_UNSIGNED_BYTE, order.data());
    EXPECT_EQ(hash(), 3068046260u);
}

TEST_F(Limits, BlendedAndDitheredPictureIsTheSame) {
    view();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 5; ++i) {
        glRotatef(17, 0, 0, 1);
        glBegin(GL_TRIANGLES);
        glColor4f(1, 1, 1, 0.7f);
        glVertex3f(-4, -1, -3);
        glColor4f(0.2f, 0.2f, 0.2f, 0.3f);
        glVertex3f(4, -1, -5);
        glColor4f(1, 1, 0, 1);
        glVertex3f(0, 1, -7);
        glEnd();
    }
    EXPECT_EQ(hash(), 853212545u);
}

#if !SPANGLE_FEATURE_COLOR_INDEX && !SPANGLE_FEATURE_POLYGON_OFFSET
/// Returns whether names of a system that was left out are refused as known names.
TEST_F(Limits, NamesOfALeftOutSystemAreKnownWhereTheyBelong) {
    GLint value[16] = {};
    void* pointer = nullptr;
    const auto get = [&](GLenum name) {
        glGetIntegerv(name, value);
        return glGetError();
    };
    const auto get_pointer = [&](GLenum name) {
        glGetPointerv(name, &pointer);
        return glGetError();
    };
    const auto enable = [](GLenum name) {
        glEnable(name);
        return glGetError();
    };
    const auto is_enabled = [](GLenum name) {
        EXPECT_FALSE(glIsEnabled(name));
        return glGetError();
    };
    const GLenum known = GL_INVALID_OPERATION, unknown = GL_INVALID_ENUM;
    EXPECT_EQ(get(GL_CURRENT_INDEX), known);
    EXPECT_EQ(get(GL_INDEX_ARRAY), known);
    EXPECT_EQ(get(GL_POLYGON_OFFSET_FILL), known);
    EXPECT_EQ(get(GL_INDEX_ARRAY_POINTER), unknown);
    EXPECT_EQ(get_pointer(GL_INDEX_ARRAY_POINTER), known);
    EXPECT_EQ(get_pointer(GL_CURRENT_INDEX), unknown);
    EXPECT_EQ(is_enabled(GL_INDEX_ARRAY), known);
    EXPECT_EQ(is_enabled(GL_POLYGON_OFFSET_FILL), known);
    EXPECT_EQ(is_enabled(GL_CURRENT_INDEX), unknown);
    EXPECT_EQ(enable(GL_POLYGON_OFFSET_FILL), known);
    EXPECT_EQ(enable(GL_INDEX_ARRAY), known); // client arrays are capabilities, too
    EXPECT_EQ(enable(GL_CURRENT_INDEX), unknown);
    glIndexi(1);
    EXPECT_EQ(glGetError(), known);
}
#endif

} // namespace
} // namespace spangle::test
