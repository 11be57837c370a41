// Functions of the chapters of GL that creating contexts, Enable, attribute stacks and queries call.
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

// gl/context
/// Reserves `count` consecutive unused names. Returns the first; 0 when there are none, or with an error set
/// when there is no memory.
GLuint take_names(Context& context, NameTable& table, GLuint count);
/// Reserves n unused names for a glGen... command, or sets an error.
void gen_names(Context& context, NameTable& table, GLsizei n, GLuint* names);

// gl/vertex
/// Top matrix of the stack that GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX or GL_TEXTURE_MATRIX names.
Matrix16 top_matrix(const Context& context, GLenum pname);
/// Entries on the stack that GL_MODELVIEW_STACK_DEPTH... names.
GLint stack_depth(const Context& context, GLenum pname);
/// Called by Enable(GL_COLOR_MATERIAL): the tracked material properties take the current colour at once (GL
/// 1.3, 2.13.3).
void color_material_enabled(Context& context);

/// Frees the maps of evaluators.
void release_evaluators(Context& context);

// gl/pixel
/// Entries of the map that GL_PIXEL_MAP_I_TO_I_SIZE... names.
GLint pixel_map_size(const Context& context, GLenum pname);
/// The counters of fragments that pass: a tool's, or the context's own while a query is active, or null.
raster::Counters* counters_of(Context& context);
/// Sets a tool's counters, or removes them (null). What a query has counted so far is kept.
void change_counters(Context& context, raster::Counters* counters);
/// Whether fragments that pass must be counted.
bool counts_passed(const Context& context);
/// Frees the query objects.
void release_queries(Context& context);
/// Frees the pixel maps.
void release_pixel_maps(Context& context);

// gl/context
/// Entries on the attribute stack of the server or of the client.
GLint saved_attributes(const Context& context, bool client);
/// Frees what is still on the attribute stacks.
void release_attributes(Context& context);

/// The buffer name that GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING... returns.
GLuint bound_buffer(const Context& context, GLenum pname);
/// hold_arrays() counts one more reference to each buffer of the client's arrays, for a saved copy of these.
/// release_arrays() undoes that.
void hold_arrays(Context& context);
void release_arrays(Context& context);
/// Frees one object of ShareGroup::buffers.
void destroy_buffer(Arena& arena, void* object);
/// The name of the bound vertex array object, and binding one by name, or the default one if that was
/// deleted. Without memory bind_vertex_array() changes nothing and returns false.
GLuint bound_vertex_array(const Context& context);
bool bind_vertex_array(Context& context, GLuint name);
/// Frees the vertex array objects of a context.
void release_vertex_arrays(Context& context);

// gl/texture
/// What the texture attribute group saves beside rows of the state table: bindings, environments, and
/// parameters of the bound objects (GL 1.3, 6.1.12).
std::size_t saved_texture_bytes();
void save_textures(const Context& context, void* to);
/// Without memory to make deleted objects again, it changes nothing and returns false.
bool restore_textures(Context& context, const void* from);
/// Name bound to a target of the active unit.
GLuint texture_binding(const Context& context, TextureKind kind);
/// Frees what this context keeps in the arena: its default textures.
void release_textures(Context& context);
/// Frees images that only recorded draws referred to, when no record does any more.
void forget_kept_images(ShareGroup& share);
/// Frees one object of ShareGroup::textures.
void destroy_texture(ShareGroup& share, void* object);

} // namespace spangle::gl
