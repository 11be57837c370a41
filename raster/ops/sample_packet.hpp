// Chooses whether the texels of a packet are sampled and combined together.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "raster/ops/speed/sample_packet.hpp"
#else
#include "raster/ops/size/sample_packet.hpp"
#endif
