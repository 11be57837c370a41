#include "gl/list/call_offsets.hpp"

#include <cstring>

namespace spangle::gl::list {

namespace {

template <class T> T element(const void* array, GLsizei i) {
    T value; // client arrays need not be aligned
    std::memcpy(&value, static_cast<const unsigned char*>(array) + static_cast<std::size_t>(i) * sizeof(T),
                sizeof value);
    return value;
}

GLuint bytes(const void* array, GLsizei i, int count) {
    const unsigned char* from =
        static_cast<const unsigned char*>(array) + static_cast<std::size_t>(i) * static_cast<unsigned>(count);
    GLuint value = 0;
    for (int k = 0; k < count; ++k)
        value = value << 8 | from[k];
    return value;
}

/// Toward zero; what no GLuint offset can be gives the largest.
GLuint truncate(Real v) {
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
    switch (type) {
    case GL_BYTE:
        return static_cast<GLuint>(element<GLbyte>(lists, i));
    case GL_UNSIGNED_BYTE:
        return element<GLubyte>(lists, i);
    case GL_SHORT:
        return static_cast<GLuint>(element<GLshort>(lists, i));
    case GL_UNSIGNED_SHORT:
        return element<GLushort>(lists, i);
    case GL_FLOAT:
        return truncate(numeric::from_float_bits(element<std::uint32_t>(lists, i)));
    case GL_2_BYTES:
        return bytes(lists, i, 2);
    case GL_3_BYTES:
        return bytes(lists, i, 3);
    case GL_4_BYTES:
        return bytes(lists, i, 4);
    default: // GL_INT, GL_UNSIGNED_INT
        return element<GLuint>(lists, i);
    }
}

} // namespace spangle::gl::list
