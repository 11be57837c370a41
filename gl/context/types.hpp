// Types of command arguments, after entry points have converted them.
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

/// The number of texture units.
inline constexpr int texture_units = raster::max_texture_units;

/// One canonical parameter, a Real or a 32-bit integer. The pname decides: a colour and a factor are Reals;
/// an enum, a boolean and a level are integers.
struct Param {
    std::uint32_t word = 0;

    static constexpr Param from(Real value) { return {value.bits}; }
    static constexpr Param from_integer(std::uint32_t value) { return {value}; }
    constexpr Real real() const { return {word}; }
    constexpr GLint integer() const { return static_cast<GLint>(word); }
    constexpr GLenum token() const { return word; }
};

/// Values of a command with a pname, such as Light, Material, Fog or TexParameter, and results of its query.
/// `count` is the number that the pname needs. It is 0 if the pname is unknown, or if the scalar form has a
/// pname of a vector. Both are INVALID_ENUM (GL 1.3, 2.5), so that a command only has to test count == 0. A
/// query leaves 0 after an error.
struct Params {
    Param v[4];
    std::uint32_t count = 0;
};

/// Returns the index of the texture unit that GL_TEXTUREi names. It is texture_units or more if there is no
/// such unit.
constexpr std::uint32_t unit_of(GLenum texture) {
    return texture - GL_TEXTURE0;
}

/// An array in client memory, whose type depends on the entry point: GL_FLOAT, GL_DOUBLE, GL_INT or GL_FIXED.
/// Arrays of pixel maps may be GL_UNSIGNED_INT or GL_UNSIGNED_SHORT, too.
struct Values {
    const void* at;
    GLenum type;
};

/// Arguments of a command with an image. Display lists store them, too.
struct ImageCommand {
    /// The other arguments of the command. Texture commands have target and level first.
    GLint arguments[5];
    GLsizei size[3]; ///< size of the image; 1 for dimensions that the image does not have
    GLenum format, type;
    const void* pixels;
    bool volume = false; ///< true if IMAGE_HEIGHT and SKIP_IMAGES apply

    GLenum target() const { return static_cast<GLenum>(arguments[0]); }
    GLint level() const { return arguments[1]; }
};

/// A matrix as given, column by column: element (row i, column j) is m[4 * j + i].
struct Matrix16 {
    Real m[16];
};

} // namespace spangle::gl
