// GL's part of eglGetProcAddress.
#pragma once

#include "gl/context/features.hpp"

namespace spangle::gl {

using EntryPoint = void (*)();

/// The entry point called `name` ("glBegin"), or null; null for every name without
/// SPANGLE_FEATURE_GET_PROC_ADDRESS.
EntryPoint find_entry_point(const char* name);

} // namespace spangle::gl
