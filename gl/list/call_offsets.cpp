#include "gl/list/call_offsets.hpp"

#include <bit>

namespace spangle::gl::list {

namespace {

/// Converts to a list name, truncated toward zero. A magnitude beyond a GLuint gives the largest GLuint.
GLuint to_list_name(Real v) {
    const numeric::detail::Unpacked u = numeric::detail::unpack(v);
    GLuint magnitude = 0xFFFFFFFF;
    if (u.exponent <= 0)
        magnitude = u.exponent > -32 ? u.mantissa >> -u.exponent : 0;
    else if (u.exponent <= 8)
        magnitude = u.mantissa << u.exponent;
    return u.negative ? 0 - magnitude : magnitude;
}

} // namespace

bool is_name_type(GLenum type) {
    return type >= GL_BYTE && type <= GL_4_BYTES;
}

GLuint name_offset(GLenum type, const void* lists, GLsizei i) {
    // Number of bytes, in the order of types.
    constexpr std::uint8_t bytes_of[] = {1, 1, 2, 2, 4, 4, 4, 2, 3, 4};
    static_assert(bytes_of[GL_UNSIGNED_BYTE - GL_BYTE] == 1 && bytes_of[GL_SHORT - GL_BYTE] == 2 &&
                  bytes_of[GL_UNSIGNED_SHORT - GL_BYTE] == 2 && bytes_of[GL_INT - GL_BYTE] == 4 &&
                  bytes_of[GL_UNSIGNED_INT - GL_BYTE] == 4 && bytes_of[GL_FLOAT - GL_BYTE] == 4 &&
                  bytes_of[GL_2_BYTES - GL_BYTE] == 2 && bytes_of[GL_3_BYTES - GL_BYTE] == 3 &&
                  bytes_of[GL_4_BYTES - GL_BYTE] == 4 && sizeof bytes_of == GL_4_BYTES - GL_BYTE + 1);
    const unsigned count = bytes_of[type - GL_BYTE];
    const auto* const from = static_cast<const unsigned char*>(lists) + static_cast<std::size_t>(i) * count;
    const bool high_first = type >= GL_2_BYTES || std::endian::native == std::endian::big;
    GLuint value = 0;
    for (unsigned k = 0; k < count; ++k)
        value = value << 8 | from[high_first ? k : count - 1 - k];
    switch (type) {
    case GL_BYTE:
        return static_cast<GLuint>(static_cast<GLbyte>(value));
    case GL_SHORT:
        return static_cast<GLuint>(static_cast<GLshort>(value));
    case GL_FLOAT:
        return to_list_name(numeric::from_float_bits(value));
    default:
        return value;
    }
}

} // namespace spangle::gl::list
