#include "raster/primitive/polygon_offset.hpp"

#include <bit>
#include <cmath>

#include "raster/primitive/draw.hpp"

namespace spangle::raster {

template <>
void set_depth_offset<DoubleVertex>(PrimitiveState& out, const PolygonOffset& offset, DepthFormat format,
                                    const DoubleVertex& a, const DoubleVertex& b, const DoubleVertex& c,
                                    std::int64_t area2) {
    const double factor = std::bit_cast<float>(numeric::to_float_bits(offset.factor)),
                 units = std::bit_cast<float>(numeric::to_float_bits(offset.units));
    // Products of a depth and a coordinate in n.8, divided by this area, are depths per pixel.
    const double area = static_cast<double>(area2) / subpixel_one;
    const double along_x = (b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y);
    const double along_y = (b.z - a.z) * (c.x - a.x) - (c.z - a.z) * (b.x - a.x);
    const double slope = area2 == 0 ? 0 : std::fmax(std::fabs(along_x), std::fabs(along_y)) / std::fabs(area);
    out.reference_depth_offset =
        slope * factor + units / (format == DepthFormat::z16 ? 65535.0 : 16777215.0 / 2);
}

template <>
void set_depth_offset<ShadowVertex>(PrimitiveState& out, const PolygonOffset& offset, DepthFormat format,
                                    const ShadowVertex& a, const ShadowVertex& b, const ShadowVertex& c,
                                    std::int64_t area2) {
    set_depth_offset(out, offset, format, a.fixed, b.fixed, c.fixed, area2);
    set_depth_offset(out, offset, format, a.twin, b.twin, c.twin, area2);
}

} // namespace spangle::raster
