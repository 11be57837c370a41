// Arrays and indices are in client memory or in buffer objects. The size of a buffer is known, so that
// accesses to it are checked (GL 1.5, 2.9.6).
#pragma once

#include "gl/context/context.hpp"
#include "gl/vertex/array_element.hpp"

namespace spangle::gl {

/// Calls f(count, indices) for each run of elements without a restart index (GL 3.1, 2.8).
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

/// True if ArrayElement with this index ends the primitive and begins another one (GL 3.1, 2.8).
inline bool is_restart_index(const ArrayBindings& bindings, std::uint32_t index) {
    return SPANGLE_FEATURE_PRIMITIVE_RESTART && bindings.restart && index == bindings.restart_index;
}

#if SPANGLE_FEATURE_BUFFERS

/// True if element `highest` of every enabled array is within the array's buffer, and none of these buffers
/// is mapped. Arrays in client memory cannot be checked.
bool arrays_reach(const Context& context, std::uint32_t highest);

/// Converts the offset given to DrawElements to an address. False: an index is outside of the bound buffer,
/// or names an element beyond an array. Indices that restart a primitive name no element and are not checked.
bool find_indices(const Context& context, std::uint32_t count, Indices& indices);

/// Converts the offsets of arrays to addresses during the lifetime of this object. The caller must have
/// checked with arrays_reach() or find_indices() that the buffers hold all elements to be read.
class AddressedArrays {
  public:
    explicit AddressedArrays(Context& context);
    ~AddressedArrays();
    AddressedArrays(const AddressedArrays&) = delete;
    AddressedArrays& operator=(const AddressedArrays&) = delete;

  private:
    Context& context_;
    ArraysState saved_arrays_;
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
