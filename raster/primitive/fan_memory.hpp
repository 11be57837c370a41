// Chooses how many triangles of a fan are walked along with its outline.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/fan_memory.hpp"
#else
#include "raster/primitive/size/fan_memory.hpp"
#endif
