// Chooses what caches of vertices and meshes may keep.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "gl/vertex/speed/cache_memory.hpp"
#else
#include "gl/vertex/size/cache_memory.hpp"
#endif
