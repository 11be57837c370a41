// Vertex arrays: where they are, which are on, and how their elements become canonical values (GL 1.3, 2.8).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/vertex/buffer_object.hpp"
#include "gl/vertex/current_element.hpp"

namespace spangle::gl {

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

void set_buffer([[maybe_unused]] Context& context, [[maybe_unused]] ClientArray& array) {
#if SPANGLE_FEATURE_BUFFERS
    bind_buffer(context, array.buffer, context.array_bindings.array_buffer);
    context.arrays.buffered = context.arrays.buffered || array.buffer != nullptr;
#endif
}

namespace {

/// Client memory need not be aligned for our reads: bytes are copied.
template <class T> T read(const std::uint8_t* at) {
    T value;
    __builtin_memcpy(&value, at, sizeof value);
    return value;
}

/// A component as a number (vertices, texture coordinates) or as a fraction (colours, normals: GL 1.3,
/// table 2.6).
Real component(const std::uint8_t* at, GLenum type, bool normalized) {
    switch (array_type(type)) {
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

/// The buffer that is bound now is the array's from now on (GL 1.5, 2.9.6). Arrays of objects with a name lie
/// in buffers (GL 3.0, 2.8).
void point(Context& context, ClientArray& array, GLint size, GLenum type, GLsizei stride,
           const void* pointer) {
    if (!has_array_type(type))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("this build has no arrays of this type (SPANGLE_ARRAY_TYPES)"));
    BufferObject* const buffer = context.array_bindings.array_buffer;
    if (bound_vertex_array(context) != 0 && buffer == nullptr && pointer != nullptr)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("a vertex array object asks for arrays in buffers"));
    set_buffer(context, array);
    array.size = size;
    array.type = type;
    array.stride = stride;
    array.pointer = pointer;
}

/// An element of one component, if the array is on.
[[maybe_unused]] void set_number(const ClientArray& array, std::uint32_t index, Real& out) {
    const ArrayReader numbers(array, false);
    if (!numbers.on())
        return;
    Real v[4];
    numbers.read(index, v);
    out = v[0];
}

bool is_integer_type(GLenum type) {
    return type >= GL_BYTE && type <= GL_UNSIGNED_INT;
}

bool is_wide_type(GLenum type) {
    return type == GL_SHORT || type == GL_INT || type == GL_FLOAT || type == GL_DOUBLE || type == GL_FIXED;
}
/// Bytes are normals, and by OES_byte_coordinates positions and texture coordinates.
bool is_signed_type(GLenum type) {
    return type == GL_BYTE || is_wide_type(type);
}

} // namespace

ArrayReader::ArrayReader(const ClientArray& array, bool normalized)
    : base_(array.enabled ? static_cast<const std::uint8_t*>(array.pointer) : nullptr), type_(array.type),
      components_(static_cast<std::uint8_t>(array.size)), normalized_(normalized) {
    const unsigned bytes = bytes_of(array_type(array.type));
    stride_ = array.stride != 0 ? static_cast<std::size_t>(array.stride) : std::size_t{bytes} * components_;
    aligned_floats_ = has_array_type(GL_FLOAT) && type_ == GL_FLOAT &&
                      ((reinterpret_cast<std::uintptr_t>(base_) | stride_) & (sizeof(float) - 1)) == 0;
}

void ArrayReader::convert(const std::uint8_t* at, Real* out) const {
    const unsigned bytes = bytes_of(array_type(type_));
    for (unsigned c = 0; c < components_; ++c)
        out[c] = component(at + std::size_t{c} * bytes, type_, normalized_);
}

void set_seldom([[maybe_unused]] CurrentState& current, [[maybe_unused]] const ArraysState& arrays,
                [[maybe_unused]] std::uint32_t index) {
#if SPANGLE_FEATURE_COLOR_INDEX
    set_number(arrays.index, index, current.index);
#endif
#if SPANGLE_FEATURE_FOG
    set_number(arrays.fog_coord, index, current.fog_coord);
#endif
#if SPANGLE_FEATURE_SECONDARY_COLOR
    if (const ArrayReader colors(arrays.secondary_color, true); colors.on())
        colors.read(index, current.secondary_color);
#endif
#if SPANGLE_FEATURE_POLYGON_MODE
    if (const ArrayReader flags(arrays.edge_flag, false); flags.on())
        current.edge_flag = *flags.words(index) != 0;
#endif
}

namespace cmd {

void VertexPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 2 || size > 4 || stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_signed_type(type))
        return error(context, GL_INVALID_ENUM);
    point(context, context.arrays.vertex, size, type, stride, pointer);
}

void NormalPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    if (stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_signed_type(type))
        return error(context, GL_INVALID_ENUM);
    point(context, context.arrays.normal, 3, type, stride, pointer);
}

void ColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 3 || size > 4 || stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_integer_type(type) && type != GL_FLOAT && type != GL_DOUBLE && type != GL_FIXED)
        return error(context, GL_INVALID_ENUM);
    point(context, context.arrays.color, size, type, stride, pointer);
}

void TexCoordPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size < 1 || size > 4 || stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_signed_type(type))
        return error(context, GL_INVALID_ENUM);
    point(context, context.arrays.tex_coord[context.array_bindings.client_unit()], size, type, stride,
          pointer);
}

void ClientActiveTexture(Context& context, GLenum texture) {
    if (unit_of(texture) >= texture_units)
        return error(context, GL_INVALID_ENUM);
    context.array_bindings.client_active = unit_of(texture);
}

#if SPANGLE_FEATURE_PRIMITIVE_RESTART
void PrimitiveRestartIndex(Context& context, GLuint index) {
    context.array_bindings.restart_index = index;
}
#endif

#if SPANGLE_FEATURE_COLOR_INDEX
void IndexPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    if (stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_wide_type(type) && type != GL_UNSIGNED_BYTE)
        return error(context, GL_INVALID_ENUM);
    point(context, context.arrays.index, 1, type, stride, pointer);
}
#endif

#if SPANGLE_FEATURE_FOG
void FogCoordPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    if (stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (type != GL_FLOAT && type != GL_DOUBLE)
        return error(context, GL_INVALID_ENUM);
    point(context, context.arrays.fog_coord, 1, type, stride, pointer);
}
#endif

#if SPANGLE_FEATURE_SECONDARY_COLOR
void SecondaryColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    if (size != 3 || stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (!is_integer_type(type) && type != GL_FLOAT && type != GL_DOUBLE)
        return error(context, GL_INVALID_ENUM);
    point(context, context.arrays.secondary_color, size, type, stride, pointer);
}
#endif

#if SPANGLE_FEATURE_POLYGON_MODE
static_assert(has_array_type(GL_UNSIGNED_BYTE), "edge flags are bytes");
void EdgeFlagPointer(Context& context, GLsizei stride, const void* pointer) {
    if (stride < 0)
        return error(context, GL_INVALID_VALUE);
    point(context, context.arrays.edge_flag, 1, GL_UNSIGNED_BYTE, stride, pointer);
}
#endif

namespace {

/// An array of a system that a build may leave out.
void enable_optional(Context& context, ClientArray& array, bool on, bool present, const char* missing) {
    if (!present)
        return error(context, GL_INVALID_OPERATION, missing);
    array.enabled = on;
}

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
        context.arrays.tex_coord[context.array_bindings.client_unit()].enabled = on;
        break;
    case GL_INDEX_ARRAY:
        return enable_optional(context, context.arrays.index, on, SPANGLE_FEATURE_COLOR_INDEX != 0,
                               SPANGLE_TEXT("this build has no SPANGLE_FEATURE_COLOR_INDEX"));
    case GL_EDGE_FLAG_ARRAY:
        return enable_optional(context, context.arrays.edge_flag, on, SPANGLE_FEATURE_POLYGON_MODE != 0,
                               SPANGLE_TEXT("this build has no SPANGLE_FEATURE_POLYGON_MODE"));
    case GL_FOG_COORDINATE_ARRAY:
        return enable_optional(context, context.arrays.fog_coord, on, SPANGLE_FEATURE_FOG != 0,
                               SPANGLE_TEXT("this build has no SPANGLE_FEATURE_FOG"));
    case GL_SECONDARY_COLOR_ARRAY:
        return enable_optional(context, context.arrays.secondary_color, on,
                               SPANGLE_FEATURE_SECONDARY_COLOR != 0,
                               SPANGLE_TEXT("this build has no SPANGLE_FEATURE_SECONDARY_COLOR"));
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
