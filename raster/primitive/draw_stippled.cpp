#include "raster/primitive/line.hpp"

namespace spangle::raster {

template <>
void draw_stippled_line<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                                     const FixedVertex& b, const FixedVertex& provoking, std::int32_t width,
                                     LineStipple& stipple) {
    draw_line_of<Fixed>(state, target, a, b, provoking, width, StippledLine{stipple});
}

} // namespace spangle::raster
