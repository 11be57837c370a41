// Primitives that somebody is told of, who keeps them or notes where they lie: what a state with a recorder
// (DrawState::recorder) does.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/span/draw_state.hpp"
#include <spangle/raster/features.hpp>

namespace spangle::raster {

struct LineStipple;
struct PixelSource;

/// A primitive as the functions of draw.hpp take it.
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
    int corners;           ///< of `corner`
    std::int32_t size = 0; ///< of points and lines: pixels; 1/8 of a pixel of smooth_point and what follows
    const FixedVertex* const* corner;
    const FixedVertex* provoking;
    const LineStipple* stipple = nullptr; ///< where the line begins; null: all of its fragments
};

struct Recorder {
    void (*primitive)(Recorder& self, const DrawState& state, const Primitive& primitive);
    void (*pixels)(Recorder& self, const DrawState& state, const FixedVertex& at, PixelSource& source);
};

/// Primitives of the state reach its surface.
inline bool draws(const DrawState& state) {
#if SPANGLE_FEATURE_BANDS
    return !state.nothing || state.draws_too;
#else
    return !state.nothing;
#endif
}

/// Of a state with DrawState::nothing: hands the primitive to its recorder, if it has one. True: the
/// primitive is drawn as well.
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

/// The same of a smooth polygon.
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

/// The same of fragments of a pixel rectangle.
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
