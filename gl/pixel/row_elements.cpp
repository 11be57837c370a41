#include "gl/pixel/row_elements.hpp"

#if SPANGLE_ROW_CODES

#include "gl/pixel/component.hpp"

namespace spangle::gl {

namespace {

/// Returns the index of the first code of `bits` bits in a table of all codes of 1 to 8 bits.
constexpr std::uint32_t first_of(unsigned bits) {
    return (1u << bits) - 2;
}
/// Returns the table of of(code) for all codes of 1 to 8 bits, ordered by bits, then by code.
template <class Of> constexpr auto of_all_codes(Of of) {
    std::array<std::uint32_t, first_of(most_code_bits + 1)> all{};
    for (unsigned bits = 1; bits <= most_code_bits; ++bits)
        for (std::uint32_t code = 0; code <= all_ones(bits); ++code)
            all[first_of(bits) + code] = of(Component{code, static_cast<std::uint8_t>(bits)});
    return all;
}
constexpr auto floats = of_all_codes([](Component c) { return encode_element(ElementKind::real, 32, c); });
constexpr auto units = of_all_codes([](Component c) { return color_units_of(c); });

/// One component of each group of a row.
struct Elements {
    const std::uint8_t* from;
    std::uint32_t stride; ///< bytes from group to group
    unsigned bits, shift;
    bool swap;
};

/// Calls take(i, component) for the component of each group i; negative values become 0.
template <ElementKind Kind, unsigned Bytes, class Take>
void take_each(Elements of, std::int32_t count, Take take) {
    const std::uint32_t mask = all_ones(of.bits);
    for (std::int32_t i = 0; i < count; ++i, of.from += of.stride) {
        const std::uint32_t element = load_element(of.from, Bytes, of.swap) >> of.shift & mask;
        const bool negative = Kind == ElementKind::signed_integer && (element >> (of.bits - 1) & 1) != 0;
        take(i, negative ? Component{0, 8} : decode_element(Kind, of.bits, element));
    }
}

/// Calls take() for component i of each group, where components are elements, not fields.
template <class Take>
void take_component(const std::uint8_t* from, const PixelLayout& layout, bool swap, unsigned i,
                    std::int32_t count, Take take) {
    const unsigned offset = layout.packed ? 0 : i * unsigned{layout.element_bytes};
    const Elements of{from + offset, layout.group_bytes(), layout.bits[i], layout.shift[i], swap};
    if (layout.kind == ElementKind::real)
        return take_each<ElementKind::real, 4>(of, count, take);
    const bool has_signs = layout.kind == ElementKind::signed_integer;
    if (layout.element_bytes == 4)
        return has_signs ? take_each<ElementKind::signed_integer, 4>(of, count, take)
                         : take_each<ElementKind::unsigned_integer, 4>(of, count, take);
    if (layout.element_bytes == 2)
        return has_signs ? take_each<ElementKind::signed_integer, 2>(of, count, take)
                         : take_each<ElementKind::unsigned_integer, 2>(of, count, take);
    take_each<ElementKind::signed_integer, 1>(of, count, take);
}

/// The channels [first, end) of red, green, blue and alpha that a component stands for.
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
    for (unsigned i = 0; i < layout.components; ++i) {
        const Channels channels = channels_of(layout.channel[i]);
        for (unsigned c = channels.first; c < channels.end; ++c)
            if (bits.of[c] != 0)
                take_component(from, layout, swap, i, count,
                               [code = out.code[c], to = bits.cut ? 8u : bits.of[c],
                                cut = bits.cut ? 8u - bits.of[c] : 0](std::int32_t n, Component v) {
                                   code[n] = static_cast<std::uint16_t>(code_of(v, to) >> cut);
                               });
    }
}

void read_units(const std::uint8_t* from, const PixelLayout& layout, bool swap, std::int32_t count,
                std::uint32_t* out) {
    for (std::int32_t i = 0; i < count; ++i) { // defaults of components that the groups lack
        out[4 * i] = out[4 * i + 1] = out[4 * i + 2] = 0;
        out[4 * i + 3] = raster::color_one;
    }
    for (unsigned i = 0; i < layout.components; ++i) {
        const Channels channels = channels_of(layout.channel[i]);
        take_component(from, layout, swap, i, count, [=](std::int32_t n, Component v) {
            const std::uint32_t value = color_units_of(v);
            for (unsigned c = channels.first; c < channels.end; ++c)
                out[4 * n + static_cast<std::int32_t>(c)] = value;
        });
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
