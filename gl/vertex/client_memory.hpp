// Reads numbers from the memory of a program.
#pragma once

#include <cstdint>

namespace spangle::gl {

/// Reads a value from client memory. The address need not be aligned.
template <class T> T read(const std::uint8_t* at) {
    T value;
    __builtin_memcpy(&value, at, sizeof value);
    return value;
}

} // namespace spangle::gl
