#include "raster/primitive/line.hpp"
#include "raster/primitive/pixels.hpp"
#include "raster/primitive/point.hpp"
#include "raster/primitive/setup_shadow.hpp"
#include "raster/primitive/shapes.hpp"
#include "raster/primitive/smooth.hpp"
#include "raster/primitive/triangle.hpp"

namespace spangle::raster {

template <>
void draw_triangle<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& a,
                                 const ShadowVertex& b, const ShadowVertex& c, const ShadowVertex& provoking,
                                 std::int64_t area2) {
    draw_triangle_of<Shadow>(state, target, a, b, c, provoking, area2);
}

template <>
void draw_line<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& a,
                             const ShadowVertex& b, const ShadowVertex& provoking, std::int32_t width) {
    draw_line_of<Shadow>(state, target, a, b, provoking, width);
}

template <>
void draw_stippled_line<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& a,
                                      const ShadowVertex& b, const ShadowVertex& provoking,
                                      std::int32_t width, LineStipple& stipple) {
    draw_line_of<Shadow>(state, target, a, b, provoking, width, StippledLine{stipple});
}

template <>
void draw_point<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& v,
                              std::int32_t size) {
    draw_point_of<Shadow>(state, target, v, size);
}

template <>
void draw_smooth_point<ShadowVertex>(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                                     const ShadowVertex& v, std::int32_t eighths) {
    draw_smooth_point_of<Shadow>(state, target, primitive, v, eighths);
}

template <>
void draw_smooth_line<ShadowVertex>(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                                    const ShadowVertex& a, const ShadowVertex& b,
                                    const ShadowVertex& provoking, std::int32_t eighths,
                                    LineStipple* stipple) {
    draw_smooth_line_of<Shadow>(state, target, primitive, a, b, provoking, eighths, stipple);
}

template <>
void draw_smooth_polygon<ShadowVertex>(const DrawState& state, const Surface& target,
                                       PrimitiveState& primitive, const ShadowVertex* const* corner,
                                       int corners, const ShadowVertex& provoking) {
    draw_smooth_polygon_of<Shadow>(state, target, primitive, corner, corners, provoking);
}

template <>
void draw_disc<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& v,
                             std::int32_t eighths) {
    draw_disc_of<Shadow>(state, target, v, eighths);
}

template <>
void draw_line_rectangle<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& a,
                                       const ShadowVertex& b, const ShadowVertex& provoking,
                                       std::int32_t eighths, LineStipple* stipple) {
    draw_line_rectangle_of<Shadow>(state, target, a, b, provoking, eighths, stipple);
}

template <>
void draw_pixels<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& at,
                               PixelSource& source) {
    draw_pixels_of<Shadow>(state, target, at, source);
}

} // namespace spangle::raster
