// An engine is the vertex pipeline of one numeric policy, behind an interface for the other parts of GL. A
// context has an engine from its creation on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

struct Context;
struct Indices; // gl/vertex/array_element.hpp defines it

// Firmware has one engine. Its functions are called by name, so that the linker drops functions that a
// program never calls. Hosts have reference engines, too, and call through a table.
#ifdef SPANGLE_FIRMWARE
#define SPANGLE_ENGINE_MEMBER static
template <class F> using EngineCall = F;
#else
#define SPANGLE_ENGINE_MEMBER
template <class F> using EngineCall = F*;
#endif

struct Engine {
    SPANGLE_ENGINE_MEMBER const std::size_t pipeline_bytes; ///< size of the object at Context::pipeline
    /// Constructs the pipeline in `pipeline_bytes` bytes of memory, all of which are 0.
    SPANGLE_ENGINE_MEMBER EngineCall<void(void* memory)> construct;
    /// Compiles fragment state for primitives with vertices of this policy.
    SPANGLE_ENGINE_MEMBER
    EngineCall<void(const raster::FragmentState&, const raster::Surface&, raster::DrawState& out)> compile;
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, GLenum mode)> begin;
    /// Takes a vertex with the current attributes, between begin() and end().
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, Real x, Real y, Real z, Real w)> vertex;
    /// Takes `count` elements of the enabled arrays, between begin() and end().
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, std::uint32_t count, const Indices&)> elements;
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&)> end;
    /// Lights the vertices given so far, before a material changes inside Begin/End.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&)> settle_colors;
#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
    /// Draws the fragments of a pixel rectangle or bitmap, with colour, depth and texture coordinates of the
    /// current raster position.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, const raster::DrawState&, const raster::Surface& target,
                                          raster::PixelSource&)>
        pixels;
#endif
#if SPANGLE_FEATURE_RASTER_POS
    /// Sets the current raster position from a position in object space and the current attributes.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, const Real (&position)[4])> raster_position;
#endif
};

#undef SPANGLE_ENGINE_MEMBER

/// The engine of the product, in fixed point.
extern const Engine fixed_engine;

} // namespace spangle::gl
