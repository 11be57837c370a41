// The rectangle around a line (GL 1.3, 3.4.2, 3.4.4): it is as wide as the line and reaches from end to end.
// A stipple leaves parts of length 1 of it.
#pragma once

#include "raster/numeric/bits.hpp"
#include "raster/numeric/reciprocal.hpp"
#include "raster/numeric/rsqrt.hpp"
#include "raster/primitive/area.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/primitive/line_stipple.hpp"

namespace spangle::raster {

namespace detail {

/// floor(sqrt(v)). The inverse root of the upper half of v is off by less than 2^-29. The root made from it
/// is then corrected in steps of 1.
constexpr std::uint32_t integer_sqrt(std::uint64_t v) {
    if (v == 0)
        return 0;
    const int zeros = numeric::clz64(v) & ~1;
    const auto top = static_cast<std::uint32_t>((v << zeros) >> 32);
    std::uint64_t root = (numeric::mul_u32(top, numeric::rsqrt(top)) >> 30) >> (zeros / 2);
    root = root < UINT32_MAX ? root : UINT32_MAX;
    while (root * root > v)
        --root;
    while (v - root * root > 2 * root)
        ++root;
    return static_cast<std::uint32_t>(root);
}

/// Rounds a point to the grid of vertices, clamped to the guard band.
constexpr Position snapped(const OutlinePoint& p) {
    constexpr int down = outline_bits - subpixel_bits;
    constexpr std::int32_t half = 1 << (down - 1);
    const auto inside = [](std::int32_t v) {
        return numeric::clamp((v + half) >> down, 1 - guard_band, guard_band - 1);
    };
    return {inside(p.x), inside(p.y)};
}

} // namespace detail

/// The rectangle around a line, and parts of it.
class LineOutline {
  public:
    LineOutline(const Position& a, const Position& b, std::int32_t eighths)
        : start_(outline_point(a)), dx_(std::int64_t{b.x} - a.x), dy_(std::int64_t{b.y} - a.y),
          length_(detail::integer_sqrt(static_cast<std::uint64_t>(dx_ * dx_ + dy_ * dy_) << 16)) {
        constexpr std::int64_t up = std::int64_t{outline_one} * subpixel_one / 16;
        half_width_ = length_ == 0 ? OutlinePoint{}
                                   : OutlinePoint{divide_by_length(-dy_ * eighths * up),
                                                  divide_by_length(dx_ * eighths * up)};
    }
    bool empty() const { return length_ == 0; }
    /// The number of parts of length 1, of which the last may be shorter.
    std::uint32_t parts() const { return static_cast<std::uint32_t>((length_ + one - 1) / one); }
    /// Calls draw(begin, end) for each stretch of parts that the stipple leaves, or for the whole line
    /// without a stipple. The stipple does not advance.
    template <class Draw> void each_stippled_part(const LineStipple* stipple, Draw draw) const {
        for (std::uint32_t begin = 0, end, n = parts(); begin < n; begin = end) {
            const bool kept = stipple == nullptr || stipple->at(stipple->position + begin);
            end = stipple == nullptr ? n : begin + 1;
            while (end < n && stipple->at(stipple->position + end) == kept)
                ++end;
            if (kept)
                draw(begin, end);
        }
    }
    /// The corners of the rectangle from the beginning of part `begin` to that of part `end`.
    void corners(std::uint32_t begin, std::uint32_t end, OutlinePoint (&out)[4]) const {
        rectangle_around(begin * one, end * one < length_ ? end * one : length_, 1, out);
    }
    /// The corners of a rectangle twice as wide as that of corners(), which is longer at the ends of the
    /// line. Only the cuts between parts bound it.
    void strip(std::uint32_t begin, std::uint32_t end, OutlinePoint (&out)[4]) const {
        rectangle_around(begin == 0 ? -one : begin * one, end * one < length_ ? end * one : length_ + one, 2,
                         out);
    }

  private:
    static constexpr std::int64_t one = std::int64_t{subpixel_one} << 8; ///< length_ of one pixel
    void rectangle_around(std::int64_t begin, std::int64_t end, std::int32_t widths,
                          OutlinePoint (&out)[4]) const {
        const OutlinePoint a = at(begin), b = at(end),
                           aside = {half_width_.x * widths, half_width_.y * widths};
        out[0] = {a.x - aside.x, a.y - aside.y};
        out[1] = {b.x - aside.x, b.y - aside.y};
        out[2] = {b.x + aside.x, b.y + aside.y};
        out[3] = {a.x + aside.x, a.y + aside.y};
    }
    OutlinePoint at(std::int64_t way) const {
        constexpr int up = outline_one / subpixel_one;
        return {start_.x + divide_by_length(dx_ * up * way), start_.y + divide_by_length(dy_ * up * way)};
    }
    /// v / length_, which is a word without sign.
    std::int32_t divide_by_length(std::int64_t v) const {
        return static_cast<std::int32_t>(numeric::quotient(v, static_cast<std::uint32_t>(length_)));
    }

    OutlinePoint start_;
    std::int64_t dx_, dy_; ///< direction of the line, in subpixels
    std::int64_t length_;  ///< subpixels with 8 more bits
    OutlinePoint half_width_{};
};

/// The corners of the rectangle as vertices. Attributes vary along the line, and not across it.
template <class V> struct LineCorners {
    V at[4];
    LineCorners(const LineOutline& line, const V& a, const V& b) : at{a, b, b, a} {
        OutlinePoint outline[4];
        line.corners(0, line.parts(), outline);
        for (int i = 0; i < 4; ++i)
            place(at[i], detail::snapped(outline[i]));
    }
};

} // namespace spangle::raster
