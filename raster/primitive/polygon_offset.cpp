#include "raster/primitive/polygon_offset.hpp"

#include "raster/numeric/reciprocal.hpp"

namespace spangle::raster {

namespace {

/// An offset beyond this limit clamps every fragment to one end of the depth range.
constexpr std::int64_t beyond_all = std::int64_t{1} << 34;

/// +-mantissa 2^exponent with the mantissa below 2^62. The size is rounded down, and is at most beyond_all.
std::int64_t saturated(bool negative, std::uint64_t mantissa, int exponent) {
    std::uint64_t size = 0;
    if (exponent <= 0)
        size = exponent > -63 ? mantissa >> -exponent : 0;
    else if (mantissa != 0)
        size = exponent < 34 && mantissa <= static_cast<std::uint64_t>(beyond_all) >> exponent
                   ? mantissa << exponent
                   : static_cast<std::uint64_t>(beyond_all);
    if (size > static_cast<std::uint64_t>(beyond_all))
        size = static_cast<std::uint64_t>(beyond_all);
    return negative ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
}

/// The change of depth from pixel to pixel along the axis where it is largest, times |area2|, in 2^-38.
std::uint64_t steepest_slope(const FixedVertex& a, const FixedVertex& b, const FixedVertex& c) {
    const auto z1 = std::int64_t{b.z} - a.z, z2 = std::int64_t{c.z} - a.z;
    const std::uint64_t along_x = numeric::abs_u64(z1 * (c.y - a.y) - z2 * (b.y - a.y));
    const std::uint64_t along_y = numeric::abs_u64(z1 * (c.x - a.x) - z2 * (b.x - a.x));
    return along_x > along_y ? along_x : along_y;
}

} // namespace

template <>
void set_depth_offset<FixedVertex>(PrimitiveState& out, const PolygonOffset& offset, DepthFormat format,
                                   const FixedVertex& a, const FixedVertex& b, const FixedVertex& c,
                                   std::int64_t area2) {
    const bool of_16 = format == DepthFormat::z16;
    const int bits = of_16 ? 16 : 24, resolved_bits = of_16 ? 16 : 23;
    const auto units = numeric::detail::unpack(offset.units), factor = numeric::detail::unpack(offset.factor);
    out.depth_offset = saturated(units.negative, units.mantissa, units.exponent + 32 - resolved_bits);
    const std::uint64_t most = steepest_slope(a, b, c);
    if (most == 0 || area2 == 0)
        return;
    // m = most / |area2| 2^-22 = q 2^exponent, where q is less than 2^-30 of itself too small.
    const int up = numeric::clz64(most) - 1, zeros = numeric::clz64(numeric::abs_u64(area2));
    const int down = zeros < 32 ? 32 - zeros : 0;
    auto q = static_cast<std::uint64_t>(numeric::quotient(
        static_cast<std::int64_t>(most << up), static_cast<std::uint32_t>(numeric::abs_u64(area2) >> down)));
    // The exponent of the depth offset, in which 2^32 is the range of depth plus one code.
    int exponent = 10 - up - down;
    q -= q >> bits;
    if (const int excess = 26 - numeric::clz64(q); excess > 0) {
        q >>= excess;
        exponent += excess;
    }
    out.depth_offset += saturated(factor.negative, q * factor.mantissa, exponent + factor.exponent);
}

} // namespace spangle::raster
