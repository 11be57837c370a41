// An engine: the vertex pipeline of one numeric policy, as the rest of GL sees it. A context has an engine
// from its creation on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

struct Context;
struct Indices; // gl/vertex/array_element.hpp

// Firmware has one engine: its functions are called by name, and functions that a program never calls are not
// linked. Hosts have reference engines, too, and call through a table.
#ifdef SPANGLE_FIRMWARE
#define SPANGLE_ENGINE_MEMBER static
template <class F> using EngineCall = F;
#else
#define SPANGLE_ENGINE_MEMBER
template <class F> using EngineCall = F*;
#endif

struct Engine {
    SPANGLE_ENGINE_MEMBER const std::size_t pipeline_bytes; ///< size of what Context::pipeline points at
    /// Constructs the pipeline in `pipeline_bytes` bytes of memory that are 0.
    SPANGLE_ENGINE_MEMBER EngineCall<void(void* memory)> construct;
    /// Compiles fragment state for primitives of this policy's vertices.
    SPANGLE_ENGINE_MEMBER
    EngineCall<void(const raster::FragmentState&, const raster::Surface&, raster::DrawState& out)> compile;
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, GLenum mode)> begin;
    /// Takes a vertex with the current attributes, between begin and end.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, Real x, Real y, Real z, Real w)> vertex;
    /// Takes `count` elements of the enabled arrays, between begin and end.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, std::uint32_t count, const Indices&)> elements;
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&)> end;
    /// Called before a material changes inside Begin/End: vertices given so far get their colours.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&)> settle_colors;
#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
    /// Draws the fragments of a pixel rectangle or a bitmap, with the values of the current raster position.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, const raster::DrawState&, const raster::Surface& target,
                                          raster::PixelSource&)>
        pixels;
#endif
#if SPANGLE_FEATURE_RASTER_POS
    /// Sets the current raster position from one in object space and from the current attributes.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, const Real (&position)[4])> raster_position;
#endif
};

#undef SPANGLE_ENGINE_MEMBER

/// The engine of the product: integers.
extern const Engine fixed_engine;

} // namespace spangle::gl
