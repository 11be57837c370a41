// Chooses when rows of a triangle are cut by the scissor rectangle.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/fill_rows.hpp"
#else
#include "raster/primitive/size/fill_rows.hpp"
#endif
