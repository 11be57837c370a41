// Groups of components: from client memory to colours, and from pixels to client memory.
#pragma once

#include "gl/pixel/component.hpp"

namespace spangle::gl {

/// How many bits a receiver keeps of R, G, B, A.
struct ColorBits {
    std::uint8_t of[4] = {8, 8, 8, 8};
};

/// The colour of one group, "final expansion to RGBA" included: L becomes R, G and B; missing colours are 0,
/// a missing alpha is 1 (GL 1.3, 3.6.4). Codes have the bits asked for.
void unpack_color(const PixelLayout& layout, bool swap_bytes, const unsigned char* from,
                  const ColorBits& bits, std::uint32_t rgba[4]);

/// A pixel as it was fetched. Depth stands in value[0].
struct Pixel {
    Component value[4];
};

/// Writes the components the format names; L is R + G + B clamped to 1 (GL 1.3, 4.3.2).
void pack_pixel(const PixelLayout& layout, bool swap_bytes, const Pixel& pixel, unsigned char* to);

/// A stencil index, masked to the bits of the type: 2^7 - 1 for BYTE (GL 1.3, table 4.6). Not for BITMAP.
void pack_index(const PixelLayout& layout, bool swap_bytes, std::uint32_t index, unsigned char* to);

} // namespace spangle::gl
