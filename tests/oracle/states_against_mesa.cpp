// Random states of every family, pixel by pixel beside Mesa's softpipe.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "tests/headless_gl.hpp"
#include "tests/oracle/states.hpp"

namespace {

using spangle::oracle::Family;
using spangle::oracle::pixel_channels;
using spangle::oracle::Planes;
using spangle::oracle::state_size;

constexpr std::size_t bytes_of_drawing = std::size_t{state_size} * state_size * pixel_channels;

Planes draw_with_mesa(const Family& family) {
    const std::string file = testing::TempDir() + "mesa_states_" + family.id + std::to_string(getpid());
    const std::string command = "ASAN_OPTIONS=detect_leaks=0 GALLIUM_DRIVER=softpipe '" MESA_STATES "' " +
                                std::string(family.id) + " '" + file + "'";
    if (std::system(command.c_str()) != 0)
        return {};
    Planes all(bytes_of_drawing * static_cast<std::size_t>(family.drawings));
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(all.size()));
    std::remove(file.c_str());
    return in ? all : Planes();
}

struct StatesOf : testing::TestWithParam<Family> {
    spangle::test::HeadlessGl current{
        state_size,
        state_size,
        {EGL_STENCIL_SIZE, 8, EGL_PRECISION_SPANGLE, EGL_PRECISION_EXACT_SPANGLE},
        {EGL_ACCUM_SIZE_SPANGLE, 16}};
};

TEST_P(StatesOf, LookLikeMesa) {
    const Family& family = GetParam();
    const Planes theirs = draw_with_mesa(family);
    ASSERT_EQ(theirs.size(), bytes_of_drawing * static_cast<std::size_t>(family.drawings));
    std::size_t differing = 0;
    int worst = 0;
    for (int n = 0; n < family.drawings; ++n) {
        const Planes ours = spangle::oracle::draw_state(family, n);
        const unsigned char* const mesa = theirs.data() + bytes_of_drawing * static_cast<std::size_t>(n);
        for (std::size_t i = 0; i < ours.size(); i += pixel_channels) {
            bool same = true;
            for (std::size_t c = 0; c < pixel_channels; ++c) {
                const int difference = std::abs(ours[i + c] - mesa[i + c]);
                const std::size_t pixel = i / pixel_channels;
                if (difference > family.tolerance && worst <= family.tolerance)
                    ADD_FAILURE() << "drawing " << n << ", pixel (" << pixel % state_size << ", "
                                  << pixel / state_size << "), channel " << c << ": " << int{ours[i + c]}
                                  << ", Mesa has " << int{mesa[i + c]};
                worst = std::max(worst, difference);
                same = same && difference == 0;
            }
            differing += same ? 0 : 1;
        }
    }
    const double pixels = static_cast<double>(theirs.size()) / pixel_channels;
    std::printf("%s: %.4f %% of %.0f pixels identical, worst difference %d\n", family.id,
                100 * (1 - static_cast<double>(differing) / pixels), pixels, worst);
    EXPECT_LE(worst, family.tolerance);
    EXPECT_LE(static_cast<double>(differing), (1 - family.identical) * pixels);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

INSTANTIATE_TEST_SUITE_P(All, StatesOf, testing::ValuesIn(spangle::oracle::all_families()),
                         [](const auto& info) { return std::string(info.param.id); });

} // namespace
