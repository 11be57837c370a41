// Chooses how a triangle whose corners are sorted is drawn.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/draw_sorted.hpp"
#else
#include "raster/primitive/size/draw_sorted.hpp"
#endif
