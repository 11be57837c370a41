// A display list keeps the image as it was when the list was compiled, whatever the client later does with
// memory and pixel storage. Transfer and zoom are those of the time when the image is drawn (GL 1.3, 3.6.1
// and 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS && SPANGLE_FEATURE_BITMAPS && SPANGLE_FEATURE_LISTS

#include "tests/gl/pixel/client_oracle.hpp"
#include "tests/gl/pixel/pixel_canvas.hpp"

namespace spangle::gl::test {
namespace {

struct Kind {
    GLenum format, type;
};
constexpr Kind kinds[] = {{GL_RGBA, GL_UNSIGNED_BYTE},          {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
                          {GL_BGR, GL_UNSIGNED_BYTE},           {GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT},
                          {GL_COLOR_INDEX, GL_BITMAP},          {GL_STENCIL_INDEX, GL_BITMAP},
                          {GL_COLOR_INDEX, GL_UNSIGNED_BYTE},   {GL_STENCIL_INDEX, GL_INT},
                          {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT}};

/// Draws an image at once or from a list. Later changes by the client must not matter.
template <class Draw> void compare(unsigned seed, GLenum format, GLenum type, Draw draw) {
    std::mt19937 random(seed);
    const int width = 1 + static_cast<int>(random() % 20), height = 1 + static_cast<int>(random() % 8);
    const Store store = Store::random(random, width);
    const ClientOracle oracle(format, type, width, height, store);
    std::vector<unsigned char> memory(oracle.bytes());
    for (auto& byte : memory)
        byte = static_cast<unsigned char>(random());
    const auto prepare = [&] {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glRasterPos2i(3, 2);
#if SPANGLE_FEATURE_PIXEL_TRANSFER
        const GLfloat map[4] = {0, 0.25f, 0.75f, 1};
        for (GLenum name :
             {GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_A})
            glPixelMapfv(name, 4, map);
        glPixelTransferf(GL_RED_SCALE, 0.5f);
#endif
    };
    PixelCanvas at_once, listed;
    glNewList(1, GL_COMPILE);
    store.apply();
    draw(width, height, memory.data());
    glEndList();
    const std::vector<unsigned char> kept = memory;
    std::fill(memory.begin(), memory.end(), static_cast<unsigned char>(0));
    Store().apply();
    prepare();
    glCallList(1);
    GLint alignment = 0;
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
    EXPECT_EQ(alignment, 1);
    set_current_context(at_once.context);
    prepare();
    store.apply();
    draw(width, height, kept.data());
    EXPECT_EQ(at_once.color, listed.color) << std::hex << format << ' ' << type;
    EXPECT_EQ(at_once.depth, listed.depth) << std::hex << format << ' ' << type;
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    set_current_context(listed.context);
}

TEST(PixelLists, ImagesAreKeptAsTheyWere) {
    for (const Kind& kind : kinds)
        for (unsigned seed = 0; seed < 100; ++seed)
            compare(seed, kind.format, kind.type, [&](int width, int height, const void* pixels) {
                glDrawPixels(width, height, kind.format, kind.type, pixels);
            });
}

TEST(PixelLists, BitmapsAreKeptAsTheyWere) {
    for (unsigned seed = 0; seed < 300; ++seed)
        compare(seed, GL_COLOR_INDEX, GL_BITMAP, [](int width, int height, const void* bits) {
            glBitmap(width, height, 0.5f, -1, 2, 3, static_cast<const GLubyte*>(bits));
            glBitmap(width, height, 0, 0, 0, 0, static_cast<const GLubyte*>(bits));
            glBitmap(0, 0, 0, 0, 1, 1, nullptr);
            glCopyPixels(0, 0, 9, 9, GL_COLOR);
        });
}

TEST(PixelLists, ErrorsComeWhenTheListIsCalled) {
    PixelCanvas canvas;
    const GLubyte bytes[4] = {};
    struct Case {
        GLsizei width;
        GLenum format, type;
        GLenum code;
    };
    for (const Case& c :
         {Case{-1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE}, Case{1, GL_RGBA, GL_BITMAP, GL_INVALID_ENUM},
          Case{1, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2, GL_INVALID_OPERATION}}) {
        glNewList(1, GL_COMPILE);
        glDrawPixels(c.width, 1, c.format, c.type, bytes);
        glEndList();
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        glCallList(1);
        EXPECT_EQ(glGetError(), c.code);
    }
    glNewList(1, GL_COMPILE);
    glDrawPixels(INT32_MAX, INT32_MAX, GL_RGBA, GL_FLOAT, bytes); // needs more memory than there is
    glEndList();
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    glNewList(1, GL_COMPILE);
    glBitmap(1, 1, 0, 0, 5, 0, bytes);
    glEndList();
    glBegin(GL_POINTS);
    glCallList(1);
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

} // namespace
} // namespace spangle::gl::test

#endif
