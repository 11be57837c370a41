// The vertex pipeline of one numeric policy, as the rest of GL sees it. A context has one from its creation
// on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

struct Context;
struct Indices; // gl/vertex/array_element.hpp

struct Engine {
    std::size_t pipeline_bytes; ///< what Context::pipeline points at
    void (*construct)(void* memory);
    void (*compile)(const raster::FragmentState&, const raster::Surface&, raster::DrawState& out);
    void (*begin)(Context&, GLenum mode);
    /// A vertex with the current attributes.
    void (*vertex)(Context&, Real x, Real y, Real z, Real w);
    /// Elements of the enabled arrays, between begin and end.
    void (*elements)(Context&, std::uint32_t count, const Indices&);
    void (*end)(Context&);
    /// Before a material changes inside Begin/End: vertices given so far get their colours.
    void (*settle_colors)(Context&);
#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
    /// Fragments of a pixel rectangle or a bitmap, with the values of the current raster position.
    void (*pixels)(Context&, const raster::DrawState&, const raster::Surface& target,
                   raster::PixelSource&) = nullptr;
#endif
#if SPANGLE_FEATURE_RASTER_POS
    /// The current raster position from one in object space, with what is current.
    void (*raster_position)(Context&, const Real (&position)[4]) = nullptr;
#endif
};

/// The product's policy.
extern const Engine fixed_engine;

} // namespace spangle::gl
