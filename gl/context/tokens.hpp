// Tokens in the order of the rasterizer's enumerations. A table says which tokens are legal, and a token's
// place in it is its enumerator.
#pragma once

#include <cstddef>

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

inline constexpr std::uint16_t stencil_ops[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                                GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP},
                               blend_equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT,
                                                    GL_MIN, GL_MAX},
                               wraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER,
                                          GL_MIRRORED_REPEAT},
                               env_modes[] = {GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD,
#if SPANGLE_FEATURE_TEXTURE_COMBINE
                                              GL_COMBINE
#endif
},
                               combine_functions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                                      GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA},
                               combine_sources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};

/// The index of a token in a table, or `count` if it is not there.
unsigned place_in(const std::uint16_t* table, unsigned count, GLenum token);
template <std::size_t count> unsigned place_in(const std::uint16_t (&table)[count], GLenum token) {
    return place_in(table, count, token);
}
template <std::size_t count> bool is_in(const std::uint16_t (&table)[count], GLenum token) {
    return place_in(table, token) < count;
}

} // namespace spangle::gl
