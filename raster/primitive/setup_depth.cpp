// Depth planes of 24 bits. A code is 2^-24 of the range, and a triangle of 2048 pixels has 4096 steps. So
// planes have 40 bits below the code, and gradients are within 2^-56 of their value. Fragments get the
// nearest code of the plane through the snapped vertices; near a tie it may be the code beside it.
#include "raster/primitive/setup.hpp"

#include "raster/numeric/wide.hpp"
#include "raster/primitive/setup_math.hpp"

namespace spangle::raster {

#if SPANGLE_DEPTH_FORMATS & 4

namespace {

using numeric::Wide;

constexpr std::uint64_t half_a_code = std::uint64_t{1} << 39;

/// The 24-bit code of the z of a vertex (Q0.30), with 40 fraction bits: z (2^24 - 1). So 1 becomes 2^64 minus
/// one code.
constexpr std::uint64_t code_24(std::uint32_t z) {
    return (std::uint64_t{z} << 34) - (std::uint64_t{z} << 10);
}
/// A difference in z of 2^-30, in the units of code_24().
constexpr Wide codes = numeric::make_wide((1 << 24) - 1, 10);

/// v rounded down, modulo 2^64.
constexpr std::uint64_t whole(Wide v) {
    return static_cast<std::uint64_t>(numeric::times_two_to(v.m, v.e));
}

/// Triangles whose window box is larger than 2^24 of their area have gradients that wrap, and hardly any
/// width.
constexpr int most_aspect_bits = 24;

} // namespace

/// Adds depth along an axis, for lines and points.
void Setup<Fixed>::add_depth_24_along() {
    const Wide difference = numeric::mul(
        numeric::make_wide(static_cast<std::int32_t>(v(1).z) - static_cast<std::int32_t>(v(0).z), 0), codes);
    const auto part = [&](std::int32_t coefficient) {
        return whole(numeric::mul(difference, numeric::make_wide(coefficient, -by().exponent)));
    };
    span_.z24.value = code_24(v(0).z) + half_a_code + part(by().center[0]);
    span_.z24.dx = part(by().dx[0]);
    span_.z24.dy = part(by().dy[0]);
}

/// Adds depth in the plane of a triangle, from the vertex at which its other planes are anchored.
void Setup<Fixed>::add_depth_24(const Vertex& a, const Vertex& b, const Vertex& c) {
    const Vertex &first = v(0), &second = &first == &a ? b : a, &third = &first == &c ? b : c;
    const std::int32_t x1 = second.x - first.x, y1 = second.y - first.y, x2 = third.x - first.x,
                       y2 = third.y - first.y;
    const auto z1 = static_cast<std::int32_t>(second.z - first.z),
               z2 = static_cast<std::int32_t>(third.z - first.z);
    const std::int64_t area = numeric::mul_s32(x1, y2) - numeric::mul_s32(x2, y1);
    const std::uint64_t box = numeric::mul_u32(range_of(0, x1, x2), range_of(0, y1, y2));
    if (numeric::abs_u64(area) <= box >> most_aspect_bits)
        return add_depth_24_along();
    // |z| <= 2^30 and |x|, |y| <= 2^22, so gradients times the area are 2^53 at most.
    const std::int64_t along_x = numeric::mul_s32(z1, y2) - numeric::mul_s32(z2, y1),
                       along_y = numeric::mul_s32(z2, x1) - numeric::mul_s32(z1, x2);
    const Wide per_subpixel = numeric::mul(codes, numeric::reciprocal(numeric::make_wide(area, 0)));
    const auto part = [&](std::int64_t v, int up) {
        return whole(numeric::mul(numeric::make_wide(v, up), per_subpixel));
    };
    const auto to_center = [](std::int32_t at) { return subpixel_one / 2 - (at & (subpixel_one - 1)); };
    span_.z24.value =
        code_24(first.z) + half_a_code + part(along_x * to_center(first.x) + along_y * to_center(first.y), 0);
    span_.z24.dx = part(along_x, subpixel_bits);
    span_.z24.dy = part(along_y, subpixel_bits);
}

#else // no depth buffer of this build has 24 bits, so spans have no plane for it

void Setup<Fixed>::add_depth_24_along() {}
void Setup<Fixed>::add_depth_24(const Vertex&, const Vertex&, const Vertex&) {}

#endif

} // namespace spangle::raster
