// Chooses the code that converts a component of a vertex array.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "gl/vertex/speed/array_component.hpp"
#else
#include "gl/vertex/size/array_component.hpp"
#endif
