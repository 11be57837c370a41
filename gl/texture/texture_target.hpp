// Which texture, and which of its images, a target names (GL 1.3, 3.8.1, 3.8.11).
#pragma once

#include "gl/texture/texture_state.hpp"

namespace spangle::gl {

struct Context;

struct ImageTarget {
    TextureKind kind;
    std::uint8_t face = 0;
    bool proxy = false;
};

/// TEXTURE_1D, TEXTURE_2D, TEXTURE_3D, TEXTURE_CUBE_MAP: bindings and parameters. False, and the error is
/// set: INVALID_ENUM, or INVALID_OPERATION for what this build has left out.
bool find_texture_target(Context& context, GLenum token, TextureKind& out);

/// Those of images with so many dimensions (0: any): of cube maps a face or the proxy of all.
bool find_image_target(Context& context, GLenum token, unsigned dimensions, ImageTarget& out);

/// The same without proxies, which have no image.
bool find_stored_target(Context& context, GLenum token, unsigned dimensions, ImageTarget& out);

/// The bound object of the active unit.
TextureObject& bound_texture(Context& context, TextureKind kind);

/// What units have bound: of each unit one name of each kind.
inline constexpr unsigned texture_bindings = texture_units * texture_kinds;
static_assert(texture_bindings <= 32);

/// The objects of these names, in the order of units and kinds. A name without an object gets one, as
/// BindTexture does; one of another kind, and 0, get null. False, and nothing is changed, without memory.
bool find_named_objects(Context& context, const GLuint (&names)[texture_bindings],
                        TextureObject* (&found)[texture_bindings]);

/// A unit has this object from now on; null: the default texture.
void bind_object(Context& context, TextureObject*& bound, TextureObject* object);

/// Images or parameters of an object are others now.
void texture_changed(Context& context, TextureObject& texture);

/// 0 to 11.
bool is_level(GLint level);

} // namespace spangle::gl
