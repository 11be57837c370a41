#include "gl/pixel/pixel_layout.hpp"

#include <cstring>
#include <iterator>

namespace spangle::gl {

namespace {

/// The components of a format: four bits each, holding Channel + 1, with the first component in the lowest
/// bits.
constexpr std::uint16_t channels(auto... components) {
    unsigned all = 0, low = 0;
    ((all |= (static_cast<unsigned>(components) + 1) << low, low += 4), ...);
    return static_cast<std::uint16_t>(all);
}

constexpr Channel R = Channel::red, G = Channel::green, B = Channel::blue, A = Channel::alpha,
                  L = Channel::luminance;

/// Two runs of consecutive tokens. Both together are the indices of one table.
struct Tokens {
    std::uint16_t first, count, others, all;

    /// The index of a token, or `all` if it is not in the table.
    constexpr unsigned place(GLenum token) const {
        if (token - first < count)
            return token - first;
        const GLenum other = token - others + count;
        return other - count < GLenum{all} - count ? other : all;
    }
};

constexpr std::uint16_t formats[] = {
    channels(Channel::color_index),
    channels(Channel::stencil),
    channels(Channel::depth),
    channels(R),
    channels(G),
    channels(B),
    channels(A),
    channels(R, G, B),
    channels(R, G, B, A),
    channels(L),
    channels(L, A),
    channels(B, G, R),
    channels(B, G, R, A),
};
constexpr Tokens format_tokens{GL_COLOR_INDEX, 11, GL_BGR, 13};
constexpr bool has_format(GLenum token, auto... components) {
    return formats[format_tokens.place(token)] == channels(components...);
}
static_assert(std::size(formats) == format_tokens.all);
static_assert(has_format(GL_COLOR_INDEX, Channel::color_index) &&
              has_format(GL_STENCIL_INDEX, Channel::stencil) &&
              has_format(GL_DEPTH_COMPONENT, Channel::depth) && has_format(GL_RED, R) &&
              has_format(GL_GREEN, G) && has_format(GL_BLUE, B) && has_format(GL_ALPHA, A) &&
              has_format(GL_RGB, R, G, B) && has_format(GL_RGBA, R, G, B, A) && has_format(GL_LUMINANCE, L) &&
              has_format(GL_LUMINANCE_ALPHA, L, A) && has_format(GL_BGR, B, G, R) &&
              has_format(GL_BGRA, B, G, R, A));

/// The sizes of the components of packed types. Each size takes four bits, and that of the first component is
/// in the lowest bits. Reversed types have the first component in their least significant bits.
constexpr std::uint16_t packed_bits[] = {
    0x233,  // UNSIGNED_BYTE_3_3_2
    0x4444, // UNSIGNED_SHORT_4_4_4_4
    0x1555, // UNSIGNED_SHORT_5_5_5_1
    0x8888, // UNSIGNED_INT_8_8_8_8
    0x2AAA, // UNSIGNED_INT_10_10_10_2
    0x233,  // UNSIGNED_BYTE_2_3_3_REV
    0x565,  // UNSIGNED_SHORT_5_6_5
    0x565,  // UNSIGNED_SHORT_5_6_5_REV
    0x4444, // UNSIGNED_SHORT_4_4_4_4_REV
    0x1555, // UNSIGNED_SHORT_1_5_5_5_REV
    0x8888, // UNSIGNED_INT_8_8_8_8_REV
    0x2AAA, // UNSIGNED_INT_2_10_10_10_REV
};
constexpr Tokens packed_tokens{GL_UNSIGNED_BYTE_3_3_2, 5, GL_UNSIGNED_BYTE_2_3_3_REV, 12};
constexpr unsigned reversed = 0xFA0; ///< bit i: packed type i is reversed
constexpr bool has_type(GLenum token, unsigned bits, bool is_reversed) {
    const unsigned place = packed_tokens.place(token);
    return packed_bits[place] == bits && (reversed >> place & 1) == is_reversed;
}
static_assert(std::size(packed_bits) == packed_tokens.all);
static_assert(has_type(GL_UNSIGNED_BYTE_3_3_2, 0x233, false) &&
              has_type(GL_UNSIGNED_BYTE_2_3_3_REV, 0x233, true) &&
              has_type(GL_UNSIGNED_SHORT_5_6_5, 0x565, false) &&
              has_type(GL_UNSIGNED_SHORT_5_6_5_REV, 0x565, true) &&
              has_type(GL_UNSIGNED_SHORT_4_4_4_4, 0x4444, false) &&
              has_type(GL_UNSIGNED_SHORT_4_4_4_4_REV, 0x4444, true) &&
              has_type(GL_UNSIGNED_SHORT_5_5_5_1, 0x1555, false) &&
              has_type(GL_UNSIGNED_SHORT_1_5_5_5_REV, 0x1555, true) &&
              has_type(GL_UNSIGNED_INT_8_8_8_8, 0x8888, false) &&
              has_type(GL_UNSIGNED_INT_8_8_8_8_REV, 0x8888, true) &&
              has_type(GL_UNSIGNED_INT_10_10_10_2, 0x2AAA, false) &&
              has_type(GL_UNSIGNED_INT_2_10_10_10_REV, 0x2AAA, true));

/// Fills in the fields of a packed type. Returns how many components it has.
unsigned place_fields(unsigned type, PixelLayout& out) {
    unsigned count = 0, all = 0;
    for (unsigned bits = packed_bits[type]; bits != 0; bits >>= 4, ++count) {
        out.bits[count] = bits & 15;
        out.shift[count] = static_cast<std::uint8_t>(all);
        all += bits & 15;
    }
    if ((reversed >> type & 1) == 0)
        for (unsigned i = 0; i < count; ++i)
            out.shift[i] = static_cast<std::uint8_t>(all - out.shift[i] - out.bits[i]);
    out.elements = 1;
    out.element_bytes = static_cast<std::uint8_t>(all / 8);
    out.packed = true;
    return count;
}

} // namespace

GLenum pixel_layout(GLenum format_token, GLenum type_token, PixelLayout& out) {
    const unsigned format = format_tokens.place(format_token);
    if (format == format_tokens.all)
        return GL_INVALID_ENUM;
    out = {};
    for (unsigned left = formats[format]; left != 0; left >>= 4)
        out.channel[out.components++] = static_cast<Channel>((left & 15) - 1);
    if (const unsigned packed = packed_tokens.place(type_token); packed != packed_tokens.all) {
        // Packed types allow only formats with their components: RGB, or RGBA and BGRA (GL 1.3, table 3.8).
        const bool goes = place_fields(packed, out) == 3 ? format_token == GL_RGB : out.components == 4;
        return goes ? GL_NO_ERROR : GL_INVALID_OPERATION;
    }
    out.elements = out.components;
    unsigned bytes = 1;
    const GLenum plain = type_token - GL_BYTE; // signed and unsigned integers of 1, 2 and 4 bytes
    static_assert(GL_UNSIGNED_BYTE - GL_BYTE == 1 && GL_SHORT - GL_BYTE == 2 &&
                  GL_UNSIGNED_SHORT - GL_BYTE == 3 && GL_INT - GL_BYTE == 4 &&
                  GL_UNSIGNED_INT - GL_BYTE == 5);
    if (plain < 6) {
        out.kind = plain % 2 == 0 ? ElementKind::signed_integer : ElementKind::unsigned_integer;
        bytes <<= plain / 2;
    } else if (type_token == GL_FLOAT) {
        out.kind = ElementKind::real;
        bytes = 4;
    } else if (type_token == GL_BITMAP && format < 2) { // BITMAP takes colour or stencil indices only
        out.kind = ElementKind::bitmap;
    } else {
        return GL_INVALID_ENUM;
    }
    out.element_bytes = static_cast<std::uint8_t>(bytes);
    std::memset(out.bits, static_cast<int>(8 * bytes), sizeof out.bits);
    return GL_NO_ERROR;
}

ImageRows image_rows(const PixelStore& store, const PixelLayout& layout, GLsizei width) {
    const auto length = static_cast<std::size_t>(store.row_length > 0 ? store.row_length : width);
    const auto alignment = static_cast<std::size_t>(store.alignment);
    const auto skip_rows = static_cast<std::size_t>(store.skip_rows);
    const auto skip_pixels = static_cast<std::size_t>(store.skip_pixels);
    ImageRows rows;
    if (layout.kind == ElementKind::bitmap) {
        rows.stride = (length + 8 * alignment - 1) / (8 * alignment) * alignment;
        rows.skip = skip_rows * rows.stride + skip_pixels / 8;
        rows.skip_bits = static_cast<unsigned>(skip_pixels % 8);
        return rows;
    }
    const std::size_t bytes = length * layout.group_bytes();
    rows.stride = layout.element_bytes >= alignment ? bytes : (bytes + alignment - 1) / alignment * alignment;
    rows.skip = skip_rows * rows.stride + skip_pixels * layout.group_bytes();
    return rows;
}

} // namespace spangle::gl
