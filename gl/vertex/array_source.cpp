#include "gl/vertex/array_source.hpp"

#if SPANGLE_FEATURE_BUFFERS

#include <initializer_list>

#include "gl/vertex/buffer_object.hpp"

namespace spangle::gl {

namespace {

unsigned bytes_of_index(GLenum type) {
    return type == GL_UNSIGNED_INT ? 4 : type == GL_UNSIGNED_SHORT ? 2 : 1;
}

bool reaches(const Context& context, const ClientArray& array, std::uint32_t highest) {
    if (!array.enabled || array.buffer == 0)
        return true;
    const BufferObject* const buffer = find_buffer(context, array.buffer);
    if (buffer == nullptr || buffer->mapped)
        return false;
    const std::uint64_t element = std::uint64_t{bytes_of(array.type)} * static_cast<unsigned>(array.size),
                        stride = array.stride != 0 ? static_cast<std::uint64_t>(array.stride) : element,
                        offset = reinterpret_cast<std::uintptr_t>(array.pointer);
    return offset <= buffer->size && stride * highest + element <= buffer->size - offset;
}

/// Calls f(array) for each.
template <class F> void each_array(ArraysState& arrays, F f) {
    for (ClientArray* array :
         {&arrays.vertex, &arrays.normal, &arrays.color, &arrays.index, &arrays.edge_flag, &arrays.fog_coord})
        f(*array);
    for (ClientArray& array : arrays.tex_coord)
        f(array);
}

} // namespace

bool arrays_reach(const Context& context, std::uint32_t highest) {
    const ArraysState& arrays = context.arrays;
    if (!arrays.buffered)
        return true;
    for (const ClientArray& array : arrays.tex_coord)
        if (!reaches(context, array, highest))
            return false;
    return reaches(context, arrays.vertex, highest) && reaches(context, arrays.normal, highest) &&
           reaches(context, arrays.color, highest) && reaches(context, arrays.index, highest) &&
           reaches(context, arrays.edge_flag, highest) && reaches(context, arrays.fog_coord, highest);
}

bool find_indices(const Context& context, std::uint32_t count, Indices& indices) {
    if (count == 0)
        return true;
    if (context.arrays.element_buffer != 0) {
        const BufferObject* const buffer = find_buffer(context, context.arrays.element_buffer);
        const auto offset = reinterpret_cast<std::uintptr_t>(indices.data);
        if (buffer == nullptr || buffer->mapped || offset > buffer->size ||
            std::uint64_t{count} * bytes_of_index(indices.type) > buffer->size - offset)
            return false;
        indices.data = buffer->bytes + offset;
    }
    if (!context.arrays.buffered)
        return true;
    std::uint32_t highest = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        highest = indices.at(i) > highest ? indices.at(i) : highest;
    return arrays_reach(context, highest);
}

AddressedArrays::AddressedArrays(Context& context) : context_(context) {
    if (!context.arrays.buffered)
        return;
    kept_ = context.arrays;
    each_array(context.arrays, [&](ClientArray& array) {
        if (!array.enabled || array.buffer == 0)
            return;
        // A draw of no elements asks nothing of its buffers: they may be empty.
        const BufferObject* const buffer = find_buffer(context, array.buffer);
        array.pointer = buffer != nullptr && buffer->bytes != nullptr
                            ? buffer->bytes + reinterpret_cast<std::uintptr_t>(array.pointer)
                            : nullptr;
    });
}

AddressedArrays::~AddressedArrays() {
    if (context_.arrays.buffered)
        context_.arrays = kept_;
}

} // namespace spangle::gl

#endif
