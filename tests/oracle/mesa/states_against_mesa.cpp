// Compares random states of every family, pixel by pixel, with Mesa's softpipe.
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "tests/oracle/mesa/mesa_planes.hpp"
#include "tests/support/headless_gl.hpp"

namespace {

using spangle::oracle::bytes_of_drawing;
using spangle::oracle::draw_with_mesa;
using spangle::oracle::Family;
using spangle::oracle::pixel_channels;
using spangle::oracle::Planes;
using spangle::oracle::state_size;

/// Returns SPANGLE_ORACLE_SEEDS times as many drawings as the family asks for.
int drawings_of(const Family& family) {
    const char* const times = std::getenv("SPANGLE_ORACLE_SEEDS");
    return family.drawings * (times != nullptr ? std::atoi(times) : 1);
}

/// In one process; with many thousands of programs Mesa runs out of resources.
constexpr int drawings_at_once = 2000;

struct Differences {
    std::size_t differing = 0; ///< number of pixels that differ
    int worst = 0;

    void compare(const Family& family, int n, const unsigned char* mesa) {
        const spangle::oracle::Drawn ours = spangle::oracle::draw_state(family, n);
        for (int i = 0; i < state_size * state_size; ++i, mesa += pixel_channels) {
            const int x = i % state_size, y = i / state_size;
            if (!ours.quads.has_on_edge(x, y))
                pixel(family, n, x, y, &ours.planes[static_cast<std::size_t>(i) * pixel_channels], mesa);
        }
    }

  private:
    void pixel(const Family& family, int n, int x, int y, const unsigned char* ours,
               const unsigned char* mesa) {
        int most = 0;
        for (int c = 0; c < pixel_channels; ++c) {
            const int difference = std::abs(ours[c] - mesa[c]);
            if (difference > family.tolerance && worst <= family.tolerance)
                ADD_FAILURE() << "drawing " << n << ", pixel (" << x << ", " << y << "), channel " << c
                              << ": " << int{ours[c]} << ", Mesa has " << int{mesa[c]};
            most = std::max(most, difference);
        }
        worst = std::max(worst, most);
        differing += most != 0 ? 1 : 0;
    }
};

struct StatesOf : testing::TestWithParam<Family> {
    spangle::test::HeadlessGl current{state_size,
                                      state_size,
                                      {EGL_STENCIL_SIZE, 8, EGL_PRECISION_SPANGLE,
                                       EGL_PRECISION_EXACT_SPANGLE, EGL_SAMPLES, GetParam().samples},
                                      {EGL_ACCUM_SIZE_SPANGLE, 16}};
};

TEST_P(StatesOf, LookLikeMesa) {
    const Family& family = GetParam();
    Differences found;
    const int drawings = drawings_of(family);
    for (int first = 0; first < drawings; first += drawings_at_once) {
        const int count = std::min(drawings - first, drawings_at_once);
        const Planes theirs = draw_with_mesa(family, first, count);
        ASSERT_EQ(theirs.size(), bytes_of_drawing * static_cast<std::size_t>(count));
        for (int n = 0; n < count; ++n)
            found.compare(family, first + n, theirs.data() + bytes_of_drawing * static_cast<std::size_t>(n));
    }
    const double pixels = static_cast<double>(drawings) * state_size * state_size;
    std::printf("%s: %.4f %% of %.0f pixels identical, worst difference %d\n", family.id,
                100 * (1 - static_cast<double>(found.differing) / pixels), pixels, found.worst);
    EXPECT_LE(found.worst, family.tolerance);
    EXPECT_LE(static_cast<double>(found.differing), (1 - family.identical) * pixels);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

INSTANTIATE_TEST_SUITE_P(All, StatesOf, testing::ValuesIn(spangle::oracle::all_families()),
                         [](const auto& info) { return std::string(info.param.id); });

} // namespace
