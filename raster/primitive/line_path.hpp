// Makes paths of lines: the places of their fragments, and their depths. L holds several lines side by side,
// or one.
#pragma once

#include <bit>

#include "raster/primitive/diamond.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/span/path.hpp"

namespace spangle::raster {

/// The interval along which attributes run on the major axis, in subpixels, from one end of the line to the
/// other. Where the centre of the first or last fragment lies beyond an end, the end is moved there
/// (detail::LineInterval).
template <class Int> struct PathInterval {
    Int begin, end;
    Int from_begin; ///< distance from the pixel of `begin` to the first fragment
};

/// Stores path i, for lines that have fragments. With lanes it stores the next paths of the vector, too.
template <class L, class Line>
SPANGLE_INLINE PathInterval<typename L::Int> set_path(Paths& paths, int i, const Line& line,
                                                      std::int32_t pixels_per_row) {
    using Int = typename L::Int;
    Int remainder;
    const Int minor = line.first(remainder), denominator = line.length() * subpixel_one;
    const auto falls = L::less(line.rise, Int{});
    const Int row = Int{} + pixels_per_row;
    Int along = Int{} + 1, across = row, x = line.major, y = minor;
    const auto along_y = L::no(line.along_x);
    L::exchange(along_y, along, across);
    L::exchange(along_y, x, y);
    const auto store = [&](Paths::Word word, Int v) { L::store(&paths.at(word, i), v); };
    using Word = typename L::Word;
    store(Paths::first,
          std::bit_cast<Int>(std::bit_cast<Word>(y) * std::bit_cast<Word>(row) + std::bit_cast<Word>(x)));
    store(Paths::along, along);
    store(Paths::aside, L::negate(falls, across));
    store(Paths::rest, L::select(falls, Int(-1 - remainder), Int(remainder - denominator)));
    store(Paths::rise, L::negate(falls, line.rise) * subpixel_one);
    store(Paths::denominator, denominator);
    const Int first = line.center(line.major), last = line.center(line.major + line.count - 1);
    Int begin = L::select(L::less(first, line.low), first, line.low),
        end = L::select(L::less(line.high, last), last, line.high);
    L::exchange(L::no(line.ascends), begin, end);
    return {begin, end, line.major - (begin >> subpixel_bits)};
}

/// Stores the depth of path i from the code of the first end and half the difference to the code of the
/// second end. Setup finds the same values in more steps.
SPANGLE_INLINE void set_path_depth(Paths& paths, int i, std::uint32_t from, std::int32_t difference,
                                   const PerPixel& per_pixel, std::int32_t begin, std::int32_t from_begin) {
    const auto part = [&](std::int32_t coefficient) {
        return scaled_word(numeric::mul_s32(difference, coefficient), per_pixel.exponent - 1);
    };
    const std::uint32_t step = part(per_pixel.coefficient);
    paths.at(Paths::depth_step, i) = static_cast<std::int32_t>(step);
    paths.at(Paths::depth, i) = static_cast<std::int32_t>(
        from + (1u << 15) + part(per_pixel.to_center(begin)) + static_cast<std::uint32_t>(from_begin) * step);
}

} // namespace spangle::raster
