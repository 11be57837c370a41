// The multisample buffer (GL 1.3, 3.2.1, 4.1.10) has four samples of every pixel. Sample i of all pixels
// forms a surface of its own. A primitive is drawn into each of these surfaces in turn, moved so that the
// sample lies where pixel centres are. Coverage, depth and colour are then those of the sample, and the code
// is that of all other surfaces. The window's picture is resolved later, for pixels to which something was
// drawn.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/surface/surface.hpp"
#include <spangle/raster/clear.hpp>
#include <spangle/raster/features.hpp>

namespace spangle::raster {

inline constexpr unsigned sample_count = 4;
static_assert(has_extents || !has_samples, "samples are resolved where something was drawn: SPANGLE_EXTENTS");

/// The planes of the samples, with the layout of the surface's planes. Depth and stencil of the first sample
/// are those of the surface itself.
struct Samples {
    std::uint8_t* color = nullptr;                 ///< first sample, GL row 0
    std::int32_t color_stride = 0;                 ///< bytes from GL row y to y + 1
    std::ptrdiff_t next_color = 0, next_depth = 0; ///< bytes from one sample to the next
    RowSpan* unresolved = nullptr; ///< columns drawn since the last resolve(), by GL row, from row 0 up
};

/// The position of a sample in its pixel, in 1/256 pixel from its lower left corner. No two samples share a
/// row, a column or a quadrant.
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
/// Clears the samples, if the surface has any. After a full clear all samples are equal, so no pixel needs
/// resolving.
void clear_samples(const Surface& s, const ClearRequest& request);

/// Sets the colours of pixels to the mean of their samples, component by component in stored bits, halves
/// rounded up. Pixels to which nothing was drawn since the last call do not change.
void resolve(const Surface& s);
#else
inline void clear_samples(const Surface& s, const ClearRequest& request) {
    clear(s, request);
}
inline void resolve(const Surface&) {}
#endif

} // namespace spangle::raster
