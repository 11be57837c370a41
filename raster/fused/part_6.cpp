// Part 6 of the table of fused spans.
#include "raster/fused/part.hpp"

template const spangle::raster::FusedSpan* spangle::raster::fused_part<6>();
