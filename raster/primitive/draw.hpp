// Window-space primitives to fragments: the one interface between GL and pixels. A band recorder can stand in
// for it.
#pragma once

#include <cstdint>

#include "raster/span/draw_state.hpp"
#include "raster/span/vertex.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// Twice the signed area of a window-space triangle, n.16; positive = counter-clockwise with y up. Exact.
template <bool LongProducts = numeric::long_products>
constexpr std::int64_t signed_area(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by,
                                   std::int32_t cx, std::int32_t cy) {
    const std::int32_t right = bx - ax, up = cy - ay, left = ax - cx, rise = by - ay;
    if constexpr (!LongProducts) {
        const auto magnitude = [](std::int32_t v) { return v ^ (v >> 31); };
        if (((magnitude(right) | magnitude(up) | magnitude(left) | magnitude(rise)) >> 14) == 0)
            return right * up + left * rise; // 2^28 each
    }
    return numeric::mul_s32(right, up) + numeric::mul_s32(left, rise); // words accumulate
}

/// V is FixedVertex, DoubleVertex or ShadowVertex; the fixed one is compiled into firmware, the others on
/// hosts only. `provoking` gives the colour when state.flat; area2 = signed_area of the three (never 0).
template <class V>
void draw_triangle(const DrawState& state, const Surface& target, const V& a, const V& b, const V& c,
                   const V& provoking, std::int64_t area2);

/// Diamond-exit line, width in whole pixels >= 1 (GL 1.3, 3.4). The last fragment is not drawn.
template <class V>
void draw_line(const DrawState& state, const Surface& target, const V& a, const V& b, const V& provoking,
               std::int32_t width);

/// Draws lines from vertices i to i + 1 of n, i = 0, step, ...: step is 1 for a strip, 2 for separate lines.
/// Several lines at a time are faster than each alone. `painted`: all lines are known to have its colour; or
/// null.
template <class V>
void draw_lines(const DrawState& state, const Surface& target, const V* const* vertex, int n, int step,
                const V* /*painted*/, std::int32_t width) {
    for (int i = 0; i + 1 < n; i += step)
        draw_line(state, target, *vertex[i], *vertex[i + 1], *vertex[i + 1], width);
}
template <>
void draw_lines<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex* const* vertex,
                             int n, int step, const FixedVertex* painted, std::int32_t width);

struct LineStipple; // line_stipple.hpp

/// Draws the fragments of a line that the stipple leaves. The stipple goes on where this line ends (GL 1.3,
/// 3.4.2).
template <class V>
void draw_stippled_line(const DrawState& state, const Surface& target, const V& a, const V& b,
                        const V& provoking, std::int32_t width, LineStipple& stipple);

/// Antialiased primitives (GL 1.3, 3.3, 3.4.2, 3.5.3): fragments of every pixel that the disc, the rectangle
/// or the convex polygon reaches, each with its area there. The state has coverage, and its `primitive` is
/// the one given. Sizes count 1/8 of a pixel, up to 64 pixels. A stipple cuts a line into parts of length 1.
template <class V>
void draw_smooth_point(const DrawState& state, const Surface& target, PrimitiveState& primitive, const V& v,
                       std::int32_t eighths);
template <class V>
void draw_smooth_line(const DrawState& state, const Surface& target, PrimitiveState& primitive, const V& a,
                      const V& b, const V& provoking, std::int32_t eighths, LineStipple* stipple);
template <class V>
void draw_smooth_polygon(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                         const V* const* corner, int corners, const V& provoking);

/// Multisample rasterization (GL 1.3, 3.3.2, 3.4.4): fragments whose centres lie in the disc of a point, on
/// its rim included, or in the rectangle of a line. Sizes count 1/8 of a pixel. A stipple cuts a line into
/// parts of length 1.
template <class V>
void draw_disc(const DrawState& state, const Surface& target, const V& v, std::int32_t eighths);
template <class V>
void draw_line_rectangle(const DrawState& state, const Surface& target, const V& a, const V& b,
                         const V& provoking, std::int32_t eighths, LineStipple* stipple);

/// Aliased point, size in whole pixels >= 1 (GL 1.3, 3.3).
template <class V>
void draw_point(const DrawState& state, const Surface& target, const V& v, std::int32_t size);

/// Receives fragments whose positions are found elsewhere.
struct PixelSink {
    /// Draws fragments [begin, end) of row y, cut by the scissor rectangle. `pixels` holds their colours
    /// where the state asks for them (DrawState::pixels), with room for `pixel_room` more behind them.
    void (*run)(PixelSink& sink, std::int32_t y, std::int32_t begin, std::int32_t end, const void* pixels);
    /// Sets the depth of the fragments that follow, Q0.30.
    void (*depth)(PixelSink& sink, std::uint32_t z);
};
inline constexpr int pixel_room = 16;

struct PixelSource {
    void (*emit)(PixelSource& source, PixelSink& sink);
};

/// Fragments of a pixel rectangle or bitmap: all but their place, colour and depth is that of `at`, whose x
/// and y do not matter (GL 1.3, 3.6.4, 3.7).
template <class V>
void draw_pixels(const DrawState& state, const Surface& target, const V& at, PixelSource& source);

} // namespace spangle::raster
