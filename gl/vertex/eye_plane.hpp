// Planes that are given in object space and kept in eye space (GL 1.3, 2.10.4 and 2.11).
#pragma once

#include "gl/vertex/transform_state.hpp"

namespace spangle::gl {

/// p M^-1 with the modelview matrix of this moment. With a singular one, which GL leaves open, the plane is
/// taken as if it were given in eye space.
void to_eye_plane(const TransformState& transform, const Real (&plane)[4], Real (&out)[4]);

} // namespace spangle::gl
