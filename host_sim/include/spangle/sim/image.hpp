// Pictures on the host, with functions for PNG files, comparison, hashes and ASCII art.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace spangle::sim {

/// A picture of R, G, B, A bytes, top row first.
struct Image {
    /// The size in pixels.
    int width = 0, height = 0;
    /// Four bytes a pixel, width * height * 4 in all.
    std::vector<std::uint8_t> rgba;

    /// An empty picture.
    Image() = default;
    /// A white, opaque picture of `w` x `h` pixels.
    Image(int w, int h)
        : width(w), height(h), rgba(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4, 255) {}
    /// The four bytes of a pixel inside the picture, (0, 0) at the top left.
    std::uint8_t* at(int x, int y) {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x));
    }
    /// The four bytes of the pixel, which cannot be changed.
    const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
    friend bool operator==(const Image&, const Image&) = default;
};

/// Whether the centre of a pixel lies on the disc, or ellipse, that fills a picture. On round
/// [glass](docs/glossary.md#glass) only these pixels are seen.
constexpr bool on_disc(int x, int y, int width, int height) {
    const std::int64_t w = width, h = height, u = (2 * x + 1 - w) * h, v = (2 * y + 1 - h) * w;
    return u * u + v * v <= w * h * w * h;
}

/// The largest picture that is read from a file, in pixels: each side, and both multiplied. A larger one is
/// refused before it is decoded.
inline constexpr int longest_side = 16384;
/// The most pixels of a picture that is read.
inline constexpr std::uint64_t most_pixels = std::uint64_t{1} << 26;

/// Writes a picture as PNG. Returns what went wrong, or an empty string. After a failure a regular file is as
/// it was before. Devices and pipes are written to as they are, and "-" is standard output.
std::string write_png(const Image& image, const std::string& path);
/// Makes the bytes of a PNG file. Returns what went wrong, or an empty string.
std::string encode_png(const Image& image, std::string& out);
/// Reads a PNG file with at most longest_side pixels a side and most_pixels in all. Returns what went wrong,
/// or an empty string.
std::string read_png(const std::string& path, Image& out);
/// Decodes the bytes of a PNG file, as read_png() does.
std::string decode_png(std::string_view bytes, Image& out);

/// A hash of size and pixels, in sixteen hexadecimal digits. It is the same on every machine.
std::string hash(const Image& image);

/// The differences of two pictures of one size, in RGB565 steps, over the pixels that `mask` marks (null: all
/// pixels).
struct Difference {
    /// Pixels that were compared, and how many of these are identical.
    std::uint64_t pixels = 0, identical = 0;
    int max_lsb = 0;       ///< largest difference of a channel, in steps of the channel
    double psnr_db = 99.0; ///< dB, of the 565 values scaled to 8 bits; 99 when identical
    /// Identical pixels in percent; 100 where nothing was compared.
    double identical_percent() const {
        return pixels == 0 ? 100.0 : 100.0 * static_cast<double>(identical) / static_cast<double>(pixels);
    }
};
/// Compares two pictures of the same size. `mask`: one element a pixel, true: compared; null: all are.
Difference compare_565(const Image& a, const Image& b, const std::vector<bool>* mask = nullptr);

/// Draws grey where pixels are equal, and red where they are not, brighter with the difference. Sizes may
/// differ: pixels of only one picture are magenta.
Image difference_picture(const Image& a, const Image& b);

/// The part of the picture in the rectangle, cut off at the borders of the picture.
Image crop(const Image& image, int x, int y, int width, int height);

/// The colours of the characters in an ASCII picture, as 0xRRGGBB. A panel keeps fewer bits, so colours are
/// equal when their RGB565 bits are. '?' is reserved for any colour that the legend does not name.
using Legend = std::map<char, std::uint32_t>;

/// A legend with ' ' for black, '#' for white, and r g b y c m for the pure colours.
const Legend& pure_colors();

/// The picture as text, a character for each pixel and a line for each row.
std::string to_ascii(const Image& image, const Legend& legend = pure_colors());

} // namespace spangle::sim
