// Chooses how elements of arrays come from the cache of vertices.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "gl/vertex/speed/element_paths.hpp"
#else
#include "gl/vertex/size/element_paths.hpp"
#endif
