#include "raster/primitive/line.hpp"
#include "raster/primitive/point.hpp"
#include "raster/primitive/setup_shadow.hpp"
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
void draw_point<ShadowVertex>(const DrawState& state, const Surface& target, const ShadowVertex& v,
                              std::int32_t size) {
    draw_point_of<Shadow>(state, target, v, size);
}

} // namespace spangle::raster
