// Implementation limits (GL 1.3, tables 6.26 to 6.29), which a build may lower (cmake/Limits.cmake).
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/raster/limits.hpp>

#ifndef SPANGLE_LIGHTS
#define SPANGLE_LIGHTS 8
#endif
#ifndef SPANGLE_LIGHT_KINDS
#define SPANGLE_LIGHT_KINDS 15
#endif
#ifndef SPANGLE_FULL_LIGHTING
#define SPANGLE_FULL_LIGHTING 1
#endif
#ifndef SPANGLE_MODELVIEW_STACK
#define SPANGLE_MODELVIEW_STACK 32
#endif
#ifndef SPANGLE_PROJECTION_STACK
#define SPANGLE_PROJECTION_STACK 2
#endif
#ifndef SPANGLE_TEXTURE_STACK
#define SPANGLE_TEXTURE_STACK 2
#endif
#ifndef SPANGLE_NAME_STACK
#define SPANGLE_NAME_STACK 64
#endif
#ifndef SPANGLE_LIST_NESTING
#define SPANGLE_LIST_NESTING 64
#endif
#ifndef SPANGLE_CLIP_SPARE
#define SPANGLE_CLIP_SPARE 2
#endif
#ifndef SPANGLE_PRIMITIVES
#define SPANGLE_PRIMITIVES 7
#endif
#ifndef SPANGLE_CLIPPING
#define SPANGLE_CLIPPING 1
#endif
#ifndef SPANGLE_ARGUMENTS_INLINE
#define SPANGLE_ARGUMENTS_INLINE 1
#endif
#ifndef SPANGLE_DISPLAYS
#define SPANGLE_DISPLAYS 4
#endif
#ifndef SPANGLE_ARRAY_TYPES
#define SPANGLE_ARRAY_TYPES 5247
#endif
#ifndef SPANGLE_ARENA_REUSE
#define SPANGLE_ARENA_REUSE 1
#endif
#ifndef SPANGLE_ARENA_LOG2
#define SPANGLE_ARENA_LOG2 0
#endif
#ifndef SPANGLE_HOST_MEMORY_MB
#define SPANGLE_HOST_MEMORY_MB 64
#endif

#ifndef SPANGLE_VERTEX_CACHE
#define SPANGLE_VERTEX_CACHE 0
#endif

namespace spangle::gl {

inline constexpr std::int32_t max_viewport_dim = 2048; ///< a quarter of raster::guard_band
inline constexpr std::int32_t max_point_size = 64;     ///< sizes are whole pixels from 1 on
inline constexpr std::int32_t max_line_width = 64;
inline constexpr std::int32_t modelview_stack_entries = SPANGLE_MODELVIEW_STACK,
                              projection_stack_entries = SPANGLE_PROJECTION_STACK,
                              texture_stack_entries = SPANGLE_TEXTURE_STACK, attrib_stack_entries = 16,
                              name_stack_entries = SPANGLE_NAME_STACK,
                              max_list_nesting = SPANGLE_LIST_NESTING;
/// True if entry points convert their arguments inline, instead of through a common function.
inline constexpr bool converts_in_line = SPANGLE_ARGUMENTS_INLINE != 0;
inline constexpr unsigned max_lights = SPANGLE_LIGHTS;
/// Optional parts of lighting. Ambient and diffuse light of directional lights is always available. Local
/// lights are positional lights, spotlights and a local viewer.
inline constexpr bool has_specular = (SPANGLE_LIGHT_KINDS & 1) != 0,
                      has_local_lights = (SPANGLE_LIGHT_KINDS & 2) != 0,
                      has_color_material = (SPANGLE_LIGHT_KINDS & 8) != 0;
/// True if normals can be normalized, and diffuse colours may be 16 or more.
inline constexpr bool has_full_lighting = SPANGLE_FULL_LIGHTING != 0;
static_assert(has_full_lighting || !has_color_material,
              "colours that materials follow may be of 16 and more");
#define SPANGLE_TWO_SIDES (SPANGLE_FEATURE_LIGHTING && (SPANGLE_LIGHT_KINDS & 4) != 0)
static_assert(SPANGLE_LIGHT_KINDS < 16);
inline constexpr int max_clip_planes = 6;

inline constexpr int clip_spare = SPANGLE_CLIP_SPARE;
/// Number of vertices of array draws that are kept for indices that come again, about 140 bytes each. A strip
/// finds the vertices that it shares with the previous strip if both rows, less a few vertices, fit. Hosts
/// have the memory to keep whole meshes, so that a mesh drawn several times a frame is transformed once.
/// Hosts allocate most of that memory in the arena when a draw first needs it.
#ifdef SPANGLE_FIRMWARE
#define SPANGLE_GROWS_CACHE 0
inline constexpr unsigned usual_vertex_cache = 80;
#else
#define SPANGLE_GROWS_CACHE 1
inline constexpr unsigned usual_vertex_cache = 8192;
#endif
inline constexpr unsigned vertex_cache =
    SPANGLE_VERTEX_CACHE != 0 ? SPANGLE_VERTEX_CACHE : usual_vertex_cache;

/// Optional primitives. Triangles, triangle strips and triangle fans are always available. Quads count as
/// polygons.
inline constexpr bool has_points = (SPANGLE_PRIMITIVES & 1) != 0, has_lines = (SPANGLE_PRIMITIVES & 2) != 0,
                      has_polygons = (SPANGLE_PRIMITIVES & 4) != 0;
static_assert(SPANGLE_PRIMITIVES < 8);

/// True if primitives are clipped. Without clipping, a primitive that crosses a plane of the view volume is
/// an error.
inline constexpr bool has_clipping = SPANGLE_CLIPPING != 0;

/// Component types of vertex arrays that the build supports. Bit i stands for the type with token GL_BYTE +
/// i.
inline constexpr unsigned array_types = SPANGLE_ARRAY_TYPES, first_array_type = 0x1400;
static_assert(array_types != 0 && (array_types & ~5247u) == 0);
constexpr bool has_array_type(unsigned token) {
    return token - first_array_type < 13 && (array_types >> (token - first_array_type) & 1) != 0;
}
/// Returns the type of an array, which is a constant in builds with a single type.
constexpr unsigned array_type(unsigned token) {
    return raster::one_of(array_types, token - first_array_type) + first_array_type;
}

using raster::line_batch;

inline constexpr int most_displays = SPANGLE_DISPLAYS;
static_assert(most_displays >= 1);

/// True if the arena gives freed memory out again.
inline constexpr bool reuses_memory = SPANGLE_ARENA_REUSE != 0;

/// Blocks of the arena are smaller than 2^arena_log2 bytes.
inline constexpr unsigned arena_log2 = SPANGLE_ARENA_LOG2 != 0 ? SPANGLE_ARENA_LOG2
                                       : sizeof(void*) == 4    ? 25
                                                               : 37;

/// Bytes of memory for programs on a host that give none.
static_assert(SPANGLE_HOST_MEMORY_MB >= 1 && SPANGLE_HOST_MEMORY_MB <= 1024);
inline constexpr std::size_t host_memory_bytes = std::size_t{SPANGLE_HOST_MEMORY_MB} << 20;

static_assert(modelview_stack_entries >= 1 && projection_stack_entries >= 1 && texture_stack_entries >= 1 &&
              name_stack_entries >= 1 && max_list_nesting >= 2);
static_assert(max_lights >= 1 && max_lights <= 8, "the tokens GL_LIGHTi there are");
static_assert(clip_spare >= 0 && arena_log2 >= 7 && arena_log2 <= 37);

} // namespace spangle::gl
