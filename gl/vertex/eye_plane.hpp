// Transforms planes from object space, in which programs give them, to eye space, in which they are stored
// (GL 1.3, 2.10.4 and 2.11).
#pragma once

#include "gl/vertex/transform_state.hpp"

namespace spangle::gl {

/// Sets `out` to plane M^-1 for the current modelview matrix M. GL leaves a singular M undefined. The plane
/// is then stored as given.
void to_eye_plane(const TransformState& transform, const Real (&plane)[4], Real (&out)[4]);

} // namespace spangle::gl
