// Chooses whether lines are drawn as paths.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/span/speed/has_paths.hpp"
#else
#include "raster/span/size/has_paths.hpp"
#endif
