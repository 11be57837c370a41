// One element of the enabled vertex arrays, as canonical values (GL 1.3, 2.8).
#pragma once

#include "gl/vertex/arrays_state.hpp"

namespace spangle::gl {

struct ElementValues {
    bool has_color = false, has_normal = false, has_tex_coord = false, has_vertex = false;
    Real color[4], normal[3], tex_coord[4], vertex[4];
};

/// Reads element `index` of every enabled array whose pointer is not null.
ElementValues fetch_element(const ArraysState& arrays, std::uint32_t index);

} // namespace spangle::gl
