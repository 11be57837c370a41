#include "gl/pixel/group.hpp"

#include "gl/context/context.hpp"

namespace spangle::gl {

namespace {

Component luminance(const Pixel& pixel) {
    const Component(&v)[4] = pixel.value;
    if (v[0].bits == 0 || v[1].bits == 0 || v[2].bits == 0)
        return component(numeric::add(numeric::add(to_real(v[0]), to_real(v[1])), to_real(v[2])));
    std::uint64_t sum = 0;
    for (unsigned c = 0; c < 3; ++c)
        sum += code_of(v[c], 32);
    constexpr std::uint64_t most = 0xFFFFFFFF;
    return {static_cast<std::uint32_t>(sum < most ? sum : most), 32};
}

Component component_of(const Pixel& pixel, Channel channel) {
    switch (channel) {
    case Channel::luminance:
        return luminance(pixel);
    case Channel::depth:
        return pixel.value[0];
    default:
        return pixel.value[static_cast<unsigned>(channel)];
    }
}

} // namespace

std::uint32_t Groups::element(const unsigned char* row, std::size_t group, unsigned component) const {
    if (layout_.kind == ElementKind::bitmap)
        return bit_of(row, group, is_lsb_first_) ? 1 : 0;
    const unsigned char* const from = row + group * layout_.group_bytes();
    const std::uint32_t offset = layout_.packed ? 0 : component * std::uint32_t{layout_.element_bytes};
    const std::uint32_t element = load_element(from + offset, layout_.element_bytes, swaps_bytes_);
    if (!layout_.packed)
        return element;
    return element >> layout_.shift[component] & all_ones(layout_.bits[component]);
}

Pixel Groups::color(const unsigned char* row, std::size_t group) const {
    Pixel color{{{0, 8}, {0, 8}, {0, 8}, {255, 8}}};
    for (unsigned i = 0; i < layout_.components; ++i) {
        const Component c = decode_element(layout_.kind, layout_.bits[i], element(row, group, i));
        const bool grey = layout_.channel[i] == Channel::luminance;
        color.value[layout_.channel[i] < Channel::luminance ? static_cast<unsigned>(layout_.channel[i]) : 0] =
            c;
        if (grey)
            color.value[1] = color.value[2] = c;
    }
    return color;
}

Index Groups::index(const unsigned char* row, std::size_t group) const {
    return decode_index(layout_.kind, layout_.bits[0], element(row, group, 0));
}

ColorImage::ColorImage(const Context& context, const PixelLayout& layout)
    : groups_(layout, context.pixel_store.unpack), transfer_(context.pixel_mode),
      has_indices_(layout.channel[0] == Channel::color_index),
      swaps_bytes_(context.pixel_store.unpack.swap_bytes && layout.element_bytes > 1) {}

Pixel ColorImage::color(const unsigned char* row, std::size_t at) const {
    return group(Content::color, row, at).color;
}

PixelGroup ColorImage::group(Content content, const unsigned char* row, std::size_t at) const {
    PixelGroup group;
    if (content == Content::depth || (content == Content::color && !has_indices_)) {
        group.color = groups_.color(row, at);
        if (content == Content::color)
            transfer_.transfer_if_needed(group.color);
        else
            group.color.value[0] = transfer_.depth(group.color.value[0]);
        return group;
    }
    const Index index = groups_.index(row, at);
    if (content == Content::color)
        group.color = transfer_.color_of(index);
    else if (raster::has_indices && content == Content::index)
        group.index = transfer_.index(index);
    else
        group.index = transfer_.stencil(index);
    return group;
}

void pack_pixel(const PixelLayout& layout, bool swap_bytes, const Pixel& pixel, unsigned char* to) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < layout.components;) {
        word |= encode_element(layout.kind, layout.bits[i], component_of(pixel, layout.channel[i]))
                << layout.shift[i];
        ++i;
        if (layout.packed && i < layout.components)
            continue;
        store_element(to, layout.element_bytes, swap_bytes, word);
        to += layout.element_bytes;
        word = 0;
    }
}

void pack_index(const PixelLayout& layout, bool swap_bytes, Index index, unsigned char* to) {
    std::uint32_t element = rounded(index);
    if (layout.kind == ElementKind::real)
        element = numeric::to_float_bits(to_real(index));
    else if (layout.kind == ElementKind::signed_integer)
        element &= all_ones(layout.bits[0]) >> 1;
    store_element(to, layout.element_bytes, swap_bytes, element);
}

} // namespace spangle::gl
