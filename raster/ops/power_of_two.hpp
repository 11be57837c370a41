// Which sizes of textures are powers of two.
#pragma once

#include <cstdint>

#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

constexpr bool is_power_of_two(std::int32_t size) {
    return (size & (size - 1)) == 0;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
