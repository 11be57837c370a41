#include "gl/pixel/row_elements.hpp"

#if SPANGLE_ROW_CODES

#include "gl/pixel/component.hpp"

namespace spangle::gl {

namespace {

/// What `of` makes of each code of 1 to 8 bits, those of more bits behind the others.
constexpr std::uint32_t first_of(unsigned bits) {
    return (1u << bits) - 2;
}
template <class Of> constexpr auto of_all_codes(Of of) {
    std::array<std::uint32_t, first_of(most_code_bits + 1)> all{};
    for (unsigned bits = 1; bits <= most_code_bits; ++bits)
        for (std::uint32_t code = 0; code <= all_ones(bits); ++code)
            all[first_of(bits) + code] = of(Component{code, static_cast<std::uint8_t>(bits)});
    return all;
}
constexpr auto floats = of_all_codes([](Component c) { return encode_element(ElementKind::real, 32, c); });
constexpr auto units = of_all_codes([](Component c) { return color_units_of(c); });

/// All elements of a component, `stride` bytes from each other.
template <ElementKind Kind, unsigned Bytes>
void read_component(const std::uint8_t* from, std::uint32_t stride, std::int32_t count, bool swap,
                    unsigned shift, unsigned bits, unsigned to, unsigned cut, std::uint16_t* out) {
    const std::uint32_t mask = all_ones(bits);
    for (std::int32_t i = 0; i < count; ++i, from += stride) {
        const std::uint32_t element = load_element(from, Bytes, swap) >> shift & mask;
        const bool negative = Kind == ElementKind::signed_integer && (element >> (bits - 1) & 1) != 0;
        const std::uint32_t code = negative ? 0 : code_of(decode_element(Kind, bits, element), to);
        out[i] = static_cast<std::uint16_t>(code >> cut);
    }
}

using ReadComponent = decltype(&read_component<ElementKind::real, 4>);

ReadComponent reader_of(const PixelLayout& layout) {
    if (layout.kind == ElementKind::real)
        return read_component<ElementKind::real, 4>;
    const bool has_signs = layout.kind == ElementKind::signed_integer;
    if (layout.element_bytes == 4)
        return has_signs ? read_component<ElementKind::signed_integer, 4>
                         : read_component<ElementKind::unsigned_integer, 4>;
    if (layout.element_bytes == 2)
        return has_signs ? read_component<ElementKind::signed_integer, 2>
                         : read_component<ElementKind::unsigned_integer, 2>;
    return read_component<ElementKind::signed_integer, 1>;
}

/// The channels that a component of a group is, of red, green, blue and alpha: [first, end).
struct Channels {
    unsigned first, end;
};
Channels channels_of(Channel channel) {
    const auto c = static_cast<unsigned>(channel);
    return channel == Channel::luminance ? Channels{0, 3} : Channels{c, c + 1};
}

template <class Encode>
void write_component(const std::uint16_t* code, std::int32_t count, std::uint8_t* to, std::uint32_t stride,
                     unsigned bytes, bool swap, Encode encode) {
    for (std::int32_t i = 0; i < count; ++i, to += stride)
        store_element(to, bytes, swap, encode(code[i]));
}

} // namespace

void read_elements(const std::uint8_t* from, const PixelLayout& layout, bool swap, std::int32_t count,
                   const CodeBits& bits, CodeRow& out) {
    const ReadComponent read_one = reader_of(layout);
    for (unsigned i = 0; i < layout.components; ++i) {
        const Channels channels = channels_of(layout.channel[i]);
        const unsigned offset = layout.packed ? 0 : i * unsigned{layout.element_bytes};
        for (unsigned c = channels.first; c < channels.end; ++c)
            if (bits.of[c] != 0)
                read_one(from + offset, layout.group_bytes(), count, swap, layout.shift[i], layout.bits[i],
                         bits.cut ? 8 : bits.of[c], bits.cut ? 8u - bits.of[c] : 0, out.code[c]);
    }
}

void write_elements(const CodeRow& from, const CodeBits& bits, const PixelLayout& to, bool swap,
                    std::int32_t count, std::uint8_t* out) {
    if (to.packed) {
        for (std::int32_t i = 0; i < count; ++i, out += to.element_bytes) {
            std::uint32_t word = 0;
            for (unsigned k = 0; k < to.components; ++k) {
                const unsigned c = channels_of(to.channel[k]).first;
                word |= rescale(from.code[c][i], bits.of[c], to.bits[k]) << to.shift[k];
            }
            store_element(out, to.element_bytes, swap, word);
        }
        return;
    }
    for (unsigned k = 0; k < to.components; ++k, out += to.element_bytes) {
        const unsigned c = channels_of(to.channel[k]).first;
        const auto each = [&](auto encode) {
            write_component(from.code[c], count, out, to.group_bytes(), to.element_bytes, swap, encode);
        };
        if (to.kind == ElementKind::real)
            each([table = &floats[first_of(bits.of[c])]](std::uint32_t code) { return table[code]; });
        else
            each([kind = to.kind, wide = to.bits[k], has = bits.of[c]](std::uint32_t code) {
                return encode_element(kind, wide, Component{code, has});
            });
    }
}

void write_units(const CodeRow& from, const CodeBits& bits, std::int32_t count, std::uint32_t* out) {
    const std::uint32_t* const red = &units[first_of(bits.of[0])];
    const std::uint32_t* const green = &units[first_of(bits.of[1])];
    const std::uint32_t* const blue = &units[first_of(bits.of[2])];
    const std::uint32_t* const alpha = &units[first_of(bits.of[3])];
    for (std::int32_t i = 0; i < count; ++i, out += 4) {
        out[0] = red[from.code[0][i]];
        out[1] = green[from.code[1][i]];
        out[2] = blue[from.code[2][i]];
        out[3] = alpha[from.code[3][i]];
    }
}

} // namespace spangle::gl

#endif
