// State of evaluators: maps, grids, and which maps are enabled (GL 1.3, 5.1).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

inline constexpr GLint max_eval_order = 8;

/// Targets of maps of one dimension, in the order of their tokens.
enum EvalTarget : unsigned {
    eval_color,
    eval_index,
    eval_normal,
    eval_texture_1,
    eval_texture_4 = eval_texture_1 + 3,
    eval_vertex_3,
    eval_vertex_4,
    eval_targets,
};

/// A map. Its control points follow it in the same block of memory. Point (i, j) of k components starts at
/// Real number (i * side[1].order + j) * k.
struct EvalMap {
    struct Side {
        GLint order;
        Real from, to; ///< ends of the domain
    } side[2];         ///< sides u and v; a map of one dimension has order 1 in v

    Real* points() { return reinterpret_cast<Real*>(this + 1); }
    const Real* points() const { return reinterpret_cast<const Real*>(this + 1); }
};

struct EvalState {
#if SPANGLE_FEATURE_EVALUATORS
    bool enabled[2][eval_targets] = {}; ///< indexed by dimension and target: MAP1_..., MAP2_...
    bool auto_normal = false;
    EvalMap* map[2][eval_targets] = {}; ///< indexed by dimension and target; null: the initial map
    GLint segments_1 = 1, segments_2[2] = {1, 1};
    Real domain_1[2] = {numeric::zero, numeric::one};
    Real domain_2[4] = {numeric::zero, numeric::one, numeric::zero, numeric::one};
#endif
};

} // namespace spangle::gl
