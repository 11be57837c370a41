// Chooses which axes of textures are read by shifts.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/ops/speed/plain_axis.hpp"
#else
#include "raster/ops/size/plain_axis.hpp"
#endif
