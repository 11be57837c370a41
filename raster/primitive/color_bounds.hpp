// Chooses how the colours of three vertices are visited and compared.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/color_bounds.hpp"
#else
#include "raster/primitive/size/color_bounds.hpp"
#endif
