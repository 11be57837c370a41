// Evaluates Bezier curves and surfaces as sums of weighted control points, in words under one exponent (GL
// 1.3, 5.1). The error of a weight is at most 2^-30, and each sum is rounded once. The error of a value is
// therefore at most (order + 2) 2^-28 of the largest control point. End points are exact.
#pragma once

#include "gl/vertex/eval_state.hpp"
#include "raster/numeric/block.hpp"

namespace spangle::gl {

/// Operations that are not inlined. Evaluators are too rare to be worth many copies of this code.
namespace evaluation {

[[gnu::noinline]] inline numeric::Block add(numeric::Block a, numeric::Block b) {
    return numeric::add(a, b);
}
inline numeric::Block sub(numeric::Block a, numeric::Block b) {
    return evaluation::add(a, numeric::negate(b));
}
[[gnu::noinline]] inline numeric::Block mul(numeric::Block a, numeric::Block b) {
    return numeric::mul(a, b);
}
[[gnu::noinline]] inline numeric::Block div(numeric::Block a, numeric::Block b) {
    return numeric::div(a, b);
}
[[gnu::noinline]] inline numeric::Block load(Real v) {
    return numeric::to_block(v);
}
[[gnu::noinline]] inline Real store(numeric::Block v) {
    return numeric::to_real(v);
}

} // namespace evaluation

/// A place in a domain as fraction t from 0 to 1, and 1 - t as `rest`.
struct EvalPlace {
    numeric::Block t, rest;
};

/// Returns the place of a coordinate in its domain. At both ends the fractions 0 and 1 are exact, since the
/// division of a block by itself is exact.
[[gnu::noinline]] inline EvalPlace place_in(const EvalMap::Side& side, Real at) {
    const numeric::Block from = evaluation::load(side.from), to = evaluation::load(side.to),
                         here = evaluation::load(at), width = evaluation::sub(to, from);
    return {evaluation::div(evaluation::sub(here, from), width),
            evaluation::div(evaluation::sub(to, here), width)};
}

/// Weights of a curve's control points at a place, each w[i] * 2^exponent. `value` holds the Bernstein
/// polynomials, and `slope` their derivatives divided by the degree.
struct EvalWeights {
    struct Words {
        std::int32_t w[max_eval_order] = {};
        std::int32_t exponent = 0;
    } value, slope;
};

namespace evaluation {

/// Converts n weights to words under one exponent. The largest word has `bits` bits.
[[gnu::noinline]] inline EvalWeights::Words words(const std::int64_t* w, GLint n, std::int32_t exponent,
                                                  int bits) {
    std::uint64_t any = 0;
    for (GLint i = 0; i < n; ++i)
        any |= numeric::abs_u64(w[i]);
    EvalWeights::Words out;
    const int down = any == 0 ? 0 : 64 - numeric::clz64(any) - bits;
    for (GLint i = 0; i < n; ++i)
        out.w[i] = static_cast<std::int32_t>(down > 0 ? (w[i] + (std::int64_t{1} << (down - 1))) >> down
                                                      : w[i] * (std::int64_t{1} << -down));
    out.exponent = exponent + down;
    return out;
}

/// Returns w * m / 2^30, for |m| <= 2^30.
inline std::int64_t part(std::int64_t w, std::int32_t m) {
    constexpr std::int32_t low = (1 << 30) - 1;
    return numeric::mul_s32(static_cast<std::int32_t>(w >> 30), m) +
           (numeric::mul_s32(static_cast<std::int32_t>(w & low), m) >> 30);
}

} // namespace evaluation

/// Computes weights by the recurrence of Bernstein polynomials, with 15 bits more than the result keeps.
/// Inside the domain, the weights of a value add up to 1, and those of a slope to at most 2. Sums of weighted
/// points then fit 63 bits. Outside of the domain, weights have two bits less.
[[gnu::noinline]] inline EvalWeights weights_of(GLint order, const EvalPlace& at) {
    constexpr int start = 52; // fraction bits of the first weight; a step at most doubles a weight
    std::int64_t w[max_eval_order] = {std::int64_t{1} << start};
    const std::int32_t m[2] = {at.t.m, at.rest.m}, e[2] = {at.t.e, at.rest.e};
    std::int32_t by[2] = {};
    const std::int32_t step = numeric::detail::under_one(2, m, e, by) + numeric::block_bits;
    const int bits = m[0] < 0 || m[1] < 0 ? numeric::block_bits - 2 : numeric::block_bits;
    EvalWeights out;
    std::int32_t exponent = -start;
    for (GLint k = 1; k < order; ++k) {
        if (k == order - 1) {
            const EvalWeights::Words before = evaluation::words(w, k, exponent, bits);
            out.slope.exponent = before.exponent;
            for (GLint i = 0; i <= k; ++i)
                out.slope.w[i] = (i > 0 ? before.w[i - 1] : 0) - (i < k ? before.w[i] : 0);
        }
        w[k] = evaluation::part(w[k - 1], by[0]);
        for (GLint i = k - 1; i > 0; --i)
            w[i] = evaluation::part(w[i], by[1]) + evaluation::part(w[i - 1], by[0]);
        w[0] = evaluation::part(w[0], by[1]);
        exponent += step;
    }
    out.value = evaluation::words(w, order, exponent, bits);
    return out;
}

namespace evaluation {

/// Returns the sum of weighted points. A point of weight 0 has no part in the common exponent. End points are
/// therefore exact, and surfaces that share the control points of an edge share the edge.
[[gnu::noinline]] inline numeric::Block combine(const numeric::Block* p, const EvalWeights::Words& by,
                                                GLint n) {
    constexpr std::int32_t none = -0x10000;
    std::int32_t top = none;
    for (GLint i = 0; i < n; ++i)
        if (by.w[i] != 0 && p[i].m != 0 && p[i].e > top)
            top = p[i].e;
    std::int64_t sum = 0;
    for (GLint i = 0; i < n && top != none; ++i)
        if (const std::int32_t below = top - p[i].e; below >= 0 && below < 63)
            sum += numeric::mul_s32(p[i].m, by.w[i]) >> below;
    return numeric::make_block(sum, top + by.exponent);
}

} // namespace evaluation

/// A component of a surface, and its derivatives by the places in u and v. Each derivative is divided by its
/// degree.
struct EvalSurface {
    numeric::Block value, u, v;
};

/// A surface at one v. Each component has the control points of the curve in u, and their derivatives in v.
struct EvalRow {
    Real at{};
    bool known = false;
    numeric::Block value[4][max_eval_order], slope[4][max_eval_order];
};

/// Reduces component c of k components to the curve in u at the given place in v. A curve (Map1) is a surface
/// of order 1 in v.
[[gnu::noinline]] inline void reduce(const EvalMap& map, unsigned c, unsigned k, const EvalWeights& v,
                                     bool slopes, numeric::Block (&value)[max_eval_order],
                                     numeric::Block (&slope)[max_eval_order]) {
    const Real* point = map.points() + c;
    const GLint order = map.side[1].order;
    for (GLint i = 0; i < map.side[0].order; ++i) {
        numeric::Block along[max_eval_order];
        for (GLint j = 0; j < order; ++j, point += k)
            along[j] = evaluation::load(*point);
        value[i] = evaluation::combine(along, v.value, order);
        if (slopes)
            slope[i] = evaluation::combine(along, v.slope, order);
    }
}

/// Returns a component of the surface at a place in u, from the curve that reduce() made.
inline EvalSurface evaluate_row(const numeric::Block (&value)[max_eval_order],
                                const numeric::Block (&slope)[max_eval_order], GLint order,
                                const EvalWeights& u, bool slopes) {
    EvalSurface out;
    out.value = evaluation::combine(value, u.value, order);
    if (slopes) {
        out.u = evaluation::combine(value, u.slope, order);
        out.v = evaluation::combine(slope, u.value, order);
    }
    return out;
}

} // namespace spangle::gl
