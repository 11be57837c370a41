// Set-up of attributes that vary over 1/w and have their own scale: texture coordinates and the fog
// coordinate.
#include "raster/primitive/coordinate_words.hpp"
#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

using numeric::clz64;

namespace {

/// One texture coordinate of three vertices, in repeats. A whole number of repeats is taken off all three
/// values, because it would take bits from the fraction.
struct Repeats {
    std::int64_t v[3];   ///< values at the vertices, with 32 fraction bits
    std::int32_t base;   ///< repeats that were taken off, clamped to 4096 either way
    std::uint32_t range; ///< range of whole repeats; its highest bit is that of all three values together

    SPANGLE_RUN_INLINE Repeats(const std::int32_t (&m)[3], const std::int32_t (&exponent)[3],
                               std::int32_t less) {
#pragma GCC unroll numeric::runs_inline ? 3 : 1
        for (int i = 0; i < 3; ++i)
            v[i] = to_repeats(m[i], exponent[i] - less);
        const auto whole = [&](int i) { return static_cast<std::int32_t>(v[i] >> 32); };
        const Ends ends(whole(0), whole(1), whole(2));
        base = ends.low;
        range = ends.range();
#pragma GCC unroll numeric::runs_inline ? 3 : 1
        for (int i = 0; i < 3; ++i)
            v[i] -= base * (std::int64_t{1} << 32);
        base = numeric::clamp<std::int32_t>(base, -4096, 4096);
    }
    SPANGLE_INLINE std::uint32_t fractions() const {
        return static_cast<std::uint32_t>(v[0]) | static_cast<std::uint32_t>(v[1]) |
               static_cast<std::uint32_t>(v[2]);
    }
};

} // namespace

void Setup<Fixed>::load_unit(int unit, UnitValues& u) const {
    const auto &a = v(0).tex[unit], &b = v(1).tex[unit], &c = v(2).tex[unit];
    // A unit with three coordinates divides at every fragment.
    u.homogeneous =
        (has_division && state_.needs.r[unit]) ||
        (has_perspective && (!has_affine_textures || a.q_is_one == 0 || b.q_is_one == 0 || c.q_is_one == 0));
    if (u.homogeneous)
        return load_homogeneous(unit, u);
    const auto halves = state_.halves[unit];
    const std::int32_t exponent[3] = {a.exponent, b.exponent, c.exponent};
    const Repeats s({a.s, b.s, c.s}, exponent, halves.s), t({a.t, b.t, c.t}, exponent, halves.t);
    const std::uint32_t range = s.range | t.range;
    const int shift_down =
        range != 0 ? 34 - numeric::clz32(range) : 2 - numeric::clz32(s.fractions() | t.fractions() | 1);
    u.shift = shift_down > 0 ? shift_down : 0;
    for (int i = 0; i < 3; ++i) {
        u.s[i] = static_cast<std::int32_t>(scaled_word(s.v[i], u.shift));
        u.t[i] = static_cast<std::int32_t>(scaled_word(t.v[i], u.shift));
    }
    u.s0 = s.v[0];
    u.t0 = t.v[0];
    span_.unit[unit].s_base = s.base;
    span_.unit[unit].t_base = t.base;
}

/// Loads s/w, t/w and q/w as block numbers. Whole repeats cannot be taken off, because q varies.
void Setup<Fixed>::load_homogeneous(int unit, UnitValues& u) const {
    const auto halves = state_.halves[unit];
    constexpr int coordinates = 4;
    std::int64_t of[3][coordinates]; // q, s, t, r
    int exponent[3][2], top[2] = {-100000, -100000};
    for (int i = 0; i < 3; ++i) {
        const auto& c = v(i).tex[unit];
        const auto over_w = [w = static_cast<std::int32_t>(v(i).w_mantissa >> 1)](std::int32_t of, int down)
                                SPANGLE_RUN_LAMBDA { return numeric::mul_s32(of, w) >> down; };
        const bool is_one = c.q_is_one != 0;
        of[i][0] = over_w(is_one ? 1 << 30 : c.q, 0);
        of[i][1] = over_w(c.s, halves.s);
        of[i][2] = over_w(c.t, halves.t);
        of[i][3] = over_w(state_.needs.r[unit] ? v(i).r[unit] : 0, 0);
        exponent[i][0] = v(i).w_exponent + (is_one ? -30 : c.exponent);
        exponent[i][1] = v(i).w_exponent + c.exponent;
        for (int k = 0; k < coordinates; ++k) {
            int& highest = top[k != 0];
            const int height = exponent[i][k != 0] + 64 - clz64(numeric::abs_u64(of[i][k]));
            highest = height > highest ? height : highest;
        }
    }
    std::int32_t* const to[coordinates] = {u.q, u.s, u.t, u.r};
    for (int k = 0; k < coordinates; ++k)
        for (int i = 0; i < 3; ++i)
            to[k][i] = static_cast<std::int32_t>(shift(of[i][k], top[k != 0] - 29 - exponent[i][k != 0]));
    u.shift = top[1] - top[0] + 32;
    span_.unit[unit].s_base = span_.unit[unit].t_base = 0;
}

/// Does what load_fog() does, for coordinates of any size.
void Setup<Fixed>::load_any_fog(std::int32_t fog[3]) const {
    std::int64_t c[3];
    std::uint64_t all = 0;
    for (int i = 0; i < 3; ++i) {
        const std::int64_t product = numeric::mul_s32(v(i).fog_mantissa, state_.fog.scale);
        c[i] = to_fixed_below(product / 2, -25 - v(i).fog_exponent - state_.fog.scale_exponent) +
               state_.fog.offset;
        all |= static_cast<std::uint64_t>(c[i] ^ c[i] >> 63); // |c|, or |c| - 1 of a negative c
    }
    int shift_down = 0;
    if (all >= (1u << 30) - 1) [[unlikely]] {
        constexpr std::int64_t limit = std::int64_t{1} << 60;
        all = 0;
        for (std::int64_t& v : c) {
            v = numeric::clamp(v, -limit, limit);
            all |= numeric::abs_u64(v);
        }
        const int down = 34 - clz64(all | 1);
        shift_down = down > 0 ? down : 0;
        span_.fog_exponent += shift_down;
    }
    for (int i = 0; i < 3; ++i)
        fog[i] = static_cast<std::int32_t>(scaled_word(c[i], shift_down));
}

/// Whether fog coordinates stay between 0 and 1 at all fragments, judged by the vertices. Ends of lines reach
/// half a pixel further. The loss of a step of the plane adds up over at most 2^14 pixels, and coefficients
/// lose 2^6.
static bool stays_inside(const std::int32_t (&fog)[3], const Interpolant<std::uint32_t>& plane) {
    const auto step = [](std::uint32_t d) { return numeric::abs_u32(static_cast<std::int32_t>(d)); };
    const std::int64_t margin = std::int64_t{step(plane.dx)} + step(plane.dy) + (1 << 16);
    const Ends ends(fog[0], fog[1], fog[2]);
    return ends.low >= margin && ends.high < (1 << 24) - margin;
}

bool Setup<Fixed>::unit_affine(int unit, const UnitValues& u, bool same_w) const {
    if constexpr (!has_division)
        return true;
    if (!has_affine_textures || u.homogeneous)
        return false;
    // The affine form of clamped coordinates does not saturate, so 7 repeats on both sides must be enough.
    const auto& placed = span_.unit[unit];
    const bool far =
        u.shift > 4 || placed.s_base < -7 || placed.s_base > 3 || placed.t_base < -7 || placed.t_base > 3;
    const auto& wraps = state_.wraps[unit];
    if (far && !(wraps.s && wraps.t))
        return false;
    if (same_w)
        return true;
    if (of_tier<[](const Knobs& k) { return k.affine_texel_bits == Knobs::never; }>(state_) || u.shift > 7)
        return false;
    // The tolerance is a part of a texel of the base level. Four times the error is range range(q) / min(q).
    const int four = of_straight_tier<[](const Knobs& k) { return k.affine_texel_bits - 2; }>(state_);
    const auto within = [&](const std::int32_t v[3], int log2_size) SPANGLE_RUN_LAMBDA {
        const std::uint32_t range = range_of(v[0], v[1], v[2]);
        return numeric::mul_u32(range + 1, q_range_) <=
               static_cast<std::uint64_t>(numeric::times_two_to(q_least_, 32 - log2_size - u.shift - four));
    };
    return within(u.s, state_.log2_width[unit]) && within(u.t, state_.log2_height[unit]);
}

void Setup<Fixed>::add_unit(int unit, UnitValues& u) {
    auto& at = span_.unit[unit];
    if (!has_division || span_.kind == Kind::affine) {
        const auto& wraps = state_.wraps[unit];
        constexpr int less = 32 - clamped_coord_bits;
        const auto first = [](std::int64_t v, bool wrap, std::int32_t base) {
            return wrap ? static_cast<std::uint32_t>(v)
                        : static_cast<std::uint32_t>(v >> less) +
                              (static_cast<std::uint32_t>(base) << clamped_coord_bits);
        };
        const int up_s = wraps.s ? u.shift : u.shift - less, up_t = wraps.t ? u.shift : u.shift - less;
        const std::uint32_t s0 = first(u.s0, wraps.s, at.s_base), t0 = first(u.t0, wraps.t, at.t_base);
        // Small builds have only the general form, if any texture of theirs may have levels.
        if ((has_shortcuts || !spans_sample_any) && !state_.needs.lod[unit]) {
            add_words(span_.s[unit], s0, u.s, up_s);
            add_words(span_.t[unit], t0, u.t, up_t);
            return;
        }
        // The level of detail needs slopes of 64 bits, because a texture may repeat more than once from pixel
        // to pixel.
        const Slope s = add_steep(span_.s[unit], s0, u.s[1] - u.s[0], u.s[2] - u.s[0], up_s);
        const Slope t = add_steep(span_.t[unit], t0, u.t[1] - u.t[0], u.t[2] - u.t[0], up_t);
        at.s.dx = s.dx;
        at.t.dx = t.dx;
        at.s_dy = s.dy;
        at.t_dy = t.dy;
        return;
    }
    at.shares_q = !u.homogeneous;
    at.exponent = u.homogeneous ? u.shift - 32 : u.shift - 2; // over_w() takes 30 bits off
    if (u.homogeneous) {
        at.q_dy = add_projective(at.q, u.q);
        if (state_.needs.r[unit])
            at.r_dy = add_projective(at.r, u.r);
    } else {
        over_w(u.s);
        over_w(u.t);
    }
    at.s_dy = add_projective(at.s, u.s);
    at.t_dy = add_projective(at.t, u.t);
}

/// Chooses `affine` where the bounds of the tier allow it, `textured` where they allow it for colours only,
/// and otherwise `full`.
SPANGLE_INLINE Kind Setup<Fixed>::choose_kind(const UnitValues units[], bool same_w, std::uint32_t color_bits,
                                              const std::int32_t fog[3]) {
    const Needs& needs = state_.needs;
    if (has_full && !same_w && color_bits != 0 && !colors_affine(color_bits))
        return Kind::full;
    for (int i = 0; i < max_texture_units; ++i)
        if (has_textures && needs.unit[i] && !unit_affine(i, units[i], same_w))
            return Kind::textured;
    if (!has_fog || !needs.fog)
        return has_affine_textures ? Kind::affine : Kind::textured;
    // Four times the tolerance of the fog factor. Tiers whose fog is always affine do not read it.
    const std::uint64_t four = of_tier<[](const Knobs& k) {
        return 1u << (26 - (k.affine_fog_bits != 0 ? k.affine_fog_bits : balanced_knobs.affine_fog_bits));
    }>(state_);
    const bool always = of_tier<[](const Knobs& k) { return k.affine_fog_bits == 0; }>(state_);
    const bool affine = span_.fog_exponent == -24 &&
                        (same_w || always || is_within_tolerance(range_of(fog[0], fog[1], fog[2]), four));
    return affine ? Kind::affine : Kind::textured;
}

/// Whether red, green and blue are equal at every vertex. Stages then interpolate one colour instead of
/// three.
SPANGLE_INLINE bool Setup<Fixed>::is_gray(std::uint32_t color_bits, const Vertex& painted) const {
    const auto gray = [](const Vertex& v)
                          SPANGLE_RUN_LAMBDA { return v.color[0] == v.color[1] && v.color[0] == v.color[2]; };
    return color_bits == 0 ? gray(painted) : gray(v(0)) && gray(v(1)) && gray(v(2));
}

void Setup<Fixed>::set_up_with_coordinates(std::uint32_t color_bits, const Vertex& painted) {
    const Needs& needs = state_.needs;
    UnitValues units[max_texture_units];
    std::int32_t fog[3] = {};
    for (int i = 0; i < max_texture_units; ++i)
        if (has_textures && needs.unit[i])
            load_unit(i, units[i]);
    if (has_fog && needs.fog)
        load_fog(fog);
    bool same_w = true;
    if (has_perspective && state_.fragment.perspective) {
        same_w = weights();
    } else if (has_division) {
        q(0) = q(1) = q(2) = 1 << 29;
        q_range_ = 0;
        q_least_ = 1u << 29;
    }
    if (unsnaps(state_))
        snap_where_w_ends();
    span_.kind = choose_kind(units, same_w, color_bits, fog);
    span_.gray = state_.variant[static_cast<unsigned>(span_.kind)].gray && is_gray(color_bits, painted);

    if (has_division && span_.kind != Kind::affine)
        span_.q_dy = add_projective(span_.q, span_.basis.q);
    if (unsnaps(state_) && color_bits != 0 && span_.kind != Kind::full && !colors_stay_inside(2 * color_bits))
        [[unlikely]] {
        const Coefficients kept = by();
        const std::uint32_t beyond = beyond_;
        snap();
        colors(color_bits, painted);
        by() = kept;
        beyond_ = beyond;
    } else {
        colors(color_bits, painted);
    }
    if (has_fog && needs.fog) {
        if (span_.kind == Kind::affine) {
            add_words(span_.fog, static_cast<std::uint32_t>(fog[0]), fog, 0);
            if constexpr (host_lanes > 1)
                span_.fog_inside = stays_inside(fog, span_.fog);
        } else {
            over_w(fog);
            span_.fog_exponent += 30;
            add_projective(span_.fog_q, fog);
        }
    }
    for (int i = 0; i < max_texture_units; ++i)
        if (has_textures && needs.unit[i])
            add_unit(i, units[i]);
    if (unsnaps(state_) && has_perspective && state_.fragment.perspective && span_.kind != Kind::affine &&
        loses_texels(units)) [[unlikely]]
        steepen(fog);
}

} // namespace spangle::raster
