// The reference policy. It computes every formula of the specification in double. It is compiled on hosts
// only.
#pragma once

#include <cmath>

#include "raster/ops/number.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

struct Double {
    using Vertex = DoubleVertex;
    using Affine = double;
    using Projective = double;
};

/// min(max(v, 0), 1). NaN becomes 0.
inline double clamp01(double v) {
    return v > 0 ? (v < 1 ? v : 1) : 0;
}

/// v, or 0 where the texels of v do not fit an int32. This happens where 1/w or q are not positive, which GL
/// leaves undefined.
inline double bounded_or_zero(double v) {
    return std::fabs(v) < 1 << 20 ? v : 0;
}

/// The number system of the reference. Components are 0 .. 1.
struct Reference {
    using Policy = Double;
    static constexpr int lanes = 1;
    using L = Lanes<1>;
    using T = double;
    using Color = Rgba<double>;
    using Coord = TexCoords<double, 1>; ///< s / q and t / q
    using Fog = double;                 ///< eye distance
    static constexpr double one = 1;

    static T from8(std::uint32_t k) { return k / 255.0; }
    static T from6(std::uint32_t k) { return k / 63.0; }
    static T from5(std::uint32_t k) { return k / 31.0; }
    static T texel5(std::uint32_t k) { return from5(k); }
    static T texel3(std::uint32_t k) { return from_units((k * color_one + 6) / 7); }
    static T texel6(std::uint32_t k) { return from6(k); }
    static T from_units(std::uint32_t c) { return static_cast<double>(c) / color_one; }
    /// The k for which k / 255 is nearest to v (GL 1.3, 2.13.9). Halves round up; 1e-9 makes up for the error
    /// of double.
    static std::uint32_t to8(T v) { return static_cast<std::uint32_t>(v * 255 + (0.5 + 1e-9)); }
    /// The dithered component. A colour on a threshold becomes the step above it; 1e-9 makes up for the error
    /// of double.
    template <unsigned Bits> static std::uint32_t dithered(T v, std::uint32_t threshold32) {
        return static_cast<std::uint32_t>(v * ((1 << Bits) - 1) + (threshold32 / 32.0 + 1e-9));
    }
    static T mul(T a, T b) { return a * b; }
    static T add(T a, T b) { return a + b < 1 ? a + b : 1; }
    template <unsigned Bits> static T over(T s, T a, std::uint32_t k) {
        return add(s * a, (1 - a) * k / ((1u << Bits) - 1));
    }
    static T subtract(T a, T b) { return a > b ? a - b : 0; }
    static T lerp(T a, T b, T k) { return clamp01(a * (1 - k) + b * k); }
    static T weighted(T a, std::uint32_t wa, T b, std::uint32_t wb, T c, std::uint32_t wc, T d,
                      std::uint32_t wd) {
        return (a * wa + b * wb + c * wc + d * wd) / 65536;
    }
};

} // namespace spangle::raster
