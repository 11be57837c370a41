// Chooses how a texture function mixes four texels.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/ops/speed/filter_texels.hpp"
#else
#include "raster/ops/size/filter_texels.hpp"
#endif
