#include "raster/primitive/line.hpp"
#include "raster/primitive/pixels.hpp"
#include "raster/primitive/point.hpp"
#include "raster/primitive/setup_double.hpp"
#include "raster/primitive/shapes.hpp"
#include "raster/primitive/smooth.hpp"
#include "raster/primitive/triangle.hpp"

namespace spangle::raster {

template <>
void draw_triangle<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& a,
                                 const DoubleVertex& b, const DoubleVertex& c, const DoubleVertex& provoking,
                                 std::int64_t area2) {
    draw_triangle_of<Double>(state, target, a, b, c, provoking, area2);
}

template <>
void draw_line<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& a,
                             const DoubleVertex& b, const DoubleVertex& provoking, std::int32_t width) {
    draw_line_of<Double>(state, target, a, b, provoking, width);
}

template <>
void draw_stippled_line<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& a,
                                      const DoubleVertex& b, const DoubleVertex& provoking,
                                      std::int32_t width, LineStipple& stipple) {
    draw_line_of<Double>(state, target, a, b, provoking, width, StippledLine{stipple});
}

template <>
void draw_point<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& v,
                              std::int32_t size) {
    draw_point_of<Double>(state, target, v, size);
}

template <>
void draw_smooth_point<DoubleVertex>(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                                     const DoubleVertex& v, std::int32_t eighths) {
    draw_smooth_point_of<Double>(state, target, primitive, v, eighths);
}

template <>
void draw_smooth_line<DoubleVertex>(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                                    const DoubleVertex& a, const DoubleVertex& b,
                                    const DoubleVertex& provoking, std::int32_t eighths,
                                    LineStipple* stipple) {
    draw_smooth_line_of<Double>(state, target, primitive, a, b, provoking, eighths, stipple);
}

template <>
void draw_smooth_polygon<DoubleVertex>(const DrawState& state, const Surface& target,
                                       PrimitiveState& primitive, const DoubleVertex* const* corner,
                                       int corners, const DoubleVertex& provoking) {
    draw_smooth_polygon_of<Double>(state, target, primitive, corner, corners, provoking);
}

template <>
void draw_disc<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& v,
                             std::int32_t eighths) {
    draw_disc_of<Double>(state, target, v, eighths);
}

template <>
void draw_line_rectangle<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& a,
                                       const DoubleVertex& b, const DoubleVertex& provoking,
                                       std::int32_t eighths, LineStipple* stipple) {
    draw_line_rectangle_of<Double>(state, target, a, b, provoking, eighths, stipple);
}

template <>
void draw_pixels<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& at,
                               PixelSource& source) {
    draw_pixels_of<Double>(state, target, at, source);
}

} // namespace spangle::raster
