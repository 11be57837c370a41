// Finds GL's entry points by name, for eglGetProcAddress.
#pragma once

#include "gl/context/features.hpp"

namespace spangle::gl {

using EntryPoint = void (*)();

/// The entry point called `name` ("glBegin"), or null. Without SPANGLE_FEATURE_GET_PROC_ADDRESS it is always
/// null.
EntryPoint find_entry_point(const char* name);

} // namespace spangle::gl
