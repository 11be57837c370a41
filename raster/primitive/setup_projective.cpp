// Planes over w, and the bounds that tell where affine ones will do.
#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

std::uint64_t Setup<Fixed>::add_projective(Interpolant<std::uint64_t>& at, const std::int32_t v[3]) {
    return projective(by_, at, v);
}

std::uint64_t Setup<Fixed>::projective(const Coefficients& by, Interpolant<std::uint64_t>& at,
                                       const std::int32_t v[3]) {
    const Gradient g = gradient(by, v[1] - v[0], v[2] - v[0]);
    const int n = by.exponent - guard_bits;
    at.value = (static_cast<std::uint64_t>(std::int64_t{v[0]}) << guard_bits) +
               static_cast<std::uint64_t>(scaled(g.center, n));
    at.dx = static_cast<std::uint64_t>(scaled(g.dx, n));
    at.dy = static_cast<std::uint64_t>(scaled(g.dy, n));
    return at.dy;
}

/// Colour times 1/w.
SPANGLE_INLINE static std::int32_t over_w(std::uint32_t color, std::int32_t q) {
    return mul30(static_cast<std::int32_t>(color << 2), q);
}

void Setup<Fixed>::projective_colors() {
    each_color([&](const ColorSource& from, int i, auto&, Interpolant<std::uint64_t>& at) {
        std::int32_t v[3];
        for (int k = 0; k < 3; ++k)
            v[k] = over_w(from.of[k][i], q_[k]);
        add_projective(at, v);
    });
}

/// Those of colours that were guessed, once one of them is asked for.
void Setup<Fixed>::project(Span<Fixed>& span) {
    const auto& guess = span.guess;
    projective(guess.by, span.q, guess.q);
    for (int i = 0; i < 3; ++i) {
        std::int32_t v[3];
        for (int k = 0; k < 3; ++k)
            v[k] = over_w(guess.color[k][i], guess.q[k]);
        projective(guess.by, span.color_q[i], v);
    }
}

/// Nothing is guessed, and nothing else has planes over w.
void Setup<Fixed>::divided_colors() {
    span_.q_dy = add_projective(span_.q, q_);
    projective_colors();
    if (!state_.guesses)
        return;
    span_.guess.doubt = 1u << 31;
    span_.guess.project = nullptr;
    for (auto& plane : span_.color_value)
        plane = {};
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

/// |error| of the affine form over a triangle is at most range(c) range(q) / (4 min(q)): the covariance of c
/// and q under any weights, over the mean of q.
bool Setup<Fixed>::bounded(std::uint32_t range, std::uint64_t four_tolerances) const {
    return numeric::mul_u32(range, q_range_) <= four_tolerances * q_least_;
}

bool Setup<Fixed>::colors_affine(std::uint32_t bits) {
    const std::uint32_t four = state_.four_color_tolerances;
    if (drawn(state_.tier) == Tier::fast || bounded(2 * bits, four))
        return true;
    widest_ = widest_range();
    return bounded(widest_, four);
}

/// Of the colours, one after the other.
std::uint32_t Setup<Fixed>::widest_range() const {
    std::uint32_t widest = 0;
    each_color([&](const ColorSource& from, int i, auto&, auto&) {
        const std::uint32_t range = range_of(0, from.difference(1, i), from.difference(2, i));
        widest = range > widest ? range : widest;
    });
    return widest;
}

} // namespace spangle::raster
