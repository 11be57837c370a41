// Multisample fragment operations (GL 1.3, 4.1.3). Alpha, or a value of the state, says which samples of a
// pixel are covered. A list of stages draws one sample, so a dropped fragment is a sample that is not
// covered.
#pragma once

#include "raster/ops/stage.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Whether a value k / 255 covers this sample at a pixel whose dither threshold is t / 32. The value covers 4
/// k / 255 samples. The fraction of that number adds one sample where it is more than the threshold, so
/// dithering spreads it over neighbouring pixels. Value 0 covers no sample, and value 255 covers all four.
constexpr bool covers_sample(std::uint32_t k, unsigned sample, std::uint32_t threshold) {
    return k * (sample_count * 32) > 255 * (32 * sample + threshold);
}

/// Applies the temporary coverage that alpha gives, then sets alpha to 1, then applies the coverage value. GL
/// sets each step on or off.
template <class N> struct SampleCoverage : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color, out = field_color;
    static constexpr bool kill = true;
    const FragmentState& state;
    inner::DitherRow<typename N::L> dither;
    unsigned sample;
    SPANGLE_INLINE SampleCoverage(const Span<typename N::Policy>& s, std::int32_t x)
        : state(s.state->fragment), dither(s.x + x, s.y), sample(s.state->primitive->sample) {}

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto alpha = static_cast<std::uint32_t>(N::to8(p.color.a));
        const std::uint32_t threshold = dither.threshold();
        const bool by_alpha = !state.alpha_to_coverage || covers_sample(alpha, sample, threshold);
        const bool by_value =
            !state.sample_coverage ||
            covers_sample(state.sample_coverage_value, sample, threshold) != state.invert_sample_coverage;
        if (state.alpha_to_one)
            p.color.a = N::from_units(color_one);
        return by_alpha && by_value;
    }
    SPANGLE_INLINE void step() { dither.step(); }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
