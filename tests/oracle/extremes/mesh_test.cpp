// Tests meshes, slivers, small w and fog at the ends of their ranges.
#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

/// Draws a window of 224 x 224 cells of two triangles at one scale, with moved inner corners.
TEST(Extreme, 31_MeshesOfAllScales) {
    constexpr std::size_t cells = 224;
    long wrong = 0, triangles = 0;
    Random random{31};
    std::vector<GLfloat> places;
    std::vector<GLuint> order;
    for (int power = -5; power <= 5; ++power) {
        const Screen screen(tiers[static_cast<std::size_t>(power + 6) % 3]);
        const double scale = std::pow(10, power);
        places.clear(), order.clear();
        for (std::size_t j = 0; j <= cells; ++j)
            for (std::size_t i = 0; i <= cells; ++i) {
                const auto moved = [&](std::size_t k) {
                    const double inner = k > 0 && k < cells ? (random.below(401) - 200.0) / 1000 : 0;
                    const double at = k == cells ? scale : (static_cast<double>(k) + inner) / cells * scale;
                    places.push_back(static_cast<GLfloat>(at));
                };
                moved(i), moved(j);
            }
        for (std::size_t j = 0; j < cells; ++j)
            for (std::size_t i = 0; i < cells; ++i) {
                const std::size_t at = j * (cells + 1) + i;
                for (const std::size_t corner :
                     {at, at + 1, at + cells + 2, at, at + cells + 2, at + cells + 1})
                    order.push_back(static_cast<GLuint>(corner));
            }
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, scale, 0, scale, -1, 1);
        Screen::count_fragments();
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(2, GL_FLOAT, 0, places.data());
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(order.size()), GL_UNSIGNED_INT, order.data());
        triangles += static_cast<long>(order.size() / 3);
        for (const Rgba& pixel : screen.picture())
            wrong += pixel[0] != 1 ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(triangles, 1'000'000);
    row("10^5 triangles at scales of 10^-5 to 10^5: each pixel once", "counting blend",
        "%ld pixels wrong under %ld triangles", wrong, triangles);
}

TEST(Extreme, 32_ColoursOfSlivers) {
    long outside = 0, fragments = 0;
    Random random{32};
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        screen.pixels_as_coordinates();
        for (const Form form : fractions)
            for (int n = 0; n < 60; ++n) {
                // Slivers go through the centres of a row, a column or a diagonal, and are 1/256 to 1/8 pixel
                // wide.
                const double y = 20.5 + n % 20, width = std::exp2(-static_cast<double>(random.below(6)) - 3);
                const double slope = n % 3 == 0 ? 0 : n % 3 == 1 ? 1 : 0.3;
                std::array<Place, 3> v{{{0.25, y + (0.25 - 0.5) * slope - width / 2, 0, 1},
                                        {0.25, y + (0.25 - 0.5) * slope + width / 2, 0, 1},
                                        {63.75, y + 63.25 * slope, 0, 1}}};
                if (n % 2 == 0)
                    for (Place& place : v)
                        std::swap(place[0], place[1]);
                glClear(GL_COLOR_BUFFER_BIT);
                glBegin(GL_TRIANGLES);
                const int low[3] = {60, 120, 90};
                for (std::size_t i = 0; i < 3; ++i) {
                    glColor3ub(static_cast<GLubyte>(low[i]), 255, static_cast<GLubyte>(200 - low[i]));
                    vertex(form, v[i]);
                }
                glEnd();
                for (const Rgba& pixel : screen.picture())
                    if (pixel[1] != 0) {
                        ++fragments;
                        outside += pixel[0] < 59 || pixel[0] > 121 || pixel[1] < 254 || pixel[2] < 79 ||
                                           pixel[2] > 141
                                       ? 1
                                       : 0;
                    }
            }
    }
    EXPECT_EQ(outside, 0);
    EXPECT_GT(fragments, 3'000);
    row("colours stay within those of the corners", "the corners, one step more",
        "%ld of %ld fragments outside", outside, fragments);
}

TEST(Extreme, 33_WTowardsZero) {
    double worst = 0, most_of_fast = 0;
    long fragments = 0;
    constexpr int texels = 256;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        std::array<GLubyte, texels * 4> image{};
        for (std::size_t i = 0; i < texels; ++i)
            image[4 * i] = static_cast<GLubyte>(i), image[4 * i + 3] = 255;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, texels, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glEnable(GL_TEXTURE_2D);
        for (int k = 0; k <= 30; k += 2) {
            // The left side of the window has w = 2^-k, the right side has w = 1, and s goes from 0 to 1.
            const double w = std::exp2(-k);
            glClear(GL_COLOR_BUFFER_BIT);
            glBegin(GL_QUADS);
            for (int i = 0; i < 4; ++i) {
                const bool right = i == 1 || i == 2;
                const double of = right ? 1 : w;
                glTexCoord2d(right ? 1 : 0, 0);
                glVertex4d((right ? 1 : -1) * of, (i < 2 ? -1 : 1) * of, 0, of);
            }
            glEnd();
            const Picture picture = screen.picture();
            for (int x = 0; x < side; ++x) {
                const auto denominator = [w](double at) { return (1 - at / side) / w + at / side; };
                const auto texel = [&](double at) {
                    return at / side / denominator(at) * texels;
                }; // GL 1.3, equation 3.4
                const double exact = texel(x + 0.5);
                const int is = picture[static_cast<std::size_t>(20 * side + x)][0];
                ++fragments;
                const double off = std::fmax(0, std::fmax(is - exact, exact - (is + 1)));
                if (tier != EGL_PRECISION_FAST_SPANGLE) {
                    worst = std::fmax(worst, off);
                    continue;
                }
                // The fast tier divides once in 16 pixels. If the w of both ends have the ratio rho, a
                // straight line is off by at most |difference| (sqrt(rho) - 1) / (sqrt(rho) + 1).
                double most = 0;
                for (int from = std::max(x - 16, 0); from <= x; ++from) {
                    const double begin = from + 0.5, end = std::min(from + 16.5, side - 0.5);
                    const double root = std::sqrt(denominator(begin) / denominator(end));
                    most = std::fmax(most, std::fabs(texel(end) - texel(begin)) * (root - 1) / (root + 1));
                }
                most_of_fast = std::fmax(most_of_fast, off / (most + 0.25));
            }
        }
    }
    EXPECT_LE(worst, 0.25);
    EXPECT_LE(most_of_fast, 1);
    EXPECT_GT(fragments, 3'000);
    row("perspective holds for w of 1 to 2^-30",
        "s = t / ((1 - t) / w + t); fast: a straight line through 16 pixels",
        "%.3f texel off at most; fast %.2f of its bound; %ld fragments", worst, most_of_fast, fragments);
}

TEST(Extreme, 34_FogWithoutLength) {
    long wrong = 0, colours = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier, 8);
        glMatrixMode(GL_PROJECTION);
        glOrtho(-1, 1, -1, 1, 0, 100);
        glMatrixMode(GL_MODELVIEW);
        glEnable(GL_FOG);
        const GLfloat fog[] = {0, 1, 0, 1};
        glFogfv(GL_FOG_COLOR, fog);
        const auto drawn = [&](double depth) {
            glColor3f(1, 0, 0);
            rectangle(-1, -1, 1, 1, -depth);
            ++colours;
            return screen.pixel(3, 3);
        };
        glFogi(GL_FOG_MODE, GL_LINEAR);
        for (const Form form : {Form::of_float, Form::of_fixed})
            // If start equals end the result is undefined, so any mixture is right.
            for (const double at : {0.0, 10.0, -5.0}) {
                if (form == Form::of_fixed) {
                    glFogxOES(GL_FOG_START, fixed(at));
                    glFogxOES(GL_FOG_END, fixed(at));
                } else {
                    glFogf(GL_FOG_START, static_cast<float>(at));
                    glFogf(GL_FOG_END, static_cast<float>(at));
                }
                for (const double depth : {0.0, 9.0, 10.0, 11.0, 99.0}) {
                    const Rgba is = drawn(depth);
                    wrong += std::abs(is[0] + is[1] - 255) > 1 || is[2] != 0 ? 1 : 0;
                }
            }
        // Other ranges, also reversed ones, give f = (e - z) / (e - s), clamped.
        for (const auto& range : {std::array<double, 2>{10, 20}, {20, 10}, {0, 1e-3}, {-1e6, 1e6}}) {
            glFogf(GL_FOG_START, static_cast<float>(range[0]));
            glFogf(GL_FOG_END, static_cast<float>(range[1]));
            for (const double depth : {0.0, 5.0, 12.5, 15.0, 19.0, 30.0}) {
                const double f = std::clamp((range[1] - depth) / (range[1] - range[0]), 0.0, 1.0);
                const Rgba is = drawn(depth);
                wrong += std::fabs(is[0] - 255 * f) > 1.5 || std::fabs(is[1] - 255 * (1 - f)) > 1.5 ? 1 : 0;
            }
        }
        for (const GLenum mode : {GL_EXP, GL_EXP2})
            for (const float density : {0.F, 1e-6F, 1.F, 1e6F}) {
                glFogi(GL_FOG_MODE, static_cast<GLint>(mode));
                glFogf(GL_FOG_DENSITY, density);
                for (const double depth : {0.0, 0.5, 2.0, 90.0}) {
                    const double power = double{density} * depth,
                                 f = std::exp(mode == GL_EXP ? -power : -power * power);
                    const Rgba is = drawn(depth);
                    wrong +=
                        std::fabs(is[0] - 255 * f) > 1.5 || std::fabs(is[1] - 255 * (1 - f)) > 1.5 ? 1 : 0;
                }
            }
        glFogf(GL_FOG_DENSITY, -1);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    }
    EXPECT_EQ(wrong, 0);
    row("start = end leaves some mixture; all else follows 3.10", "the formulas of fog",
        "%ld of %ld colours wrong", wrong, colours);
}

} // namespace
} // namespace spangle::test
