// Exact tier: planes of attributes through the vertices before they were snapped to 1/256 pixel.
//
// Coverage is that of the snapped vertices, so fragments may lie beyond the vertices of the planes, by up to
// half a step in x and in y. The functions of this file keep this from being seen. Attributes that would
// leave the range of the numbers in which stages hold them go through the snapped vertices, as in the other
// tiers.
#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

using numeric::abs_u32;
using numeric::clz32;

namespace {

/// Returns (d + rest / 2^16) 2^up: `d` is a difference of snapped coordinates, and `rest` the difference of
/// what snapping took off them.
std::int32_t with_rest(std::int32_t d, std::int32_t rest, int up) {
    const std::int32_t fine = up >= 16 ? rest * (1 << (up - 16)) : rest >> (16 - up);
    return d * (1 << up) + fine;
}

/// The way from v - rest to the centre of its pixel, in 2^-16 of a step.
std::int32_t to_center(std::int32_t v, std::int32_t rest) {
    return (subpixel_one / 2 - (v & (subpixel_one - 1))) * 65536 - rest;
}

/// The largest beyond_ that planes may have. With more, planes say little about the area between the
/// vertices.
constexpr std::uint32_t most_beyond = 1u << 28; // 1/16

} // namespace

/// Makes by() the coefficients of planes through three unsnapped vertices. Returns false where these vertices
/// are so near to one line that only planes through the snapped vertices are possible.
SPANGLE_INLINE bool Setup<Fixed>::unsnap_plane() {
    const Vertex &a = v(0), &b = v(1), &c = v(2);
    // Vertices are sorted by y, so y2 >= |y1|.
    const std::int32_t y2 = c.y - a.y, y1 = a.y - b.y, x2 = a.x - c.x, x1 = b.x - a.x;
    // The rests of two vertices are half a step each and sum to at most one step. Even then |d| 2^up is less
    // than 2^31.
    const int up = clz32(static_cast<std::uint32_t>(y2) | abs_u32(x2) | abs_u32(x1)) - 2;
    const std::int32_t ry2 = c.y_rest - a.y_rest, ry1 = a.y_rest - b.y_rest, rx2 = a.x_rest - c.x_rest,
                       rx1 = b.x_rest - a.x_rest;
    std::int32_t d[4];
    if (up >= 16) [[likely]] { // the triangle lies within 64 pixels
        const int more = up - 16;
        d[0] = (y2 * 65536 + ry2) * (1 << more), d[1] = (y1 * 65536 + ry1) * (1 << more);
        d[2] = (x2 * 65536 + rx2) * (1 << more), d[3] = (x1 * 65536 + rx1) * (1 << more);
    } else {
        d[0] = with_rest(y2, ry2, up), d[1] = with_rest(y1, ry1, up);
        d[2] = with_rest(x2, rx2, up), d[3] = with_rest(x1, rx1, up);
    }
    const std::int64_t area = numeric::mul_long(d[3], d[0]) - numeric::mul_long(d[2], d[1]);
    const std::uint64_t size = numeric::abs_u64(area);
    // One of the differences has at least 29 bits. So the upper word of the area is 0 only if the vertices
    // are nearly on one line.
    const auto high = static_cast<std::uint32_t>(size >> 32);
    if (high == 0)
        return false;
    const int zeros = clz32(high);
    const std::uint32_t top = high << zeros | static_cast<std::uint32_t>(size) >> 1 >> (31 - zeros),
                        reciprocal = numeric::reciprocal(top);
    // A fragment lies at most half a step beyond the vertices in x and in y. So an attribute goes beyond by
    // half of the sum of these differences over the area; y1 counts as y2.
    const std::uint32_t half_sum = abs_u32(d[0]) + (1u << up) + (abs_u32(d[2]) >> 1) + (abs_u32(d[3]) >> 1);
    const int exponent = 54 - up - zeros; // d/area per pixel is c 2^-exponent
    const auto down = static_cast<std::uint32_t>(exponent - 24);
    if (down > 31)
        return false;
    beyond_ = (numeric::mul_high_u32(half_sum, reciprocal) >> down) + 1;
    if (beyond_ > most_beyond)
        return false;
    const auto inverse = static_cast<std::int32_t>(reciprocal - (reciprocal >> 31));
    const std::int32_t signed_inverse = area < 0 ? -inverse : inverse;
    const std::int32_t ox = to_center(a.x, a.x_rest), oy = to_center(a.y, a.y_rest);
    for (int i = 0; i < 2; ++i) {
        const std::int32_t dx = numeric::mul_high_s32(d[i], signed_inverse),
                           dy = numeric::mul_high_s32(d[2 + i], signed_inverse);
        by().dx[i] = dx;
        by().dy[i] = dy;
        by().center[i] = static_cast<std::int32_t>( // the sum of both products is below 2^55
            (numeric::mul_long(dx, ox) + numeric::mul_long(dy, oy)) >> (subpixel_bits + 16));
    }
    by().exponent = exponent;
    return true;
}

/// Does what unsnap_plane() does, along an axis. An end that was moved to a fragment (detail::LineInterval)
/// has no rest.
bool Setup<Fixed>::unsnap_axis() {
    const Vertex &a = v(0), &b = v(1);
    const bool x = axis_.of_x;
    const std::int32_t begin_rest = axis_.begin == (x ? a.x : a.y) ? (x ? a.x_rest : a.y_rest) : 0,
                       end_rest = axis_.end == (x ? b.x : b.y) ? (x ? b.x_rest : b.y_rest) : 0;
    const std::int32_t length = axis_.end - axis_.begin;
    // Both ends together move by at most one step, which may be a 16th of the length.
    if ((begin_rest | end_rest) == 0 || abs_u32(length) < 16)
        return false;
    const int up = clz32(abs_u32(length)) - 2;
    const std::int32_t fine = with_rest(length, end_rest - begin_rest, up);
    const std::uint32_t size = abs_u32(fine);
    const int zeros = clz32(size);
    const std::uint32_t reciprocal = numeric::reciprocal(size << zeros);
    beyond_ = (reciprocal >> (32 - up - zeros)) + 1;
    // PerPixel wants the leading zeros of the length in whole subpixels. `fine` has `up` bits more.
    const PerPixel per_pixel(reciprocal, up + zeros, fine < 0);
    (axis_.along_x ? by().dx[0] : by().dy[0]) = per_pixel.coefficient;
    by().exponent = per_pixel.exponent;
    by().center[0] = static_cast<std::int32_t>(
        numeric::mul_long(per_pixel.coefficient, to_center(axis_.begin, begin_rest)) >> (subpixel_bits + 16));
    return true;
}

/// Whether colours lie so little beyond 0 and 1 that they are stored as 0 and 1. Where only the top bits of a
/// plane count, the margin is 1/10 of a 255th: half of one is added, or thresholds are at least an eighth.
/// Elsewhere the margin is 2^-10 of a 255th. No colour has a larger range than `range`.
bool Setup<Fixed>::colors_stay_inside(std::uint32_t range) const {
    const bool tops = state_.variant[static_cast<unsigned>(Kind::affine)].color_bias != 1u << 15;
    const std::uint32_t margin = tops && !state_.textured_or_fogged ? color_one / 2550 : 1u << 10;
    if (numeric::mul_high_u32(range, beyond_) < margin)
        return true;
    bool inside = true;
    each_color<false>([&](const ColorSource& from, int i, auto&, auto&) {
        const Ends ends(static_cast<std::int32_t>(from.of[0][i]), static_cast<std::int32_t>(from.of[1][i]),
                        static_cast<std::int32_t>(from.of[2][i]));
        const auto more = static_cast<std::int32_t>(numeric::mul_high_u32(ends.range(), beyond_) + 1);
        const auto limit = static_cast<std::int32_t>(margin), one = static_cast<std::int32_t>(color_one);
        inside =
            inside && (ends.range() == 0 || (ends.low - more > -limit && ends.high + more < one + limit));
    });
    return inside;
}

/// Makes planes go through the unsnapped vertices. It is called after depth, and before all other attributes
/// are set up.
void Setup<Fixed>::unsnap() {
    const Vertex &a = v(0), &b = v(1), &c = v(2);
    beyond_ = 0;
    if ((a.x_rest | a.y_rest | b.x_rest | b.y_rest | c.x_rest | c.y_rest) != 0 &&
        !(&a == &c ? unsnap_axis() : unsnap_plane()))
        beyond_ = 0;
}

/// Makes all planes go through snapped vertices where 1/w would come near 0 beyond its least vertex.
void Setup<Fixed>::snap_where_w_ends() {
    if constexpr (has_division)
        if (beyond_ != 0 && numeric::mul_high_u32(q_range_, beyond_) > q_least_ - (q_least_ >> 3))
            snap();
}

} // namespace spangle::raster
