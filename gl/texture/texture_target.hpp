// Finds the texture and the image that a target stands for (GL 1.3, 3.8.1, 3.8.11).
#pragma once

#include "gl/texture/texture_state.hpp"

namespace spangle::gl {

struct Context;

struct ImageTarget {
    TextureKind kind;
    std::uint8_t face = 0;
    bool proxy = false;
};

/// Finds the kind of a target of bindings and parameters: TEXTURE_1D, TEXTURE_2D, TEXTURE_3D,
/// TEXTURE_CUBE_MAP. Returns false after INVALID_ENUM, or INVALID_OPERATION for a kind that this build leaves
/// out.
bool find_texture_target(Context& context, GLenum token, TextureKind& out);

/// Finds the target of an image with `dimensions` dimensions, or with any number of them if `dimensions` is
/// 0. The target may be a proxy. For cube maps it is a face, or the proxy of all faces. Returns false after
/// an error.
bool find_image_target(Context& context, GLenum token, unsigned dimensions, ImageTarget& out);

/// Does what find_image_target() does, but refuses proxies, which store no image.
bool find_stored_target(Context& context, GLenum token, unsigned dimensions, ImageTarget& out);

/// The object of this kind that is bound to the active unit.
TextureObject& bound_texture(Context& context, TextureKind kind);

/// The number of bindings: each unit has one for each kind.
inline constexpr unsigned texture_bindings = texture_units * texture_kinds;
static_assert(texture_bindings <= 32);

/// Finds the objects of names, which are ordered by unit, then by kind. A name that has no object gets one,
/// as in BindTexture. The object is null for name 0, and for a name that belongs to another kind of texture.
/// If the arena is full, the function changes nothing and returns false.
bool find_named_objects(Context& context, const GLuint (&names)[texture_bindings],
                        TextureObject* (&found)[texture_bindings]);

/// Binds an object to a unit; null binds the default texture.
void bind_object(Context& context, TextureObject*& bound, TextureObject* object);

/// Called when images or parameters of an object have changed: invalidates what was derived from them.
void texture_changed(Context& context, TextureObject& texture);

/// Whether a level is in 0 .. texture_levels - 1.
bool is_level(GLint level);

} // namespace spangle::gl
