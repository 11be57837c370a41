#include "raster/surface/narrow.hpp"

#include <spangle/raster/limits.hpp>

namespace spangle::raster {
namespace {

template <unsigned Bits>
std::uint32_t narrow_component(std::uint32_t c, bool dither, std::uint32_t threshold) {
    return dither ? dithered_step<Bits, 255>(c, threshold) : c >> (8 - Bits);
}

std::uint8_t low_byte(std::uint32_t v) {
    return static_cast<std::uint8_t>(v);
}

/// The three bytes of a pair of rgb444 pixels, which share the second byte.
std::uint8_t* pair_of(std::uint8_t* row, std::int32_t x) {
    return row + (x >> 1) * 3;
}

/// The shift of a 4-bit pixel in its byte: an even x has the high nibble.
int nibble_shift(std::int32_t x) {
    return (x & 1) != 0 ? 0 : 4;
}

std::uint8_t row_bit(std::int32_t y) {
    return low_byte(0x80u >> (y & 7));
}

void put_bits(std::uint8_t& byte, std::uint32_t mask, std::uint32_t bits) {
    byte = low_byte((byte & ~mask) | (bits & mask));
}

void fill_pairs(std::uint8_t* row, std::int32_t x, std::int32_t end, const std::uint32_t (&word)[4]) {
    for (std::uint8_t* at = pair_of(row, x); x < end; x += 2, at += 3) {
        const std::uint32_t left = word[x & 3], right = word[(x & 3) + 1];
        at[0] = low_byte(left >> 4);
        at[1] = low_byte(left << 4 | right >> 8);
        at[2] = low_byte(right);
    }
}

} // namespace

std::uint32_t narrow_word(PixelFormat format, const Rgb8& c, bool dither, std::uint32_t threshold) {
    switch (drawn(format)) {
    case PixelFormat::rgb444:
        return narrow_component<4>(c.r, dither, threshold) << 8 |
               narrow_component<4>(c.g, dither, threshold) << 4 | narrow_component<4>(c.b, dither, threshold);
    case PixelFormat::rgb332:
        return narrow_component<3>(c.r, dither, threshold) << 5 |
               narrow_component<3>(c.g, dither, threshold) << 2 | narrow_component<2>(c.b, dither, threshold);
    case PixelFormat::grey4:
        return narrow_component<4>(luma(c.r, c.g, c.b), dither, threshold);
    default:
        return narrow_component<1>(luma(c.r, c.g, c.b), dither, threshold);
    }
}

NarrowColor narrow_color(PixelFormat format, std::uint32_t word) {
    const auto part = [word](unsigned shift, std::uint32_t max) {
        return static_cast<std::uint8_t>(word >> shift & max);
    };
    switch (drawn(format)) {
    case PixelFormat::rgb666:
        return {{part(12, 63), part(6, 63), part(0, 63)}, {63, 63, 63}};
    case PixelFormat::rgb444:
        return {{part(8, 15), part(4, 15), part(0, 15)}, {15, 15, 15}};
    case PixelFormat::rgb332:
        return {{part(5, 7), part(2, 7), part(0, 3)}, {7, 7, 3}};
    case PixelFormat::grey4:
        return {{part(0, 15), part(0, 15), part(0, 15)}, {15, 15, 15}};
    default:
        return {{part(0, 1), part(0, 1), part(0, 1)}, {1, 1, 1}};
    }
}

std::uint32_t narrow_open(PixelFormat format, std::uint32_t mask) {
    const FormatInfo f = format_info(format);
    if (f.grey)
        return mask != 0 ? 0xFu >> (4 - f.red_bits) : 0;
    const auto part = [mask](unsigned i, unsigned bits) {
        return (mask >> i & 1) != 0 ? (1u << bits) - 1 : 0u;
    };
    return (part(0, f.red_bits) << f.green_bits | part(1, f.green_bits)) << f.blue_bits |
           part(2, f.blue_bits);
}

std::uint32_t load_narrow(PixelFormat format, const std::uint8_t* row, std::int32_t x, std::int32_t y) {
    switch (drawn(format)) {
    case PixelFormat::rgb666:
        row += 3 * x;
        return word_666(row[0] >> 2, row[1] >> 2, row[2] >> 2);
    case PixelFormat::rgb444: {
        const std::uint8_t* const at = row + (x >> 1) * 3;
        return (x & 1) == 0 ? std::uint32_t{at[0]} << 4 | at[1] >> 4 : (at[1] & 15u) << 8 | at[2];
    }
    case PixelFormat::rgb332:
        return row[x];
    case PixelFormat::grey4:
        return row[x >> 1] >> nibble_shift(x) & 15u;
    default:
        return (row[x] & row_bit(y)) != 0 ? 1 : 0;
    }
}

void store_narrow(PixelFormat format, std::uint8_t* row, std::int32_t x, std::int32_t y, std::uint32_t word) {
    switch (drawn(format)) {
    case PixelFormat::rgb666:
        row += 3 * x;
        row[0] = low_byte(word >> 12 << 2);
        row[1] = low_byte((word >> 6 & 63) << 2);
        row[2] = low_byte((word & 63) << 2);
        break;
    case PixelFormat::rgb444: {
        std::uint8_t* const at = pair_of(row, x);
        if ((x & 1) == 0) {
            at[0] = low_byte(word >> 4);
            put_bits(at[1], 0xF0, word << 4);
        } else {
            put_bits(at[1], 0x0F, word >> 8);
            at[2] = low_byte(word);
        }
        break;
    }
    case PixelFormat::rgb332:
        row[x] = low_byte(word);
        break;
    case PixelFormat::grey4:
        put_bits(row[x >> 1], 15u << nibble_shift(x), word << nibble_shift(x));
        break;
    default:
        put_bits(row[x], row_bit(y), word != 0 ? 0xFFu : 0);
        break;
    }
}

void fill_narrow(PixelFormat format, std::uint8_t* row, std::int32_t y, std::int32_t begin, std::int32_t end,
                 const std::uint32_t (&word)[4]) {
    std::int32_t x = begin;
    switch (drawn(format)) {
    case PixelFormat::rgb332:
        for (; x < end; ++x)
            row[x] = low_byte(word[x & 3]);
        break;
    case PixelFormat::mono: {
        const std::uint8_t bit = row_bit(y);
        std::uint8_t columns[4];
        for (int i = 0; i < 4; ++i)
            columns[i] = word[i] != 0 ? 0xFF : 0;
        fill_page(row, bit, begin, end, columns);
        break;
    }
    case PixelFormat::rgb666:
        for (; x < end; ++x)
            store_narrow(format, row, x, y, word[x & 3]);
        break;
    default: // formats of which two pixels make whole bytes
        if ((x & 1) != 0 && x < end) {
            store_narrow(format, row, x, y, word[x & 3]);
            ++x;
        }
        if (drawn(format) == PixelFormat::rgb444)
            fill_pairs(row, x, end & ~1, word);
        else
            for (std::int32_t i = x; i < (end & ~1); i += 2)
                row[i >> 1] = low_byte(word[i & 3] << 4 | word[(i & 3) + 1]);
        if ((end & 1) != 0 && x < end)
            store_narrow(format, row, end - 1, y, word[(end - 1) & 3]);
        break;
    }
}

void fill_page(std::uint8_t* page, std::uint8_t rows, std::int32_t begin, std::int32_t end,
               const std::uint8_t (&column)[4]) {
    if (rows == 0xFF) {
        for (std::int32_t x = begin; x < end; ++x)
            page[x] = column[x & 3];
        return;
    }
    for (std::int32_t x = begin; x < end; ++x)
        put_bits(page[x], rows, column[x & 3]);
}

} // namespace spangle::raster
