// Exact tier: planes of attributes through the vertices as they were before they were snapped to 1/256 pixel.
//
// Coverage stays that of the snapped vertices, so fragments may lie beyond the vertices that the planes go
// through, by up to half a step in x and in y. What follows keeps that from being seen: attributes that would
// leave the numbers which stages have for them go through the snapped vertices, as they do in the other
// tiers.
#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

using numeric::abs_u32;
using numeric::clz32;

namespace {

/// A difference of snapped coordinates and of their rests, times 2^up.
std::int32_t with_rest(std::int32_t d, std::int32_t rest, int up) {
    const std::int32_t fine = up >= 16 ? rest * (1 << (up - 16)) : rest >> (16 - up);
    return d * (1 << up) + fine;
}

/// From v - rest to the centre of its pixel, in 2^-16 of a step.
std::int32_t to_center(std::int32_t v, std::int32_t rest) {
    return (subpixel_one / 2 - (v & (subpixel_one - 1))) * 65536 - rest;
}

/// What a vertex may lie beyond the others, at most: more, and planes say little of what lies between them.
constexpr std::uint32_t most_beyond = 1u << 28; // 1/16

} // namespace

/// In place of by(), through three vertices. False: they are those of snapped vertices, or too near to one
/// line for any other.
bool Setup<Fixed>::unsnap_plane() {
    const Vertex &a = v(0), &b = v(1), &c = v(2);
    const std::int32_t y2 = c.y - a.y, y1 = a.y - b.y, x2 = a.x - c.x, x1 = b.x - a.x;
    // Half a step of two vertices is one: with it |d| 2^up is less than 2^31.
    const int up = clz32(static_cast<std::uint32_t>(y2) | abs_u32(y1) | abs_u32(x2) | abs_u32(x1)) - 2;
    const std::int32_t d[4] = {with_rest(y2, c.y_rest - a.y_rest, up), with_rest(y1, a.y_rest - b.y_rest, up),
                               with_rest(x2, a.x_rest - c.x_rest, up),
                               with_rest(x1, b.x_rest - a.x_rest, up)};
    const std::int64_t area = numeric::mul_long(d[3], d[0]) - numeric::mul_long(d[2], d[1]);
    const std::uint64_t size = numeric::abs_u64(area);
    const int zeros = numeric::clz64(size | 1);
    const std::uint32_t reciprocal = numeric::reciprocal(numeric::high_word_before(size | 1, zeros));
    // A fragment lies half a step beyond in x and in y at most, so half the sum of what differences are
    // there, over the area.
    std::uint32_t half_sum = 0;
    for (const std::int32_t of : d)
        half_sum += abs_u32(of) >> 1;
    const int exponent = 54 - up - zeros; // 256 d / area = c 2^-exponent
    const int down = exponent - 24;
    if (down < 0 || down > 31)
        return false;
    beyond_ = (numeric::mul_high_u32(half_sum, reciprocal) >> down) + 1;
    if (beyond_ > most_beyond)
        return false;
    const auto inverse = static_cast<std::int32_t>(reciprocal - (reciprocal >> 31));
    const std::int32_t signed_inverse = area < 0 ? -inverse : inverse;
    for (int i = 0; i < 2; ++i) {
        by().dx[i] = numeric::mul_high_s32(d[i], signed_inverse);
        by().dy[i] = numeric::mul_high_s32(d[2 + i], signed_inverse);
    }
    by().exponent = exponent;
    const std::int32_t ox = to_center(a.x, a.x_rest), oy = to_center(a.y, a.y_rest);
    for (int i = 0; i < 2; ++i) // |dx ox + dy oy| < 2^30 2^25
        by().center[i] = static_cast<std::int32_t>(
            (numeric::mul_long(by().dx[i], ox) + numeric::mul_long(by().dy[i], oy)) >> (subpixel_bits + 16));
    return true;
}

/// The same along an axis. Ends that were moved to a fragment (detail::LineInterval) have nothing taken off.
bool Setup<Fixed>::unsnap_axis() {
    const Vertex &a = v(0), &b = v(1);
    const bool x = axis_.of_x;
    const std::int32_t begin_rest = axis_.begin == (x ? a.x : a.y) ? (x ? a.x_rest : a.y_rest) : 0,
                       end_rest = axis_.end == (x ? b.x : b.y) ? (x ? b.x_rest : b.y_rest) : 0;
    const std::int32_t length = axis_.end - axis_.begin;
    // A step beyond 16 of them at most; half of one at either end.
    if ((begin_rest | end_rest) == 0 || abs_u32(length) < 16)
        return false;
    const int up = clz32(abs_u32(length)) - 2;
    const std::int32_t fine = with_rest(length, end_rest - begin_rest, up);
    const std::uint32_t size = abs_u32(fine);
    const int zeros = clz32(size);
    beyond_ = (1u << 31) / abs_u32(length) + 1;
    // PerPixel counts zeros of a length in steps.
    const PerPixel per_pixel(numeric::reciprocal(size << zeros), up + zeros, fine < 0);
    (axis_.along_x ? by().dx[0] : by().dy[0]) = per_pixel.coefficient;
    by().exponent = per_pixel.exponent;
    by().center[0] = static_cast<std::int32_t>(
        numeric::mul_long(per_pixel.coefficient, to_center(axis_.begin, begin_rest)) >> (subpixel_bits + 16));
    return true;
}

/// What colours may lie beyond 0 and 1, and be stored as these: where no more than the top bits of a plane
/// counts, 1/10 of a 255th (half of one is added, or thresholds are an eighth at least); else 2^-10.
bool Setup<Fixed>::colors_stay_inside(std::uint32_t color_bits) const {
    const bool tops = state_.variant[static_cast<unsigned>(Kind::affine)].color_bias != 1u << 15;
    const std::uint32_t margin = tops && !state_.textured_or_fogged ? color_one / 2550 : 1u << 10;
    // The range of three values is at most the sum of two differences.
    if (numeric::mul_high_u32(2 * color_bits, beyond_) < margin)
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

/// After depth, before all else. Of colours that would not stay inside: alone, or with what they are divided
/// by.
[[gnu::noinline]] void Setup<Fixed>::unsnap(std::uint32_t color_bits) {
    snapped_ = by();
    beyond_ = 0;
    colors_snapped_ = false;
    const Vertex &a = v(0), &b = v(1), &c = v(2);
    if ((a.x_rest | a.y_rest | b.x_rest | b.y_rest | c.x_rest | c.y_rest) == 0)
        return;
    if (!(&a == &c ? unsnap_axis() : unsnap_plane())) {
        beyond_ = 0;
        return;
    }
    if (color_bits == 0 || colors_stay_inside(color_bits))
        return;
    colors_snapped_ = true;
    if (!state_.textured_or_fogged) {
        by() = snapped_;
        beyond_ = 0;
    }
}

/// Where 1/w would come near 0 beyond its least vertex, all planes go through snapped vertices.
void Setup<Fixed>::snap_where_w_ends() {
    if constexpr (!has_division)
        return;
    if (beyond_ == 0 || numeric::mul_high_u32(q_range_, beyond_) <= q_least_ >> 2)
        return;
    by() = snapped_;
    beyond_ = 0;
}

} // namespace spangle::raster
