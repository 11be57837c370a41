// A context: its state by chapters of GL, the gate that entry points test, and the objects that it shares.
#pragma once

#include <cstdint>

#include "gl/context/attrib_state.hpp"
#include "gl/context/error.hpp"
#include "gl/context/recording.hpp"
#include "gl/context/threads.hpp"
#include "gl/context/types.hpp"
#include "gl/context/watch.hpp"
#include "gl/list/list_state.hpp"
#include "gl/pixel/fog_state.hpp"
#include "gl/pixel/fragment_cache.hpp"
#include "gl/pixel/fragment_ops_state.hpp"
#include "gl/pixel/hint_state.hpp"
#include "gl/pixel/pixel_mode_state.hpp"
#include "gl/pixel/pixel_store_state.hpp"
#include "gl/pixel/query_state.hpp"
#include "gl/texture/texture_state.hpp"
#include "gl/vertex/arrays_state.hpp"
#include "gl/vertex/current_state.hpp"
#include "gl/vertex/eval_state.hpp"
#include "gl/vertex/lighting_state.hpp"
#include "gl/vertex/polygon_state.hpp"
#include "gl/vertex/render_state.hpp"
#include "gl/vertex/transform_state.hpp"
#include "raster/surface/surface.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {
class BatchRows;
}

namespace spangle::gl {

class Arena;
struct ShareGroup;
struct Engine; // gl/vertex/engine.hpp defines it

/// Reasons that keep an entry point from running its command at once. They are bits of one byte, so that a
/// usual call needs one test.
enum Gate : std::uint8_t {
    gate_inside = 1,    ///< set from Begin to End
    gate_compiling = 2, ///< set from NewList to EndList
#if SPANGLE_WATCHED
    gate_watched = 4, ///< set if a Watcher must be told of the command first
#else
    gate_watched = 0,
#endif
    /// Set in a batch that a band leaves out, in which vertex commands return at once.
    gate_left_out = 8,
};

/// Derived state that must be computed again before the next primitive. Code that changes state calls
/// changed(), and code that derives state clears the bits.
enum Dirty : std::uint16_t {
    dirty_none = 0,
    dirty_others = 1,            ///< clip planes, texture units and their generated coordinates, and fog
    dirty_fragment = 2,          ///< sources of raster::FragmentState, the drawable included
    dirty_modelview = 4,         ///< the modelview matrix
    dirty_projection = 8,        ///< the projection matrix
    dirty_texture_matrices = 16, ///< the texture matrices of all units
    dirty_viewport = 32,         ///< viewport and depth range
    dirty_lights = 64,           ///< lights and the light model
    dirty_materials = 128,       ///< materials, even if they follow the current colour
    dirty_normals = 256,         ///< LIGHTING, NORMALIZE and RESCALE_NORMAL
    dirty_transform = dirty_modelview | dirty_projection | dirty_texture_matrices | dirty_viewport,
    dirty_vertex = dirty_others | dirty_transform | dirty_lights | dirty_materials | dirty_normals,
    dirty_all = 0xFFFF,
};

/// The drawable as EGL describes it, for DrawBuffer, ReadBuffer and queries of bit depths.
struct Drawable {
    raster::Surface surface; ///< the draw surface
    raster::Surface read;    ///< the read surface, equal to the draw surface unless EGL was given two
    bool double_buffered = false, read_double_buffered = false; ///< true if GL_BACK names a surface's buffer
    bool front_buffered = false, read_front_buffered = false;   ///< true if GL_FRONT names a surface's buffer
    /// Bits of a colour index, up to 8. 0: the framebuffer has RGBA colours.
    std::uint8_t index_bits = 0;
    void (*show)(bool finish) = nullptr; ///< called by Flush and Finish; null: there is nothing to show
#if SPANGLE_HAS_PLATFORMS
    void (*follow)() = nullptr; ///< adopts a new size of the window; null: the size never changes
#endif
#if SPANGLE_HAS_RECORDS
    const Recording* recording = nullptr; ///< receives drawing commands; null: drawing is not recorded
#else
    static constexpr const Recording* recording = nullptr;
#endif
#if SPANGLE_FEATURE_BANDS
    /// Rows that batches reach, for bands drawn by a callback, or null.
    raster::BatchRows* batches = nullptr;
#else
    static constexpr raster::BatchRows* batches = nullptr;
#endif
    /// True after the first drawable has set viewport and scissor box (GL 1.3, 2.10.1).
    bool bound_before = false;
};

/// True if the drawable is in colour index mode (GL_INDEX_MODE).
constexpr bool is_indexed(const Drawable& drawable) {
    return raster::has_indices && drawable.index_bits != 0;
}

struct Context {
    std::uint8_t gate = 0;           ///< set of Gate bits
    std::uint16_t dirty = dirty_all; ///< set of Dirty bits
    GLenum error_code = GL_NO_ERROR;
#if SPANGLE_MESSAGES
    PendingError pending_error; ///< error whose message has not been sent
    Compiled compiled;          ///< command that is being compiled into a list
#endif
#if SPANGLE_WATCHED
    Watcher* watcher = nullptr; ///< not null if gate_watched is set
#endif
    GLenum primitive = GL_POINTS; ///< mode of the last Begin

    // Small members come first, because load and store instructions of microcontrollers reach only 4 KB.
    raster::Tier tier = raster::Tier::exact; ///< tier of the EGL config, which hints of GL_DONT_CARE select
#if SPANGLE_OWN_TIERS
    bool own_tier = false; ///< true if hints of GL_DONT_CARE select `knobs` instead of `tier`
    raster::Knobs knobs{};
#endif
    const Engine* engine = nullptr;
    void* pipeline = nullptr; ///< state of the engine, engine->pipeline_bytes bytes
    Arena* arena = nullptr;
    ShareGroup* share = nullptr;
    RenderState render;

    Drawable drawable;
    CurrentState current;
    PolygonState polygon;
    FragmentOpsState fragment_ops;
    FogState fog;
    ArraysState arrays;
    ArrayBindings array_bindings;
    QueryState query;
    PixelStoreState pixel_store;
    PixelModeState pixel_mode;
    HintState hint;
    ListState list;
    AttribState attrib;
    EvalState eval;
    FragmentCache fragments;
    LightingState lighting;
    TextureState texture;
    TransformState transform;

    void changed(Dirty bits) {
        dirty = static_cast<std::uint16_t>(dirty | bits);
    }
    bool inside_begin_end() const {
        return (gate & gate_inside) != 0;
    }
};

/// Sets the context of this thread. MakeCurrent of EGL calls it after it has set `drawable`. Null leaves the
/// thread without a context.
void set_current_context(Context* context);

/// Returns the context of this thread (of the program, in firmware), or null.
inline Context* current_context() {
    return detail::current;
}

} // namespace spangle::gl
