// Functions of all chapters of GL that are called when contexts are created, and by Enable, attribute stacks
// and queries.
#pragma once

#include <cstddef>

#include "gl/context/types.hpp"

namespace spangle::raster {
struct Counters;
}

namespace spangle::gl {

class Arena;
class NameTable;
struct Context;
struct ShareGroup;
enum class TextureKind : std::uint8_t;

// Defined in gl/context:
/// Reserves `count` consecutive unused names and returns the first. 0: there are none, or there is no memory
/// and the error is set.
GLuint take_names(Context& context, NameTable& table, GLuint count);
/// Reserves n unused names for a glGen... command, or sets an error.
void gen_names(Context& context, NameTable& table, GLsizei n, GLuint* names);

// Defined in gl/vertex:
/// Returns the top matrix of the stack that GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX or GL_TEXTURE_MATRIX
/// names.
Matrix16 top_matrix(const Context& context, GLenum pname);
/// Returns the number of entries on the stack that GL_MODELVIEW_STACK_DEPTH or a similar token names.
GLint stack_depth(const Context& context, GLenum pname);
/// Sets the tracked material properties to the current colour, for Enable(GL_COLOR_MATERIAL) (GL 1.3,
/// 2.13.3).
void color_material_enabled(Context& context);

/// Frees the maps of evaluators.
void release_evaluators(Context& context);

// Defined in gl/pixel:
/// Returns the number of entries of the map that GL_PIXEL_MAP_I_TO_I_SIZE or a similar token names.
GLint pixel_map_size(const Context& context, GLenum pname);
/// Returns the counters of fragments that pass: those of a tool, those of the context while a query is
/// active, or null.
raster::Counters* counters_of(Context& context);
/// Sets the counters of a tool, or removes them (null). Counts of an active query are kept.
void change_counters(Context& context, raster::Counters* counters);
/// True if fragments that pass must be counted.
bool counts_passed(const Context& context);
/// Frees the query objects.
void release_queries(Context& context);
/// Frees the pixel maps.
void release_pixel_maps(Context& context);

// Defined in gl/context and gl/vertex:
/// Returns the number of entries on the attribute stack of the server or of the client.
GLint saved_attributes(const Context& context, bool client);
/// Frees all entries of the attribute stacks.
void release_attributes(Context& context);

/// Returns the buffer name for GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING and similar tokens.
GLuint bound_buffer(const Context& context, GLenum pname);
/// hold_arrays() adds one reference to each buffer of the client's arrays, for a saved copy of the arrays.
/// release_arrays() removes these references.
void hold_arrays(Context& context);
void release_arrays(Context& context);
/// Frees one object of ShareGroup::buffers.
void destroy_buffer(Arena& arena, void* object);
/// Returns the name of the bound vertex array object, or binds one by name. A deleted name binds the default
/// object. False: there is no memory, and nothing changed.
GLuint bound_vertex_array(const Context& context);
bool bind_vertex_array(Context& context, GLuint name);
/// Frees the vertex array objects of a context.
void release_vertex_arrays(Context& context);

// Defined in gl/texture:
/// These functions save what the texture attribute group has beside rows of the state table: bindings,
/// environments, and parameters of the bound objects (GL 1.3, 6.1.12).
std::size_t saved_texture_bytes();
void save_textures(const Context& context, void* to);
/// Restores saved textures. False: there is no memory to make deleted objects again, and nothing changed.
bool restore_textures(Context& context, const void* from);
/// Returns the name bound to a target of the active unit.
GLuint texture_binding(const Context& context, TextureKind kind);
/// Frees the default textures that this context keeps in the arena.
void release_textures(Context& context);
/// Frees images that only recorded draws used, when no record uses them any more.
void forget_kept_images(ShareGroup& share);
/// Frees one object of ShareGroup::textures.
void destroy_texture(ShareGroup& share, void* object);

} // namespace spangle::gl
