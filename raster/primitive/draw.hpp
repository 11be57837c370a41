// Draws primitives in window space as fragments. These functions are the one interface between GL and pixels.
// A band recorder can take their place.
#pragma once

#include <cstdint>

#include "raster/span/draw_state.hpp"
#include "raster/span/vertex.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// Twice the signed area of a window-space triangle, n.16, exact. It is positive for counter-clockwise order
/// with y up.
template <bool LongProducts = numeric::long_products>
constexpr std::int64_t signed_area(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by,
                                   std::int32_t cx, std::int32_t cy) {
    const std::int32_t right = bx - ax, up = cy - ay, left = ax - cx, rise = by - ay;
    if constexpr (!LongProducts) {
        const auto magnitude = [](std::int32_t v) { return v ^ (v >> 31); };
        if (((magnitude(right) | magnitude(up) | magnitude(left) | magnitude(rise)) >> 14) == 0)
            return right * up + left * rise; // each product is below 2^28
    }
    return numeric::mul_s32(right, up) + numeric::mul_s32(left, rise); // exact, in 64 bits
}

/// Draws a triangle. V is FixedVertex, DoubleVertex or ShadowVertex; firmware has the fixed one only.
/// `provoking` gives the colour where state.flat is set. area2 is signed_area() of the three vertices and
/// never 0.
template <class V>
void draw_triangle(const DrawState& state, const Surface& target, const V& a, const V& b, const V& c,
                   const V& provoking, std::int64_t area2);

/// Draws a line by diamond exit, without its last fragment (GL 1.3, 3.4). The width is in whole pixels, at
/// least 1.
template <class V>
void draw_line(const DrawState& state, const Surface& target, const V& a, const V& b, const V& provoking,
               std::int32_t width);

/// Draws lines from vertices i to i + 1 of n, i = 0, step, 2 step, and so on. `step` is 1 for a strip and 2
/// for separate lines. Several lines at a time are faster than each alone. All lines have the colour of
/// `painted`; it is null where they may differ.
template <class V>
void draw_lines(const DrawState& state, const Surface& target, const V* const* vertex, int n, int step,
                const V* /*painted*/, std::int32_t width) {
    for (int i = 0; i + 1 < n; i += step)
        draw_line(state, target, *vertex[i], *vertex[i + 1], *vertex[i + 1], width);
}
template <>
void draw_lines<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex* const* vertex,
                             int n, int step, const FixedVertex* painted, std::int32_t width);

struct LineStipple; // defined in line_stipple.hpp

/// Draws the fragments of a line that the stipple leaves. The next line goes on in the stipple where this
/// line ends (GL 1.3, 3.4.2).
template <class V>
void draw_stippled_line(const DrawState& state, const Surface& target, const V& a, const V& b,
                        const V& provoking, std::int32_t width, LineStipple& stipple);

/// Draws antialiased primitives (GL 1.3, 3.3, 3.4.2, 3.5.3): every pixel that the disc, the rectangle or the
/// convex polygon reaches, with its area there. The state must have coverage, and `primitive` must be the one
/// given. Sizes count 1/8 of a pixel, up to 64 pixels. A stipple cuts a line into parts of length 1.
template <class V>
void draw_smooth_point(const DrawState& state, const Surface& target, PrimitiveState& primitive, const V& v,
                       std::int32_t eighths);
template <class V>
void draw_smooth_line(const DrawState& state, const Surface& target, PrimitiveState& primitive, const V& a,
                      const V& b, const V& provoking, std::int32_t eighths, LineStipple* stipple);
template <class V>
void draw_smooth_polygon(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                         const V* const* corner, int corners, const V& provoking);

/// Draws primitives of multisample rasterization (GL 1.3, 3.3.2, 3.4.4). Their fragments have centres in the
/// disc of a point, including its rim, or in the rectangle of a line. Sizes count 1/8 of a pixel. A stipple
/// cuts a line into parts of length 1.
template <class V>
void draw_disc(const DrawState& state, const Surface& target, const V& v, std::int32_t eighths);
template <class V>
void draw_line_rectangle(const DrawState& state, const Surface& target, const V& a, const V& b,
                         const V& provoking, std::int32_t eighths, LineStipple* stipple);

/// Draws an aliased point (GL 1.3, 3.3). The size is in whole pixels, at least 1.
template <class V>
void draw_point(const DrawState& state, const Surface& target, const V& v, std::int32_t size);

/// Receives fragments whose positions the caller finds.
struct PixelSink {
    /// Draws fragments [begin, end) of row y, cut by the scissor rectangle. Where the state asks for colours
    /// (DrawState::pixels), `pixels` holds them, with room for `pixel_room` more behind.
    void (*run)(PixelSink& sink, std::int32_t y, std::int32_t begin, std::int32_t end, const void* pixels);
    /// Sets the depth of the next fragments, in Q0.30.
    void (*depth)(PixelSink& sink, std::uint32_t z);
};
inline constexpr int pixel_room = 16;

struct PixelSource {
    void (*emit)(PixelSource& source, PixelSink& sink);
};

/// Draws the fragments of a pixel rectangle or bitmap (GL 1.3, 3.6.4, 3.7). All attributes except place,
/// colour and depth are those of `at`, whose x and y do not matter.
template <class V>
void draw_pixels(const DrawState& state, const Surface& target, const V& at, PixelSource& source);

} // namespace spangle::raster
