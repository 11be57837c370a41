#include "gl/vertex/array_source.hpp"

#if SPANGLE_FEATURE_BUFFERS

#include "gl/vertex/buffer_object.hpp"

namespace spangle::gl {

namespace {

bool is_within_buffer(const ClientArray& array, std::uint32_t highest) {
    const BufferObject* const buffer = array.buffer;
    if (!array.enabled || buffer == nullptr)
        return true;
    if (buffer->mapped)
        return false;
    const std::uint64_t element = std::uint64_t{bytes_of(array.type)} * static_cast<unsigned>(array.size),
                        stride = array.stride != 0 ? static_cast<std::uint64_t>(array.stride) : element,
                        offset = reinterpret_cast<std::uintptr_t>(array.pointer);
    return offset <= buffer->size && stride * highest + element <= buffer->size - offset;
}

} // namespace

bool arrays_reach(const Context& context, std::uint32_t highest) {
    const ArraysState& arrays = context.arrays;
    if (!arrays.buffered)
        return true;
    bool all = true;
    each_array(arrays, [&](const ClientArray& array) { all = all && is_within_buffer(array, highest); });
    return all;
}

bool find_indices(const Context& context, std::uint32_t count, Indices& indices) {
    if (count == 0)
        return true;
    const BufferObject* const buffer = context.arrays.element_buffer;
    if (indices.type != GL_NONE && buffer != nullptr) {
        const auto offset = reinterpret_cast<std::uintptr_t>(indices.data);
        if (buffer->mapped || offset > buffer->size ||
            std::uint64_t{count} * bytes_of(indices.type) > buffer->size - offset)
            return false;
        indices.data = buffer->bytes + offset;
    }
    if (!context.arrays.buffered)
        return true;
    bool any = false;
    std::uint32_t highest = 0;
    for_each_run(context.array_bindings, count, indices, [&](std::uint32_t n, const Indices& run) {
        any = any || n != 0;
        if (run.type == GL_NONE)
            highest = n != 0 ? run.first + n - 1 : highest;
        else
            for (std::uint32_t i = 0; i < n; ++i)
                highest = run.at(i) > highest ? run.at(i) : highest;
    });
    return !any || arrays_reach(context, highest);
}

AddressedArrays::AddressedArrays(Context& context) : context_(context) {
    if (!context.arrays.buffered)
        return;
    saved_arrays_ = context.arrays;
    each_array(context.arrays, [&](ClientArray& array) {
        const BufferObject* const buffer = array.buffer;
        if (!array.enabled || buffer == nullptr)
            return;
        // A draw without elements is not checked. Its buffers may be empty, and its offsets may be beyond
        // their ends.
        const auto offset = reinterpret_cast<std::uintptr_t>(array.pointer);
        array.pointer = buffer->bytes != nullptr && offset <= buffer->size ? buffer->bytes + offset : nullptr;
    });
}

AddressedArrays::~AddressedArrays() {
    if (context_.arrays.buffered)
        context_.arrays = saved_arrays_;
}

} // namespace spangle::gl

#endif
