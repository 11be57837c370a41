// Parts of the vertex pipeline that a test makes alone, for the current context.
#pragma once

#include "gl/context/context.hpp"
#include "gl/vertex/fixed_lighting.hpp"
#include "gl/vertex/fixed_math.hpp"
#include "gl/vertex/shading.hpp"
#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {

using Vertex = gl::Vertex<gl::FixedMath>;

/// Makes what `Part` keeps from its users available to a test, and begins draws as Pipeline does.
template <class Part> struct Alone : Part {
    using Part::assembler_;
    using Part::modes_;
    using Part::state_;
    using Part::vertex_slot_;

    /// Begins a draw, as Pipeline::begin() does. Returns what derive() tells.
    gl::Stale begin(GLenum mode) {
        gl::Context& context = *gl::current_context();
        Part::context_ = &context;
        assembler_.begin(mode, vertex_slot_);
        const gl::Stale stale = Part::derive(context, mode);
        state_ = &gl::draw_state(context,
                                 mode == GL_POINTS ? gl::PrimitiveKind::points : gl::PrimitiveKind::polygons);
        return stale;
    }
    /// Processes a vertex with the current attributes.
    void process(Vertex& v, float x, float y, float z, float w = 1) {
        const gl::CurrentState& current = gl::current_context()->current;
        const float given[4] = {x, y, z, w};
        for (int c = 0; c < 4; ++c)
            v.position[c] = numeric::from_float(given[c]);
        v.set_normal(current.normal);
        Part::transform_vertex(v);
        Part::set_attributes_of(current, v);
    }
};

/// The context's own pipeline must derive everything anew after a part has taken the changes.
class VertexParts : public Canvas {
  protected:
    void TearDown() override {
        gl::current_context()->changed(gl::dirty_all);
        Canvas::TearDown();
    }
};

} // namespace spangle::test
