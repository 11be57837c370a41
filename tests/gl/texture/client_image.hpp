// Texture images with their arguments in the order of GL's commands.
#pragma once

#include "gl/api/generated/commands.hpp"

namespace spangle::gl {

inline void tex_image_2d(Context& context, GLenum target, GLint level, GLint internal_format, GLsizei width,
                         GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels) {
    cmd::TexImage2D(context, {{static_cast<GLint>(target), level, internal_format, border},
                              {width, height, 1},
                              format,
                              type,
                              pixels});
}
inline void tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                             GLsizei height, GLenum format, GLenum type, const void* pixels) {
    cmd::TexSubImage2D(context,
                       {{static_cast<GLint>(target), level, x, y}, {width, height, 1}, format, type, pixels});
}

} // namespace spangle::gl
