// Plays a day of animation at 60 frames a second. Tests how errors add up in matrices that are never reset,
// and what a clock gives that is never set back. Long doubles judge both.
#include <cstdlib>

#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

using Exact = long double;
using Affine = std::array<Exact, 12>; ///< three columns and a translation

constexpr double turn_bound = 0x1p-31; ///< radians by which each turn may be off (docs/bounds.md)

/// Returns the hours of animation: SPANGLE_HOURS, or three minutes.
double hours() {
    const char* const wish = std::getenv("SPANGLE_HOURS");
    return wish != nullptr ? std::atof(wish) : 0.05;
}
int frames() {
    return static_cast<int>(hours() * 3600 * 60);
}

Affine modelview() {
    std::array<GLdouble, 16> m{};
    glGetDoublev(GL_MODELVIEW_MATRIX, m.data());
    Affine out{};
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 3; ++r)
            out[3 * c + r] = static_cast<Exact>(m[4 * c + r]);
    return out;
}

/// m = m b.
void multiply(Affine& m, const Affine& b) {
    Affine out{};
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 3; ++r)
            out[3 * c + r] = m[r] * b[3 * c] + m[3 + r] * b[3 * c + 1] + m[6 + r] * b[3 * c + 2] +
                             (c == 3 ? m[9 + r] : Exact{0});
    m = out;
}

/// Returns a turn about (1, 2, 2) / 3 and then a step in the turned system (GL 1.3, 2.10.2).
Affine turn_and_step(float degrees, const std::array<float, 3>& step) {
    const Exact angle = static_cast<Exact>(degrees) * std::acos(Exact{-1}) / 180;
    const Exact c = std::cos(angle), s = std::sin(angle), x = Exact{1} / 3, y = Exact{2} / 3, z = y;
    Affine m{x * x * (1 - c) + c,     y * x * (1 - c) + z * s, x * z * (1 - c) - y * s,
             x * y * (1 - c) - z * s, y * y * (1 - c) + c,     y * z * (1 - c) + x * s,
             x * z * (1 - c) + y * s, y * z * (1 - c) - x * s, z * z * (1 - c) + c};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c2 = 0; c2 < 3; ++c2)
            m[9 + r] += m[3 * c2 + r] * static_cast<Exact>(step[c2]);
    return m;
}

/// Returns the largest difference of elements from `first` up to `last`.
double off(const Affine& is, const Affine& exact, std::size_t first, std::size_t last) {
    double worst = 0;
    for (std::size_t i = first; i < last; ++i)
        worst = std::fmax(worst, static_cast<double>(std::fabs(is[i] - exact[i])));
    return worst;
}

TEST(Extreme, 35_ADayOfTurns) {
    const int n = frames();
    double worst = 0, share = 0, far = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        if (tier != tiers[0] && n > 100'000)
            continue; // matrices have no tiers
        for (const float degrees : {0.1F, 0.7F, 1.0F, 6.25F, 137.5F}) {
            // The steps are small and at right angles to the axis, so the path is a circle.
            const std::array<float, 3> step{0.02F, -0.02F, 0.01F};
            const Affine each = turn_and_step(degrees, step);
            Affine exact{1, 0, 0, 0, 1, 0, 0, 0, 1};
            glLoadIdentity();
            for (int i = 0; i < n; ++i) {
                glRotatef(degrees, 1, 2, 2);
                glTranslatef(step[0], step[1], step[2]);
                multiply(exact, each);
            }
            const Affine is = modelview();
            const double turned = off(is, exact, 0, 9);
            worst = std::fmax(worst, turned);
            share = std::fmax(share, turned / (n * turn_bound + 0x1p-24));
            far = std::fmax(far, off(is, exact, 9, 12));
        }
    }
    // Rounding errors go either way, so they use little of the bound. An error that is the same in each turn
    // would use nearly all of it.
    EXPECT_LE(share, 0.1);
    EXPECT_LE(far, 100 * n * turn_bound + 1e-5); // the circles of this step have a radius of 17 at most
    row("n turns about an axis, each with a step, are n 2^-31 off at most", "products in long double",
        "%.2g off after %g h, %.2g of the bound; the place %.2g off", worst, hours(), share, far);
}

/// The error of a translation that grows by `step` each frame and turns back after `period` frames.
struct Scrolled {
    double off, share;
};
Scrolled scroll(int n, float step, int period) {
    Exact exact = 0, most = 0;
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (int i = 0; i < n; ++i) {
        const float by = i / period % 2 == 0 ? step : -step;
        glTranslatef(by, 0, 0);
        exact += static_cast<Exact>(by);
        most = std::fmax(most, std::fabs(exact));
    }
    std::array<GLdouble, 16> m{};
    glGetDoublev(GL_MODELVIEW_MATRIX, m.data());
    const auto is_off = static_cast<double>(std::fabs(static_cast<Exact>(m[12]) - exact));
    const auto bound =
        static_cast<double>(n * most * 0x1p-31L + most * 0x1p-24L); // a query rounds to a float
    return {is_off, is_off / bound};
}

TEST(Extreme, 36_ADayOfScrolls) {
    const int n = frames();
    Scrolled onward{}, back{};
    const Screen screen(tiers[0]);
    for (const float step : {1.0F / 600, 1.0F / 64, 0.037F}) {
        const Scrolled there = scroll(n, step, n), again = scroll(n, step, 250);
        onward = {std::fmax(onward.off, there.off), std::fmax(onward.share, there.share)};
        back = {std::fmax(back.off, again.off), std::fmax(back.share, again.share)};
    }
    EXPECT_LE(std::fmax(onward.share, back.share), 1);
    row("a sum t of n steps is n t 2^-31 off at most", "the sum in long double",
        "onward %.2g off after %g h, %.2g of the bound; to and fro %.2g off", onward.off, hours(),
        onward.share, back.off);
}

/// Draws a texture of 16 grey columns, moved by the clock, over the whole window. Returns how many pixel
/// columns are wrong.
long wrong_columns(const Screen& screen, double seconds) {
    const auto from = static_cast<float>(seconds * 0.1);
    glTexCoord2f(from, 0);
    glBegin(GL_QUADS);
    glTexCoord2f(from, 0), glVertex2f(-1, -1);
    glTexCoord2f(from + 1, 0), glVertex2f(1, -1);
    glTexCoord2f(from + 1, 0), glVertex2f(1, 1);
    glTexCoord2f(from, 0), glVertex2f(-1, 1);
    glEnd();
    const Picture picture = screen.picture();
    long wrong = 0;
    const double first = from, last = from + 1.0F; // the ends as floats hold them
    for (int x = 0; x < side; ++x) {
        const double s = (first + (last - first) * (x + 0.5) / side) * 16;
        if (std::fabs(s - std::nearbyint(s)) < 1.0 / 64)
            continue; // the place lies between two columns
        const auto column = static_cast<long>(std::floor(s)) & 15;
        wrong += picture[static_cast<std::size_t>(32 * side + x)][0] != column * 16 ? 1 : 0;
    }
    return wrong;
}

/// Draws linear fog from 1 to 11 over a white square whose distance the clock changes. Returns the error of
/// the colour.
double fogged(const Screen& screen, double seconds) {
    const auto z = static_cast<float>(6 + 4.5 * std::sin(seconds));
    glEnable(GL_FOG);
    glDisable(GL_TEXTURE_2D);
    glColor3ub(255, 255, 255);
    glLoadIdentity();
    glTranslatef(0, 0, -z);
    rectangle(-1, -1, 1, 1);
    glLoadIdentity();
    glDisable(GL_FOG);
    glEnable(GL_TEXTURE_2D);
    return std::fabs(screen.pixel(9, 9)[0] - 255 * (11 - double{z}) / 10);
}

/// Measures the error of a turn by the clock's angle: as a float, and as a double whose angle becomes a
/// float.
void turned(double seconds, std::array<double, 2>& worst, double& share) {
    for (const std::size_t wide : {0U, 1U}) {
        const double degrees = seconds * 90;
        const Exact angle =
            wide != 0 ? static_cast<Exact>(degrees) : static_cast<Exact>(static_cast<float>(degrees));
        glLoadIdentity();
        if (wide != 0)
            glRotated(degrees, 0, 0, 1);
        else
            glRotatef(static_cast<float>(degrees), 0, 0, 1);
        const Affine is = modelview();
        const Exact radians = angle * std::acos(Exact{-1}) / 180;
        const double off_by = static_cast<double>(
            std::fmax(std::fabs(is[0] - std::cos(radians)), std::fabs(is[1] - std::sin(radians))));
        worst[wide] = std::fmax(worst[wide], off_by);
        const double bound = 0x1p-24 + (wide != 0 ? static_cast<double>(radians) * 0x1p-24 : 0);
        share = std::fmax(share, off_by / bound);
    }
    glLoadIdentity();
}

TEST(Extreme, 37_ADayOfClocks) {
    long wrong = 0, columns = 0;
    std::array<double, 2> worst{};
    double share = 0, fog = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        std::array<GLubyte, 16> texels{};
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = static_cast<GLubyte>(16 * i);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 16, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glEnable(GL_TEXTURE_2D);
        glFogi(GL_FOG_MODE, GL_LINEAR);
        glFogf(GL_FOG_START, 1);
        glFogf(GL_FOG_END, 11);
        glMatrixMode(GL_PROJECTION);
        glOrtho(-1, 1, -1, 1, 0, 20);
        glMatrixMode(GL_MODELVIEW);
        for (int i = 0; i < 200; ++i) {
            const double seconds = 86'400.0 * i / 199;
            wrong += wrong_columns(screen, seconds);
            columns += side;
            fog = std::fmax(fog, fogged(screen, seconds));
            turned(seconds, worst, share);
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(fog, 0.6);
    EXPECT_LE(share, 1);
    row("after 24 h a clock's s, fog and angle are as exact as the float that holds them",
        "texels, fog and turns in long double",
        "%ld of %ld columns wrong, fog %.2f of 255, turns %.2g, by doubles %.2g off", wrong, columns, fog,
        worst[0], worst[1]);
}

} // namespace
} // namespace spangle::test
