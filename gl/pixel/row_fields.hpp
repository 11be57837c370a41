// Where the components of a colour lie in a group of at most four bytes: of a client image, of an image of
// texels or of a surface (GL 1.3, tables 3.5 to 3.12).
#pragma once

#include <bit>

#include "gl/pixel/pixel_layout.hpp"
#include "raster/span/lanes.hpp"
#include <spangle/raster/limits.hpp>

/// Builds that convert rows of pixels by lanes (row_codes.hpp): those that run on hosts and have shortcuts.
#if defined(__SSE2__) || defined(__ARM_NEON)
#define SPANGLE_ROW_CODES (SPANGLE_SHORTCUTS && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
#else
#define SPANGLE_ROW_CODES 0
#endif

namespace spangle::gl {

inline constexpr bool has_row_codes = SPANGLE_ROW_CODES != 0;

/// `bits` is 0 where the group has no such component.
struct GroupField {
    std::uint8_t shift = 0, bits = 0;
};

/// A group is a word whose first byte is the lowest. The fields are red, green, blue and alpha.
struct GroupFields {
    std::uint8_t bytes = 0; ///< 1 to 4; 0: the format has other components, and nothing else is valid
    bool swapped = false;   ///< a word of two bytes, of which the first is the highest
    bool cut = false;       ///< to be written: codes are the highest bits of those of eight bits
    GroupField field[4] = {};
};

/// The fields of a layout of unsigned components with at most eight bits each. A luminance is read as red,
/// green and blue.
GroupFields fields_of(const PixelLayout& layout, bool swap_bytes);

/// The fields of the words that SurfaceRow (row_converter.hpp) gives.
GroupFields fields_of(PixelFormat surface);

} // namespace spangle::gl
