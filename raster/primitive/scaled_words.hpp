// Chooses how words of scaled() are made.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/primitive/speed/scaled_words.hpp"
#else
#include "raster/primitive/size/scaled_words.hpp"
#endif
