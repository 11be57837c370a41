// Patterns of bytes that fill planes.
#pragma once

#include <cstdint>

#include <spangle/raster/limits.hpp>

namespace spangle::raster {

namespace clearing {

/// The bytes of a row: a sequence of `period` bytes that is repeated. From any of its first four bytes on,
/// four words can be read, or twelve for pixels of three bytes.
struct Pattern {
    alignas(4) std::uint8_t byte[64];
    std::int32_t bytes = 16; ///< number of bytes of the pattern that repeat: 16 or 48

    std::int32_t period() const { return has_format(PixelFormat::rgb888) ? bytes : 16; }
};

inline void copy_bytes(std::uint8_t* to, const std::uint8_t* from, std::int32_t n) {
    for (std::int32_t i = 0; i < n; ++i)
        to[i] = from[i];
}

} // namespace clearing

} // namespace spangle::raster
