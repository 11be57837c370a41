// Where arrays and indices lie: in client memory, or in buffer objects that say how long they are (GL 1.5,
// 2.9.6).
#pragma once

#include "gl/context/context.hpp"
#include "gl/vertex/array_element.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_BUFFERS

/// Element `highest` of every array that is on lies in its buffer, and no such buffer is mapped. Client
/// memory is not ours to check.
bool arrays_reach(const Context& context, std::uint32_t highest);

/// The offset of DrawElements becomes an address. False: the indices are not all in the bound buffer, or one
/// of them is beyond an array.
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
