#include "gl/pixel/pixel_layout.hpp"

namespace spangle::gl {

namespace {

struct Format {
    std::uint16_t token;
    std::uint8_t components;
    Channel channel[4];
};

constexpr Channel R = Channel::red, G = Channel::green, B = Channel::blue, A = Channel::alpha,
                  L = Channel::luminance;

constexpr Format formats[] = {
    {GL_RGBA, 4, {R, G, B, A}},
    {GL_RGB, 3, {R, G, B}},
    {GL_BGRA, 4, {B, G, R, A}},
    {GL_BGR, 3, {B, G, R}},
    {GL_RED, 1, {R}},
    {GL_GREEN, 1, {G}},
    {GL_BLUE, 1, {B}},
    {GL_ALPHA, 1, {A}},
    {GL_LUMINANCE, 1, {L}},
    {GL_LUMINANCE_ALPHA, 2, {L, A}},
    {GL_DEPTH_COMPONENT, 1, {Channel::depth}},
    {GL_COLOR_INDEX, 1, {Channel::color_index}},
    {GL_STENCIL_INDEX, 1, {Channel::stencil}},
};

struct Type {
    std::uint16_t token;
    std::uint8_t bytes;
    ElementKind kind;
    std::uint8_t fields; ///< 0: one component per element
    bool reversed;       ///< first component in the least significant bits
    std::uint8_t bits[4];
};

constexpr ElementKind whole = ElementKind::unsigned_integer;

constexpr Type types[] = {
    {GL_UNSIGNED_BYTE, 1, whole, 0, false, {}},
    {GL_BYTE, 1, ElementKind::signed_integer, 0, false, {}},
    {GL_UNSIGNED_SHORT, 2, whole, 0, false, {}},
    {GL_SHORT, 2, ElementKind::signed_integer, 0, false, {}},
    {GL_UNSIGNED_INT, 4, whole, 0, false, {}},
    {GL_INT, 4, ElementKind::signed_integer, 0, false, {}},
    {GL_FLOAT, 4, ElementKind::real, 0, false, {}},
    {GL_BITMAP, 1, ElementKind::bitmap, 0, false, {}},
    {GL_UNSIGNED_BYTE_3_3_2, 1, whole, 3, false, {3, 3, 2}},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, whole, 3, true, {3, 3, 2}},
    {GL_UNSIGNED_SHORT_5_6_5, 2, whole, 3, false, {5, 6, 5}},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, whole, 3, true, {5, 6, 5}},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, whole, 4, false, {4, 4, 4, 4}},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, whole, 4, true, {4, 4, 4, 4}},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, whole, 4, false, {5, 5, 5, 1}},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, whole, 4, true, {5, 5, 5, 1}},
    {GL_UNSIGNED_INT_8_8_8_8, 4, whole, 4, false, {8, 8, 8, 8}},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, whole, 4, true, {8, 8, 8, 8}},
    {GL_UNSIGNED_INT_10_10_10_2, 4, whole, 4, false, {10, 10, 10, 2}},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, whole, 4, true, {10, 10, 10, 2}},
};

template <class Row, std::size_t count> const Row* find(const Row (&table)[count], GLenum token) {
    for (const Row& row : table)
        if (row.token == token)
            return &row;
    return nullptr;
}

void place_fields(const Type& type, PixelLayout& out) {
    unsigned low = type.reversed ? 0 : 8u * type.bytes;
    for (unsigned i = 0; i < type.fields; ++i) {
        if (!type.reversed)
            low -= type.bits[i];
        out.bits[i] = type.bits[i];
        out.shift[i] = static_cast<std::uint8_t>(low);
        if (type.reversed)
            low += type.bits[i];
    }
}

} // namespace

GLenum pixel_layout(GLenum format_token, GLenum type_token, PixelLayout& out) {
    const Format* format = find(formats, format_token);
    const Type* type = find(types, type_token);
    if (format == nullptr || type == nullptr)
        return GL_INVALID_ENUM;
    if (type->kind == ElementKind::bitmap && format_token != GL_STENCIL_INDEX &&
        format_token != GL_COLOR_INDEX)
        return GL_INVALID_ENUM;
    // Packed types name their components: RGB, or RGBA and BGRA (table 3.8).
    if (type->fields == 3 && format_token != GL_RGB)
        return GL_INVALID_OPERATION;
    if (type->fields == 4 && format->components != 4)
        return GL_INVALID_OPERATION;
    out = {};
    out.components = format->components;
    out.packed = type->fields != 0;
    out.elements = out.packed ? std::uint8_t{1} : format->components;
    out.element_bytes = type->bytes;
    out.kind = type->kind;
    for (unsigned i = 0; i < format->components; ++i) {
        out.channel[i] = format->channel[i];
        out.bits[i] = static_cast<std::uint8_t>(8 * type->bytes);
    }
    if (out.packed)
        place_fields(*type, out);
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
