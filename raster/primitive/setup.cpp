#include "raster/primitive/setup.hpp"

#include "raster/numeric/reciprocal.hpp"

namespace spangle::raster {

namespace {

using numeric::abs_u32;
using numeric::clz32;
using numeric::clz64;

std::uint32_t range_of(std::int32_t a, std::int32_t b, std::int32_t c) {
    const std::int32_t low = a < b ? (a < c ? a : c) : (b < c ? b : c);
    const std::int32_t high = a > b ? (a > c ? a : c) : (b > c ? b : c);
    return static_cast<std::uint32_t>(high) - static_cast<std::uint32_t>(low);
}

/// v * 2^-n for any n, rounded to nearest on the way down, mod 2^64 on the way up.
SPANGLE_INLINE std::int64_t shift(std::int64_t v, int n) {
    if (n > 0)
        return n > 62 ? 0 : ((v >> (n - 1)) + 1) >> 1;
    return n < -63 ? 0 : static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << -n);
}

/// a * b / 2^30, rounded.
SPANGLE_INLINE std::int32_t mul30(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>((std::int64_t{a} * b + (1 << 29)) >> 30);
}

/// m * 2^exponent with `fraction` fraction bits, saturated below 2^61.
std::int64_t to_fixed(std::int64_t m, int exponent, int fraction) {
    const int up = exponent + fraction;
    if (up <= 0)
        return shift(m, -up < 62 ? -up : 62);
    constexpr std::int64_t limit = std::int64_t{1} << 61;
    if (m == 0)
        return 0;
    if (up >= clz64(numeric::abs_u64(m)) - 2)
        return m < 0 ? -limit : limit;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(m) << up);
}

std::int64_t least_of(const std::int64_t v[3]) {
    const std::int64_t ab = v[0] < v[1] ? v[0] : v[1];
    return ab < v[2] ? ab : v[2];
}

} // namespace

// --- geometry

void Setup<Fixed>::start() {
    span_.x = v_[0]->x >> subpixel_bits;
    span_.y = v_[0]->y >> subpixel_bits;
    ox_ = subpixel_one / 2 - (v_[0]->x & (subpixel_one - 1));
    oy_ = subpixel_one / 2 - (v_[0]->y & (subpixel_one - 1));
}

void Setup<Fixed>::along_axis(const Vertex& from, const Vertex& to, bool along_x, std::int32_t begin,
                              std::int32_t end) {
    v_[0] = v_[2] = &from;
    v_[1] = &to;
    cx_[0] = cx_[1] = cy_[0] = cy_[1] = 0;
    ex_ = ey_ = 1;
    start();
    (along_x ? span_.x : span_.y) = begin >> subpixel_bits;
    (along_x ? ox_ : oy_) = subpixel_one / 2 - (begin & (subpixel_one - 1));
    const std::uint32_t length = abs_u32(end - begin);
    if (length == 0)
        return;
    const int zeros = clz32(length);
    // 256 / length = mantissa 2^-(53 - zeros)
    const auto mantissa = static_cast<std::int32_t>(numeric::reciprocal(length << zeros) >> 1);
    (along_x ? cx_[0] : cy_[0]) = end < begin ? -mantissa : mantissa;
    (along_x ? ex_ : ey_) = 53 - zeros;
}

void Setup<Fixed>::in_plane(std::int64_t area2) {
    const std::uint64_t area = numeric::abs_u64(area2);
    const int zeros = clz64(area);
    // 1 / area2 = inverse 2^(zeros - 94)
    const auto inverse =
        static_cast<std::int64_t>(numeric::reciprocal(static_cast<std::uint32_t>((area << zeros) >> 32)));
    const std::int64_t signed_inverse = area2 < 0 ? -inverse : inverse;
    const auto coefficients = [&](std::int32_t d1, std::int32_t d2, std::int32_t c[2]) {
        const int up = clz32(abs_u32(d1) | abs_u32(d2)) - 2; // |d| 2^up < 2^30
        c[0] = static_cast<std::int32_t>((d1 * (std::int64_t{1} << up) * signed_inverse) >> 31);
        c[1] = static_cast<std::int32_t>((d2 * (std::int64_t{1} << up) * signed_inverse) >> 31);
        return 55 + up - zeros; // 256 d / area2 = c 2^-this
    };
    ex_ = coefficients(v_[2]->y - v_[0]->y, v_[0]->y - v_[1]->y, cx_);
    ey_ = coefficients(v_[0]->x - v_[2]->x, v_[1]->x - v_[0]->x, cy_);
    start();
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

void Setup<Fixed>::move_projective(std::uint32_t columns, std::uint32_t rows) {
    const auto right =
        static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<std::int32_t>(columns)));
    const auto up = static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<std::int32_t>(rows)));
    for (int i = 0; i < projective_count_; ++i)
        projective_[i].at->value += right * projective_[i].at->dx + up * projective_[i].dy;
}

// --- planes

/// v 2^-n rounded down (what that loses is below the last bit of an interpolant), mod 2^64 on the way up.
SPANGLE_INLINE static std::int64_t scaled(std::int64_t v, int n) {
    if (n >= 0) [[likely]]
        return v >> (n < 63 ? n : 63);
    return shift(v, n);
}

/// Per pixel, counted in 2^-up of the unit of v.
SPANGLE_INLINE Setup<Fixed>::Gradient Setup<Fixed>::gradient(const std::int32_t v[3], int up) const {
    const std::int32_t d1 = v[1] - v[0], d2 = v[2] - v[0];
    return {scaled(std::int64_t{d1} * cx_[0] + std::int64_t{d2} * cx_[1], ex_ - up),
            scaled(std::int64_t{d1} * cy_[0] + std::int64_t{d2} * cy_[1], ey_ - up)};
}

/// From the vertex to the centre of its pixel.
SPANGLE_INLINE std::uint64_t Setup<Fixed>::to_anchor(const Gradient& g) const {
    const auto dx = static_cast<std::int32_t>(g.dx), dy = static_cast<std::int32_t>(g.dy);
    std::int64_t sum;
    if (dx == g.dx && dy == g.dy) [[likely]] // two short products
        sum = std::int64_t{dx} * ox_ + std::int64_t{dy} * oy_;
    else
        sum = static_cast<std::int64_t>(
            static_cast<std::uint64_t>(g.dx) * static_cast<std::uint64_t>(std::int64_t{ox_}) +
            static_cast<std::uint64_t>(g.dy) * static_cast<std::uint64_t>(std::int64_t{oy_}));
    return static_cast<std::uint64_t>(sum >> subpixel_bits);
}

std::uint64_t Setup<Fixed>::add_affine(Interpolant<std::uint32_t>& at, std::uint32_t first,
                                       const std::int32_t v[3], int up) {
    const Gradient g = gradient(v, up);
    at.value = first + static_cast<std::uint32_t>(to_anchor(g));
    at.dx = static_cast<std::uint32_t>(g.dx);
    affine_[affine_count_++] = {&at, static_cast<std::uint32_t>(g.dy)};
    return static_cast<std::uint64_t>(g.dy);
}

std::uint64_t Setup<Fixed>::add_projective(Interpolant<std::uint64_t>& at, const std::int32_t v[3]) {
    const Gradient g = gradient(v, guard_bits);
    at.value = (static_cast<std::uint64_t>(std::int64_t{v[0]}) << guard_bits) + to_anchor(g);
    at.dx = static_cast<std::uint64_t>(g.dx);
    projective_[projective_count_++] = {&at, static_cast<std::uint64_t>(g.dy)};
    return static_cast<std::uint64_t>(g.dy);
}

// --- attributes

void Setup<Fixed>::add_depth() {
    // k + 1/2 for a code k in the top bits; z31 has half of its last bit.
    const int bits = state_.depth_format == DepthFormat::z16 ? 16 : 24;
    std::uint32_t z[3];
    std::int32_t half[3];
    for (int i = 0; i < 3; ++i) {
        z[i] = (v_[i]->z << 2) -
               (v_[i]->z >> (bits - 2)); // z (2^bits - 1) 2^(32 - bits); 1 is 2^32 less one code
        half[i] = static_cast<std::int32_t>(z[i] >> 1);
    }
    if (bits == 24) {
        // Half a code is less than the error of a steep plane may be: keep slopes so far from both ends that
        // no value wraps. A constant depth stays as it is.
        const std::uint32_t range = range_of(half[0], half[1], half[2]);
        const std::uint32_t margin = range == 0 ? 0 : (range >> 16) + (1u << 11);
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t highest = 0xFFFFFF00u - margin;
            z[i] = z[i] < margin ? margin : z[i] > highest ? highest : z[i];
            half[i] = static_cast<std::int32_t>(z[i] >> 1);
        }
    }
    add_affine(span_.z, z[0] + (1u << (31 - bits)), half, 1);
}

void Setup<Fixed>::add_color(int component, bool secondary) {
    const auto of = [&](int i) {
        return static_cast<std::int32_t>(secondary ? v_[i]->secondary[component] : v_[i]->color[component]);
    };
    const std::int32_t c[3] = {of(0), of(1), of(2)};
    if (span_.kind == Kind::full) {
        const std::int32_t over_w[3] = {mul30(c[0] << 2, q_[0]), mul30(c[1] << 2, q_[1]),
                                        mul30(c[2] << 2, q_[2])};
        add_projective(secondary ? span_.secondary_q[component] : span_.color_q[component], over_w);
        return;
    }
    const std::uint32_t bias = state_.variant[static_cast<unsigned>(span_.kind)].color_bias;
    constexpr int up = 24 - color_fraction_bits;
    add_affine(secondary ? span_.secondary[component] : span_.color_value[component],
               (static_cast<std::uint32_t>(c[0]) << up) + bias, c, up);
}

/// 1/w of the reference vertices with one exponent, and its range; true when it does not vary.
bool Setup<Fixed>::weights() {
    const int e0 = v_[0]->w_exponent, e1 = v_[1]->w_exponent, e2 = v_[2]->w_exponent;
    const int highest = e0 > e1 ? (e0 > e2 ? e0 : e2) : (e1 > e2 ? e1 : e2);
    const auto scaled = [&](int i, int e) {
        const int down = 2 + highest - e;
        const std::uint32_t q = down < 32 ? v_[i]->w_mantissa >> down : 0;
        return static_cast<std::int32_t>(q != 0 ? q : 1);
    };
    q_[0] = scaled(0, e0);
    q_[1] = scaled(1, e1);
    q_[2] = scaled(2, e2);
    q_range_ = range_of(q_[0], q_[1], q_[2]);
    const std::int32_t least = q_[0] < q_[1] ? q_[0] : q_[1];
    q_least_ = static_cast<std::uint32_t>(least < q_[2] ? least : q_[2]);
    return q_range_ == 0;
}

void Setup<Fixed>::load_unit(int unit, UnitValues& u) const {
    u.homogeneous = false;
    for (int i = 0; i < 3; ++i)
        u.homogeneous = u.homogeneous || v_[i]->tex[unit].q_is_one == 0;
    if (u.homogeneous) {
        load_homogeneous(unit, u);
        return;
    }
    std::int64_t s[3], t[3];
    for (int i = 0; i < 3; ++i) {
        const auto& c = v_[i]->tex[unit];
        s[i] = to_fixed(c.s, c.exponent, 32);
        t[i] = to_fixed(c.t, c.exponent, 32);
    }
    // Whole repeats come off first: they would take bits from the fraction.
    constexpr std::int64_t repeat = std::int64_t{1} << 32;
    const std::int64_t base_s = least_of(s) >> 32, base_t = least_of(t) >> 32;
    std::uint64_t all = 0;
    for (int i = 0; i < 3; ++i) {
        s[i] -= base_s * repeat;
        t[i] -= base_t * repeat;
        all |= static_cast<std::uint64_t>(s[i] | t[i]);
    }
    const int shift_down = 34 - clz64(all | 1);
    u.shift = shift_down > 0 ? shift_down : 0;
    for (int i = 0; i < 3; ++i) {
        u.s[i] = static_cast<std::int32_t>(s[i] >> u.shift);
        u.t[i] = static_cast<std::int32_t>(t[i] >> u.shift);
    }
    u.s0 = s[0];
    u.t0 = t[0];
    span_.unit[unit].s_base = static_cast<std::int32_t>(numeric::clamp<std::int64_t>(base_s, -4096, 4096));
    span_.unit[unit].t_base = static_cast<std::int32_t>(numeric::clamp<std::int64_t>(base_t, -4096, 4096));
}

/// s/w, t/w and q/w as block numbers: the whole repeats cannot be taken off, because q varies.
void Setup<Fixed>::load_homogeneous(int unit, UnitValues& u) const {
    std::int64_t s[3], t[3], q[3];
    int exponent[3], exponent_q[3], top_st = -100000, top_q = -100000;
    const auto height = [](std::int64_t v) { return 64 - clz64(numeric::abs_u64(v)); };
    for (int i = 0; i < 3; ++i) {
        const auto& c = v_[i]->tex[unit];
        const std::int64_t w = v_[i]->w_mantissa >> 1;
        const bool is_one = c.q_is_one != 0;
        s[i] = c.s * w;
        t[i] = c.t * w;
        q[i] = (is_one ? 1 << 30 : c.q) * w;
        exponent[i] = v_[i]->w_exponent + c.exponent;
        exponent_q[i] = v_[i]->w_exponent + (is_one ? -30 : c.exponent);
        const int st = height(s[i]) > height(t[i]) ? height(s[i]) : height(t[i]);
        top_st = exponent[i] + st > top_st ? exponent[i] + st : top_st;
        top_q = exponent_q[i] + height(q[i]) > top_q ? exponent_q[i] + height(q[i]) : top_q;
    }
    for (int i = 0; i < 3; ++i) {
        u.s[i] = static_cast<std::int32_t>(shift(s[i], top_st - 29 - exponent[i]));
        u.t[i] = static_cast<std::int32_t>(shift(t[i], top_st - 29 - exponent[i]));
        u.q[i] = static_cast<std::int32_t>(shift(q[i], top_q - 29 - exponent_q[i]));
    }
    u.shift = top_st - top_q + 32;
    span_.unit[unit].s_base = span_.unit[unit].t_base = 0;
}

/// Fog coordinates, counting 2^span.fog_exponent: 2^-24 where all of them fit s7.24.
void Setup<Fixed>::load_fog(std::int32_t fog[3]) const {
    std::int64_t c[3];
    std::uint64_t all = 0;
    constexpr std::int64_t limit = std::int64_t{1} << 60;
    for (int i = 0; i < 3; ++i) {
        const std::uint64_t product = numeric::mul_u32(v_[i]->fog_mantissa, abs_u32(state_.fog.scale));
        const std::int64_t half = static_cast<std::int64_t>(product >> 1);
        c[i] = to_fixed(state_.fog.scale < 0 ? -half : half,
                        1 + v_[i]->fog_exponent + state_.fog.scale_exponent, 24);
        c[i] = numeric::clamp(c[i] + state_.fog.offset, -limit, limit);
        all |= numeric::abs_u64(c[i]);
    }
    const int down = 34 - clz64(all | 1);
    const int shift_down = down > 0 ? down : 0;
    for (int i = 0; i < 3; ++i)
        fog[i] = static_cast<std::int32_t>(c[i] >> shift_down);
    span_.fog_exponent = shift_down - 24;
}

void Setup<Fixed>::constant_colors(const Vertex& provoking) {
    const std::uint32_t bias = state_.variant[static_cast<unsigned>(span_.kind)].color_bias;
    constexpr int up = 24 - color_fraction_bits;
    for (int i = 0; i < 4; ++i)
        span_.color_value[i] = {(provoking.color[i] << up) + bias, 0};
    for (int i = 0; i < 3; ++i)
        span_.secondary[i] = {(provoking.secondary[i] << up) + bias, 0};
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
    if (bounded(color_one, four)) // whatever the colours are
        return true;
    const auto within = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return bounded(range_of(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b),
                                static_cast<std::int32_t>(c)),
                       four);
    };
    const auto& [a, b, c] = v_;
    for (int i = 0; i < (state_.needs.alpha ? 4 : 3); ++i)
        if (!within(a->color[i], b->color[i], c->color[i]))
            return false;
    for (int i = 0; state_.needs.secondary && i < 3; ++i)
        if (!within(a->secondary[i], b->secondary[i], c->secondary[i]))
            return false;
    return true;
}

bool Setup<Fixed>::unit_affine(int unit, const UnitValues& u, bool same_w) const {
    if (u.homogeneous)
        return false;
    // The affine form of clamped coordinates does not saturate: 7 repeats on both sides must do.
    const auto& placed = span_.unit[unit];
    const bool far =
        u.shift > 4 || placed.s_base < -7 || placed.s_base > 3 || placed.t_base < -7 || placed.t_base > 3;
    const auto& wraps = state_.wraps[unit];
    if (far && !(wraps.s && wraps.t))
        return false;
    if (same_w)
        return true;
    if (state_.tier == Tier::exact || u.shift > 7)
        return false;
    // A quarter of a texel of the base level.
    const auto within = [&](const std::int32_t v[3], int log2_size) {
        const std::uint32_t range = range_of(v[0], v[1], v[2]);
        return (std::uint64_t{range} + 1) * q_range_ <= (std::uint64_t{q_least_} << (32 - log2_size)) >>
               u.shift;
    };
    return within(u.s, state_.log2_width[unit]) && within(u.t, state_.log2_height[unit]);
}

Kind Setup<Fixed>::choose_kind(const UnitValues units[], bool same_w, bool same_color,
                               const std::int32_t fog[3]) const {
    const Needs& needs = state_.needs;
    const bool textured = needs.unit[0] || needs.unit[1];
    const bool full_color = !same_w && !same_color && !colors_affine();
    if (full_color)
        return Kind::full;
    if (!textured && !needs.fog)
        return same_color && state_.variant[0].run != nullptr ? Kind::flat : Kind::affine;
    bool affine = true;
    for (int i = 0; i < max_texture_units; ++i)
        affine = affine && (!needs.unit[i] || unit_affine(i, units[i], same_w));
    if (needs.fog && affine) {
        const std::uint64_t four = state_.tier == Tier::exact ? 1u << 5 : 1u << 17; // of f: 2^-22; 2^-9
        affine = span_.fog_exponent == -24 &&
                 (same_w || state_.tier == Tier::fast || bounded(range_of(fog[0], fog[1], fog[2]), four));
    }
    return affine ? Kind::affine : Kind::textured;
}

void Setup<Fixed>::add_unit(int unit, const UnitValues& u) {
    auto& at = span_.unit[unit];
    if (span_.kind == Kind::affine) {
        const auto& wraps = state_.wraps[unit];
        constexpr int less = 32 - clamped_coord_bits;
        const auto first = [&](std::int64_t v, bool wrap, std::int32_t base) {
            return wrap ? static_cast<std::uint32_t>(v)
                        : static_cast<std::uint32_t>(v >> less) +
                              (static_cast<std::uint32_t>(base) << clamped_coord_bits);
        };
        at.s_dy = add_affine(span_.s[unit], first(u.s0, wraps.s, at.s_base), u.s,
                             wraps.s ? u.shift : u.shift - less);
        at.t_dy = add_affine(span_.t[unit], first(u.t0, wraps.t, at.t_base), u.t,
                             wraps.t ? u.shift : u.shift - less);
        return;
    }
    at.shares_q = !u.homogeneous;
    at.exponent = u.homogeneous ? u.shift - 32 : u.shift - 2; // mul30 below takes 30 bits off
    if (u.homogeneous) {
        at.s_dy = add_projective(at.s, u.s);
        at.t_dy = add_projective(at.t, u.t);
        at.q_dy = add_projective(at.q, u.q);
        return;
    }
    std::int32_t s[3], t[3];
    for (int i = 0; i < 3; ++i) {
        s[i] = mul30(u.s[i], q_[i]);
        t[i] = mul30(u.t[i], q_[i]);
    }
    at.s_dy = add_projective(at.s, s);
    at.t_dy = add_projective(at.t, t);
}

void Setup<Fixed>::attributes(const Vertex& provoking) {
    const Needs& needs = state_.needs;
    const bool textured = needs.unit[0] || needs.unit[1];
    UnitValues units[max_texture_units];
    std::int32_t fog[3] = {};
    for (int i = 0; i < max_texture_units; ++i)
        if (needs.unit[i])
            load_unit(i, units[i]);
    if (needs.fog)
        load_fog(fog);
    const Vertex &a = *v_[0], &b = *v_[1], &c = *v_[2];
    bool same_color = true;
    if (!state_.fragment.flat) {
        std::uint32_t differ = 0;
        for (int i = 0; needs.rgb && i < (needs.alpha ? 4 : 3); ++i)
            differ |= (a.color[i] ^ b.color[i]) | (a.color[i] ^ c.color[i]);
        for (int i = 0; needs.secondary && i < 3; ++i)
            differ |= (a.secondary[i] ^ b.secondary[i]) | (a.secondary[i] ^ c.secondary[i]);
        same_color = differ == 0;
    }
    const bool weighted = state_.fragment.perspective && (textured || needs.fog || !same_color);
    const bool same_w = !weighted || weights();
    if (!weighted) {
        q_[0] = q_[1] = q_[2] = 1 << 29;
        q_range_ = 0;
        q_least_ = 1u << 29;
    }
    span_.kind = choose_kind(units, same_w, same_color, fog);

    if (needs.z)
        add_depth();
    if (span_.kind == Kind::textured || span_.kind == Kind::full) {
        add_projective(span_.q, q_);
        span_.q_dy = projective_[projective_count_ - 1].dy;
    }
    if (span_.kind == Kind::flat) {
        const auto to8 = [&](int i) {
            return (provoking.color[i] + (1u << (color_fraction_bits - 1))) >> color_fraction_bits;
        };
        span_.flat_word = (to8(0) >> 3) << 11 | (to8(1) >> 2) << 5 | to8(2) >> 3;
        return;
    }
    if (state_.fragment.flat || same_color) {
        constant_colors(provoking);
    } else {
        for (int i = 0; needs.rgb && i < (needs.alpha ? 4 : 3); ++i)
            add_color(i, false);
        for (int i = 0; needs.secondary && i < 3; ++i)
            add_color(i, true);
    }
    if (needs.fog) {
        if (span_.kind == Kind::affine) {
            add_affine(span_.fog, static_cast<std::uint32_t>(fog[0]), fog, 0);
        } else {
            for (int i = 0; i < 3; ++i)
                fog[i] = mul30(fog[i], q_[i]);
            span_.fog_exponent += 30;
            add_projective(span_.fog_q, fog);
        }
    }
    for (int i = 0; i < max_texture_units; ++i)
        if (needs.unit[i])
            add_unit(i, units[i]);
}

} // namespace spangle::raster
