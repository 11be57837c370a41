// Implements InterleavedArrays (GL 1.3, 2.8, table 2.5).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/vertex/buffer_object.hpp"

namespace spangle::gl::cmd {

namespace {

/// One row of table 2.5. The arrays are in the order texture coordinates, colour, normal, position. `size`
/// has the components of each array, or 0 for an array that the format does not have. `at` and `stride` count
/// bytes.
struct Format {
    std::uint8_t size[4], at[4], stride;
    bool color_bytes;
};

/// Formats in the order of their tokens, from V2F on.
constexpr Format formats[] = {
    {{0, 0, 0, 2}, {0, 0, 0, 0}, 8, false},     // V2F
    {{0, 0, 0, 3}, {0, 0, 0, 0}, 12, false},    // V3F
    {{0, 4, 0, 2}, {0, 0, 0, 4}, 12, true},     // C4UB_V2F
    {{0, 4, 0, 3}, {0, 0, 0, 4}, 16, true},     // C4UB_V3F
    {{0, 3, 0, 3}, {0, 0, 0, 12}, 24, false},   // C3F_V3F
    {{0, 0, 3, 3}, {0, 0, 0, 12}, 24, false},   // N3F_V3F
    {{0, 4, 3, 3}, {0, 0, 16, 28}, 40, false},  // C4F_N3F_V3F
    {{2, 0, 0, 3}, {0, 0, 0, 8}, 20, false},    // T2F_V3F
    {{4, 0, 0, 4}, {0, 0, 0, 16}, 32, false},   // T4F_V4F
    {{2, 4, 0, 3}, {0, 8, 0, 12}, 24, true},    // T2F_C4UB_V3F
    {{2, 3, 0, 3}, {0, 8, 0, 20}, 32, false},   // T2F_C3F_V3F
    {{2, 0, 3, 3}, {0, 0, 8, 20}, 32, false},   // T2F_N3F_V3F
    {{2, 4, 3, 3}, {0, 8, 24, 36}, 48, false},  // T2F_C4F_N3F_V3F
    {{4, 4, 3, 4}, {0, 16, 32, 44}, 60, false}, // T4F_C4F_N3F_V4F
};

/// True if a format has the given numbers of components, and a stride of exactly their bytes.
constexpr bool has_bytes(GLenum format, std::uint8_t texture, bool color_bytes, std::uint8_t color,
                         std::uint8_t normal, std::uint8_t vertex) {
    const Format& f = formats[format - GL_V2F];
    return f.size[0] == texture && f.color_bytes == color_bytes && f.size[1] == color &&
           f.size[2] == normal && f.size[3] == vertex &&
           f.stride == 4 * (texture + (color_bytes ? 1 : color) + normal + vertex);
}
static_assert(has_bytes(GL_V2F, 0, false, 0, 0, 2) && has_bytes(GL_V3F, 0, false, 0, 0, 3) &&
              has_bytes(GL_C4UB_V2F, 0, true, 4, 0, 2) && has_bytes(GL_C4UB_V3F, 0, true, 4, 0, 3) &&
              has_bytes(GL_C3F_V3F, 0, false, 3, 0, 3) && has_bytes(GL_N3F_V3F, 0, false, 0, 3, 3) &&
              has_bytes(GL_C4F_N3F_V3F, 0, false, 4, 3, 3) && has_bytes(GL_T2F_V3F, 2, false, 0, 0, 3) &&
              has_bytes(GL_T4F_V4F, 4, false, 0, 0, 4) && has_bytes(GL_T2F_C4UB_V3F, 2, true, 4, 0, 3) &&
              has_bytes(GL_T2F_C3F_V3F, 2, false, 3, 0, 3) && has_bytes(GL_T2F_N3F_V3F, 2, false, 0, 3, 3) &&
              has_bytes(GL_T2F_C4F_N3F_V3F, 2, false, 4, 3, 3) &&
              has_bytes(GL_T4F_C4F_N3F_V4F, 4, false, 4, 3, 4));

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
    ClientArray* const array[] = {&arrays.tex_coord[context.array_bindings.client_unit()], &arrays.color,
                                  &arrays.normal, &arrays.vertex};
    for (unsigned i = 0; i < 4; ++i)
        set(context, *array[i], f.size[i], i == 1 && f.color_bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, step,
            pointer, f.at[i]);
}

} // namespace spangle::gl::cmd
