// The area of a triangle and of its box, by one form for all areas.
#pragma once

#include "raster/primitive/setup.hpp"
#include "raster/primitive/setup_math.hpp"

namespace spangle::raster {

/// Whether the area of a box is larger than `most`. The box holds a corner and two others, which lie x1 and
/// x2 from it; it is `height` high.
SPANGLE_INLINE bool is_box_beyond(std::uint64_t most, std::int32_t x1, std::int32_t x2,
                                  std::uint32_t height) {
    return numeric::mul_u32(range_of(0, x1, x2), height) > most;
}

/// An area of a triangle that is not thin.
SPANGLE_INLINE Setup<Fixed>::Area Setup<Fixed>::area_word(std::uint64_t area, std::int32_t sign) {
    const int zeros = numeric::clz64(area);
    return {numeric::high_word_before(area, zeros), 32 - zeros, sign};
}

} // namespace spangle::raster
