// The maps of evaluators, as commands, display lists and evaluation see them (GL 1.3, 5.1).
#pragma once

#include "gl/context/error.hpp"
#include "gl/vertex/eval_state.hpp"

namespace spangle::gl {

struct Context;

/// What Map1 and Map2 are given; of Map1, v has order 1.
struct MapArguments {
    GLenum target;
    struct Side {
        Real from, to;
        GLint stride, order;
    } side[2];
    Values points;
};

/// Those of Map1.
inline MapArguments map_arguments(GLenum target, Real u1, Real u2, GLint stride, GLint order,
                                  const Values& points) {
    return {target, {{u1, u2, stride, order}, {numeric::zero, numeric::one, 4, 1}}, points};
}

/// Components of a control point: 1 to 4.
unsigned components_of(unsigned target);

/// The error of arguments that no state makes right, or GL_NO_ERROR. `dimension`: 0 for Map1, 1 for Map2.
GLenum map_error(const MapArguments& map, unsigned dimension);

/// The rule behind its INVALID_VALUE, for people; null: a pointer is null.
inline const char* map_rule([[maybe_unused]] const MapArguments& map) {
    return map.points.at == nullptr
               ? nullptr
               : SPANGLE_TEXT(
                     "an order is out of its range, a stride is less than a point, or a domain is empty");
}

/// One component of one control point.
Real control_value(const MapArguments& map, GLint i, GLint j, unsigned c);

/// The map of a target; one of order 1, the initial one, where none was given.
const EvalMap& map_of(const Context& context, unsigned dimension, unsigned target);

} // namespace spangle::gl
