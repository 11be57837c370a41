// Says how one group of components lies in client memory, for each format and type of pixels (GL 1.3, 3.6.4,
// tables 3.5 to 3.12).
#pragma once

#include "gl/pixel/pixel_store_state.hpp"

namespace spangle::gl {

/// What a component of a group is.
enum class Channel : std::uint8_t { red, green, blue, alpha, luminance, depth, color_index, stencil };

enum class ElementKind : std::uint8_t { unsigned_integer, signed_integer, real, bitmap };

struct PixelLayout {
    std::uint8_t components = 0;    ///< components of a group
    std::uint8_t elements = 0;      ///< elements of a group; 1 for packed types
    std::uint8_t element_bytes = 0; ///< 1 for BITMAP, whose groups are single bits
    ElementKind kind = ElementKind::unsigned_integer;
    Channel channel[4] = {};
    bool packed = false;
    std::uint8_t bits[4] = {};  ///< bits of component i in its element
    std::uint8_t shift[4] = {}; ///< packed types: lowest bit of component i

    std::uint32_t group_bytes() const { return std::uint32_t{elements} * element_bytes; }
};

/// Returns NO_ERROR with `out` filled in, or an error. INVALID_ENUM: an unknown format or type, or BITMAP
/// with a format other than indices. INVALID_OPERATION: a packed type with another number of components.
GLenum pixel_layout(GLenum format, GLenum type, PixelLayout& out);

/// Where the rows of an image lie: the first begins at byte `skip`, and each next one `stride` bytes further.
/// With BITMAP, group 0 of a row is bit `skip_bits` of its first byte, counted in the order that LSB_FIRST
/// says.
struct ImageRows {
    std::size_t stride = 0, skip = 0;
    unsigned skip_bits = 0;
};

/// The rows of an image `width` groups wide (GL 1.3, 3.6.4): k = n l, or a / s * ceil(s n l / a) when the
/// elements are smaller than the alignment.
ImageRows image_rows(const PixelStore& store, const PixelLayout& layout, GLsizei width);

/// Bytes from one image of a volume to the next, as IMAGE_HEIGHT says. SKIP_IMAGES images lie before the
/// first (GL 1.3, 3.6.1, 3.8.1). Both apply to volumes only.
inline std::size_t image_stride(const PixelStore& store, const ImageRows& rows, GLsizei height) {
    return rows.stride * static_cast<std::size_t>(store.image_height > 0 ? store.image_height : height);
}

} // namespace spangle::gl
