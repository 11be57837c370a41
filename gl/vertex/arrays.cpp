// Vertex arrays: where they are, which are on, and how their elements become canonical values (GL 1.3, 2.8).
#include <initializer_list>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/array_element.hpp"

namespace spangle::gl {

namespace {

unsigned bytes_of(GLenum type) {
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
        return 2;
    case GL_DOUBLE:
        return 8;
    default:
        return 4;
    }
}

/// Client memory need not be aligned for our reads: bytes are copied.
template <class T> T read(const std::uint8_t* at) {
    T value;
    __builtin_memcpy(&value, at, sizeof value);
    return value;
}

/// A component as a number (vertices, texture coordinates) or as a fraction (colours, normals: GL 1.3,
/// table 2.6).
Real component(const std::uint8_t* at, GLenum type, bool normalized) {
    switch (type) {
    case GL_FLOAT:
        return numeric::from_float_bits(read<std::uint32_t>(at));
    case GL_DOUBLE:
        return numeric::from_double_bits(read<std::uint64_t>(at));
    case GL_FIXED:
        return numeric::from_fixed16(read<std::int32_t>(at));
    case GL_BYTE:
        return normalized ? numeric::normalized_byte(read<std::int8_t>(at))
                          : numeric::from_i32(read<std::int8_t>(at));
    case GL_UNSIGNED_BYTE:
        return normalized ? numeric::normalized_ubyte(*at) : numeric::from_i32(*at);
    case GL_SHORT:
        return normalized ? numeric::normalized_short(read<std::int16_t>(at))
                          : numeric::from_i32(read<std::int16_t>(at));
    case GL_UNSIGNED_SHORT:
        return normalized ? numeric::normalized_ushort(read<std::uint16_t>(at))
                          : numeric::from_i32(read<std::uint16_t>(at));
    case GL_INT:
        return normalized ? numeric::normalized_int(read<std::int32_t>(at))
                          : numeric::from_i32(read<std::int32_t>(at));
    default:
        return normalized ? numeric::normalized_uint(read<std::uint32_t>(at))
                          : numeric::from_u32(read<std::uint32_t>(at));
    }
}

/// Components of element `index`; those beyond the array's size keep what `out` holds.
bool fetch(const ClientArray& array, std::uint32_t index, bool normalized, Real* out) {
    if (!array.enabled || array.pointer == nullptr)
        return false;
    const unsigned bytes = bytes_of(array.type);
    const auto size = static_cast<unsigned>(array.size);
    const std::size_t stride =
        array.stride != 0 ? static_cast<std::size_t>(array.stride) : std::size_t{bytes} * size;
    const auto* at = static_cast<const std::uint8_t*>(array.pointer) + stride * index;
    if (array.type == GL_FLOAT) { // the usual case, in line
        for (unsigned c = 0; c < size; ++c)
            out[c] = numeric::from_float_bits(read<std::uint32_t>(at + 4 * c));
        return true;
    }
    for (unsigned c = 0; c < size; ++c)
        out[c] = component(at + std::size_t{c} * bytes, array.type, normalized);
    return true;
}

void point(ClientArray& array, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    array.size = size;
    array.type = type;
    array.stride = stride;
    array.pointer = pointer;
}

bool is_position_type(GLenum type) {
    return type == GL_SHORT || type == GL_INT || type == GL_FLOAT || type == GL_DOUBLE || type == GL_FIXED;
}

} // namespace

ElementValues fetch_element(const ArraysState& arrays, std::uint32_t index) {
    ElementValues v;
    for (Real* four : {v.color, v.tex_coord, v.vertex}) {
        four[0] = four[1] = four[2] = numeric::zero;
        four[3] = numeric::one;
    }
    v.has_color = fetch(arrays.color, index, true, v.color);
    v.has_normal = fetch(arrays.normal, index, true, v.normal);
    v.has_tex_coord = fetch(arrays.tex_coord[0], index, false, v.tex_coord);
    v.has_vertex = fetch(arrays.vertex, index, false, v.vertex);
    return v;
}

namespace cmd {

void VertexPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 2 || size > 4 || stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_position_type(type))
        return error(context, GL_INVALID_ENUM);
    point(context.arrays.vertex, size, type, stride, pointer);
}

void NormalPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    if (stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_position_type(type) && type != GL_BYTE)
        return error(context, GL_INVALID_ENUM);
    point(context.arrays.normal, 3, type, stride, pointer);
}

void ColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 3 || size > 4 || stride < 0)
        return error(context, GL_INVALID_VALUE);
    const bool integer = type >= GL_BYTE && type <= GL_UNSIGNED_INT;
    if (!integer && type != GL_FLOAT && type != GL_DOUBLE && type != GL_FIXED)
        return error(context, GL_INVALID_ENUM);
    point(context.arrays.color, size, type, stride, pointer);
}

void TexCoordPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 1 || size > 4 || stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_position_type(type))
        return error(context, GL_INVALID_ENUM);
    point(context.arrays.tex_coord[0], size, type, stride, pointer);
}

namespace {

void enable_array(Context& context, GLenum array, bool on) {
    switch (array) {
    case GL_VERTEX_ARRAY:
        context.arrays.vertex.enabled = on;
        break;
    case GL_NORMAL_ARRAY:
        context.arrays.normal.enabled = on;
        break;
    case GL_COLOR_ARRAY:
        context.arrays.color.enabled = on;
        break;
    case GL_TEXTURE_COORD_ARRAY:
        context.arrays.tex_coord[0].enabled = on;
        break;
    default:
        error(context, GL_INVALID_ENUM);
    }
}

} // namespace

void EnableClientState(Context& context, GLenum array) {
    enable_array(context, array, true);
}

void DisableClientState(Context& context, GLenum array) {
    enable_array(context, array, false);
}

} // namespace cmd

} // namespace spangle::gl
