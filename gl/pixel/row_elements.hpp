// Converts codes of a row of colours from and to elements that are not bit fields: signed integers, floats,
// and elements with more than eight bits (GL 1.3, tables 2.6 and 4.7).
#pragma once

#include "gl/pixel/row_codes.hpp"

namespace spangle::gl {

/// Reads elements, clamped to [0, 1], as the nearest codes. Luminance is read as red, green and blue.
void read_elements(const std::uint8_t* from, const PixelLayout& layout, bool swap, std::int32_t count,
                   const CodeBits& bits, CodeRow& out);

/// Reads elements in the rasterizer's colour units, four words per group. Colours that the groups lack are
/// read as 0, and a missing alpha as 1.
void read_units(const std::uint8_t* from, const PixelLayout& layout, bool swap, std::int32_t count,
                std::uint32_t* out);

/// Writes codes, which have `bits` bits, as elements. Luminance is taken from red.
void write_elements(const CodeRow& from, const CodeBits& bits, const PixelLayout& to, bool swap,
                    std::int32_t count, std::uint8_t* out);

/// Writes codes, which have `bits` bits, in the rasterizer's colour units, four words per group.
void write_units(const CodeRow& from, const CodeBits& bits, std::int32_t count, std::uint32_t* out);

} // namespace spangle::gl
