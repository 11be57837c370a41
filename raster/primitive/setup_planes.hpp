// Inline functions that several files of set-up use: gradients, and the loop over the colours that a state
// needs.
#pragma once

#include "raster/ops/lanes.hpp"
#include "raster/ops/line_lanes.hpp"
#include "raster/primitive/color_bounds.hpp"
#include "raster/primitive/setup.hpp"
#include "raster/primitive/setup_math.hpp"

namespace spangle::raster {

/// The gradient of an attribute that differs by d1 and d2 from its value at reference vertex 0. It counts
/// 2^-exponent of the unit of d.
SPANGLE_INLINE Setup<Fixed>::Gradient Setup<Fixed>::gradient(const Coefficients& by, std::int32_t d1,
                                                             std::int32_t d2) {
    return {numeric::mul_long(d1, by.dx[0]) + numeric::mul_long(d2, by.dx[1]),
            numeric::mul_long(d1, by.dy[0]) + numeric::mul_long(d2, by.dy[1]),
            numeric::mul_long(d1, by.center[0]) + numeric::mul_long(d2, by.center[1])};
}

/// The plane of an attribute that differs by d1 and d2 from its value at reference vertex 0, without this
/// value. It counts 2^-up of the unit of d.
SPANGLE_RUN_INLINE Interpolant<std::uint64_t>
Setup<Fixed>::scaled_plane(const Coefficients& by, std::int32_t d1, std::int32_t d2, int up) {
    const Gradient g = gradient(by, d1, d2);
    const int n = by.exponent - up;
    return {scaled_words(g.center, n), scaled_words(g.dx, n), scaled_words(g.dy, n)};
}

/// Makes a plane from differences for which fits_lifted() holds.
SPANGLE_INLINE static void add_lifted(Interpolant<std::uint32_t>& at, std::uint32_t first, std::int32_t d1,
                                      std::int32_t d2, std::uint32_t lift, const Coefficients& by) {
    const std::int32_t a = shift_by_lift(d1, lift), b = shift_by_lift(d2, lift);
    at.dx = lifted_word(a, b, by.dx);
    at.dy = lifted_word(a, b, by.dy);
    at.value = first + lifted_word(a, b, by.center);
}

/// Does what each_color() does, inline.
template <bool Rgb, class F> SPANGLE_INLINE void Setup<Fixed>::every_color(F add) const {
    const Needs& needs = state_.needs;
    if (Rgb || needs.rgb) {
        const int some = !Rgb && spans_by_gray.some && state_.textured_or_fogged && span_.gray ? 1 : 3;
#pragma GCC unroll numeric::runs_inline ? 3 : 1
        for (int i = 0; i < some; ++i)
            add(primary(), i, span_.color_value[i], span_.color_q[has_full ? i : 0]);
    }
    if (!Rgb && needs.alpha)
        add(primary(), 3, span_.color_value[3], span_.color_q[has_full ? 3 : 0]);
    if (has_color_sum && !Rgb && needs.secondary)
        for (int i = 0; i < 3; ++i)
            add(secondary(), i, span_.secondary[i], span_.secondary_q[i]);
}

/// The largest range of the first three components of colours. The range of three numbers is half of the sum
/// of their three distances.
SPANGLE_INLINE static std::uint32_t widest_of_three(const std::uint32_t (&a)[4], const std::uint32_t (&b)[4],
                                                    const std::uint32_t (&c)[4]) {
    using L = LineLanes<4>;
    const auto load = [](const std::uint32_t(&color)[4]) {
        L::Int v;
        __builtin_memcpy(&v, color, sizeof v);
        return v;
    };
    const auto apart = [](L::Int v, L::Int w) {
        const L::Int d = v - w;
        return L::negate(d >> 31, d);
    };
    const L::Int x = load(a), y = load(b), z = load(c), sum = apart(y, x) + apart(z, x) + apart(z, y);
    const std::int32_t some = sum[0] > sum[1] ? sum[0] : sum[1];
    return static_cast<std::uint32_t>(some > sum[2] ? some : sum[2]) >> 1;
}

/// The largest range of a colour component.
template <bool Rgb> SPANGLE_INLINE std::uint32_t Setup<Fixed>::color_range() const {
    if constexpr (Rgb && host_lanes > 1)
        return widest_of_three(v(0).color, v(1).color, v(2).color);
    std::uint32_t widest = 0;
    each_color<Rgb>([&](const ColorSource& from, int i, auto&, auto&) {
        const std::uint32_t range = range_of(0, from.difference(1, i), from.difference(2, i));
        widest = range > widest ? range : widest;
    });
    return widest;
}

/// Loads 1/w of the reference vertices with one exponent, and its range. Returns true where 1/w does not
/// vary.
SPANGLE_INLINE bool Setup<Fixed>::weights() {
    load_weights();
    const Ends ends(q(0), q(1), q(2));
    q_range_ = ends.range();
    q_least_ = static_cast<std::uint32_t>(ends.low);
    return q_range_ == 0;
}

/// Multiplies the values of an attribute at the three vertices by 1/w.
SPANGLE_RUN_INLINE void Setup<Fixed>::over_w(std::int32_t v[3]) const {
    for (int i = 0; i < 3; ++i)
        v[i] = mul30(v[i], q(i));
}

/// Whether the affine form of an attribute is within a tolerance. Its |error| over a triangle is at most
/// range(c) range(q) / (4 min(q)): the covariance of c and q under any weights, over the mean of q.
SPANGLE_INLINE bool Setup<Fixed>::is_within_tolerance(std::uint32_t range,
                                                      std::uint64_t four_tolerances) const {
    return numeric::mul_u32(range, q_range_) <= four_tolerances * q_least_;
}

} // namespace spangle::raster
