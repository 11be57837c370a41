// Evaluates maps: EvalCoord, EvalPoint, grids and meshes (GL 1.3, 5.1).
#include "gl/context/batches.hpp"
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_EVALUATORS

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/bernstein.hpp"
#include "gl/vertex/cache_memory.hpp"
#include "gl/vertex/color_tracking.hpp"
#include "gl/vertex/maps.hpp"

namespace spangle::gl {

namespace {

/// Returns the last enabled target from `first` to `last`, or eval_targets if none is enabled. The map with
/// the most components takes effect (GL 1.3, 5.1).
unsigned last_enabled_target(const bool (&enabled)[eval_targets], unsigned first, unsigned last) {
    for (unsigned t = last; t >= first; --t)
        if (enabled[t])
            return t;
    return eval_targets;
}

/// Evaluates all enabled maps at one coordinate, for one EvalCoord command.
class Evaluation {
  public:
    /// `row` caches the vertex map reduced to a curve at this v, for all vertices of a row. Null: the curve
    /// is not cached.
    Evaluation(Context& context, unsigned dimension, Real u, Real v, EvalRow* row = nullptr)
        : context_(context), dimension_(dimension), coordinate_{u, v}, row_(row) {}

    /// Gives a vertex with the values of the maps. Current values are as before afterwards (GL 1.3, 5.1).
    void run() {
        const bool(&on)[eval_targets] = context_.eval.enabled[dimension_];
        const unsigned vertex = last_enabled_target(on, eval_vertex_3, eval_vertex_4);
        if (vertex == eval_targets || !context_.inside_begin_end())
            return;
        const CurrentState before = context_.current;
        EvalSurface at[4];
        const bool normal = dimension_ == 1 && context_.eval.auto_normal;
        evaluate(vertex, at, normal, row_);
        attributes(on, vertex, at);
        Real p[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
        for (unsigned c = 0; c < components_of(vertex); ++c)
            p[c] = evaluation::store(at[c].value);
        cmd::Vertex(context_, p[0], p[1], p[2], p[3]);
        context_.current = before;
        if (on[eval_color]) // the material that tracks the colour gets its old value back
            follow_color(context_);
    }

  private:
    Context& context_;
    unsigned dimension_;
    Real coordinate_[2];
    EvalRow* row_;

    void attributes(const bool (&on)[eval_targets], unsigned vertex, EvalSurface (&at)[4]) {
        CurrentState& current = context_.current;
        if (on[eval_color]) {
            values(eval_color, current.color);
            follow_color(context_);
        }
        if (on[eval_index])
            values(eval_index, &current.index);
        if (dimension_ == 1 && context_.eval.auto_normal)
            auto_normal(vertex, at);
        else if (on[eval_normal])
            values(eval_normal, current.normal);
        if (const unsigned texture = last_enabled_target(on, eval_texture_1, eval_texture_4);
            texture != eval_targets) {
            Real(&strq)[4] = current.tex_coord[0].v;
            strq[1] = strq[2] = numeric::zero; // a smaller map leaves these components at their defaults
            strq[3] = numeric::one;
            values(texture, strq);
        }
    }

    /// Evaluates all components of a target.
    [[gnu::noinline]] void evaluate(unsigned target, EvalSurface (&out)[4], bool slopes,
                                    EvalRow* row = nullptr) const {
        const EvalMap& map = map_of(context_, dimension_, target);
        const GLint order = map.side[0].order;
        const EvalWeights u = weights(map.side[0], coordinate_[0]);
        const Real at_v = dimension_ == 0 ? map.side[1].from : coordinate_[1];
        const bool known = row != nullptr && row->known && row->at.bits == at_v.bits;
        EvalWeights v;
        if (!known)
            v = weights(map.side[1], at_v);
        for (unsigned c = 0, k = components_of(target); c < k; ++c) {
            numeric::Block value[max_eval_order], slope[max_eval_order];
            if (row == nullptr) {
                reduce(map, c, k, v, slopes, value, slope);
                out[c] = evaluate_row(value, slope, order, u, slopes);
            } else {
                if (!known)
                    reduce(map, c, k, v, slopes, row->value[c], row->slope[c]);
                out[c] = evaluate_row(row->value[c], row->slope[c], order, u, slopes);
            }
        }
        if (row != nullptr) {
            row->known = true;
            row->at = at_v;
        }
    }
    static EvalWeights weights(const EvalMap::Side& side, Real at) {
        return weights_of(side.order, place_in(side, at));
    }

    [[gnu::noinline]] void values(unsigned target, Real* out) const {
        EvalSurface at[4];
        evaluate(target, at, false);
        for (unsigned c = 0; c < components_of(target); ++c)
            out[c] = evaluation::store(at[c].value);
    }

    /// Sets the normal to dq/du x dq/dv, normalised (GL 1.3, 5.1). q is the point p, or xyz / w of a p with
    /// four components. The derivatives of that quotient leave out the factor 1 / w^2, which is positive.
    [[gnu::noinline]] void auto_normal(unsigned vertex, EvalSurface (&p)[4]) {
        for (int c = 0; c < 3 && vertex == eval_vertex_4; ++c) {
            p[c].u = quotient_slope(p[c], p[c].u, p[3], p[3].u);
            p[c].v = quotient_slope(p[c], p[c].v, p[3], p[3].v);
        }
        const EvalMap& map = map_of(context_, dimension_, vertex);
        // Slopes are derivatives by t from 0 to 1. A domain that runs backwards reverses their sign.
        const bool turned = (map.side[0].to < map.side[0].from) != (map.side[1].to < map.side[1].from);
        const numeric::Block3 along_u = numeric::to_block(p[0].u, p[1].u, p[2].u),
                              along_v = numeric::to_block(p[0].v, p[1].v, p[2].v);
        const numeric::Unit3 n =
            numeric::normalize(numeric::cross(turned ? along_v : along_u, turned ? along_u : along_v));
        for (int c = 0; c < 3; ++c)
            context_.current.normal[c] = evaluation::store(numeric::make_block(n.m[c], -numeric::block_bits));
    }

    [[gnu::noinline]] static numeric::Block quotient_slope(const EvalSurface& p, numeric::Block slope,
                                                           const EvalSurface& w, numeric::Block w_slope) {
        return evaluation::sub(evaluation::mul(slope, w.value), evaluation::mul(p.value, w_slope));
    }
};

/// Returns the coordinate of grid point i of n segments over a domain. Both ends are exact (GL 1.3, 5.1).
[[gnu::noinline]] Real grid_point(Real from, Real to, GLint n, GLint i) {
    if (i == 0)
        return from;
    if (i == n)
        return to;
    const numeric::Block start = evaluation::load(from),
                         step = evaluation::div(evaluation::sub(evaluation::load(to), start),
                                                numeric::make_block(n, 0));
    return evaluation::store(evaluation::add(start, evaluation::mul(step, numeric::make_block(i, 0))));
}

void grid_vertex(Context& context, GLint i) {
    const EvalState& e = context.eval;
    Evaluation(context, 0, grid_point(e.domain_1[0], e.domain_1[1], e.segments_1, i), numeric::zero).run();
}

[[gnu::noinline]] void grid_vertex(Context& context, GLint i, GLint j, EvalRow* row = nullptr) {
    const EvalState& e = context.eval;
    Evaluation(context, 1, grid_point(e.domain_2[0], e.domain_2[1], e.segments_2[0], i),
               grid_point(e.domain_2[2], e.domain_2[3], e.segments_2[1], j), row)
        .run();
}

/// True if a map of vertices is enabled. Otherwise a mesh has no vertices, and its loop is skipped.
bool has_vertices(const Context& context, unsigned dimension) {
    return last_enabled_target(context.eval.enabled[dimension], eval_vertex_3, eval_vertex_4) != eval_targets;
}

/// Caches the vertex maps of two neighbouring rows of a mesh, reduced to curves. Each vertex is then a point
/// of a curve. Builds for size have no memory for this cache.
struct MeshRows {
    static constexpr int kept = kept_mesh_rows;
    EvalRow at[kept == 0 ? 1 : kept];
    EvalRow* row(GLint j) { return kept == 0 ? nullptr : at + (j & 1); }
};

/// Draws points `first` to `last` of row j, or of column j, as one primitive. A quad strip takes the points
/// of row j + 1, too. Points of all rows belong to one primitive, which the caller begins.
[[gnu::noinline]] void draw_mesh_strip(Context& context, GLenum mode, GLint first, GLint last, GLint j,
                                       bool column, MeshRows& rows) {
    if (mode != GL_POINTS)
        cmd::Begin(context, mode);
    for (std::int64_t at = first; at <= last && !is_skipped(context); ++at) {
        const auto i = static_cast<GLint>(at);
        const GLint v = column ? i : j;
        grid_vertex(context, column ? j : i, v, column ? nullptr : rows.row(v));
        if (mode == GL_QUAD_STRIP)
            grid_vertex(context, i, j + 1, rows.row(j + 1));
    }
    if (mode != GL_POINTS)
        cmd::End(context);
}

} // namespace

namespace cmd {

void EvalCoord1(Context& context, Real u) {
    Evaluation(context, 0, u, numeric::zero).run();
}

void EvalCoord2(Context& context, Real u, Real v) {
    Evaluation(context, 1, u, v).run();
}

void EvalPoint1(Context& context, GLint i) {
    grid_vertex(context, i);
}

void EvalPoint2(Context& context, GLint i, GLint j) {
    grid_vertex(context, i, j);
}

void MapGrid1(Context& context, GLint un, Real u1, Real u2) {
    if (un < 1)
        return error(context, GL_INVALID_VALUE);
    EvalState& e = context.eval;
    e.segments_1 = un;
    e.domain_1[0] = u1;
    e.domain_1[1] = u2;
}

void MapGrid2(Context& context, GLint un, Real u1, Real u2, GLint vn, Real v1, Real v2) {
    if (un < 1 || vn < 1)
        return error(context, GL_INVALID_VALUE);
    EvalState& e = context.eval;
    e.segments_2[0] = un;
    e.segments_2[1] = vn;
    e.domain_2[0] = u1;
    e.domain_2[1] = u2;
    e.domain_2[2] = v1;
    e.domain_2[3] = v2;
}

void EvalMesh1(Context& context, GLenum mode, GLint i1, GLint i2) {
    if (mode != GL_POINT && mode != GL_LINE)
        return error(context, GL_INVALID_ENUM);
    Begin(context, mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
    for (std::int64_t i = i1; has_vertices(context, 0) && !is_skipped(context) && i <= i2; ++i)
        grid_vertex(context, static_cast<GLint>(i));
    End(context);
}

void EvalMesh2(Context& context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
    if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL)
        return error(context, GL_INVALID_ENUM);
    if (!has_vertices(context, 1))
        return;
    const GLenum rows = mode == GL_POINT ? GL_POINTS : mode == GL_LINE ? GL_LINE_STRIP : GL_QUAD_STRIP;
    MeshRows kept;
    if (mode == GL_POINT)
        Begin(context, rows);
    for (std::int64_t j = j1, end = std::int64_t{j2} + (mode != GL_FILL); j < end; ++j)
        draw_mesh_strip(context, rows, i1, i2, static_cast<GLint>(j), false, kept);
    if (mode == GL_POINT)
        End(context);
    if (mode != GL_LINE)
        return;
    for (std::int64_t i = i1, last = i2; i <= last; ++i)
        draw_mesh_strip(context, rows, j1, j2, static_cast<GLint>(i), true, kept);
}

} // namespace cmd

} // namespace spangle::gl

#endif
