// Finds GL's entry points by name, for eglGetProcAddress.
#pragma once

#include "gl/context/features.hpp"

namespace spangle::gl {

using EntryPoint = void (*)();

/// Returns the entry point with this name, such as "glBegin", or null if there is none. Without
/// SPANGLE_FEATURE_GET_PROC_ADDRESS the result is always null.
EntryPoint find_entry_point(const char* name);

} // namespace spangle::gl
