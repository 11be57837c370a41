// Chooses how the area of a triangle is computed.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/triangle_area.hpp"
#else
#include "raster/primitive/size/triangle_area.hpp"
#endif
