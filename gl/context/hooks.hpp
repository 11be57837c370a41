// What creation, Enable and the queries ask of the chapters: state that is computed rather than stored as it
// is returned.
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
/// So many unused names that follow each other become used: the first, or 0 when there are none; an error
/// without memory.
GLuint take_names(Context& context, NameTable& table, GLuint count);
/// glGen...: n unused names become used, or an error is set.
void gen_names(Context& context, NameTable& table, GLsizei n, GLuint* names);

// gl/vertex
/// Top matrix of the stack that GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX or GL_TEXTURE_MATRIX names.
Matrix16 top_matrix(const Context& context, GLenum pname);
/// Entries on the stack that GL_MODELVIEW_STACK_DEPTH... names.
GLint stack_depth(const Context& context, GLenum pname);
/// Enable(GL_COLOR_MATERIAL): the tracked properties become the current colour at once (GL 1.3, 2.13.3).
void color_material_enabled(Context& context);

/// Frees the maps of evaluators.
void release_evaluators(Context& context);

// gl/pixel
/// Entries of the map that GL_PIXEL_MAP_I_TO_I_SIZE... names.
GLint pixel_map_size(const Context& context, GLenum pname);
/// Where passing fragments are counted: a tool's counters, or the context's own while a query is active, or
/// nowhere.
raster::Counters* counters_of(Context& context);
/// A tool brings counters, or takes them back (null): what a query counted so far is kept.
void change_counters(Context& context, raster::Counters* counters);
/// Fragments that pass must be counted.
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

/// The name that GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING... ask for.
GLuint bound_buffer(const Context& context, GLenum pname);
/// A copy of the client's arrays is there twice, or it is no more: so are its buffers.
void hold_arrays(Context& context);
void release_arrays(Context& context);
/// Frees one object of ShareGroup::buffers.
void destroy_buffer(Arena& arena, void* object);
/// Name of the vertex array object that is bound; binding one again, or none where it was deleted. False, and
/// nothing is changed, without memory.
GLuint bound_vertex_array(const Context& context);
bool bind_vertex_array(Context& context, GLuint name);
/// Frees the vertex array objects of a context.
void release_vertex_arrays(Context& context);

// gl/texture
/// What the texture group saves beside rows of the state table: bindings, environments, and parameters of the
/// bound objects (GL 1.3, 6.1.12).
std::size_t saved_texture_bytes();
void save_textures(const Context& context, void* to);
/// False, and nothing is changed, without memory for objects that were deleted meanwhile.
bool restore_textures(Context& context, const void* from);
/// Name bound to a target of the active unit.
GLuint texture_binding(const Context& context, TextureKind kind);
/// Undoes what this context keeps in the arena (the default textures).
void release_textures(Context& context);
/// Frees images that recorded draws looked at, which none does any more.
void forget_kept_images(ShareGroup& share);
/// Frees one object of ShareGroup::textures.
void destroy_texture(ShareGroup& share, void* object);

} // namespace spangle::gl
