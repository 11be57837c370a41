// Pixel rectangles and bitmaps produce fragments. In every state they do what points of the same colours do
// at the same places (GL 1.3, 3.6.4, 3.7; order of operations: docs/features.md A06).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS && SPANGLE_FEATURE_BITMAPS && SPANGLE_FEATURE_RASTER_POS

#include <random>

#include "gl/vertex/reference.hpp"
#include "tests/gl/pixel/pixel_canvas.hpp"

namespace spangle::gl::test {
namespace {

constexpr std::int32_t width = 48, height = 20;

class State {
  public:
    explicit State(unsigned seed) : random_(seed) {}
    unsigned upto(unsigned n) { return static_cast<unsigned>(random_()) % n; }
    bool maybe() { return upto(2) != 0; }
    float unit() { return static_cast<float>(upto(256)) / 255; }

    /// Returns a window depth that the raster position, a float, holds exactly.
    float depth() { return static_cast<float>(upto(257)) / 128 - 1; }

    void set(GLenum cap) { (maybe() ? glEnable : glDisable)(cap); }

    /// Sets random state of fragments.
    void fragments() {
        constexpr GLenum compare[] = {GL_LESS, GL_LEQUAL, GL_GREATER, GL_ALWAYS, GL_NOTEQUAL, GL_EQUAL};
        constexpr GLenum source[] = {GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA,
                                     GL_DST_ALPHA};
        constexpr GLenum destination[] = {GL_ZERO, GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR};
        constexpr GLenum op[] = {GL_KEEP, GL_REPLACE, GL_INCR, GL_INVERT};
        set(GL_DITHER);
        if (maybe())
            set(GL_BLEND);
        glBlendFunc(source[upto(5)], destination[upto(4)]);
        if (maybe())
            set(GL_ALPHA_TEST);
        glAlphaFunc(compare[upto(6)], unit());
        if (maybe())
            set(GL_DEPTH_TEST);
        glDepthFunc(compare[upto(6)]);
        glDepthMask(maybe() ? GL_TRUE : GL_FALSE);
        if (maybe())
            set(GL_STENCIL_TEST);
        glStencilFunc(compare[upto(6)], static_cast<GLint>(upto(4)), 3);
        glStencilOp(op[upto(4)], op[upto(4)], op[upto(4)]);
        if (upto(4) == 0)
            glColorMask(maybe() ? GL_TRUE : GL_FALSE, GL_TRUE, maybe() ? GL_TRUE : GL_FALSE, GL_TRUE);
        set(GL_SCISSOR_TEST);
        glScissor(static_cast<GLint>(upto(10)), static_cast<GLint>(upto(6)), 30, 12);
    }
    void fog() {
#if SPANGLE_FEATURE_FOG
        if (upto(3) != 0)
            return;
        glEnable(GL_FOG);
        constexpr GLint modes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
        glFogi(GL_FOG_MODE, modes[upto(3)]);
        glFogf(GL_FOG_END, 0.9f);
        const GLfloat color[4] = {unit(), unit(), unit(), 1};
        glFogfv(GL_FOG_COLOR, color);
#endif
    }
    void textures() {
        for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
            if (upto(3) != 0)
                continue;
            glActiveTexture(unit);
            GLubyte texels[8][8][4];
            for (auto& row : texels)
                for (auto& texel : row)
                    for (GLubyte& v : texel)
                        v = static_cast<GLubyte>(upto(256));
            const GLint filter = maybe() ? GL_NEAREST : GL_LINEAR;
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
            glTexImage2D(GL_TEXTURE_2D, 0, maybe() ? GL_RGBA : GL_RGB, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texels);
            constexpr GLint modes[] = {GL_MODULATE, GL_DECAL, GL_REPLACE, GL_ADD, GL_BLEND};
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, modes[upto(5)]);
            glEnable(GL_TEXTURE_2D);
            glMultiTexCoord4f(unit, unit_coord(), unit_coord(), 0, maybe() ? 1.0f : 2.0f);
        }
        glActiveTexture(GL_TEXTURE0);
    }
    float unit_coord() {
        return static_cast<float>(upto(4096)) / 1024.0f - 1;
    }

    std::vector<GLubyte> image() {
        std::vector<GLubyte> v(static_cast<std::size_t>(width * height * 4));
        for (GLubyte& b : v)
            b = static_cast<GLubyte>(upto(256));
        return v;
    }

  private:
    std::mt19937 random_;
};

void background(PixelCanvas& canvas, unsigned seed) {
    std::mt19937 random(seed);
    for (auto& byte : canvas.color)
        byte = static_cast<std::uint8_t>(random());
    for (auto& word : canvas.depth)
        word = static_cast<std::uint32_t>(random()) & 0xC0000003; // some depths are equal
}

CanvasWish wish_of(unsigned i) {
    constexpr PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                       PixelFormat::rgba8888};
    return {.format = formats[i % 4],
            .depth = i % 5 == 0 ? DepthFormat::z16 : DepthFormat::z24s8,
            .tier = static_cast<raster::Tier>(i / 4 % 3),
            .width = width,
            .height = height,
            .top_first = i % 7 < 3};
}

void expect_same(const PixelCanvas& a, const PixelCanvas& b, unsigned i) {
    ASSERT_EQ(a.depth, b.depth) << i;
    std::size_t differ = 0;
    for (std::size_t at = 0; at < a.color.size(); ++at)
        differ += a.color[at] != b.color[at] ? 1u : 0u;
    // A vertex's fog distance comes from the matrix, and the raster position's is a float, so rounding may
    // differ.
    ASSERT_LE(differ, glIsEnabled(GL_FOG) != GL_FALSE ? a.color.size() / 100 : 0) << i;
}

/// Draws the same in two ways, in two contexts.
template <class One, class Other> void compare(unsigned i, One one, Other other) {
    const auto paint = [i](PixelCanvas& canvas, auto draw) {
        background(canvas, i);
        State state(i);
        state.fragments();
        state.fog();
        state.textures();
        draw(state);
    };
    PixelCanvas first(wish_of(i)), second(wish_of(i));
    paint(second, other);
    set_current_context(first.context);
    paint(first, one);
    expect_same(first, second, i);
    set_current_context(second.context);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    set_current_context(first.context);
}

TEST(PixelPipeline, RectanglesArePointsOfTheirColours) {
    for (unsigned i = 0; i < 4000 && !testing::Test::HasFatalFailure(); ++i)
        compare(
            i,
            [](State& state) {
                const float z = state.depth();
                const auto image = state.image();
                glRasterPos3f(0, 0, z);
                glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
            },
            [](State& state) {
                const float z = state.depth();
                const auto image = state.image();
                glBegin(GL_POINTS);
                for (std::size_t p = 0; p < static_cast<std::size_t>(width * height); ++p) {
                    glColor4ubv(&image[4 * p]);
                    glVertex3f(static_cast<float>(p % width) + 0.5f, static_cast<float>(p / width) + 0.5f, z);
                }
                glEnd();
            });
}

TEST(PixelPipeline, BitmapsArePointsOfTheRasterColour) {
    for (unsigned i = 0; i < 2000 && !testing::Test::HasFatalFailure(); ++i)
        compare(
            i,
            [](State& state) {
                const float z = state.depth();
                const auto image = state.image();
                glColor4ubv(image.data());
                glRasterPos3f(0, 0, z);
                glBitmap(width, height, 0, 0, 0, 0, image.data());
            },
            [](State& state) {
                const float z = state.depth();
                const auto image = state.image();
                glColor4ubv(image.data());
                glBegin(GL_POINTS);
                for (std::size_t p = 0; p < static_cast<std::size_t>(width * height); ++p)
                    if ((image[p / width * (width / 8) + p % width / 8] >> (7 - p % 8) & 1) != 0)
                        glVertex3f(static_cast<float>(p % width) + 0.5f, static_cast<float>(p / width) + 0.5f,
                                   z);
                glEnd();
            });
}

/// A rectangle of depths equals points of the raster colour, each at its depth.
TEST(PixelPipeline, DepthRectanglesArePointsOfTheirDepth) {
    for (unsigned i = 0; i < 1000 && !testing::Test::HasFatalFailure(); ++i) {
        std::vector<float> z(width * height);
        std::mt19937 random(i);
        for (float& v : z)
            v = static_cast<float>(random() % 257) / 256;
        compare(
            i,
            [&](State& state) {
                glColor4ubv(state.image().data());
                glRasterPos3f(0, 0, 0.25f);
                glDrawPixels(width, height, GL_DEPTH_COMPONENT, GL_FLOAT, z.data());
            },
            [&](State& state) {
                glColor4ubv(state.image().data());
#if SPANGLE_FEATURE_FOG
                // Fog uses the distance of the raster position, not the drawn depth.
                const GLboolean fog = glIsEnabled(GL_FOG);
                if (fog != GL_FALSE)
                    glTranslatef(0, 0, 0.25f);
#endif
                for (std::size_t p = 0; p < z.size(); ++p) {
                    glDepthRange(z[p], z[p]);
                    glBegin(GL_POINTS);
                    glVertex2f(static_cast<float>(p % width) + 0.5f, static_cast<float>(p / width) + 0.5f);
                    glEnd();
                }
            });
    }
}

/// Engines of reference precision draw the rectangles, too, and the shadow draws the product's picture.
TEST(PixelPipeline, ReferenceAndShadow) {
    for (unsigned i = 0; i < 300 && !testing::Test::HasFatalFailure(); ++i) {
        const auto paint = [i](PixelCanvas& canvas) {
            background(canvas, i);
            State state(i);
            state.fragments();
            state.fog();
            state.textures();
            const auto image = state.image();
            glRasterPos3f(1.25f, 1.25f, 0.5f);
            glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
            glBitmap(width, height, 0, 0, 0, 0, image.data());
        };
        CanvasWish wish = wish_of(i);
        PixelCanvas fixed(wish);
        paint(fixed);
        wish.engine = &shadow_engine;
        {
            PixelCanvas shadow(wish);
            paint(shadow);
            expect_same(fixed, shadow, i);
        }
        if (wish.tier == raster::Tier::exact && i % 4 >= 2) {
            wish.engine = &double_engine;
            PixelCanvas reference(wish);
            paint(reference);
            std::size_t differ = 0;
            for (std::size_t at = 0; at < fixed.color.size(); ++at)
                differ += std::abs(fixed.color[at] - reference.color[at]) > 1 ? 1u : 0u;
            EXPECT_LE(differ, fixed.color.size() / 50) << i; // pixels whose tests give the other result
        }
        set_current_context(fixed.context);
    }
}

} // namespace
} // namespace spangle::gl::test

#endif
