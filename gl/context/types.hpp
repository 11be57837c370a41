// The types that commands take, once the entry points have converted their arguments.
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

/// The values of a Light, Material, Fog, TexParameter... command, and the results of their queries. `count`
/// is what the pname needs. It is 0 when the pname is unknown, or takes a vector but came through the scalar
/// form. Both are INVALID_ENUM (GL 1.3, 2.5), so a command only has to test count == 0. A query leaves 0
/// after an error.
struct Params {
    Param v[4];
    std::uint32_t count = 0;
};

/// The index of the texture unit that GL_TEXTUREi names; it is texture_units or more when there is no such
/// unit.
constexpr std::uint32_t unit_of(GLenum texture) {
    return texture - GL_TEXTURE0;
}

/// An array of client memory whose type is given by its entry point: GL_FLOAT, GL_DOUBLE, GL_INT or GL_FIXED;
/// for pixel maps also GL_UNSIGNED_INT or GL_UNSIGNED_SHORT.
struct Values {
    const void* at;
    GLenum type;
};

/// The arguments of a command that takes an image, which display lists keep, too.
struct ImageCommand {
    GLint arguments[5]; ///< the command's other arguments; texture commands have target and level first
    GLsizei size[3];    ///< 1 where the image has fewer dimensions
    GLenum format, type;
    const void* pixels;
    bool volume = false; ///< IMAGE_HEIGHT and SKIP_IMAGES apply

    GLenum target() const { return static_cast<GLenum>(arguments[0]); }
    GLint level() const { return arguments[1]; }
};

/// A matrix as given, column-major: element (row i, column j) is m[4 * j + i].
struct Matrix16 {
    Real m[16];
};

} // namespace spangle::gl
