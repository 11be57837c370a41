// Tests matrices, stacks, rectangles, arrays and colours at the ends of their ranges.
#include <cstdlib>
#include <limits>

#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

using Matrix = std::array<double, 16>; ///< column-major

Matrix modelview() {
    std::array<GLfloat, 16> m{};
    glGetFloatv(GL_MODELVIEW_MATRIX, m.data());
    Matrix out{};
    std::copy(m.begin(), m.end(), out.begin());
    return out;
}

/// Turns by one degree many times; SPANGLE_ROTATIONS=1000000 sets how many.
TEST(Extreme, 26_ManyRotations) {
    const char* wish = std::getenv("SPANGLE_ROTATIONS");
    const int most = wish != nullptr ? std::atoi(wish) : 50'000;
    double worst_share = 0, off_last = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        for (const bool product : {false, true}) {
            glLoadIdentity();
            const double radians = std::acos(-1.0) / 180;
            const std::array<GLfloat, 16> turn{static_cast<GLfloat>(std::cos(radians)),
                                               static_cast<GLfloat>(std::sin(radians)),
                                               0,
                                               0,
                                               -static_cast<GLfloat>(std::sin(radians)),
                                               static_cast<GLfloat>(std::cos(radians)),
                                               0,
                                               0,
                                               0,
                                               0,
                                               1,
                                               0,
                                               0,
                                               0,
                                               0,
                                               1};
            // Floats are no exact rotation by a degree, so their own length and angle are the expected ones.
            const double c = double{turn[0]}, s = double{turn[1]};
            const double angle = product ? std::atan2(s, c) : radians;
            const double stretch = product ? std::hypot(c, s) : 1;
            for (int n = 1; n <= most; ++n) {
                if (product)
                    glMultMatrixf(turn.data());
                else if (n % 2 == 0)
                    glRotatexOES(65536, 0, 0, 65536);
                else
                    glRotatef(1, 0, 0, 1);
                if (n != 1024 && n != most)
                    continue;
                const Matrix m = modelview();
                const double length = std::pow(stretch, n);
                const double exact[4] = {length * std::cos(n * angle), length * std::sin(n * angle),
                                         -length * std::sin(n * angle), length * std::cos(n * angle)};
                const double is[4] = {m[0], m[1], m[4], m[5]};
                // Rounding to 31 bits goes either way, so errors grow as the root of the number of steps, and
                // a query rounds to a float. An error that always went the same way would be n steps off.
                const double bound = 4 * std::sqrt(n) * 0x1p-31 + 0x1p-24;
                for (int i = 0; i < 4; ++i) {
                    const double off = std::fabs(is[i] - exact[i]);
                    worst_share = std::fmax(worst_share, off / bound);
                    off_last = n == most ? std::fmax(off_last, off) : off_last;
                }
            }
        }
    }
    EXPECT_LE(worst_share, 1);
    row("n products are no more than 4 sqrt(n) 2^-31 off", "cos n a, sin n a",
        "%.2g off after %d, %.2g of the bound", off_last, most, worst_share);
}

TEST(Extreme, 27_StacksInMidFrame) {
    long wrong = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        const std::array<Place, 3> half{{{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}}};
        for (const auto& [mode, depth] :
             {std::pair<GLenum, GLenum>{GL_MODELVIEW, GL_MAX_MODELVIEW_STACK_DEPTH},
              {GL_PROJECTION, GL_MAX_PROJECTION_STACK_DEPTH},
              {GL_TEXTURE, GL_MAX_TEXTURE_STACK_DEPTH}}) {
            GLint entries = 0;
            glGetIntegerv(depth, &entries);
            glMatrixMode(mode);
            glLoadIdentity();
            glScalef(0.5F, 1, 1);
            for (const bool push : {true, false}) {
                for (GLint i = 1; i < entries; ++i) {
                    (push ? glPushMatrix : glPopMatrix)();
                    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
                }
                for (int i = 0; i < 3; ++i) {
                    (push ? glPushMatrix : glPopMatrix)();
                    EXPECT_EQ(glGetError(), GLenum(push ? GL_STACK_OVERFLOW : GL_STACK_UNDERFLOW));
                    glClear(GL_COLOR_BUFFER_BIT);
                    polygon(Form::of_float, GL_TRIANGLES, half);
                    // The left corner goes to -1/2 if x is halved.
                    const int from = mode == GL_TEXTURE ? 0 : side / 4;
                    const Picture picture = screen.picture();
                    for (int x = 0; x < side; ++x)
                        wrong += (picture[static_cast<std::size_t>(x)][0] != 0) != (x >= from) ? 1 : 0;
                }
            }
            glLoadIdentity();
        }
        glMatrixMode(GL_MODELVIEW);
    }
    EXPECT_EQ(wrong, 0);
    row("GL_STACK_OVERFLOW and _UNDERFLOW; matrix and picture stay", "the errors; the rectangle",
        "%ld pixels wrong", wrong);
}

TEST(Extreme, 28_RectanglesAndStrides) {
    long wrong = 0, rectangles = 0;
    const int end = std::numeric_limits<int>::max(), low = std::numeric_limits<int>::min();
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        glEnable(GL_SCISSOR_TEST);
        for (const auto& s : {std::array<int, 4>{-10, -10, 20, 20},
                              {60, 60, end, end},
                              {0, 0, 0, 0},
                              {low, low, end, end},
                              {64, 0, 9, 9},
                              {-end, -end, end, end},
                              {-5, 3, end, 1},
                              {63, 63, 1, 1}})
            for (const bool clear : {false, true}) {
                glDisable(GL_SCISSOR_TEST);
                glClear(GL_COLOR_BUFFER_BIT);
                glEnable(GL_SCISSOR_TEST);
                glScissor(s[0], s[1], s[2], s[3]);
                glClearColor(1, 1, 1, 1);
                if (clear)
                    glClear(GL_COLOR_BUFFER_BIT);
                else
                    rectangle(-1, -1, 1, 1);
                glClearColor(0, 0, 0, 0);
                ++rectangles;
                const Picture picture = screen.picture();
                for (int y = 0; y < side; ++y)
                    for (int x = 0; x < side; ++x) {
                        const auto within = [](std::int64_t v, std::int64_t from, std::int64_t many) {
                            return v >= from && v < from + many;
                        };
                        const bool in = within(x, s[0], s[2]) && within(y, s[1], s[3]);
                        wrong += (picture[static_cast<std::size_t>(y * side + x)][0] != 0) != in ? 1 : 0;
                    }
            }
        glDisable(GL_SCISSOR_TEST);
        // Rows lie far apart and are read partly beside the window; the memory between them is not written.
        std::vector<GLubyte> rows(8 * 4 * 100, 77);
        rectangle(-1, -1, 1, 1);
        glPixelStorei(GL_PACK_ROW_LENGTH, 100);
        glReadPixels(-4, -4, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
        glPixelStorei(GL_PACK_ROW_LENGTH, 0);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::size_t y = i / 400, x = i % 400 / 4;
            if (x >= 8)
                wrong += rows[i] != 77 ? 1 : 0;
            else if (x >= 4 && y >= 4)
                wrong += rows[i] != 255 ? 1 : 0;
        }
        // Vertices lie 1000 bytes apart, the last at the end of the memory; and one vertex serves for all.
        for (const std::size_t stride : {std::size_t{1000}, std::size_t{8}}) {
            std::vector<GLfloat> memory(3 * stride / 4 - stride / 4 + 2);
            const GLfloat corners[3][2] = {{-1, -1}, {3, -1}, {-1, 3}};
            for (std::size_t i = 0; i < 3; ++i)
                std::copy(corners[i], corners[i] + 2,
                          memory.begin() + static_cast<std::ptrdiff_t>(i * stride / 4));
            glClear(GL_COLOR_BUFFER_BIT);
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(2, GL_FLOAT, static_cast<GLsizei>(stride), memory.data());
            glDrawArrays(GL_TRIANGLES, 0, 3);
            glDisableClientState(GL_VERTEX_ARRAY);
            for (const Rgba& pixel : screen.picture())
                wrong += pixel[0] != 255 ? 1 : 0;
        }
        glVertexPointer(2, GL_FLOAT, -1, nullptr);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    }
    EXPECT_EQ(wrong, 0);
    row("nothing beside the window or between rows", "the rectangle; guards; sanitizers",
        "%ld pixels wrong of %ld rectangles", wrong, rectangles);
}

TEST(Extreme, 29_SumsOfColours) {
    long wrong = 0, colours = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier, 8);
        const auto expect = [&](double red, int slack = 0) {
            ++colours;
            wrong += std::abs(screen.pixel(3, 3)[0] -
                              static_cast<int>(std::lround(255 * std::clamp(red, 0.0, 1.0)))) > slack
                         ? 1
                         : 0;
        };
        for (const double red : {2.0, 1.0, 0.0, -1.0, 1e38, -1e38})
            for (const Form form : fractions) {
                if (form == Form::of_float)
                    glColor4f(static_cast<float>(red), 0, 0, 1);
                else if (form == Form::of_double)
                    glColor4d(red, 0, 0, 1);
                else
                    glColor4xOES(fixed(red), 0, 0, 65536);
                rectangle(-1, -1, 1, 1);
                expect(red);
            }
        const GLint all[] = {std::numeric_limits<GLint>::max(), 0, 0, std::numeric_limits<GLint>::max()};
        glColor4iv(all);
        rectangle(-1, -1, 1, 1);
        expect(1);
        // Sums of two components beyond 1, and white times white, are white.
        const std::array<GLubyte, 4> white{255, 255, 255, 255};
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glEnable(GL_TEXTURE_2D);
        for (const GLenum mode : {GL_MODULATE, GL_ADD, GL_REPLACE}) {
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
            glColor3ub(255, 255, 255);
            rectangle(-1, -1, 1, 1);
            expect(1);
        }
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
        for (int red = 0; red < 256; ++red) { // multiplied by white it does not change
            glColor3ub(static_cast<GLubyte>(red), 0, 0);
            rectangle(-1, -1, 1, 1);
            expect(red / 255.0);
        }
        glDisable(GL_TEXTURE_2D);
        glEnable(GL_BLEND);
        for (const double alpha : {0.0, 1.0, 255.0 / 256, -1.0, 2.0})
            for (const double below : {0.0, 0.4, 1.0}) {
                glClearColor(static_cast<float>(below), 0, 0, 1);
                glClear(GL_COLOR_BUFFER_BIT);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                glColor4d(0.8, 0, 0, alpha);
                rectangle(-1, -1, 1, 1);
                const double a = std::clamp(alpha, 0.0, 1.0);
                expect(0.8 * a + below * (1 - a), a == 0 || a == 1 ? 0 : 1);
            }
        glBlendFunc(GL_ONE, GL_ONE);
        rectangle(-1, -1, 1, 1);
        expect(1);
    }
    EXPECT_EQ(wrong, 0);
    row("clamped; white by white is white, alpha 0 and 1 are exact", "the sums and products",
        "%ld of %ld colours wrong", wrong, colours);
}

TEST(Extreme, 30_RampsIn565) {
    long wrong = 0, pixels = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier, side, 16, 5);
        for (const bool dither : {false, true}) {
            (dither ? glEnable : glDisable)(GL_DITHER);
            for (int gray = 0; gray < 256; ++gray) {
                const auto g = static_cast<GLubyte>(gray);
                glColor3ub(g, g, g);
                rectangle(-1, -1, 1, 1);
                for (const Rgba& pixel : screen.picture())
                    for (std::size_t c = 0; c < 3; ++c) {
                        const int steps = c == 1 ? 63 : 31;
                        const double exact = gray * steps / 255.0;
                        const int is = static_cast<int>(std::lround(pixel[c] * steps / 255.0));
                        ++pixels;
                        // Dithering takes the step below or above; without it the top bits are stored (GL
                        // 1.3, 4.1.8).
                        wrong += dither ? is < std::floor(exact) || is > std::ceil(exact) ? 1 : 0
                                 : is != gray >> (c == 1 ? 2 : 3) ? 1
                                                                  : 0;
                        wrong += (gray == 0 && pixel[c] != 0) || (gray == 255 && pixel[c] != 255) ? 1 : 0;
                    }
            }
        }
    }
    EXPECT_EQ(wrong, 0);
    row("ends kept; dither takes the step below or above, without it the top bits", "k / 31 and k / 63",
        "%ld of %ld components wrong", wrong, pixels);
}

} // namespace
} // namespace spangle::test
