// Chooses the loops that fill bytes with a pattern.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/surface/speed/fill_pattern.hpp"
#else
#include "raster/surface/size/fill_pattern.hpp"
#endif
