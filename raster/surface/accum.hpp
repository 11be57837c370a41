// The accumulation buffer (GL 1.3, 4.2.4): sums of pictures, k / 32767 in 16 bits, saturated.
#pragma once

#include <cstdint>

#include "raster/surface/surface.hpp"

namespace spangle::raster {

inline constexpr std::int32_t accum_one = 32767;

/// Fraction bits of `value` in an AccumRequest. They are as many as can still change the buffer, or a colour
/// for give_back.
inline constexpr int accum_value_bits = 20, accum_return_bits = 16;

/// An operation on the accumulation buffer of a surface. If the surface has samples, sums read the resolved
/// colours, and give_back writes every sample.
struct AccumRequest {
    enum class Op : std::uint8_t { clear, accumulate, load, multiply, add, give_back };
    Op op = Op::clear;
    std::uint8_t channels = 0; ///< for give_back: bits of the channels that it writes
    bool dither = false;       ///< for give_back: whether it dithers
    Rect area;                 ///< lies inside the surface; the source may hold a part of it; may be empty
    std::int32_t value = 0;    ///< the factor or summand v of all operations except clear
    std::int16_t clear[4] = {};
};

/// Changes the pixels of the area, which lies in the surface:
///   clear       A := clear
///   accumulate  A := A + C v, where C is the colour of `source`, 0 .. 1
///   load        A := C v
///   multiply    A := A v
///   add         A := A + v
///   give_back   colour := A v (accum_return_bits), clamped to 0 .. 1, where `channels` (bit 0 red ...) are
///   open
void accum(const Surface& s, const AccumRequest& request, const Surface& source);

void clear_accum(const Surface& s, Rect area, const std::int16_t (&value)[4]);

} // namespace spangle::raster
