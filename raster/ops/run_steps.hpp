// Chooses how runs of coordinates follow each other.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/ops/speed/run_steps.hpp"
#else
#include "raster/ops/size/run_steps.hpp"
#endif
