// Pictures on the host: PNG files, comparison, hashes, ASCII art.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace spangle::sim {

/// RGBA, 8 bits each, top row first.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    Image() = default;
    Image(int w, int h)
        : width(w), height(h), rgba(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4, 255) {}
    std::uint8_t* at(int x, int y) {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x));
    }
    const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
    friend bool operator==(const Image&, const Image&) = default;
};

/// Whether a pixel's centre lies on the disc, or ellipse, that fills a picture: what is seen of round glass.
constexpr bool on_disc(int x, int y, int width, int height) {
    const std::int64_t w = width, h = height, u = (2 * x + 1 - w) * h, v = (2 * y + 1 - h) * w;
    return u * u + v * v <= w * h * w * h;
}

/// What is read of other people's pictures; a larger one is refused before anything of it is decoded.
inline constexpr int longest_side = 16384;
inline constexpr std::uint64_t most_pixels = std::uint64_t{1} << 26;

/// Empty on success, else what went wrong. A regular file is whole or as it was before; devices and pipes are
/// written to as they are, and "-" is standard output.
std::string write_png(const Image& image, const std::string& path);
/// The bytes of that file.
std::string encode_png(const Image& image, std::string& out);
/// At most longest_side pixels a side and most_pixels together.
std::string read_png(const std::string& path, Image& out);
/// The picture that such a file's bytes hold.
std::string decode_png(std::string_view bytes, Image& out);

/// Sixteen hexadecimal digits that name the picture: the same on every machine.
std::string hash(const Image& image);

/// What two pictures of one size have in common, counted in RGB565 steps over the pixels `mask` marks (null:
/// all).
struct Difference {
    std::uint64_t pixels = 0, identical = 0;
    int max_lsb = 0;       ///< largest difference of a channel, in its own steps
    double psnr_db = 99.0; ///< of the 565 values scaled to 8 bits; 99 when identical
    double identical_percent() const {
        return pixels == 0 ? 100.0 : 100.0 * static_cast<double>(identical) / static_cast<double>(pixels);
    }
};
Difference compare_565(const Image& a, const Image& b, const std::vector<bool>* mask = nullptr);

/// Grey where equal, red where not, brighter with the difference. Sizes may differ: what only one has is
/// magenta.
Image difference_picture(const Image& a, const Image& b);

/// The part of the picture in the rectangle; what lies outside of the picture is left out.
Image crop(const Image& image, int x, int y, int width, int height);

/// What a character of an ASCII picture stands for: 0xRRGGBB. A panel keeps fewer bits, so colours are equal
/// when their RGB565 bits are. '?' is kept: any colour that the legend does not name.
using Legend = std::map<char, std::uint32_t>;

/// ' ' black, '#' white, and r g b y c m for the pure colours.
const Legend& pure_colors();

/// One character a pixel, a line a row.
std::string to_ascii(const Image& image, const Legend& legend = pure_colors());

} // namespace spangle::sim
