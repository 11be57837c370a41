// Chooses when a stage asks whether fragments are alive.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/chain/speed/run_asking.hpp"
#else
#include "raster/chain/size/run_asking.hpp"
#endif
