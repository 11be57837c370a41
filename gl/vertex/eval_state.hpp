// Evaluators: maps, grids, and what is on (GL 1.3, 5.1).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

inline constexpr GLint max_eval_order = 8;

/// The targets of one dimension, in the order of their tokens.
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

/// Control points follow in the same block: point (i, j) of k components at (i * order[1] + j) * k.
struct EvalMap {
    struct Side {
        GLint order;
        Real from, to; ///< the domain
    } side[2];         ///< u, v; a map of one dimension has order 1 in v

    Real* points() { return reinterpret_cast<Real*>(this + 1); }
    const Real* points() const { return reinterpret_cast<const Real*>(this + 1); }
};

struct EvalState {
#if SPANGLE_FEATURE_EVALUATORS
    bool enabled[2][eval_targets] = {}; ///< MAP1_..., MAP2_...
    bool auto_normal = false;
    EvalMap* map[2][eval_targets] = {}; ///< null: as initially
    GLint segments_1 = 1, segments_2[2] = {1, 1};
    Real domain_1[2] = {numeric::zero, numeric::one};
    Real domain_2[4] = {numeric::zero, numeric::one, numeric::zero, numeric::one};
#endif
};

} // namespace spangle::gl
