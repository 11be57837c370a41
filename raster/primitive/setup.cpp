#include "raster/primitive/setup_planes.hpp"

#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/primitive/triangle_area.hpp"

namespace spangle::raster {

using numeric::abs_u32;
using numeric::clz32;

// --- geometry

/// Sets the anchor: the pixel in which the lowest vertex (x, y) lies.
SPANGLE_INLINE void Setup<Fixed>::set_anchor(std::int32_t x, std::int32_t y) {
    span_.anchor_x = x >> subpixel_bits;
    span_.anchor_y = y >> subpixel_bits;
    const std::int32_t ox = subpixel_one / 2 - (x & (subpixel_one - 1));
    const std::int32_t oy = subpixel_one / 2 - (y & (subpixel_one - 1));
    for (int i = 0; i < 2; ++i) // the sum of both products is at most 2^38
        by().center[i] = static_cast<std::int32_t>(
            (numeric::mul_long(by().dx[i], ox) + numeric::mul_long(by().dy[i], oy)) >> subpixel_bits);
}

void Setup<Fixed>::along_axis(const Vertex& from, const Vertex& to, const Axis& axis) {
    span_.basis = {{&from, &to, &from}, {}, {}};
    axis_ = axis;
    const PerPixel per_pixel(axis.begin, axis.end);
    (axis.along_x ? by().dx[0] : by().dy[0]) = per_pixel.coefficient;
    by().exponent = per_pixel.exponent;
    set_anchor(axis.along_x ? axis.begin : from.x, axis.along_x ? from.y : axis.begin);
}

/// Interpolates along the longer axis of the box of three corners, which are sorted upwards.
void Setup<Fixed>::along_longer_axis(const Vertex& a, const Vertex& b, const Vertex& c) {
    const Vertex* left = b.x < a.x ? &b : &a;
    const Vertex* right = b.x < a.x ? &a : &b;
    left = c.x < left->x ? &c : left;
    right = c.x > right->x ? &c : right;
    if (right->x - left->x <= c.y - a.y)
        along_axis(a, c, {a.y, c.y, false, false});
    else
        along_axis(*left, *right, {left->x, right->x, true, true});
}

/// Computes the coefficients of planes. |area2| 2^zeros has its highest bit set; `top` is its upper word.
SPANGLE_INLINE void Setup<Fixed>::in_plane(std::uint32_t top, int zeros, bool negative) {
    // 1 / area2 is inverse 2^(zeros - 94). The inverse of 2^31 itself is off by 2^-31 of its value.
    const std::uint32_t reciprocal = numeric::reciprocal(top);
    const auto inverse = static_cast<std::int32_t>(reciprocal - (reciprocal >> 31));
    const std::int32_t signed_inverse = negative ? -inverse : inverse;
    const std::int32_t y2 = v(2).y - v(0).y, y1 = v(0).y - v(1).y;
    const std::int32_t x2 = v(0).x - v(2).x, x1 = v(1).x - v(0).x;
    // |d| 2^up < 2^31; y2 >= |y1|
    const int up = clz32(static_cast<std::uint32_t>(y2) | abs_u32(x2) | abs_u32(x1)) - 1;
    const auto coefficient = [&](std::int32_t d) {
        return numeric::mul_high_s32(static_cast<std::int32_t>(static_cast<std::uint32_t>(d) << up),
                                     signed_inverse);
    };
    by().dx[0] = coefficient(y2);
    by().dx[1] = coefficient(y1);
    by().dy[0] = coefficient(x2);
    by().dy[1] = coefficient(x1);
    by().exponent = 54 + up - zeros; // d/area2 per pixel is c 2^-exponent
    set_anchor(v(0).x, v(0).y);
}

/// Makes planes go through the snapped vertices again (unsnap()).
[[gnu::noinline]] void Setup<Fixed>::snap() {
    if (beyond_ == 0)
        return;
    beyond_ = 0;
    if (&v(0) == &v(2))
        return along_axis(v(0), v(1), axis_);
    const Vertex &a = v(0), &b = v(1), &c = v(2);
    const Area area =
        area_of(a, b, c, numeric::mul_s32(b.x - a.x, c.y - a.y) - numeric::mul_s32(c.x - a.x, b.y - a.y));
    const int unused = clz32(area.word); // not 0: thin triangles are never unsnapped
    in_plane(area.word << unused, 32 - area.exponent + unused, area.sign < 0);
}

// --- planes

/// Adds a plane that may be steep. The function is not inline in builds where add_lifted() is.
Setup<Fixed>::Slope Setup<Fixed>::add_steep(Interpolant<std::uint32_t>& at, std::uint32_t first,
                                            std::int32_t d1, std::int32_t d2, int up) {
    const Interpolant<std::uint64_t> plane = scaled_plane(by(), d1, d2, up);
    at.value = first + static_cast<std::uint32_t>(plane.value);
    at.dx = static_cast<std::uint32_t>(plane.dx);
    at.dy = static_cast<std::uint32_t>(plane.dy);
    return {plane.dx, plane.dy};
}

// --- attributes

SPANGLE_INLINE void Setup<Fixed>::add_depth() {
    // The value is k + 1/2 for a code k in the top bits. Differences are halved to fit a word, so they have
    // half of the code's last bit.
    constexpr int bits = 16;
    const std::uint32_t z0 = depth_code(v(0).z, bits), z1 = depth_code(v(1).z, bits),
                        z2 = depth_code(v(2).z, bits);
    const std::uint32_t first = z0 + (1u << (31 - bits));
    const auto d1 = static_cast<std::int32_t>((z1 >> 1) - (z0 >> 1)),
               d2 = static_cast<std::int32_t>((z2 >> 1) - (z0 >> 1));
    const auto lift = static_cast<std::uint32_t>(33 - by().exponent);
    if (fits_lifted(difference_bits(d1, d2), lift)) [[likely]]
        return add_lifted(span_.z, first, d1, d2, lift, by());
    add_steep(span_.z, first, d1, d2, 1);
}

void Setup<Fixed>::any_color(ColorVisitor add) const {
    every_color<false>(add);
}

constexpr int color_up = 24 - color_fraction_bits;

void Setup<Fixed>::steep_colors(std::uint32_t bias) {
    each_color([&](const ColorSource& from, int i, Interpolant<std::uint32_t>& at, auto&) {
        add_steep(at, (from.first(i) << color_up) + bias, from.difference(1, i), from.difference(2, i),
                  color_up);
    });
}

void Setup<Fixed>::steep_steps(std::uint32_t bias) {
    each_step([&](auto& at, std::uint32_t first, std::int32_t d1, std::int32_t d2) {
        add_steep(at, (first << color_up) + bias, d1, d2, color_up);
    });
}

/// Sets up colours whose differences are `bits` (difference_bits()).
template <bool Rgb> SPANGLE_INLINE void Setup<Fixed>::varying_colors(std::uint32_t bits) {
    if (has_full && span_.kind == Kind::full)
        projective_colors();
    else
        window_colors<Rgb>(bits, 0);
}

/// Sets up colours that are affine in the window, and subtracts `less` from them.
template <bool Rgb> SPANGLE_INLINE void Setup<Fixed>::window_colors(std::uint32_t bits, std::uint32_t less) {
    const Variant& variant = state_.variant[static_cast<unsigned>(span_.kind)];
    const std::uint32_t bias = variant.color_bias - less;
    if (!spans_dither || !variant.steps)
        affine_colors<Rgb>(bits, bias);
    else if constexpr (Rgb)
        stepped_colors(bits, bias);
    else
        stepped_colors_apart(bits, bias);
}

/// Calls add(plane, first value, differences) for each component that is dithered: red, green and blue.
template <class Steps, class F> SPANGLE_INLINE void Setup<Fixed>::each_step(Steps in_steps, F add) const {
#pragma GCC unroll numeric::runs_inline ? 3 : 1
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t s0 = in_steps(v(0).color[i], i), s1 = in_steps(v(1).color[i], i),
                            s2 = in_steps(v(2).color[i], i);
        add(span_.color_value[i], s0, static_cast<std::int32_t>(s1 - s0), static_cast<std::int32_t>(s2 - s0));
    }
}

/// Calls each_step() for the kind of factors. Without long products each kind of factors has its own form,
/// and so have guessed colours.
template <class F> SPANGLE_INLINE void Setup<Fixed>::each_step(F add) const {
    if constexpr (numeric::long_products)
        each_step(
            [factors = state_.step_factors](std::uint32_t c, int i)
                __attribute__((always_inline)) { return numeric::mul_high_u32(c, factors.of(i)); },
            add);
    else if (has_full && span_.kind == Kind::full)
        each_step(color_in_guessed_steps, add);
    else if (of_tier<[](const Knobs& k) { return k.exact_steps; }>(state_))
        each_step(color_in_steps<>, add);
    else
        each_step(color_in_near_steps<>, add);
}

/// Sets up colours in steps of dithering. Their differences take no more bits than those of the colours.
SPANGLE_INLINE void Setup<Fixed>::stepped_colors(std::uint32_t bits, std::uint32_t bias) {
    const Coefficients& by = this->by();
    const auto lift = static_cast<std::uint32_t>(32 + color_up - by.exponent);
    if (fits_lifted(bits, lift)) [[likely]] {
        return each_step([&](auto& at, std::uint32_t first, std::int32_t d1, std::int32_t d2) __attribute__((
            always_inline)) { add_lifted(at, (first << color_up) + bias, d1, d2, lift, by); });
    }
    steep_steps(bias);
}

void Setup<Fixed>::stepped_colors_apart(std::uint32_t bits, std::uint32_t bias) {
    stepped_colors(bits, bias);
}

template <bool Rgb> SPANGLE_INLINE void Setup<Fixed>::affine_colors(std::uint32_t bits, std::uint32_t bias) {
    const Coefficients& by = this->by();
    const auto lift = static_cast<std::uint32_t>(32 + color_up - by.exponent);
    if (fits_lifted(bits, lift)) [[likely]] {
        return each_color<Rgb>([&](const ColorSource& from, int i, Interpolant<std::uint32_t>& at, auto&) {
            add_lifted(at, (from.first(i) << color_up) + bias, from.difference(1, i), from.difference(2, i),
                       lift, by);
        });
    }
    steep_colors(bias);
}

/// Sets up the guess of colours. The affine colour is off by at most range(c) range(q) / (4 min(q))
/// (is_within_tolerance()). Points beyond the vertices by a 16th, which unsnap() allows, change that by less.
/// Set-up loses 2^-18 of 255 in affine colours. In planes over w, where 1/w varies by at most twice, it loses
/// three times as much. Together this is 2^-8 of a 255th.
SPANGLE_INLINE void Setup<Fixed>::guessed_colors(std::uint32_t bits) {
    constexpr std::uint32_t lost = 1u << 17; // 8.24
    const std::uint64_t product = numeric::mul_u32(widest_color_range_, q_range_);
    if (q_least_ < 1u << 28 || product >> 52 != 0)
        return divided_colors();
    // The error is 16 product / (4 q), which is below 2^26. The two quotients are less than 16 and 1 too
    // small.
    const std::uint32_t error = static_cast<std::uint32_t>(product >> 20) / (q_least_ >> 18) * 16 + 17;
    // Steps are at most as large as 255ths and off by less than 2^-11 of them, which is less than what
    // remains of `lost`.
    const std::uint32_t off = error + lost;
    span_.guess.doubt(2 * off);
    span_.guess.project = &project;
    window_colors<true>(bits, off);
}

void Setup<Fixed>::constant_colors(const Vertex& painted) {
    const Variant& variant = state_.variant[static_cast<unsigned>(span_.kind)];
    const std::uint32_t bias = variant.color_bias;
    constexpr int up = 24 - color_fraction_bits;
    for (int i = 0; i < 4; ++i)
        span_.color_value[i] = {(painted.color[i] << up) + bias, 0, 0};
    // Only builds without the chain may lack the span of one dithered colour.
    if constexpr (!has_chain && spans_are_raw && spans_dither)
        for (int i = 0; variant.steps && i < 3; ++i)
            span_.color_value[i].value = color_in_steps<>(painted.color[i], i) << up;
    for (int i = 0; has_color_sum && i < 3; ++i)
        span_.secondary[i] = {(painted.secondary[i] << up) + bias, 0, 0};
}

// --- the cheapest kind within the tier's bounds

/// Whether colours whose differences are `bits` must be divided at every fragment. Where they may be guessed,
/// `bits` becomes twice their range.
template <bool Rgb> SPANGLE_INLINE bool Setup<Fixed>::needs_division(std::uint32_t bits) {
    if (Rgb && state_.guesses)
        return !weights() && !is_within_tolerance(widest_color_range_, state_.four_color_tolerances);
    return !nearly_affine(bits) && !weights() && !colors_affine(bits);
}

/// Sets up attributes of states without textures and fog.
template <bool Rgb>
SPANGLE_INLINE void Setup<Fixed>::set_up_without_coordinates(std::uint32_t bits, const Vertex& painted) {
    Kind kind = Kind::affine;
    if (bits == 0)
        kind = state_.variant[0].run != nullptr ? Kind::flat : Kind::affine;
    else if (has_full && state_.fragment.perspective && needs_division<Rgb>(bits))
        kind = Kind::full;
    const bool guesses = Rgb && has_fused_spans && state_.guesses;
    if (unsnaps(state_) && bits != 0 && (kind == Kind::affine || guesses) &&
        !colors_stay_inside(guesses ? widest_color_range_ : 2 * bits))
        snap();
    span_.kind = kind;
    if (kind == Kind::flat)
        span_.flat_word = flat_word(state_, painted.color);
    else if (bits == 0)
        constant_colors(painted);
    else if (has_full && kind == Kind::full)
        guesses ? guessed_colors(bits) : divided_colors();
    else if constexpr (Rgb)
        varying_colors<Rgb>(bits);
    else
        colors(bits, painted);
}

/// Sets up colours whose differences are `bits`; 0 means that there is one colour.
void Setup<Fixed>::colors(std::uint32_t bits, const Vertex& painted) {
    if (bits == 0)
        constant_colors(painted);
    else
        varying_colors<false>(bits);
}

template <bool Rgb> SPANGLE_INLINE void Setup<Fixed>::attributes_of(const Vertex& provoking) {
    // In smooth shading a single colour is the one that all corners share. The provoking vertex need not be a
    // corner, because quads and clipped polygons are drawn in parts.
    const bool flat = !Rgb && state_.fragment.flat;
    if constexpr (!Rgb)
        span_.gray = false; // spans of smooth_rgb never read `gray`
    const Vertex& painted = flat ? provoking : v(0);
    const std::uint32_t bits = flat ? 0 : color_bits<Rgb>();
    if (state_.needs.z && !has_24_bits())
        add_depth();
    if constexpr (Rgb) {
        if (unsnaps(state_) && bits != 0)
            return set_up_exact_colors(bits);
    } else if (unsnaps(state_) && (bits != 0 || state_.textured_or_fogged)) {
        unsnap();
    }
    if ((has_textures || has_fog) && !Rgb && state_.textured_or_fogged)
        set_up_with_coordinates(bits, painted);
    else
        set_up_without_coordinates<Rgb>(bits, painted);
}

/// Not inline, because the other tiers would keep registers for it.
void Setup<Fixed>::set_up_exact_colors(std::uint32_t bits) {
    unsnap();
    set_up_without_coordinates<true>(bits, v(0));
}

/// Sets up attributes of all primitives except usual triangles, so it is not inline.
void Setup<Fixed>::attributes(const Vertex& provoking) {
    attributes_of<false>(provoking);
}

// --- primitives

Setup<Fixed>::Area Setup<Fixed>::area_of(const Vertex& a, const Vertex& b, const Vertex& c,
                                         std::int64_t area2) {
    const std::int32_t x1 = b.x - a.x, x2 = c.x - a.x;
    const auto height = static_cast<std::uint32_t>(c.y - a.y);
    const std::uint64_t area = numeric::abs_u64(area2);
    if (is_box_beyond(thin_aspect * area, x1, x2, height))
        return {};
    return area_word(area, area2 < 0 ? -1 : 1);
}

Setup<Fixed>::Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& c,
                    const Vertex& provoking, std::int64_t area2)
    : Setup(span, a, b, c, provoking, area_of(a, b, c, area2)) {}

Setup<Fixed>::Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& c,
                    const Vertex& provoking, const Area& area)
    : span_(span), state_(*span.state) {
    span.basis.v[0] = &a, span.basis.v[1] = &b, span.basis.v[2] = &c;
    third_vertex_ = &c;
    if (area.word != 0) [[likely]] {
        const int zeros = clz32(area.word);
        in_plane(area.word << zeros, 32 - area.exponent + zeros, area.sign < 0);
    } else {
        along_longer_axis(a, b, c);
        third_vertex_ = &v(0) != &a && &v(1) != &a ? &a : &v(0) != &b && &v(1) != &b ? &b : &c;
        if (has_24_bits())
            add_depth_24(a, b, c);
    }
    triangle_attributes(provoking);
    if (has_24_bits() && area.word != 0)
        add_depth_24(a, b, c);
}

Setup<Fixed>::Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& provoking,
                    bool along_x, std::int32_t begin, std::int32_t end, bool of_x)
    : span_(span), state_(*span.state) {
    along_axis(a, b, {begin, end, along_x, of_x});
    third_vertex_ = &a;
    if (has_24_bits()) // before attributes() may unsnap the axis: depth always goes through snapped ends
        add_depth_24_along();
    attributes(provoking);
}

Setup<Fixed>::Setup(Span<Fixed>& span, const Vertex& v) : Setup(span, v, v, v, true, v.x, v.x) {}

} // namespace spangle::raster
