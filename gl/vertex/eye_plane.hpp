// Transforms planes, which are given in object space and kept in eye space (GL 1.3, 2.10.4 and 2.11).
#pragma once

#include "gl/vertex/transform_state.hpp"

namespace spangle::gl {

/// out = plane M^-1, where M is the current modelview matrix. GL leaves a singular M undefined; the plane is
/// then taken as if it were given in eye space.
void to_eye_plane(const TransformState& transform, const Real (&plane)[4], Real (&out)[4]);

} // namespace spangle::gl
