// The attribute stacks of server and client (GL 1.3, 6.1.12).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

struct SavedAttributes; // gl/context/attrib_stack.cpp defines it

struct AttribStack {
    SavedAttributes* top = nullptr;
    GLint depth = 0;
};

struct AttribState {
#if SPANGLE_FEATURE_ATTRIB_STACKS
    AttribStack server, client;
#endif
};

} // namespace spangle::gl
