// Where arrays and indices lie: in client memory, or in buffer objects that say how long they are (GL 1.5,
// 2.9.6).
#pragma once

#include "gl/context/context.hpp"
#include "gl/vertex/array_element.hpp"

namespace spangle::gl {

/// Calls f(count, indices) for the elements between those that end a primitive and begin another
/// (GL 3.1, 2.8).
template <class F>
void for_each_run(const ArrayBindings& bindings, std::uint32_t count, const Indices& indices, F f) {
    if (!SPANGLE_FEATURE_PRIMITIVE_RESTART || !bindings.restart)
        return f(count, indices);
    std::uint32_t begin = 0;
    for (std::uint32_t i = 0; i <= count; ++i)
        if (i == count || indices.at(i) == bindings.restart_index) {
            f(i - begin, indices.from(begin));
            begin = i + 1;
        }
}

/// ArrayElement of this index is End and Begin.
inline bool restarts(const ArrayBindings& bindings, std::uint32_t index) {
    return SPANGLE_FEATURE_PRIMITIVE_RESTART && bindings.restart && index == bindings.restart_index;
}

#if SPANGLE_FEATURE_BUFFERS

/// Element `highest` of every array that is on lies in its buffer, and no such buffer is mapped. Client
/// memory is not ours to check.
bool arrays_reach(const Context& context, std::uint32_t highest);

/// The offset of DrawElements becomes an address. False: the indices are not all in the bound buffer, or one
/// of them is beyond an array. Those that restart a primitive name no element.
bool find_indices(const Context& context, std::uint32_t count, Indices& indices);

/// While it lives the offsets of arrays are addresses. They have to reach what will be read.
class AddressedArrays {
  public:
    explicit AddressedArrays(Context& context);
    ~AddressedArrays();
    AddressedArrays(const AddressedArrays&) = delete;
    AddressedArrays& operator=(const AddressedArrays&) = delete;

  private:
    Context& context_;
    ArraysState kept_;
};

#else

struct AddressedArrays {
    explicit AddressedArrays(Context&) {}
};

inline bool arrays_reach(const Context&, std::uint32_t) {
    return true;
}
inline bool find_indices(const Context&, std::uint32_t, Indices&) {
    return true;
}

#endif

} // namespace spangle::gl
