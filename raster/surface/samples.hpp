// The multisample buffer (GL 1.3, 3.2.1, 4.1.10): four samples of every pixel, each kind of them a surface of
// its own. A primitive is drawn into one after the other, moved so that the sample lies where centres are:
// coverage, depth and colour are then those of the sample, by what draws every other surface. What the window
// shows is resolved later, where something was drawn.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/surface/surface.hpp"
#include <spangle/raster/clear.hpp>
#include <spangle/raster/features.hpp>

namespace spangle::raster {

inline constexpr unsigned sample_count = 4;
static_assert(has_extents || !has_samples, "samples are resolved where something was drawn: SPANGLE_EXTENTS");

/// Laid out as the surface's own planes. Depth and stencil of the first sample are the surface's.
struct Samples {
    std::uint8_t* color = nullptr;                 ///< of the first sample, GL row 0
    std::int32_t color_stride = 0;                 ///< bytes from GL row y to y + 1
    std::ptrdiff_t next_color = 0, next_depth = 0; ///< bytes from a sample to the next
    RowSpan* unresolved = nullptr;                 ///< of GL row 0 and up
};

/// Where a sample lies in its pixel, 1/256, from its lower left corner: no two in one row, column or
/// quadrant.
struct SamplePosition {
    std::int32_t x, y;
};
inline constexpr SamplePosition sample_position[sample_count] = {{96, 32}, {224, 96}, {32, 160}, {160, 224}};

/// One sample of every pixel, as a surface.
Surface sample_of(const Surface& s, unsigned sample);

/// Calls draw(surface, sample) for each sample, or once for a surface that has none.
template <class Draw> void each_sample(const Surface& s, Draw draw) {
    if constexpr (has_samples) {
        if (s.samples != nullptr) {
            for (unsigned i = 0; i < sample_count; ++i)
                draw(sample_of(s, i), i);
            return;
        }
    }
    draw(s, 0u);
}

#if SPANGLE_FEATURE_MULTISAMPLE
/// Of the samples, where there are some. What is cleared whole is the same in all of them: it needs no
/// resolving.
void clear_samples(const Surface& s, const ClearRequest& request);

/// Colours are the mean of their samples', component by component as they are stored, halves up. Nothing
/// happens where nothing was drawn since.
void resolve(const Surface& s);
#else
inline void clear_samples(const Surface& s, const ClearRequest& request) {
    clear(s, request);
}
inline void resolve(const Surface&) {}
#endif

} // namespace spangle::raster
