// Where the components of a colour lie in a group of up to four bytes: in client images, texels or surfaces
// (GL 1.3, tables 3.5 to 3.12).
#pragma once

#include <bit>

#include "gl/pixel/pixel_layout.hpp"
#include "raster/ops/lanes.hpp"
#include <spangle/raster/limits.hpp>

/// True in builds that convert rows of pixels by vector lanes (row_codes.hpp): host builds with shortcuts.
#if defined(__SSE2__) || defined(__ARM_NEON)
#define SPANGLE_ROW_CODES (SPANGLE_SHORTCUTS && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
#else
#define SPANGLE_ROW_CODES 0
#endif

namespace spangle::gl {

inline constexpr bool has_row_codes = SPANGLE_ROW_CODES != 0;

/// A bit field of a group; `bits` is 0 when the group has no such component.
struct GroupField {
    std::uint8_t shift = 0, bits = 0;
};

/// The fields of a group: red, green, blue and alpha. A group is a word whose first byte is the least
/// significant.
struct GroupFields {
    std::uint8_t bytes = 0; ///< 1 to 4; 0: the groups are not bit fields, and no other member is valid
    bool swapped = false;   ///< a word of two bytes whose first byte is the most significant
    bool cut = false;       ///< when written, codes are rounded to eight bits and cut to their highest bits
    GroupField field[4] = {};
};

/// The fields of a layout of unsigned components with up to eight bits each. Luminance counts as red, green
/// and blue.
GroupFields fields_of(const PixelLayout& layout, bool swap_bytes);

/// The fields of the groups that SurfaceRow (row_converter.hpp) returns.
GroupFields fields_of(PixelFormat surface);

} // namespace spangle::gl
