#include "raster/primitive/smooth.hpp"

namespace spangle::raster {

template <>
void draw_smooth_point<FixedVertex>(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                                    const FixedVertex& v, std::int32_t eighths) {
    draw_smooth_point_of<Fixed>(state, target, primitive, v, eighths);
}

template <>
void draw_smooth_line<FixedVertex>(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                                   const FixedVertex& a, const FixedVertex& b, const FixedVertex& provoking,
                                   std::int32_t eighths, LineStipple* stipple) {
    draw_smooth_line_of<Fixed>(state, target, primitive, a, b, provoking, eighths, stipple);
}

template <>
void draw_smooth_polygon<FixedVertex>(const DrawState& state, const Surface& target,
                                      PrimitiveState& primitive, const FixedVertex* const* corner,
                                      int corners, const FixedVertex& provoking) {
    draw_smooth_polygon_of<Fixed>(state, target, primitive, corner, corners, provoking);
}

} // namespace spangle::raster
