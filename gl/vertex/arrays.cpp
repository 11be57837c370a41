// Commands that set and enable vertex arrays, and the conversion of elements to canonical values (GL 1.3,
// 2.8).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/vertex/array_component.hpp"
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

/// Returns a set of component types. Bit 0 stands for GL_BYTE, and the other bits for the types with the
/// tokens after it.
template <class... T> constexpr std::uint16_t types_of(T... types) {
    return static_cast<std::uint16_t>(((1u << (types - GL_BYTE)) | ...));
}
constexpr std::uint16_t wide_types = types_of(GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED);
/// Types of normals, positions and texture coordinates. GL allows bytes for normals only;
/// OES_byte_coordinates allows them for the others, too.
constexpr std::uint16_t signed_types = wide_types | types_of(GL_BYTE);
constexpr std::uint16_t color_types = types_of(GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT,
                                               GL_UNSIGNED_INT, GL_FLOAT, GL_DOUBLE);

/// Component types and sizes that an array may have.
struct Allowed {
    std::uint16_t types;
    std::uint8_t least, most; ///< bounds of the number of components per element
};

/// The arguments of a command that sets an array.
struct PointerArguments {
    GLint size;
    GLenum type;
    GLsizei stride;
    const void* pointer;
};

/// Sets an array to the buffer that is bound to ARRAY_BUFFER, or to client memory (GL 1.5, 2.9.6). The arrays
/// of a named vertex array object must be in buffers (GL 3.0, 2.8).
void point(Context& context, ClientArray& array, Allowed allowed, const PointerArguments& to) {
    const auto& [size, type, stride, pointer] = to;
    if (size < allowed.least || size > allowed.most || stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (type - GL_BYTE > GL_FIXED - GL_BYTE || (allowed.types >> (type - GL_BYTE) & 1) == 0)
        return error(context, GL_INVALID_ENUM);
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

/// Reads an element of an array with one component, if the array is enabled.
[[maybe_unused]] void set_number(const ClientArray& array, std::uint32_t index, Real& out) {
    const ArrayReader numbers(array, false);
    if (!numbers.on())
        return;
    Real v[4];
    numbers.read(index, v);
    out = v[0];
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
        out[c] = array_component(at + std::size_t{c} * bytes, type_, normalized_);
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
    point(context, context.arrays.vertex, {signed_types, 2, 4}, {size, type, stride, pointer});
}

void NormalPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    point(context, context.arrays.normal, {signed_types, 3, 3}, {3, type, stride, pointer});
}

void ColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    point(context, context.arrays.color, {color_types | types_of(GL_FIXED), 3, 4},
          {size, type, stride, pointer});
}

void TexCoordPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    point(context, context.arrays.tex_coord[context.array_bindings.client_unit()], {signed_types, 1, 4},
          {size, type, stride, pointer});
}

void ClientActiveTexture(Context& context, GLenum texture) {
    if (unit_of(texture) >= texture_units)
        return error(context, GL_INVALID_ENUM,
                     SPANGLE_TEXT("texture is beyond the units of this build (SPANGLE_TEXTURE_UNITS)"));
    context.array_bindings.client_active = unit_of(texture);
}

#if SPANGLE_FEATURE_PRIMITIVE_RESTART
void PrimitiveRestartIndex(Context& context, GLuint index) {
    context.array_bindings.restart_index = index;
}
#endif

#if SPANGLE_FEATURE_COLOR_INDEX
void IndexPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    point(context, context.arrays.index, {wide_types | types_of(GL_UNSIGNED_BYTE), 1, 1},
          {1, type, stride, pointer});
}
#endif

#if SPANGLE_FEATURE_FOG
void FogCoordPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
    point(context, context.arrays.fog_coord, {types_of(GL_FLOAT, GL_DOUBLE), 1, 1},
          {1, type, stride, pointer});
}
#endif

#if SPANGLE_FEATURE_SECONDARY_COLOR
void SecondaryColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    point(context, context.arrays.secondary_color, {color_types, 3, 3}, {size, type, stride, pointer});
}
#endif

#if SPANGLE_FEATURE_POLYGON_MODE
static_assert(has_array_type(GL_UNSIGNED_BYTE), "edge flags are bytes");
void EdgeFlagPointer(Context& context, GLsizei stride, const void* pointer) {
    point(context, context.arrays.edge_flag, {types_of(GL_UNSIGNED_BYTE), 1, 1},
          {1, GL_UNSIGNED_BYTE, stride, pointer});
}
#endif

namespace {

/// Enables or disables an array that not every build has. If `present` is false, sets the error with the
/// message `missing`.
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
