// Bezier curves and surfaces by de Casteljau's steps, in block form: each step rounds once, so that a value
// is within (order + 2) 2^-28 of the largest control point, and end points are exact (GL 1.3, 5.1).
#pragma once

#include "gl/vertex/eval_state.hpp"
#include "raster/numeric/block.hpp"

namespace spangle::gl {

/// Arithmetic in one place each: maps are not worth the bytes of many copies.
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

/// A place in a domain, from 0 to 1, and what is left to 1.
struct EvalPlace {
    numeric::Block t, rest;
};

/// 0 and 1 are exact at both ends of the domain, since quotients are that can be.
[[gnu::noinline]] inline EvalPlace place_in(const EvalMap::Side& side, Real at) {
    const numeric::Block from = evaluation::load(side.from), to = evaluation::load(side.to),
                         here = evaluation::load(at), width = evaluation::sub(to, from);
    return {evaluation::div(evaluation::sub(here, from), width),
            evaluation::div(evaluation::sub(to, here), width)};
}

/// A value, and its derivative with respect to the place.
struct EvalResult {
    numeric::Block value, slope;
};

/// Of a curve of the given order; overwrites its points.
[[gnu::noinline]] inline EvalResult evaluate_curve(numeric::Block (&p)[max_eval_order], GLint order,
                                                   const EvalPlace& at) {
    numeric::Block slope;
    for (GLint left = order - 1; left > 0; --left) {
        if (left == 1)
            slope = evaluation::mul(evaluation::sub(p[1], p[0]), numeric::make_block(order - 1, 0));
        for (GLint i = 0; i < left; ++i)
            p[i] = evaluation::add(evaluation::mul(p[i], at.rest), evaluation::mul(p[i + 1], at.t));
    }
    return {p[0], slope};
}

/// A component of a surface, and its derivatives.
struct EvalSurface {
    numeric::Block value, u, v;
};

/// Component c of k. A curve is a surface whose order in v is 1.
[[gnu::noinline]] inline EvalSurface evaluate_surface(const EvalMap& map, unsigned c, unsigned k,
                                                      const EvalPlace& u, const EvalPlace& v) {
    numeric::Block across[max_eval_order], slope[max_eval_order], along[max_eval_order];
    const Real* point = map.points() + c;
    for (GLint i = 0; i < map.side[0].order; ++i) {
        for (GLint j = 0; j < map.side[1].order; ++j, point += k)
            along[j] = evaluation::load(*point);
        const EvalResult r = evaluate_curve(along, map.side[1].order, v);
        across[i] = r.value;
        slope[i] = r.slope;
    }
    const EvalResult r = evaluate_curve(across, map.side[0].order, u);
    return {r.value, r.slope, evaluate_curve(slope, map.side[0].order, u).value};
}

} // namespace spangle::gl
