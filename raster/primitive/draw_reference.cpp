#include "raster/primitive/line.hpp"
#include "raster/primitive/point.hpp"
#include "raster/primitive/setup_double.hpp"
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
void draw_point<DoubleVertex>(const DrawState& state, const Surface& target, const DoubleVertex& v,
                              std::int32_t size) {
    draw_point_of<Double>(state, target, v, size);
}

} // namespace spangle::raster
