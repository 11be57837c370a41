#include "raster/primitive/draw.hpp"

#include "raster/primitive/point.hpp"
#include "raster/primitive/triangle.hpp"

namespace spangle::raster {

template <>
void draw_triangle<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                                const FixedVertex& b, const FixedVertex& c, const FixedVertex& provoking,
                                std::int64_t area2) {
    draw_triangle_of<Fixed>(state, target, a, b, c, provoking, area2);
}

template <>
void draw_point<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& v,
                             std::int32_t size) {
    draw_point_of<Fixed>(state, target, v, size);
}

} // namespace spangle::raster
