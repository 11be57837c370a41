// Chooses whether factors of texels are looked up or computed.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/ops/speed/texel_factor.hpp"
#else
#include "raster/ops/size/texel_factor.hpp"
#endif
