// Planes over w, and the bounds that say where affine planes are good enough.
#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

std::uint64_t Setup<Fixed>::add_projective(Interpolant<std::uint64_t>& at, const std::int32_t v[3]) {
    return projective(by(), at, v);
}

std::uint64_t Setup<Fixed>::projective(const Coefficients& by, Interpolant<std::uint64_t>& at,
                                       const std::int32_t v[3]) {
    const Interpolant<std::uint64_t> plane = scaled_plane(by, v[1] - v[0], v[2] - v[0], guard_bits);
    at.value = (static_cast<std::uint64_t>(std::int64_t{v[0]}) << guard_bits) + plane.value;
    at.dx = plane.dx;
    at.dy = plane.dy;
    return plane.dy;
}

void Setup<Fixed>::projective_colors() {
    each_color([&](const ColorSource& from, int i, auto&, Interpolant<std::uint64_t>& at) {
        std::int32_t v[3];
        for (int k = 0; k < 3; ++k)
            v[k] = static_cast<std::int32_t>(from.of[k][i] << 2);
        over_w(v);
        add_projective(at, v);
    });
}

/// Makes the planes over w of colours that were guessed, when a fragment first needs one of them.
void Setup<Fixed>::project(Span<Fixed>& span) {
    const Basis& from = span.basis;
    projective(from.by, span.q, from.q);
    for (int i = 0; i < 3; ++i) {
        std::int32_t v[3];
        for (int k = 0; k < 3; ++k)
            v[k] = mul30(static_cast<std::int32_t>(from.v[k]->color[i] << 2), from.q[k]);
        projective(from.by, span.color_q[has_full ? i : 0], v);
    }
}

/// Sets up colours over w where no colour is guessed and no other attribute has planes over w.
void Setup<Fixed>::divided_colors() {
    if (unsnaps(state_))
        snap_where_w_ends();
    span_.q_dy = add_projective(span_.q, span_.basis.q);
    projective_colors();
    if (!has_fused_spans || !state_.guesses)
        return;
    span_.guess.doubt(1u << 31);
    span_.guess.project = nullptr;
    for (auto& plane : span_.color_value)
        plane = {};
}

/// Loads 1/w of reference vertices with several exponents, scaled to the highest exponent.
void Setup<Fixed>::weights_of_several_exponents() {
    const int e0 = v(0).w_exponent, e1 = v(1).w_exponent, e2 = v(2).w_exponent;
    const int highest = e0 > e1 ? (e0 > e2 ? e0 : e2) : (e1 > e2 ? e1 : e2);
    const auto scaled = [&](int i, int e) {
        const int down = 2 + highest - e;
        const std::uint32_t q = down < 32 ? v(i).w_mantissa >> down : 0;
        return static_cast<std::int32_t>(q != 0 ? q : 1);
    };
    q(0) = scaled(0, e0);
    q(1) = scaled(1, e1);
    q(2) = scaled(2, e2);
}

bool Setup<Fixed>::colors_affine(std::uint32_t bits) {
    const std::uint32_t four = state_.four_color_tolerances;
    constexpr bool any = SPANGLE_OWN_TIERS || (has_given_knobs && given_knobs.affine_color_bits == 0);
    if ((any || !has_chain) && four == any_color_tolerance)
        return true;
    return colors_within_tolerance(bits, four);
}

} // namespace spangle::raster
