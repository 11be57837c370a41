// One fragment state and one surface, compiled: primitives to pixels.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/raster/fragment_state.hpp>
#include <spangle/raster/surface.hpp>
#include <spangle/raster/vertex.hpp>

namespace spangle::raster {

/// A state with everything off but dithering, that draws on the whole surface.
inline FragmentState whole(const Surface& surface) {
    FragmentState state;
    state.scissor = surface.area();
    return state;
}

/// A white, opaque vertex at a pixel's lower left corner; w = 1, depth and texture coordinates 0. Fractions
/// of pixels: x and y of the result count 1/256.
constexpr FixedVertex at(std::int32_t x, std::int32_t y) {
    FixedVertex v{};
    v.x = static_cast<std::int32_t>(static_cast<std::uint32_t>(x) << subpixel_bits);
    v.y = static_cast<std::int32_t>(static_cast<std::uint32_t>(y) << subpixel_bits);
    v.w_mantissa = 1u << 31;
    v.w_exponent = -31;
    for (std::uint32_t& c : v.color)
        c = color_one;
#if SPANGLE_TEXTURE_UNITS
    for (auto& unit : v.tex)
        unit.q_is_one = 1;
#endif
    return v;
}

/// An immutable rasterizer; copies draw the same. The surface's planes and the state's textures must outlive
/// it. A primitive with a vertex outside of the ranges that vertex.hpp states is not drawn. Pixels outside of
/// the scissor box, which is cut to the surface, are not touched.
class Rasterizer {
  public:
    /// Compiles the state for this surface.
    Rasterizer(const FragmentState& state, const Surface& surface);

    /// Draws a triangle of either orientation. The provoking vertex gives the colour where
    /// FragmentState::flat is set.
    void triangle(const FixedVertex& a, const FixedVertex& b, const FixedVertex& c,
                  const FixedVertex& provoking) const;
    /// Draws a triangle whose provoking vertex is the last one.
    void triangle(const FixedVertex& a, const FixedVertex& b, const FixedVertex& c) const {
        triangle(a, b, c, c);
    }
    /// Draws a line by the diamond-exit rule (GL 1.3, 3.4.1), without its last pixel; b is the provoking
    /// vertex. The width is clamped to 1 .. 64 pixels.
    void line(const FixedVertex& a, const FixedVertex& b, std::int32_t width = 1) const;
    /// Draws a square of `size` pixels, clamped to 1 .. 64 (GL 1.3, 3.3).
    void point(const FixedVertex& v, std::int32_t size = 1) const;

  private:
    Surface surface_;
    /// The compiled state (raster/span/draw_state.hpp), whose parts are private to the rasterizer.
    alignas(8) std::byte state_[320 + 112 * sizeof(void*)];
};

} // namespace spangle::raster
