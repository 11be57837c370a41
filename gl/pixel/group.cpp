#include "gl/pixel/group.hpp"

namespace spangle::gl {

namespace {

std::uint32_t element_of(const PixelLayout& layout, bool swap_bytes, const unsigned char* from,
                         unsigned component) {
    const std::uint32_t offset = layout.packed ? 0 : component * std::uint32_t{layout.element_bytes};
    const std::uint32_t element = load_element(from + offset, layout.element_bytes, swap_bytes);
    return layout.packed ? element >> layout.shift[component] & all_ones(layout.bits[component]) : element;
}

Component luminance(const Pixel& pixel) {
    std::uint64_t sum = 0;
    for (unsigned c = 0; c < 3; ++c)
        sum += rescale(pixel.value[c].code, pixel.value[c].bits, 32);
    constexpr std::uint64_t most = 0xFFFFFFFF;
    return {static_cast<std::uint32_t>(sum < most ? sum : most), 32};
}

Component pick(const Pixel& pixel, Channel channel) {
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

void unpack_color(const PixelLayout& layout, bool swap_bytes, const unsigned char* from,
                  const ColorBits& bits, std::uint32_t rgba[4]) {
    rgba[0] = rgba[1] = rgba[2] = 0;
    rgba[3] = all_ones(bits.of[3]);
    for (unsigned i = 0; i < layout.components; ++i) {
        const std::uint32_t element = element_of(layout, swap_bytes, from, i);
        const bool grey = layout.channel[i] == Channel::luminance;
        const unsigned first = grey ? 0 : static_cast<unsigned>(layout.channel[i]);
        const unsigned last = grey ? 2 : first;
        for (unsigned c = first; c <= last; ++c)
            rgba[c] = decode_element(layout.kind, layout.bits[i], element, bits.of[c]);
    }
}

void pack_pixel(const PixelLayout& layout, bool swap_bytes, const Pixel& pixel, unsigned char* to) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < layout.components; ++i) {
        const std::uint32_t element =
            encode_element(layout.kind, layout.bits[i], pick(pixel, layout.channel[i]));
        if (layout.packed)
            word |= element << layout.shift[i];
        else
            store_element(to + i * std::uint32_t{layout.element_bytes}, layout.element_bytes, swap_bytes,
                          element);
    }
    if (layout.packed)
        store_element(to, layout.element_bytes, swap_bytes, word);
}

void pack_index(const PixelLayout& layout, bool swap_bytes, std::uint32_t index, unsigned char* to) {
    std::uint32_t element = index;
    if (layout.kind == ElementKind::real)
        element = numeric::to_float_bits(numeric::from_u32(index));
    else if (layout.kind == ElementKind::signed_integer)
        element &= all_ones(layout.bits[0]) >> 1;
    store_element(to, layout.element_bytes, swap_bytes, element);
}

} // namespace spangle::gl
