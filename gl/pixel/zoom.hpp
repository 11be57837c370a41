// Finds the group of a pixel rectangle that a fragment belongs to. The result follows GL's rule exactly, for
// any raster position and zoom (GL 1.3, 3.6.4).
#pragma once

#include <cstdint>

#include "raster/numeric/real.hpp"

namespace spangle::gl {

/// Returns the corner of a bitmap in window coordinates: floor(at - origin + ahead / 2^12 + 2^-13) (GL 1.3,
/// 3.7). The result is at most 2^27, and exact if both numbers are below 2^26. A transformed raster position
/// misses whole numbers by less than 2^-15 on the largest viewport. The added 2^-13 therefore keeps bits in
/// place.
std::int32_t whole_pixels(numeric::Real at, numeric::Real origin, std::int32_t ahead = 0);

/// Pixels or groups [begin, end); empty if they are equal.
struct Interval {
    std::int32_t begin, end;
};

/// The part of [at, at + size), size >= 0, that lies in [low, high).
Interval clip_interval(std::int32_t at, std::int32_t size, std::int32_t low, std::int32_t high);

/// One axis of a zoomed rectangle. Group n covers the fragments whose centre lies in [at + zoom n, at + zoom
/// (n + 1)), or for a negative zoom in [at + zoom (n + 1), at + zoom n). All numbers have 32 fraction bits:
/// floats of at least 2^-9 are exact, and smaller ones are rounded to a multiple of 2^-32.
class ZoomAxis {
  public:
    /// `shift` moves the whole rectangle, in 1/256 pixel.
    ZoomAxis(numeric::Real at, numeric::Real zoom, std::int32_t shift = 0);

    /// Whether the zoom is 0, so that nothing is drawn.
    bool is_empty() const { return zoom_ == 0; }
    /// Whether the zoom is 1, so that each group covers one fragment, in order.
    bool is_unit_zoom() const { return zoom_ == std::int64_t{1} << 32; }

    using Range = Interval; ///< a range of fragments
    /// Returns the fragments that groups [first, last) cover and that lie in [low, high) on the surface.
    Range covered_fragments(std::int32_t first, std::int32_t last, std::int32_t low, std::int32_t high) const;

    /// Steps from fragment to fragment, and says which group each belongs to.
    class GroupWalk {
      public:
        std::int32_t group() const { return static_cast<std::int32_t>(group_); }
        void step();

      private:
        friend class ZoomAxis;
        std::int64_t group_, remainder_; ///< the present group, and the remainder of the division
        std::int64_t step_quotient_, step_remainder_,
            divisor_; ///< a step of one fragment, divided by |zoom|, which is the divisor
    };
    /// A walk that begins at a fragment, which must be covered.
    GroupWalk from(std::int32_t fragment) const;

  private:
    std::int32_t first_fragment(std::int32_t group) const;

    std::int64_t origin_, zoom_;
};

} // namespace spangle::gl
