// Maps of evaluators, for commands, display lists and evaluation (GL 1.3, 5.1).
#pragma once

#include "gl/context/error.hpp"
#include "gl/vertex/eval_state.hpp"

namespace spangle::gl {

struct Context;

/// Arguments of Map1 and Map2. A map of Map1 has order 1 in v.
struct MapArguments {
    GLenum target;
    struct Side {
        Real from, to;
        GLint stride, order;
    } side[2];
    Values points;
};

/// Returns the arguments of a Map1 command.
inline MapArguments map_arguments(GLenum target, Real u1, Real u2, GLint stride, GLint order,
                                  const Values& points) {
    return {target, {{u1, u2, stride, order}, {numeric::zero, numeric::one, 4, 1}}, points};
}

/// Returns the number of components of a control point, 1 to 4.
unsigned components_of(unsigned target);

/// Returns the error of arguments that are wrong in every state, or GL_NO_ERROR. `dimension` is 0 for Map1
/// and 1 for Map2.
GLenum map_error(const MapArguments& map, unsigned dimension);

/// Returns the message for an INVALID_VALUE of map_error(). Null: the pointer is null, which needs no
/// message.
inline const char* map_rule([[maybe_unused]] const MapArguments& map) {
    return map.points.at == nullptr
               ? nullptr
               : SPANGLE_TEXT(
                     "an order is out of its range, a stride is less than a point, or a domain is empty");
}

/// Returns component c of control point (i, j).
Real control_value(const MapArguments& map, GLint i, GLint j, unsigned c);

/// Returns the map of a target. Before the program sets one, that is the initial map of order 1. `dimension`
/// is 0 for Map1 and 1 for Map2.
const EvalMap& map_of(const Context& context, unsigned dimension, unsigned target);

} // namespace spangle::gl
