// Codes of a row of colours from and to elements that are not fields: signed integers, floats, and more than
// eight bits (GL 1.3, tables 2.6 and 4.7).
#pragma once

#include "gl/pixel/row_codes.hpp"

namespace spangle::gl {

/// Elements as the nearest codes to what is left of them in [0, 1]. A luminance is red, green and blue.
void read_elements(const std::uint8_t* from, const PixelLayout& layout, bool swap, std::int32_t count,
                   const CodeBits& bits, CodeRow& out);

/// Elements in the rasterizer's colour units, four words a group. What the groups lack is 0, alpha 1.
void read_units(const std::uint8_t* from, const PixelLayout& layout, bool swap, std::int32_t count,
                std::uint32_t* out);

/// Codes of so many bits as elements. A luminance is in the place of red.
void write_elements(const CodeRow& from, const CodeBits& bits, const PixelLayout& to, bool swap,
                    std::int32_t count, std::uint8_t* out);

/// Codes of so many bits in the rasterizer's colour units, four words a group.
void write_units(const CodeRow& from, const CodeBits& bits, std::int32_t count, std::uint32_t* out);

} // namespace spangle::gl
