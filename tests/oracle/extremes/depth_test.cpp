// Tests depth at the ends of its range, in 16 and in 24 bits.
#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

constexpr double all_ones = 4294967295.0;

TEST(Extreme, 14_DepthRanges) {
    double worst = 0;
    long wrong = 0;
    for (const EGLint tier : tiers)
        for (const EGLint bits : {16, 24}) {
            const Screen screen(tier, side, bits);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            for (const Form form : fractions)
                for (const auto& range :
                     {std::array<double, 2>{0, 1}, {1, 0}, {0.5, 0.5}, {-5, 7}, {9, -9}, {0.25, 0.75}}) {
                    if (form == Form::of_fixed)
                        glDepthRangexOES(fixed(range[0]), fixed(range[1]));
                    else if (form == Form::of_float)
                        glDepthRangef(static_cast<float>(range[0]), static_cast<float>(range[1]));
                    else
                        glDepthRange(range[0], range[1]);
                    const double n = std::clamp(range[0], 0.0, 1.0), f = std::clamp(range[1], 0.0, 1.0);
                    for (const double z : {-1.0, -0.5, 0.0, 0.75, 1.0}) {
                        polygon(form, GL_QUADS,
                                std::array<Place, 4>{
                                    {{-1, -1, z, 1}, {1, -1, z, 1}, {1, 1, z, 1}, {-1, 1, z, 1}}});
                        const double exact = n + (f - n) * (z + 1) / 2;
                        for (const GLuint depth : screen.depths()) {
                            const double off = std::fabs(depth / all_ones - exact) * (std::exp2(bits) - 1);
                            worst = std::fmax(worst, off);
                            // Both ends of the range have exact codes.
                            const GLuint end = exact == 0 ? 0 : 0xFFFFFFFF;
                            wrong += (exact == 0 || exact == 1) && depth != end ? 1 : 0;
                        }
                    }
                }
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(worst, 1);
    row("turned, empty and clamped ranges; the ends are 0 and all ones", "n + (f - n)(z + 1) / 2",
        "%.2f codes off at most, %ld ends wrong", worst, wrong);
}

TEST(Extreme, 15_FarOverNear) {
    double worst = 0;
    long wrong = 0, planes = 0;
    for (const EGLint tier : tiers)
        for (const EGLint bits : {16, 24}) {
            const Screen screen(tier, side, bits);
            glMatrixMode(GL_PROJECTION);
            const double n = 1.0 / 16, f = n * 1e6;
            glFrustum(-n, n, -n, n, n, f);
            glMatrixMode(GL_MODELVIEW);
            glEnable(GL_DEPTH_TEST);
            GLuint before = 0;
            for (double z = n * 1.001; z < f; z *= 1.25, ++planes) {
                const std::array<Place, 4> v{
                    {{-z, -z, -z, 1}, {z, -z, -z, 1}, {z, z, -z, 1}, {-z, z, -z, 1}}};
                glDepthFunc(GL_ALWAYS);
                glDisable(GL_BLEND);
                polygon(Form::of_float, GL_QUADS, v);
                const std::vector<GLuint> depths = screen.depths();
                const double exact = f / (f - n) * (1 - n / static_cast<float>(z));
                worst = std::fmax(worst, std::fabs(depths[0] / all_ones - exact) * (std::exp2(bits) - 1));
                for (const GLuint depth : depths)
                    wrong += depth != depths[0] || depth < before ? 1 : 0;
                before = depths[0];
                // Drawn again, every fragment passes LEQUAL and none passes LESS.
                for (const GLenum test : {GL_LEQUAL, GL_LESS}) {
                    glDepthFunc(test);
                    glClear(GL_COLOR_BUFFER_BIT);
                    polygon(Form::of_float, GL_QUADS, v);
                    for (const Rgba& pixel : screen.picture())
                        wrong += (pixel[0] != 0) != (test == GL_LEQUAL) ? 1 : 0;
                }
            }
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(worst, 1);
    row("monotone over far / near = 10^6; LEQUAL passes again, LESS does not", "f / (f - n) (1 - n / z)",
        "%ld wrong on %ld planes, %.2f codes off at most", wrong, planes, worst);
}

TEST(Extreme, 16_PolygonOffsets) {
    long wrong = 0;
    double least = 1e9;
    for (const EGLint tier : tiers)
        for (const EGLint bits : {16, 24}) {
            const Screen screen(tier, side, bits);
            glEnable(GL_DEPTH_TEST);
            glEnable(GL_POLYGON_OFFSET_FILL);
            const auto offset = [](Form form, double factor, double units) {
                if (form == Form::of_fixed)
                    glPolygonOffsetxOES(fixed(factor), fixed(units));
                else
                    glPolygonOffset(static_cast<float>(factor), static_cast<float>(units));
            };
            const auto plane = [](double slope, double z) {
                polygon(Form::of_float, GL_QUADS,
                        std::array<Place, 4>{{{-1, -1, z - slope, 1},
                                              {1, -1, z + slope, 1},
                                              {1, 1, z + slope, 1},
                                              {-1, 1, z - slope, 1}}});
            };
            for (const Form form : {Form::of_float, Form::of_fixed})
                for (const double factor : {0.0, 1.0, 8.0, 64.0})
                    for (const double slope : {0.0, 0.5, 0.9})
                        for (const double sign : {-1.0, 1.0}) {
                            if (factor == 0 && slope > 0.5)
                                continue;
                            glDepthFunc(GL_ALWAYS);
                            offset(form, 0, 0);
                            plane(slope, 0);
                            const std::vector<GLuint> plain = screen.depths();
                            offset(form, sign * factor, sign);
                            plane(slope, 0);
                            const std::vector<GLuint> moved = screen.depths();
                            // The offset is m factor + r units (GL 1.3, 3.5.5). Here m is the slope for each
                            // pixel, and r is one code or a few.
                            const double by = factor * slope / side;
                            for (std::size_t i = 0; i < moved.size(); ++i) {
                                const double off = sign * (moved[i] / all_ones - plain[i] / all_ones);
                                const double code = 1 / (std::exp2(bits) - 1);
                                const double room = sign > 0 ? 1 - plain[i] / all_ones : plain[i] / all_ones;
                                // The offset reaches the end of the range, and depth stays there.
                                if (by + 4 * code > room) {
                                    wrong += moved[i] != (sign > 0 ? 0xFFFFFFFF : 0) && off < by - 3 * code
                                                 ? 1
                                                 : 0;
                                } else {
                                    wrong += off < by + (factor == 0 ? 0.99 : -0.01) * code ||
                                                     off > by * 1.001 + 4 * code
                                                 ? 1
                                                 : 0;
                                    if (factor == 0)
                                        least = std::fmin(least, off / code);
                                }
                            }
                        }
        }
    EXPECT_EQ(wrong, 0);
    row("a unit separates planes; factors up to 64 stop at 0 and 1", "m factor + r units, r of 1 to 4 codes",
        "%ld wrong; a unit is %.2f codes at least", wrong, least);
}

/// Makes a triangle as long as the window, with an area of 6/65536 square pixel. Its vertices are (0, 0),
/// (16001, 16000), (12, 12) in 256ths, and a third of a step off the grid. A pixel centre lies at (on, on) of
/// its short edge.
void put_sliver(Place* v, unsigned turned, int on) {
    const double corner[3][3] = {{0, 0, 0}, {16001, 16000, 0.9}, {12, 12, -0.5}};
    for (unsigned i = 0; i < 3; ++i) {
        double x = corner[i][0] + 128 - on, y = corner[i][1] + 128 - on;
        if (turned % 2 != 0)
            std::swap(x, y);
        if (turned % 4 >= 2)
            x = 16384 - x, y = 16384 - y;
        v[i] = {(x + 0.3) / 8192 - 1, (y - 0.3) / 8192 - 1, corner[i][2], 1};
    }
}

TEST(Extreme, 17_EqualInTwoPasses) {
    long misses = 0, fragments = 0;
    Random random{17};
    for (const EGLint tier : tiers)
        for (const EGLint bits : {16, 24}) {
            const Screen screen(tier, side, bits);
            glEnable(GL_DEPTH_TEST);
            const std::array<GLubyte, 16> texels{255, 0, 0, 255, 255, 9, 0, 255,
                                                 255, 0, 9, 255, 255, 7, 7, 255};
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            for (const Form form : fractions)
                for (int n = 0; n < 10; ++n) {
                    std::array<Place, 12> v{};
                    for (Place& place : v) {
                        const auto lot = [&] { return random.below(3001) / 1000.0 - 1.5; };
                        const double w = random.below(1000) / 250.0 + 0.1;
                        place = {lot() * w, lot() * w, lot() * w, w};
                    }
                    if (n % 2 == 0)
                        for (unsigned i = 0; i < 12; i += 3)
                            put_sliver(&v[i], n + i, 1 + static_cast<int>(random.below(11)));
                    const auto pass = [&](GLenum test) {
                        glDepthFunc(test);
                        for (const GLenum mode : {GL_TRIANGLES, GL_LINES, GL_POINTS})
                            if (n % 2 != 0 || mode == GL_TRIANGLES)
                                polygon(form, mode, v);
                    };
                    glDisable(GL_BLEND);
                    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                    glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
                    pass(GL_LEQUAL);
                    const Picture first = screen.picture();
                    // The second pass changes everything that must not move a fragment (GL 1.3, appendix
                    // A.3).
                    glClear(GL_COLOR_BUFFER_BIT);
                    glEnable(GL_TEXTURE_2D);
                    glEnable(GL_BLEND);
                    glBlendFunc(GL_ONE, GL_ZERO);
                    glEnable(GL_FOG);
                    glFogf(GL_FOG_DENSITY, 0);
                    glDepthMask(GL_FALSE);
                    pass(GL_EQUAL);
                    glDepthMask(GL_TRUE);
                    glDisable(GL_FOG);
                    glDisable(GL_TEXTURE_2D);
                    const Picture second = screen.picture();
                    for (std::size_t i = 0; i < first.size(); ++i) {
                        fragments += first[i][0] != 0 ? 1 : 0;
                        misses += (first[i][0] != 0) != (second[i][0] != 0) ? 1 : 0;
                    }
                }
        }
    EXPECT_EQ(misses, 0);
    EXPECT_GT(fragments, 100'000);
    row("a second pass with EQUAL meets every fragment of the first", "the first pass without its state",
        "%ld of %ld fragments missed", misses, fragments);
}

} // namespace
} // namespace spangle::test
