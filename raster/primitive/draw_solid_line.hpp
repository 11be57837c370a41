// Chooses the loop that draws lines without a stipple.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/draw_solid_line.hpp"
#else
#include "raster/primitive/size/draw_solid_line.hpp"
#endif
