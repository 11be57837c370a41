// Which group of a pixel rectangle a fragment belongs to: GL's exact rule, for any raster position and zoom
// (GL 1.3, 3.6.4).
#pragma once

#include <cstdint>

#include "raster/numeric/real.hpp"

namespace spangle::gl {

/// floor(at - origin + 2^-13) of window coordinates: the corner of a bitmap (GL 1.3, 3.7), at most 2^27;
/// exact where both are less than 2^26. What a transformed raster position misses of a whole number, less
/// than 2^-15 on the largest viewport, moves no bit. `ahead` is added, in 2^-12.
std::int32_t whole_pixels(numeric::Real at, numeric::Real origin, std::int32_t ahead = 0);

/// Pixels or groups [begin, end); none where they are equal.
struct Interval {
    std::int32_t begin, end;
};

/// The part of [at, at + size), size >= 0, that lies in [low, high).
Interval inside(std::int32_t at, std::int32_t size, std::int32_t low, std::int32_t high);

/// One axis. Group n covers the fragments whose centre lies in [at + zoom n, at + zoom (n + 1)), or with a
/// negative zoom in [at + zoom (n + 1), at + zoom n). All numbers have 32 fraction bits: those of floats from
/// 2^-9 on lose nothing, of smaller ones the nearest 2^-32 counts.
class ZoomAxis {
  public:
    /// `shift` moves all of it, in 1/256 pixel.
    ZoomAxis(numeric::Real at, numeric::Real zoom, std::int32_t shift = 0);

    /// Nothing is drawn.
    bool is_empty() const { return zoom_ == 0; }
    /// Each group covers one fragment, in their order.
    bool is_one() const { return zoom_ == std::int64_t{1} << 32; }

    using Range = Interval; ///< of fragments
    /// Of groups [first, last), as far as they lie in [low, high), of coordinates that a surface has.
    Range covered(std::int32_t first, std::int32_t last, std::int32_t low, std::int32_t high) const;

    /// Groups of fragments that follow each other.
    class Walk {
      public:
        std::int32_t group() const { return static_cast<std::int32_t>(group_); }
        void step();

      private:
        friend class ZoomAxis;
        std::int64_t group_, rest_;      ///< what is asked for, and the remainder of the division
        std::int64_t whole_, part_, by_; ///< per fragment: groups and remainder; the divisor |zoom|
    };
    /// From a fragment that is covered.
    Walk from(std::int32_t fragment) const;

  private:
    std::int32_t first_fragment(std::int32_t group) const;

    std::int64_t at_, zoom_;
};

} // namespace spangle::gl
