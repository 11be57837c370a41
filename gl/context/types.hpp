// The words commands are made of once the wrappers have converted their arguments.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/GL/gl.h>

#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "raster/numeric/real.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::gl {

using numeric::Real;

/// Texture units of GL; arrays over units are sized by it.
inline constexpr int texture_units = raster::max_texture_units;

/// One canonical parameter: a Real or a 32-bit integer, by what its pname means (a colour and a factor are
/// Reals, an enum, a boolean and a level are integers).
struct Param {
    std::uint32_t word = 0;

    static constexpr Param from(Real value) { return {value.bits}; }
    static constexpr Param from_integer(std::uint32_t value) { return {value}; }
    constexpr Real real() const { return {word}; }
    constexpr GLint integer() const { return static_cast<GLint>(word); }
    constexpr GLenum token() const { return word; }
};

/// The value of a Light/Material/Fog/TexParameter... command, and what their queries give back. `count` is
/// what the pname needs, or 0: the pname is unknown, or takes a vector and was given through the scalar form;
/// both are INVALID_ENUM (GL 1.3, 2.5), so a command only has to ask for count == 0. A query leaves 0 after
/// an error.
struct Params {
    Param v[4];
    std::uint32_t count = 0;
};

/// Which texture unit GL_TEXTUREi names; texture_units or more when there is none of that name.
constexpr std::uint32_t unit_of(GLenum texture) {
    return texture - GL_TEXTURE0;
}

/// An array of the client whose type is its entry point's: GL_FLOAT, GL_DOUBLE, GL_INT or GL_FIXED;
/// GL_UNSIGNED_INT or GL_UNSIGNED_SHORT of pixel maps.
struct Values {
    const void* at;
    GLenum type;
};

/// What a command that takes an image is given, and what lists keep of it.
struct ImageCommand {
    GLint arguments[5]; ///< whatever the command has beside; of textures target and level come first
    GLsizei size[3];    ///< 1 where the image has fewer dimensions
    GLenum format, type;
    const void* pixels;
    bool volume = false; ///< IMAGE_HEIGHT and SKIP_IMAGES count

    GLenum target() const { return static_cast<GLenum>(arguments[0]); }
    GLint level() const { return arguments[1]; }
};

/// A matrix as given, column-major: element (row i, column j) is m[4 * j + i].
struct Matrix16 {
    Real m[16];
};

} // namespace spangle::gl
