// Polygon stipple patterns as images in client memory: 32 x 32 bits of BITMAP (GL 1.3, 3.5.2 and 6.1.5).
#pragma once

#include "gl/pixel/pixel_store_state.hpp"
#include "gl/vertex/polygon_state.hpp"

namespace spangle::gl {

StipplePattern unpack_stipple(const PixelStore& store, const void* image);
void pack_stipple(const PixelStore& store, const StipplePattern& pattern, void* image);

} // namespace spangle::gl
