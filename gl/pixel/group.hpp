// Groups of components: unpacks them from client memory to colours, depths and indices, and packs them back.
#pragma once

#include "gl/pixel/transfer.hpp"

namespace spangle::gl {

struct Context;

/// The kind of value in the groups of a format. On RGBA surfaces, colour indices count as colours, because
/// transfer maps them to colours.
enum class Content : std::uint8_t { color, index, depth, stencil };
inline Content content_of(const PixelLayout& layout, bool index_mode) {
    return layout.channel[0] == Channel::depth                       ? Content::depth
           : layout.channel[0] == Channel::stencil                   ? Content::stencil
           : layout.channel[0] == Channel::color_index && index_mode ? Content::index
                                                                     : Content::color;
}

/// A group after pixel transfer. Its content says what it holds: a colour, a depth in place of red, or an
/// index.
struct PixelGroup {
    Pixel color;
    Index index;
};

/// The groups of one image in client memory, laid out as UNPACK_SWAP_BYTES and UNPACK_LSB_FIRST say. `row` is
/// the first byte of a row. `group` counts groups from there, including the skipped bits of a BITMAP
/// (pixel_layout.hpp).
class Groups {
  public:
    Groups(const PixelLayout& layout, const PixelStore& store)
        : layout_(layout), swaps_bytes_(store.swap_bytes), is_lsb_first_(store.lsb_first) {}
    explicit Groups(const PixelLayout& layout) : layout_(layout) {}

    /// The colour of a group after "final expansion to RGBA": L becomes R, G and B, missing colours are 0, a
    /// missing alpha is 1 (GL 1.3, 3.6.4). A depth is in the place of red. The function must not be called
    /// for indices.
    Pixel color(const unsigned char* row, std::size_t group) const;
    Index index(const unsigned char* row, std::size_t group) const;

  private:
    std::uint32_t element(const unsigned char* row, std::size_t group, unsigned component) const;

    const PixelLayout& layout_;
    bool swaps_bytes_ = false, is_lsb_first_ = false;
};

/// The groups of a client image after pixel transfer. DrawPixels and the commands for texture images read
/// them (GL 1.3, 3.6.4, 3.6.5 and 3.8.1). The object must not outlive the layout, and must not be used after
/// the context's state has changed.
class ColorImage {
  public:
    ColorImage(const Context& context, const PixelLayout& layout);

    /// Whether every group is a colour that transfer leaves unchanged.
    bool keeps_colors() const { return !has_indices_ && !transfer_.changes_colors(); }
    /// Whether transfer leaves colours unchanged and bytes are not swapped. Rows of the image may then be
    /// copied to a receiver that stores colours as the client does.
    bool is_plain() const { return keeps_colors() && !swaps_bytes_; }

    Pixel color(const unsigned char* row, std::size_t group) const;
    PixelGroup group(Content content, const unsigned char* row, std::size_t group) const;

  private:
    Groups groups_;
    Transfer transfer_;
    bool has_indices_, swaps_bytes_;
};

/// Writes the components that the format names, clamped to [0, 1]; L is R + G + B (GL 1.3, 4.3.2). A depth is
/// taken from value[0].
void pack_pixel(const PixelLayout& layout, bool swap_bytes, const Pixel& pixel, unsigned char* to);

/// Writes an index masked to the bits of the type, 2^7 - 1 for BYTE and unmasked for FLOAT (GL 1.3, table
/// 4.6). The function must not be called for BITMAP.
void pack_index(const PixelLayout& layout, bool swap_bytes, Index index, unsigned char* to);

/// Returns the mask of bit `at` of a row, within the byte that holds the bit.
inline unsigned char bit_mask(std::size_t at, bool lsb_first) {
    return static_cast<unsigned char>(lsb_first ? 1u << at % 8 : 0x80u >> at % 8);
}
inline bool bit_of(const unsigned char* row, std::size_t at, bool lsb_first) {
    return (row[at / 8] & bit_mask(at, lsb_first)) != 0;
}

} // namespace spangle::gl
