// Chooses the stages of a chain, where several would draw the same bytes.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/chain/speed/stage_choice.hpp"
#else
#include "raster/chain/size/stage_choice.hpp"
#endif
