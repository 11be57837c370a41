// Tests texture coordinates and levels at the ends of their ranges.
#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

/// Makes a texture of `width` x 1 texels, in which texel i has red i.
void texels(int width) {
    std::vector<GLubyte> image(static_cast<std::size_t>(width) * 4);
    for (std::size_t i = 0; i < image.size(); i += 4) {
        image[i] = static_cast<GLubyte>(i / 4);
        image[i + 3] = 255;
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
}
void filters(GLenum minify, GLenum wrap) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}
/// Draws over the whole window, with the current s, t, r, q.
void window() {
    rectangle(-1, -1, 1, 1);
}

TEST(Extreme, 18_TextureCoordinates) {
    constexpr int width = 256;
    long wrong = 0, pixels = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        texels(width);
        for (const Form form : forms)
            for (const GLenum wrap : {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT})
                for (const double wish : {0.0, 1.0, -1.0, 1000.0, -1000.0, 1024.0, 32767.0, 1e6, -1e-6,
                                          1000.251, -1000.251, 0.501, 0.9999, -0.0001}) {
                    double s = wish;
                    if (form == Form::of_fixed) {
                        s = std::clamp(wish, -32768.0, 32767.0);
                        s = fixed(wish == -1e-6 ? -0x1p-16 : s) / 65536.0;
                        glTexCoord2xOES(fixed(s), 0);
                    } else if (form == Form::of_int) {
                        s = whole(wish);
                        glTexCoord2i(whole(s), 0);
                    } else if (form == Form::of_float) {
                        s = static_cast<float>(wish);
                        glTexCoord2f(static_cast<float>(s), 0);
                    } else {
                        s = static_cast<float>(wish); // the float that is left of it
                        glTexCoord2d(wish, 0);
                    }
                    filters(GL_NEAREST, wrap);
                    glClear(GL_COLOR_BUFFER_BIT);
                    window();
                    // Wrap modes and filters by GL 1.3, 3.8.6 and 3.8.7.
                    double f = s - std::floor(s);
                    if (wrap == GL_MIRRORED_REPEAT && std::fmod(std::floor(s), 2) != 0)
                        f = 1 - f;
                    if (wrap == GL_CLAMP_TO_EDGE)
                        f = s;
                    const int texel = std::clamp(static_cast<int>(std::floor(f * width)), 0, width - 1);
                    for (const Rgba& pixel : screen.picture()) {
                        ++pixels;
                        wrong += pixel[0] != texel ? 1 : 0;
                    }
                }
    }
    EXPECT_EQ(wrong, 0);
    row("floor of s, also of -1e-6, 1 and 10^6", "the texel of the formula", "%ld of %ld pixels wrong", wrong,
        pixels);
}

TEST(Extreme, 19_QAtAndBelowZero) {
    long wrong = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        texels(256);
        filters(GL_NEAREST, GL_REPEAT);
        for (const double q : {0.0, -0.0, -1.0, 1e-38, -1e-38, -32768.0})
            for (const bool mixed : {false, true}) {
                glBegin(GL_TRIANGLES);
                for (int i = 0; i < 3; ++i) {
                    if (i == 1)
                        glTexCoord4xOES(65536 * i, 65536, 0, fixed(q));
                    else
                        glTexCoord4d(i, 1, 0, mixed ? 1 : q);
                    glVertex2i(i == 1 ? 3 : -1, i == 2 ? 3 : -1);
                }
                glEnd();
            }
        // A q above 0 divides the coordinates.
        for (const double q : {2.0, 0x1p-10, 0x1p10}) {
            glTexCoord4d(0.252 * q, 0, 0, q);
            window();
            for (const Rgba& pixel : screen.picture())
                wrong += pixel[0] != 64 ? 1 : 0;
        }
    }
    EXPECT_EQ(wrong, 0);
    row("undefined, no crash; right again afterwards", "s / q afterwards; sanitizers", "%ld pixels wrong",
        wrong);
}

TEST(Extreme, 20_LevelsOfDetail) {
    long wrong = 0, rectangles = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        for (const int width : {1, 2, 64, 256}) {
            int last = 0;
            for (int w = width; w > 0; w /= 2, ++last) {
                const std::vector<GLubyte> image(static_cast<std::size_t>(w) * 4,
                                                 static_cast<GLubyte>(10 + 20 * last));
                glTexImage2D(GL_TEXTURE_2D, last, GL_RGBA, w, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
            }
            --last;
            filters(GL_NEAREST_MIPMAP_NEAREST, GL_REPEAT);
            // rho is the number of texels a pixel. 1.2 times a power of 2 is away from the places where
            // levels change.
            for (int k = -12; k <= 20; ++k) {
                const double rho = k == -12 ? 0 : 1.2 * std::exp2(k), s = rho * side / width;
                glBegin(GL_QUADS);
                for (int i = 0; i < 4; ++i) {
                    const bool right = i == 1 || i == 2;
                    glTexCoord2d(right ? s : 0, 0);
                    glVertex2i(right ? 1 : -1, i < 2 ? -1 : 1);
                }
                glEnd();
                // The level is the one next to log2 rho, and 0 if the texture is magnified (GL 1.3, 3.8.8).
                const double lambda = rho > 0 ? std::log2(rho) : -99;
                const int level =
                    lambda <= 0.5 ? 0 : std::min(last, static_cast<int>(std::ceil(lambda + 0.5)) - 1);
                ++rectangles;
                for (const Rgba& pixel : screen.picture())
                    wrong += pixel[0] != 10 + 20 * level ? 1 : 0;
            }
        }
    }
    EXPECT_EQ(wrong, 0);
    row("rho from 0 to 2^20 takes the levels up to the last, of one texel, too", "log2 of rho",
        "%ld pixels wrong of %ld rectangles", wrong, rectangles);
}

} // namespace
} // namespace spangle::test
