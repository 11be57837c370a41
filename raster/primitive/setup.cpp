#include "raster/primitive/setup.hpp"

#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/setup_math.hpp"

namespace spangle::raster {

using numeric::abs_u32;
using numeric::clz32;

// --- geometry

/// The anchor: the pixel that the lowest vertex (x, y) lies in.
SPANGLE_INLINE void Setup<Fixed>::start(std::int32_t x, std::int32_t y) {
    span_.anchor_x = x >> subpixel_bits;
    span_.anchor_y = y >> subpixel_bits;
    const std::int32_t ox = subpixel_one / 2 - (x & (subpixel_one - 1));
    const std::int32_t oy = subpixel_one / 2 - (y & (subpixel_one - 1));
    for (int i = 0; i < 2; ++i) // |cx ox + cy oy| <= 2^30 256
        center_[i] = static_cast<std::int32_t>((std::int64_t{cx_[i]} * ox + std::int64_t{cy_[i]} * oy) >>
                                               subpixel_bits);
}

void Setup<Fixed>::along_axis(const Vertex& from, const Vertex& to, bool along_x, std::int32_t begin,
                              std::int32_t end) {
    v_[0] = v_[2] = &from;
    v_[1] = &to;
    cx_[0] = cx_[1] = cy_[0] = cy_[1] = 0;
    const PerPixel per_pixel(begin, end);
    (along_x ? cx_[0] : cy_[0]) = per_pixel.coefficient;
    exponent_ = per_pixel.exponent;
    start(along_x ? begin : from.x, along_x ? from.y : begin);
}

SPANGLE_INLINE void Setup<Fixed>::in_plane(std::int64_t area2) {
    const std::uint64_t area = numeric::abs_u64(area2);
    const auto high = static_cast<std::uint32_t>(area >> 32), low = static_cast<std::uint32_t>(area);
    const int zeros = high == 0 ? 32 + clz32(low) : clz32(high);
    const std::uint32_t top =
        high == 0 ? low << (zeros - 32) : static_cast<std::uint32_t>((area << zeros) >> 32);
    // 1 / area2 = inverse 2^(zeros - 94); 2^31 itself is off by 2^-31 of its value
    const std::uint32_t reciprocal = numeric::reciprocal(top);
    const auto inverse = static_cast<std::int32_t>(reciprocal - (reciprocal >> 31));
    const std::int32_t signed_inverse = area2 < 0 ? -inverse : inverse;
    const std::int32_t y2 = v_[2]->y - v_[0]->y, y1 = v_[0]->y - v_[1]->y;
    const std::int32_t x2 = v_[0]->x - v_[2]->x, x1 = v_[1]->x - v_[0]->x;
    const int up = clz32(abs_u32(y2) | abs_u32(y1) | abs_u32(x2) | abs_u32(x1)) - 1; // |d| 2^up < 2^31
    const auto coefficient = [&](std::int32_t d) {
        return numeric::mul_high_s32(static_cast<std::int32_t>(static_cast<std::uint32_t>(d) << up),
                                     signed_inverse);
    };
    cx_[0] = coefficient(y2);
    cx_[1] = coefficient(y1);
    cy_[0] = coefficient(x2);
    cy_[1] = coefficient(x1);
    exponent_ = 54 + up - zeros; // 256 d / area2 = c 2^-exponent
    start(v_[0]->x, v_[0]->y);
}

Setup<Fixed>::Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& c,
                    const Vertex& provoking, std::int64_t area2)
    : span_(span), state_(*span.state), v_{&a, &b, &c} {
    const std::uint32_t width = range_of(a.x, b.x, c.x);
    const auto height = static_cast<std::uint32_t>(c.y - a.y);
    const auto thin = static_cast<std::uint64_t>(thin_aspect);
    if (std::uint64_t{width} * height > thin * numeric::abs_u64(area2)) {
        if (width <= height) {
            along_axis(a, c, false, a.y, c.y);
        } else {
            const Vertex* left = b.x < a.x ? &b : &a;
            const Vertex* right = b.x < a.x ? &a : &b;
            left = c.x < left->x ? &c : left;
            right = c.x > right->x ? &c : right;
            along_axis(*left, *right, true, left->x, right->x);
        }
    } else {
        in_plane(area2);
    }
    attributes(provoking);
}

Setup<Fixed>::Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& provoking,
                    bool along_x, std::int32_t begin, std::int32_t end)
    : span_(span), state_(*span.state) {
    along_axis(a, b, along_x, begin, end);
    attributes(provoking);
}

Setup<Fixed>::Setup(Span<Fixed>& span, const Vertex& v) : Setup(span, v, v, v, true, v.x, v.x) {}

// --- planes

/// Differences counted in 2^(exponent - up) of the unit of v.
SPANGLE_INLINE Setup<Fixed>::Gradient Setup<Fixed>::gradient(std::int32_t v0, std::int32_t v1,
                                                             std::int32_t v2) const {
    const std::int32_t d1 = v1 - v0, d2 = v2 - v0;
    return {std::int64_t{d1} * cx_[0] + std::int64_t{d2} * cx_[1],
            std::int64_t{d1} * cy_[0] + std::int64_t{d2} * cy_[1],
            std::int64_t{d1} * center_[0] + std::int64_t{d2} * center_[1]};
}

SPANGLE_INLINE Setup<Fixed>::Gradient Setup<Fixed>::affine(Interpolant<std::uint32_t>& at,
                                                           std::uint32_t first, std::int32_t v0,
                                                           std::int32_t v1, std::int32_t v2, int up) {
    const Gradient g = gradient(v0, v1, v2);
    const int n = exponent_ - up;
    at.value = first + scaled_word(g.center, n);
    at.dx = scaled_word(g.dx, n);
    at.dy = scaled_word(g.dy, n);
    return g;
}

Setup<Fixed>::Slope Setup<Fixed>::add_affine(Interpolant<std::uint32_t>& at, std::uint32_t first,
                                             const std::int32_t v[3], int up) {
    const Gradient g = affine(at, first, v[0], v[1], v[2], up);
    return {static_cast<std::uint64_t>(scaled(g.dx, exponent_ - up)),
            static_cast<std::uint64_t>(scaled(g.dy, exponent_ - up))};
}

std::uint64_t Setup<Fixed>::add_projective(Interpolant<std::uint64_t>& at, const std::int32_t v[3]) {
    const Gradient g = gradient(v[0], v[1], v[2]);
    const int n = exponent_ - guard_bits;
    at.value = (static_cast<std::uint64_t>(std::int64_t{v[0]}) << guard_bits) +
               static_cast<std::uint64_t>(scaled(g.center, n));
    at.dx = static_cast<std::uint64_t>(scaled(g.dx, n));
    at.dy = static_cast<std::uint64_t>(scaled(g.dy, n));
    return at.dy;
}

// --- attributes

void Setup<Fixed>::add_depth() {
    // k + 1/2 for a code k in the top bits; z31 has half of its last bit.
    const int bits = state_.depth_format == DepthFormat::z16 ? 16 : 24;
    std::uint32_t z0 = depth_code(v_[0]->z, bits), z1 = depth_code(v_[1]->z, bits),
                  z2 = depth_code(v_[2]->z, bits);
    if (bits == 24) {
        // Half a code is less than the error of a steep plane may be: keep slopes so far from both ends that
        // no value wraps. A constant depth stays as it is.
        const std::uint32_t range =
            range_of(static_cast<std::int32_t>(z0 >> 1), static_cast<std::int32_t>(z1 >> 1),
                     static_cast<std::int32_t>(z2 >> 1));
        const std::uint32_t margin = range == 0 ? 0 : (range >> 16) + (1u << 11);
        const std::uint32_t highest = 0xFFFFFF00u - margin;
        z0 = numeric::clamp(z0, margin, highest);
        z1 = numeric::clamp(z1, margin, highest);
        z2 = numeric::clamp(z2, margin, highest);
    }
    affine(span_.z, z0 + (1u << (31 - bits)), static_cast<std::int32_t>(z0 >> 1),
           static_cast<std::int32_t>(z1 >> 1), static_cast<std::int32_t>(z2 >> 1), 1);
}

/// `count` colour components of the three vertices.
void Setup<Fixed>::add_colors(const ColorSource& from, Span<Fixed>::Affine* at, Span<Fixed>::Projective* at_q,
                              int count) {
    if (span_.kind == Kind::full) {
        for (int i = 0; i < count; ++i) {
            std::int32_t over_w[3];
            for (int k = 0; k < 3; ++k)
                over_w[k] = mul30(static_cast<std::int32_t>(from.of[k][i] << 2), q_[k]);
            add_projective(at_q[i], over_w);
        }
        return;
    }
    const std::uint32_t bias = state_.variant[static_cast<unsigned>(span_.kind)].color_bias;
    constexpr int up = 24 - color_fraction_bits;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t first = from.of[0][i];
        affine(at[i], (first << up) + bias, static_cast<std::int32_t>(first),
               static_cast<std::int32_t>(from.of[1][i]), static_cast<std::int32_t>(from.of[2][i]), up);
    }
}

/// 1/w of the reference vertices with one exponent, and its range; true when it does not vary.
bool Setup<Fixed>::weights() {
    const int e0 = v_[0]->w_exponent, e1 = v_[1]->w_exponent, e2 = v_[2]->w_exponent;
    const int highest = e0 > e1 ? (e0 > e2 ? e0 : e2) : (e1 > e2 ? e1 : e2);
    if (e0 == e1 && e0 == e2) { // mantissas have their top bit
        for (int i = 0; i < 3; ++i)
            q_[i] = static_cast<std::int32_t>(v_[i]->w_mantissa >> 2);
    } else {
        const auto scaled = [&](int i, int e) {
            const int down = 2 + highest - e;
            const std::uint32_t q = down < 32 ? v_[i]->w_mantissa >> down : 0;
            return static_cast<std::int32_t>(q != 0 ? q : 1);
        };
        q_[0] = scaled(0, e0);
        q_[1] = scaled(1, e1);
        q_[2] = scaled(2, e2);
    }
    q_range_ = range_of(q_[0], q_[1], q_[2]);
    const std::int32_t least = q_[0] < q_[1] ? q_[0] : q_[1];
    q_least_ = static_cast<std::uint32_t>(least < q_[2] ? least : q_[2]);
    return q_range_ == 0;
}

SPANGLE_INLINE void Setup<Fixed>::constant_colors(const Vertex& painted) {
    const std::uint32_t bias = state_.variant[static_cast<unsigned>(span_.kind)].color_bias;
    constexpr int up = 24 - color_fraction_bits;
    for (int i = 0; i < 4; ++i)
        span_.color_value[i] = {(painted.color[i] << up) + bias, 0, 0};
    for (int i = 0; i < 3; ++i)
        span_.secondary[i] = {(painted.secondary[i] << up) + bias, 0, 0};
}

// --- the cheapest kind within the tier's bounds

/// |error| of the affine form over a triangle is at most range(c) range(q) / (4 min(q)): the covariance of c
/// and q under any weights, over the mean of q.
bool Setup<Fixed>::bounded(std::uint32_t range, std::uint64_t four_tolerances) const {
    return numeric::mul_u32(range, q_range_) <= four_tolerances * q_least_;
}

bool Setup<Fixed>::colors_affine() const {
    if (state_.tier == Tier::fast)
        return true;
    // Exact: 2^-19 of full scale. Balanced: a quarter of a step of the target.
    const std::uint64_t four = state_.tier == Tier::exact                   ? color_one >> 17
                               : format_info(state_.format).green_bits == 8 ? 1u << color_fraction_bits
                                                                            : 4u << color_fraction_bits;
    std::uint32_t widest = 0;
    const auto widen = [&](const ColorSource& from, int count) {
        for (int i = 0; i < count; ++i) {
            const std::uint32_t range =
                range_of(static_cast<std::int32_t>(from.of[0][i]), static_cast<std::int32_t>(from.of[1][i]),
                         static_cast<std::int32_t>(from.of[2][i]));
            widest = range > widest ? range : widest;
        }
    };
    widen(primary(), state_.needs.alpha ? 4 : 3);
    if (state_.needs.secondary)
        widen(secondary(), 3);
    return bounded(widest, four);
}

/// All three vertices have the same colours, as far as they are looked at.
bool Setup<Fixed>::same_colors() const {
    const Needs& needs = state_.needs;
    const auto same = [](const ColorSource& from, int count) {
        for (int i = 0; i < count; ++i)
            if (from.of[0][i] != from.of[1][i] || from.of[0][i] != from.of[2][i])
                return false;
        return true;
    };
    return (!needs.rgb || same(primary(), needs.alpha ? 4 : 3)) && (!needs.secondary || same(secondary(), 3));
}

/// With neither textures nor fog.
SPANGLE_INLINE void Setup<Fixed>::plain(const Vertex& painted) {
    const bool one_color = state_.fragment.flat || same_colors();
    Kind kind = Kind::affine;
    if (one_color)
        kind = state_.variant[0].run != nullptr ? Kind::flat : Kind::affine;
    else if (state_.fragment.perspective && !weights() && q_range_ > q_least_ >> state_.affine_color_shift &&
             !colors_affine())
        kind = Kind::full;
    span_.kind = kind;
    if (state_.needs.z)
        add_depth();
    if (kind == Kind::full)
        span_.q_dy = add_projective(span_.q, q_);
    if (kind == Kind::flat)
        span_.flat_word = word565(painted.color);
    else
        colors(one_color, painted);
}

void Setup<Fixed>::colors(bool one_color, const Vertex& painted) {
    if (one_color)
        return constant_colors(painted);
    const Needs& needs = state_.needs;
    if (needs.rgb)
        add_colors(primary(), span_.color_value, span_.color_q, needs.alpha ? 4 : 3);
    if (needs.secondary)
        add_colors(secondary(), span_.secondary, span_.secondary_q, 3);
}

void Setup<Fixed>::attributes(const Vertex& provoking) {
    // One colour is, in smooth shading, the one its corners share: the provoking vertex need not be a corner
    // (quads and clipped polygons are drawn in parts).
    const Vertex& painted = state_.fragment.flat ? provoking : *v_[0];
    if (state_.textured_or_fogged)
        with_coordinates(painted);
    else
        plain(painted);
}

} // namespace spangle::raster
