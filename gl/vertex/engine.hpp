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

// Firmware has one engine: its functions are called by name, and those that a program never calls are not
// linked. Hosts, which have references beside it, call through a table.
#ifdef SPANGLE_FIRMWARE
#define SPANGLE_ENGINE_MEMBER static
template <class F> using EngineCall = F;
#else
#define SPANGLE_ENGINE_MEMBER
template <class F> using EngineCall = F*;
#endif

struct Engine {
    SPANGLE_ENGINE_MEMBER const std::size_t pipeline_bytes; ///< what Context::pipeline points at
    /// In memory of so many bytes that are 0.
    SPANGLE_ENGINE_MEMBER EngineCall<void(void* memory)> construct;
    SPANGLE_ENGINE_MEMBER
    EngineCall<void(const raster::FragmentState&, const raster::Surface&, raster::DrawState& out)> compile;
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, GLenum mode)> begin;
    /// A vertex with the current attributes.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, Real x, Real y, Real z, Real w)> vertex;
    /// Elements of the enabled arrays, between begin and end.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, std::uint32_t count, const Indices&)> elements;
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&)> end;
    /// Before a material changes inside Begin/End: vertices given so far get their colours.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&)> settle_colors;
#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
    /// Fragments of a pixel rectangle or a bitmap, with the values of the current raster position.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, const raster::DrawState&, const raster::Surface& target,
                                          raster::PixelSource&)>
        pixels;
#endif
#if SPANGLE_FEATURE_RASTER_POS
    /// The current raster position from one in object space, with what is current.
    SPANGLE_ENGINE_MEMBER EngineCall<void(Context&, const Real (&position)[4])> raster_position;
#endif
};

#undef SPANGLE_ENGINE_MEMBER

/// The product's policy.
extern const Engine fixed_engine;

} // namespace spangle::gl
