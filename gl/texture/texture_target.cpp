#include "gl/texture/texture_target.hpp"

#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"

namespace spangle::gl {

namespace {

static_assert(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z - GL_TEXTURE_CUBE_MAP_POSITIVE_X == cube_faces - 1);

bool is_face(GLenum token) {
    return token - GL_TEXTURE_CUBE_MAP_POSITIVE_X < cube_faces;
}

bool any_kind_of(GLenum token, TextureKind& out) {
    switch (token) {
    case GL_TEXTURE_1D:
    case GL_PROXY_TEXTURE_1D:
        out = TextureKind::one;
        return true;
    case GL_TEXTURE_2D:
    case GL_PROXY_TEXTURE_2D:
        out = TextureKind::two;
        return true;
    case GL_TEXTURE_3D:
    case GL_PROXY_TEXTURE_3D:
        out = TextureKind::three;
        return true;
    case GL_TEXTURE_CUBE_MAP:
    case GL_PROXY_TEXTURE_CUBE_MAP:
        out = TextureKind::cube;
        return true;
    default:
        out = TextureKind::cube;
        return is_face(token);
    }
}

bool is_proxy(GLenum token) {
    return token == GL_PROXY_TEXTURE_1D || token == GL_PROXY_TEXTURE_2D || token == GL_PROXY_TEXTURE_3D ||
           token == GL_PROXY_TEXTURE_CUBE_MAP;
}

/// Whether this build has the kind; if not, raises an error that names the missing system.
bool has_kind(Context& context, TextureKind kind) {
    const char* missing = nullptr;
    if (kind == TextureKind::one && !SPANGLE_FEATURE_TEXTURE_1D)
        missing = SPANGLE_TEXT("this build has no SPANGLE_FEATURE_TEXTURE_1D");
    if (kind == TextureKind::three && !SPANGLE_FEATURE_TEXTURE_3D)
        missing = SPANGLE_TEXT("this build has no SPANGLE_FEATURE_TEXTURE_3D");
    if (kind == TextureKind::cube && !SPANGLE_FEATURE_TEXTURE_CUBE_MAP)
        missing = SPANGLE_TEXT("this build has no SPANGLE_FEATURE_TEXTURE_CUBE_MAP");
    const bool left_out = (kind == TextureKind::one && !SPANGLE_FEATURE_TEXTURE_1D) ||
                          (kind == TextureKind::three && !SPANGLE_FEATURE_TEXTURE_3D) ||
                          (kind == TextureKind::cube && !SPANGLE_FEATURE_TEXTURE_CUBE_MAP);
    if (left_out)
        error(context, GL_INVALID_OPERATION, missing);
    return !left_out;
}

} // namespace

bool find_texture_target(Context& context, GLenum token, TextureKind& out) {
    if (!any_kind_of(token, out) || is_proxy(token) || is_face(token)) {
        error(context, GL_INVALID_ENUM);
        return false;
    }
    return has_kind(context, out);
}

bool find_image_target(Context& context, GLenum token, unsigned dimensions, ImageTarget& out) {
    if (!any_kind_of(token, out.kind) || token == GL_TEXTURE_CUBE_MAP ||
        (dimensions != 0 && dimensions_of(out.kind) != dimensions)) {
        error(context, GL_INVALID_ENUM);
        return false;
    }
    out.proxy = is_proxy(token);
    out.face =
        is_face(token) ? static_cast<std::uint8_t>(token - GL_TEXTURE_CUBE_MAP_POSITIVE_X) : std::uint8_t{0};
    return has_kind(context, out.kind);
}

bool find_stored_target(Context& context, GLenum token, unsigned dimensions, ImageTarget& out) {
    if (is_proxy(token)) {
        error(context, GL_INVALID_ENUM);
        return false;
    }
    return find_image_target(context, token, dimensions, out);
}

TextureObject& bound_texture(Context& context, TextureKind kind) {
    return context.texture.bound(context.texture.active_unit(), kind);
}

void texture_changed(Context& context, TextureObject& texture) {
    texture.view_valid = false;
    ++context.share->texture_changes; // compiled states of other contexts may point at the old texels
    context.changed(dirty_fragment);
}

bool is_level(GLint level) {
    return level >= 0 && level < texture_levels;
}

} // namespace spangle::gl
