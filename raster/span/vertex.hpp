// A vertex of each numeric policy, and its position as coverage reads it.
#pragma once

#include <cstdint>

#include <spangle/raster/vertex.hpp>

namespace spangle::raster {

/// A vertex of the reference policy. x and y are the snapped position of the product, for coverage and depth.
/// All other attributes are doubles in GL's units (colours and depth are 0 .. 1). Their planes go through the
/// position before snapping.
struct DoubleVertex {
    std::int32_t x, y;
    double z, inv_w, fog;
    double color[4], secondary[3];
    struct TexCoord {
        double s, t, q, r;
    } tex[max_texture_units];
    double x_exact, y_exact; ///< window position before snapping
};

/// A vertex of the shadow policy. It holds a vertex of each other policy, so that every step can be compared
/// (docs/architecture/fragments.md, "Policies": diagnosis and profiling). The picture comes from `fixed`.
struct ShadowVertex {
    FixedVertex fixed;
    DoubleVertex twin;
};

/// Sets the depth of a vertex; z is in Q0.30.
inline void set_depth(FixedVertex& v, std::uint32_t z) {
    v.z = z;
}
inline void set_depth(DoubleVertex& v, std::uint32_t z) {
    v.z = z / double{depth_one};
}
inline void set_depth(ShadowVertex& v, std::uint32_t z) {
    set_depth(v.fixed, z);
    set_depth(v.twin, z);
}

/// The snapped position of a vertex (n.8). Coverage reads it in every policy.
struct Position {
    std::int32_t x, y;
};
constexpr Position position(const Position& p) {
    return p;
}
constexpr Position position(const FixedVertex& v) {
    return {v.x, v.y};
}
constexpr Position position(const DoubleVertex& v) {
    return {v.x, v.y};
}
constexpr Position position(const ShadowVertex& v) {
    return {v.fixed.x, v.fixed.y};
}

/// Moves a vertex to the position p. Its other attributes do not change.
constexpr void place(FixedVertex& v, const Position& p) {
    v.x = p.x;
    v.y = p.y;
}
constexpr void place(DoubleVertex& v, const Position& p) {
    v.x_exact += (p.x - v.x) / double{subpixel_one};
    v.y_exact += (p.y - v.y) / double{subpixel_one};
    v.x = p.x;
    v.y = p.y;
}
constexpr void place(ShadowVertex& v, const Position& p) {
    place(v.fixed, p);
    place(v.twin, p);
}

/// The position of a vertex before snapping, in pixels. Only some policies keep it.
struct ExactPosition {
    double x, y;
};
constexpr ExactPosition exact_position(const DoubleVertex& v) {
    return {v.x_exact, v.y_exact};
}
constexpr ExactPosition exact_position(const ShadowVertex& v) {
    return exact_position(v.twin);
}

} // namespace spangle::raster
