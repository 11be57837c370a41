#include "raster/primitive/pixels.hpp"

namespace spangle::raster {

template <>
void draw_pixels<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& at,
                              PixelSource& source) {
    draw_pixels_of<Fixed>(state, target, at, source);
}

} // namespace spangle::raster
