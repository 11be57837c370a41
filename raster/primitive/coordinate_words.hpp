// Chooses how texture and fog coordinates become words.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/coordinate_words.hpp"
#else
#include "raster/primitive/size/coordinate_words.hpp"
#endif
