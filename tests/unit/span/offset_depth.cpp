// Tests that the polygon offset is added to eight depths as it is added to one, and that sums are clamped.
#include <gtest/gtest.h>

#include <cstdint>

#include "raster/ops/number_wide.hpp"
#include "raster/ops/stage_depth.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::raster {
namespace {

constexpr std::int64_t most = INT64_C(0xFFFFFFFF);

/// A span of which depth stages read the state alone.
struct StateOnly {
    const DrawState* state;
};

/// Depths that the test has chosen.
struct ChosenWords {
    Lanes<8>::U32 depth = Lanes<8>::splat32(0);
    ChosenWords(const StateOnly&, std::int32_t) {}
    Lanes<8>::U32 words() const { return depth; }
};

std::uint32_t clamped(std::int64_t sum) {
    return static_cast<std::uint32_t>(sum < 0 ? 0 : sum > most ? most : sum);
}

TEST(OffsetDepth, EightDepthsAreClampedAsOneIs) {
    if constexpr (host_lanes == 8) {
        const std::int64_t offsets[] = {
            0,    1,        -1,    255,       1 << 20,   -(1 << 20), INT64_C(1) << 31, most - 1,
            most, most + 1, -most, -most - 1, -most + 1, INT64_MAX,  INT64_MIN};
        const std::uint32_t words[] = {
            0,          1,          255,        0x7FFFFFFF, 0x80000000, 0x80000001, 0xFFF00000, 0xFFFFFFFFu,
            0xFFFFFFFE, 0x12345678, 0xEDCBA987, 1u << 20,   65535,      65536,      0x80007FFF, 3};
        PrimitiveState primitive;
        DrawState state;
        state.primitive = &primitive;
        for (const bool is_on : {true, false})
            for (const std::int64_t offset : offsets) {
                state.fragment.depth_offset = is_on;
                primitive.depth_offset = offset;
                OffsetDepthValue<ExactLanes, ChosenWords> lanes(StateOnly{&state}, 0);
                for (int first = 0; first < 16; first += 8) {
                    lanes.depth = Lanes<8>::gather(words + first);
                    std::uint32_t found[8];
                    Lanes<8>::store32(reinterpret_cast<std::uint8_t*>(found), lanes.words());
                    for (int lane = 0; lane < 8; ++lane) {
                        const std::uint32_t word = words[first + lane];
                        // No depth is moved further than by the whole range.
                        const std::int64_t by = offset > most ? most : offset < -most ? -most : offset;
                        EXPECT_EQ(found[lane], is_on ? clamped(word + by) : word) << offset << ' ' << word;
                    }
                }
            }
    }
}

} // namespace
} // namespace spangle::raster
