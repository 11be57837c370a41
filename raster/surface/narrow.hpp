// Pixels of small display controllers: six, four or three bits per component, greys, and single bits. These
// functions give the stored bits of a colour and their place. One run-time switch covers all of these
// formats, so firmware that uses none of them pays for the switch only once.
#pragma once

#include <cstdint>

#include <spangle/dither.hpp>
#include <spangle/format.hpp>
#include <spangle/raster/units.hpp>

namespace spangle::raster {

/// Components in 255ths.
struct Rgb8 {
    std::uint32_t r, g, b;
};

/// The stored bits of a pixel. Without dithering they are the top bits (GL 1.3, 2.13.9). With dithering,
/// steps are made from the rounded 255ths. A display that converts a surface with eight bits per component to
/// the same format shows the same picture. The function does not serve rgb666, whose six bits are dithered
/// from the whole colour.
std::uint32_t narrow_word(PixelFormat format, const Rgb8& c, bool dither, std::uint32_t threshold);

constexpr std::uint32_t word_666(std::uint32_t r6, std::uint32_t g6, std::uint32_t b6) {
    return r6 << 12 | g6 << 6 | b6;
}

/// The components of a word: k / max each.
struct NarrowColor {
    std::uint8_t k[3], max[3];
};
NarrowColor narrow_color(PixelFormat format, std::uint32_t word);

/// The bits of a word that the mask opens (bit 0 red, bit 1 green, bit 2 blue). Any bit of the mask opens all
/// bits of a grey.
std::uint32_t narrow_open(PixelFormat format, std::uint32_t mask);

/// The component k / max in colour units, where `max` is that of a narrow format. It is rounded down by less
/// than dithering can tell, so that k is stored again.
constexpr std::uint32_t narrow_units(std::uint32_t k, std::uint32_t max) {
    const std::uint32_t step = max == 63   ? color_one / 63
                               : max == 15 ? color_one / 15
                               : max == 7  ? color_one / 7
                               : max == 3  ? color_one / 3
                                           : color_one;
    return k == max ? color_one : k * step;
}

/// Reads the word of column x in the stored row that holds GL row y; store_narrow() writes it. Other pixels
/// in the same bytes do not change.
std::uint32_t load_narrow(PixelFormat format, const std::uint8_t* row, std::int32_t x, std::int32_t y);
void store_narrow(PixelFormat format, std::uint8_t* row, std::int32_t x, std::int32_t y, std::uint32_t word);

/// Fills columns [begin, end) of GL row y: column x gets `word[x & 3]`, as the dither matrix has four
/// columns.
void fill_narrow(PixelFormat format, std::uint8_t* row, std::int32_t y, std::int32_t begin, std::int32_t end,
                 const std::uint32_t (&word)[4]);

/// Fills columns of a page of mono, in all rows whose bits are set in `rows`: bit r comes from bit r of
/// `column[x & 3]`.
void fill_page(std::uint8_t* page, std::uint8_t rows, std::int32_t begin, std::int32_t end,
               const std::uint8_t (&column)[4]);

} // namespace spangle::raster
