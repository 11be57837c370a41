// Chooses which cases draw their rows one after the other.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/fused/speed/rows_apart.hpp"
#else
#include "raster/fused/size/rows_apart.hpp"
#endif
