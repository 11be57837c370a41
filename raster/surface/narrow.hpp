// Pixels as small controllers take them: six, four, three bits a component, greys, single bits. What a colour
// becomes, and where it lies. One run-time switch for all of them: firmware that draws on none pays once.
#pragma once

#include <cstdint>

#include <spangle/dither.hpp>
#include <spangle/format.hpp>
#include <spangle/raster/units.hpp>

namespace spangle::raster {

/// Components as 255ths.
struct Rgb8 {
    std::uint32_t r, g, b;
};

/// The stored bits of a pixel: without dithering the top bits (GL 1.3, 2.13.9); with it, steps are taken from
/// the rounded 255ths, as the display does that turns a surface of eight bits a component into the same
/// format: the same picture. Not of rgb666, whose six bits are dithered from the whole colour.
std::uint32_t narrow_word(PixelFormat format, const Rgb8& c, bool dither, std::uint32_t threshold);

constexpr std::uint32_t word_666(std::uint32_t r6, std::uint32_t g6, std::uint32_t b6) {
    return r6 << 12 | g6 << 6 | b6;
}

/// The components of a word: k / max each.
struct NarrowColor {
    std::uint8_t k[3], max[3];
};
NarrowColor narrow_color(PixelFormat format, std::uint32_t word);

/// The bits of a word that the mask (bit 0 red, 1 green, 2 blue) opens; of a grey all, unless it opens none.
std::uint32_t narrow_open(PixelFormat format, std::uint32_t mask);

/// k / max in colour units, for the maxima of these formats. Rounded down by less than a step of dithering
/// can tell: what is stored again is k.
constexpr std::uint32_t narrow_units(std::uint32_t k, std::uint32_t max) {
    const std::uint32_t step = max == 63   ? color_one / 63
                               : max == 15 ? color_one / 15
                               : max == 7  ? color_one / 7
                               : max == 3  ? color_one / 3
                                           : color_one;
    return k == max ? color_one : k * step;
}

/// The word of column x in the stored row that holds GL row y, and a new one there: bytes that other pixels
/// share keep these.
std::uint32_t load_narrow(PixelFormat format, const std::uint8_t* row, std::int32_t x, std::int32_t y);
void store_narrow(PixelFormat format, std::uint8_t* row, std::int32_t x, std::int32_t y, std::uint32_t word);

/// Columns [begin, end) of GL row y: column x gets `word[x & 3]`, a period of the dither matrix.
void fill_narrow(PixelFormat format, std::uint8_t* row, std::int32_t y, std::int32_t begin, std::int32_t end,
                 const std::uint32_t (&word)[4]);

/// Of mono, all rows that the bits of `rows` name at once: bit r of the bytes comes from `column[x & 3]`.
void fill_page(std::uint8_t* page, std::uint8_t rows, std::int32_t begin, std::int32_t end,
               const std::uint8_t (&column)[4]);

} // namespace spangle::raster
