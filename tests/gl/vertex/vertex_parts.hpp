// Parts of the vertex pipeline that a test makes alone, for the current context.
#pragma once

#include <vector>

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
    using Part::context_;
    using Part::modes_;
    using Part::set_attributes_of;
    using Part::state_;
    using Part::transform_vertex;
    using Part::transforms_;
    using Part::vertex_slot_;

    /// Begins a draw, as Pipeline::begin() does. Returns what derive() tells.
    gl::Stale begin(GLenum mode) {
        gl::Context& context = *gl::current_context();
        context_ = &context;
        assembler_.begin(mode, vertex_slot_);
        const gl::Stale stale = Part::derive(context, mode);
        const gl::PrimitiveKind drawn = mode == GL_POINTS       ? gl::PrimitiveKind::points
                                        : mode <= GL_LINE_STRIP ? gl::PrimitiveKind::lines
                                                                : gl::PrimitiveKind::polygons;
        state_ = &gl::draw_state(context, drawn);
        context.fragments.primitive.stippled = drawn == gl::PrimitiveKind::polygons;
        return stale;
    }
    /// Processes a vertex with the current attributes. While primitives are captured, and where backs are
    /// lit, the vertex must be one of vertex_slot_.
    void process(Vertex& v, float x, float y, float z, float w = 1) {
        const gl::CurrentState& current = gl::current_context()->current;
        const float given[4] = {x, y, z, w};
        for (int c = 0; c < 4; ++c)
            v.position[c] = numeric::from_float(given[c]);
        v.set_normal(current.normal);
        Part::transform_vertex(v);
        Part::set_attributes_of(current, v);
        if (modes_.needs_vertex_state())
            Part::take_vertex_state(current, v);
    }
};

/// The context's own pipeline must derive everything anew after a part has taken the changes.
class VertexParts : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    void TearDown() override {
        gl::current_context()->changed(gl::dirty_all);
        Canvas::TearDown();
    }
    /// A window coordinate in pixels.
    static double pixels(std::int32_t coordinate) { return coordinate / double{raster::subpixel_one}; }
    static bool is_at(const raster::FixedVertex& v, const Vertex& corner) {
        return v.x == corner.window.x && v.y == corner.window.y;
    }
    static float red(const raster::FixedVertex& v) {
        numeric::Real color[4];
        gl::FixedMath::color_of(v, color);
        return numeric::to_float(color[0]);
    }
    /// Row y of the picture: true where the red of a pixel is not 0.
    static std::vector<bool> row_of_picture(int y) {
        std::vector<GLubyte> row(size * 4);
        glReadPixels(0, y, size, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
        std::vector<bool> drawn;
        for (std::size_t x = 0; x < size; ++x)
            drawn.push_back(row[4 * x] != 0);
        return drawn;
    }
};

} // namespace spangle::test
