// Hands primitives to a recorder (DrawState::recorder), which keeps them or notes the rows that they reach.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/span/draw_state.hpp"
#include <spangle/raster/features.hpp>

namespace spangle::raster {

struct LineStipple;
struct PixelSource;

/// A primitive, with the arguments of the functions of draw.hpp.
struct Primitive {
    enum class Shape : std::uint8_t {
        triangle,
        line,
        point,
        smooth_point,
        smooth_line,
        smooth_polygon,
        disc,
        line_rectangle,
    };
    Shape shape;
    int corners;           ///< number of entries of `corner`
    std::int32_t size = 0; ///< pixels for point and line, 1/8 pixels for smooth_point and later shapes
    const FixedVertex* const* corner;
    const FixedVertex* provoking;
    const LineStipple* stipple = nullptr; ///< stipple at the beginning of the line; null: not stippled
};

struct Recorder {
    void (*primitive)(Recorder& self, const DrawState& state, const Primitive& primitive);
    void (*pixels)(Recorder& self, const DrawState& state, const FixedVertex& at, PixelSource& source);
};

/// Whether primitives of this state are drawn to its surface.
inline bool draws(const DrawState& state) {
#if SPANGLE_FEATURE_BANDS
    return !state.nothing || state.draws_too;
#else
    return !state.nothing;
#endif
}

/// Hands a primitive of a state with DrawState::nothing to its recorder, if there is one. Returns true where
/// the primitive must be drawn, too.
template <class V, class... Corner>
inline bool keep([[maybe_unused]] const DrawState& state, [[maybe_unused]] Primitive::Shape shape,
                 [[maybe_unused]] std::int32_t size, [[maybe_unused]] const LineStipple* stipple,
                 [[maybe_unused]] const V& provoking, [[maybe_unused]] const Corner&... corner) {
#if SPANGLE_FEATURE_BANDS
    if constexpr (std::is_same_v<V, FixedVertex>) {
        if (state.recorder == nullptr)
            return false;
        const FixedVertex* const corners[] = {&corner...};
        state.recorder->primitive(*state.recorder, state,
                                  {shape, sizeof...(Corner), size, corners, &provoking, stipple});
        return state.draws_too;
    }
#endif
    return false;
}

/// Does what keep() does, for a smooth polygon.
template <class V>
inline bool keep_polygon([[maybe_unused]] const DrawState& state, [[maybe_unused]] const V* const* corner,
                         [[maybe_unused]] int corners, [[maybe_unused]] const V& provoking) {
#if SPANGLE_FEATURE_BANDS
    if constexpr (std::is_same_v<V, FixedVertex>)
        if (state.recorder != nullptr) {
            state.recorder->primitive(*state.recorder, state,
                                      {Primitive::Shape::smooth_polygon, corners, 0, corner, &provoking});
            return state.draws_too;
        }
#endif
    return false;
}

/// Does what keep() does, for the fragments of a pixel rectangle.
template <class V>
inline bool keep_pixels([[maybe_unused]] const DrawState& state, [[maybe_unused]] const V& at,
                        [[maybe_unused]] PixelSource& source) {
#if SPANGLE_FEATURE_BANDS
    if constexpr (std::is_same_v<V, FixedVertex>)
        if (state.recorder != nullptr) {
            state.recorder->pixels(*state.recorder, state, at, source);
            return state.draws_too;
        }
#endif
    return false;
}

} // namespace spangle::raster
