// What creation, Enable and the queries ask of the chapters: state that is computed rather than stored as it
// is returned.
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

class Arena;
struct Context;

// gl/vertex
/// Top matrix of the stack that GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX or GL_TEXTURE_MATRIX names.
Matrix16 top_matrix(const Context& context, GLenum pname);
/// Entries on the stack that GL_MODELVIEW_STACK_DEPTH... names.
GLint stack_depth(const Context& context, GLenum pname);
/// Enable(GL_COLOR_MATERIAL): the tracked properties become the current colour at once (GL 1.3, 2.13.3).
void color_material_enabled(Context& context);

// gl/texture
/// Name bound to GL_TEXTURE_2D of the active unit.
GLuint texture_binding_2d(const Context& context);
/// Undoes what this context keeps in the arena (the default textures).
void release_textures(Context& context);
/// Frees one object of ShareGroup::textures.
void destroy_texture(Arena& arena, void* object);

} // namespace spangle::gl
