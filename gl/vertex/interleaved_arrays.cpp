// InterleavedArrays (GL 1.3, 2.8, table 2.5).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/vertex/buffer_object.hpp"

namespace spangle::gl::cmd {

namespace {

/// One row of the table: sizes (0 = absent) and byte offsets, the default stride last.
struct Format {
    std::uint8_t tex_size, color_size;
    bool color_bytes, normal;
    std::uint8_t position_size, color_at, normal_at, position_at, stride;
};

/// In the order of the tokens, V2F first.
constexpr Format formats[] = {
    {0, 0, false, false, 2, 0, 0, 0, 8},    // V2F
    {0, 0, false, false, 3, 0, 0, 0, 12},   // V3F
    {0, 4, true, false, 2, 0, 0, 4, 12},    // C4UB_V2F
    {0, 4, true, false, 3, 0, 0, 4, 16},    // C4UB_V3F
    {0, 3, false, false, 3, 0, 0, 12, 24},  // C3F_V3F
    {0, 0, false, true, 3, 0, 0, 12, 24},   // N3F_V3F
    {0, 4, false, true, 3, 0, 16, 28, 40},  // C4F_N3F_V3F
    {2, 0, false, false, 3, 0, 0, 8, 20},   // T2F_V3F
    {4, 0, false, false, 4, 0, 0, 16, 32},  // T4F_V4F
    {2, 4, true, false, 3, 8, 0, 12, 24},   // T2F_C4UB_V3F
    {2, 3, false, false, 3, 8, 0, 20, 32},  // T2F_C3F_V3F
    {2, 0, false, true, 3, 0, 8, 20, 32},   // T2F_N3F_V3F
    {2, 4, false, true, 3, 8, 24, 36, 48},  // T2F_C4F_N3F_V3F
    {4, 4, false, true, 4, 16, 32, 44, 60}, // T4F_C4F_N3F_V4F
};

void set(Context& context, ClientArray& array, GLint size, GLenum type, GLsizei stride, const void* pointer,
         unsigned at) {
    array.enabled = size != 0;
    if (size == 0)
        return; // a disabled array keeps its pointer
    array.size = size;
    array.type = type;
    array.stride = stride;
    set_buffer(context, array);
    array.pointer = pointer != nullptr || array.buffer != nullptr
                        ? reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(pointer) + at)
                        : nullptr;
}

} // namespace

void InterleavedArrays(Context& context, GLenum format, GLsizei stride, const void* pointer) {
    if (format < GL_V2F || format > GL_T4F_C4F_N3F_V4F)
        return error(context, GL_INVALID_ENUM);
    if (stride < 0)
        return error(context, GL_INVALID_VALUE);
    if (bound_vertex_array(context) != 0 && context.array_bindings.array_buffer == nullptr &&
        pointer != nullptr)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("a vertex array object asks for arrays in buffers"));
    if (!has_array_type(GL_FLOAT) || !has_array_type(GL_UNSIGNED_BYTE))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("this build has no arrays of floats and bytes (SPANGLE_ARRAY_TYPES)"));
    const Format& f = formats[format - GL_V2F];
    const GLsizei step = stride != 0 ? stride : f.stride;
    ArraysState& arrays = context.arrays;
    arrays.index.enabled = arrays.edge_flag.enabled = arrays.fog_coord.enabled = false;
    arrays.secondary_color.enabled = false;
    set(context, arrays.tex_coord[context.array_bindings.client_unit()], f.tex_size, GL_FLOAT, step, pointer,
        0);
    set(context, arrays.color, f.color_size, f.color_bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, step, pointer,
        f.color_at);
    set(context, arrays.normal, f.normal ? 3 : 0, GL_FLOAT, step, pointer, f.normal_at);
    set(context, arrays.vertex, f.position_size, GL_FLOAT, step, pointer, f.position_at);
}

} // namespace spangle::gl::cmd
