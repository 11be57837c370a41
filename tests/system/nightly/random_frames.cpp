// Draws frames of random commands, each a pure function of its number. ./dev nightly runs a million of them
// under ASan and UBSan. Three kinds take turns: streams by the command table, which are mostly errors;
// streams with displays and threads of EGL; and drawings in legal random states, in each tier.
//
// usage: random_frames FIRST COUNT
#include <charconv>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

#include "tests/gl/api/command_stream.hpp"
#include "tests/oracle/mesa/states.hpp"
#include "tests/support/headless_gl.hpp"
#include "tests/system/streams/egl_stream.hpp"

namespace {

using spangle::oracle::state_size;

std::vector<std::uint8_t> bytes_of(unsigned frame) {
    std::mt19937 random(frame);
    std::vector<std::uint8_t> data(200 + random() % 1800);
    for (std::uint8_t& byte : data)
        byte = static_cast<std::uint8_t>(random() >> 9);
    return data;
}

void draw_legal_state(unsigned frame) {
    static const auto& families = spangle::oracle::all_families();
    constexpr EGLint tiers[] = {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_BALANCED_SPANGLE,
                                EGL_PRECISION_FAST_SPANGLE};
    const auto& family = families[frame % families.size()];
    const spangle::test::HeadlessGl current{
        state_size,
        state_size,
        {EGL_STENCIL_SIZE, 8, EGL_PRECISION_SPANGLE, tiers[frame % 3], EGL_SAMPLES, family.samples},
        {EGL_ACCUM_SIZE_SPANGLE, 16}};
    spangle::oracle::draw_state(family, static_cast<int>(frame % 0x10000000));
}

void draw(unsigned frame) {
    if (frame % 2 != 0)
        return draw_legal_state(frame / 2);
    const auto data = bytes_of(frame);
    if (frame % 16 == 0)
        spangle::test::run_egl_stream(data.data(), data.size());
    else
        spangle::test::run_command_stream(data.data(), data.size());
}

bool number(const char* text, unsigned& out) {
    const char* const end = text + std::strlen(text);
    const auto [at, wrong] = std::from_chars(text, end, out);
    return wrong == std::errc{} && at == end;
}

} // namespace

int main(int argc, char** argv) {
    unsigned first = 0, count = 0;
    if (argc != 3 || !number(argv[1], first) || !number(argv[2], count)) {
        std::fprintf(stderr, "usage: random_frames FIRST COUNT\n");
        return 2;
    }
    for (unsigned i = 0; i < count; ++i) {
        // If a sanitizer ends the program, this line shows in which frame.
        std::printf("\r%u", first + i);
        std::fflush(stdout);
        draw(first + i);
    }
    std::printf("\n%u frames\n", count);
    return testing::UnitTest::GetInstance()->failed_test_count() == 0 ? 0 : 1;
}
