#include "host_sim/bringup/card.hpp"

#include <algorithm>
#include <string_view>

#include "raster/surface/narrow.hpp"

namespace spangle::bringup {
namespace {

struct Color {
    std::uint8_t r, g, b;
};
constexpr Color black = {0, 0, 0}, white = {255, 255, 255}, red = {255, 0, 0}, green = {0, 255, 0},
                blue = {0, 0, 255};

void fill(sim::Image& image, int x, int y, int w, int h, Color c) {
    for (int row = std::max(y, 0); row < std::min(y + h, image.height); ++row)
        for (int column = std::max(x, 0); column < std::min(x + w, image.width); ++column) {
            std::uint8_t* const p = image.at(column, row);
            p[0] = c.r, p[1] = c.g, p[2] = c.b;
        }
}

/// Draws a letter of five columns and seven rows.
void draw_letter(sim::Image& image, int x, int y, int scale, std::string_view shape) {
    for (int i = 0; i < 35; ++i)
        if (shape[static_cast<std::size_t>(i)] == '#')
            fill(image, x + i % 5 * scale, y + i / 5 * scale, scale, scale, white);
}

constexpr std::string_view letters[] = {
    "####.#...##...#####.#.#..#..#.#...#", ".###.#...##....#.####...##...#.####",
    "####.#...##...#####.#...##...#####.", "######....#....####.#....#....#...."};

/// Stores a colour in the format of the frame's memory.
void put(std::uint8_t* at, PixelFormat format, const std::uint8_t* rgb, bool swapped) {
    const unsigned r = rgb[0], g = rgb[1], b = rgb[2];
    if (is_indexed(format)) { // the index in the initial palette
        *at = static_cast<std::uint8_t>((r >> 5) << 5 | (g >> 5) << 2 | b >> 6);
        return;
    }
    if (format_info(format).bytes_per_pixel != 2) {
        std::copy_n(rgb, 3, at);
        if (format == PixelFormat::rgba8888)
            at[3] = 255;
        return;
    }
    const unsigned word = (r >> 3) << 11 | (g >> 2) << 5 | b >> 3;
    const bool high_first = (format == PixelFormat::rgb565_be) != swapped;
    at[high_first ? 0 : 1] = static_cast<std::uint8_t>(word >> 8);
    at[high_first ? 1 : 0] = static_cast<std::uint8_t>(word);
}

/// Stores the picture in a format whose pixels share bytes; such formats have no bytes to swap.
void put_narrow(const hal::Frame& frame, PixelFormat format, const sim::Image& picture) {
    const int lowest = stored_rows(format, picture.height) - 1;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int gl_y = picture.height - 1 - y, stored = gl_y / format_info(format).rows;
            const std::uint8_t* const c = picture.at(x, y);
            const std::uint32_t word = format == PixelFormat::rgb666
                                           ? raster::word_666(c[0] >> 2u, c[1] >> 2u, c[2] >> 2u)
                                           : raster::narrow_word(format, {c[0], c[1], c[2]}, false, 0);
            raster::store_narrow(format, frame.pixels + std::ptrdiff_t{lowest - stored} * frame.stride, x,
                                 gl_y, word);
        }
}

/// Draws a white frame of the outermost pixels that are seen.
void frame(sim::Image& image, bool round) {
    const auto is_seen = [&](int x, int y) {
        const bool inside = x >= 0 && y >= 0 && x < image.width && y < image.height;
        return inside && (!round || sim::on_disc(x, y, image.width, image.height));
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool within =
                is_seen(x - 1, y) && is_seen(x + 1, y) && is_seen(x, y - 1) && is_seen(x, y + 1);
            if (is_seen(x, y) && !within)
                fill(image, x, y, 1, 1, white);
        }
}

} // namespace

sim::Image card(int width, int height, bool round) {
    sim::Image image(width, height);
    fill(image, 0, 0, width, height, black);
    frame(image, round);
    // Seven tenths of a disc's width lie within the square inside it.
    const int w = round ? width * 7 / 10 : width, h = round ? height * 7 / 10 : height;
    const int left = (width - w) / 2, top = (height - h) / 2;
    const int row = h / 8, scale = std::max(1, std::min(w / 16, h / 32));
    // The F stands in the upper half, left of the middle, so that it looks different in every turn and mirror
    // image.
    draw_letter(image, left + w / 8, top + row, std::max(1, std::min(w / 12, h / 20)), letters[3]);
    const Color colors[] = {red, green, blue};
    for (int i = 0; i < 3; ++i) {
        const int y = top + h / 2 + i * row;
        draw_letter(image, left + w / 8, y, std::max(1, scale / 2), letters[i]);
        fill(image, left + w / 2, y, w / 4 - i * w / 16, row * 3 / 4, colors[i]);
    }
    return image;
}

hal::Result<void> show(hal::Display& display, const sim::Image& picture, bool swapped) {
    const hal::Result<hal::Frame> frame = display.acquire();
    if (!frame)
        return frame.error();
    const hal::DisplayInfo info = display.info();
    if (picture.width != info.width || picture.height != info.height)
        return hal::Error{hal::Fault::bad_argument, "card: the picture has another size than the display"};
    const std::size_t bytes = format_info(info.format).bytes_per_pixel;
    for (int y = 0; y < info.height; ++y) {
        std::uint8_t* const row = frame.value().pixels + std::ptrdiff_t{y} * frame.value().stride;
        for (int x = 0; x < info.width && !is_narrow(info.format); ++x)
            put(row + static_cast<std::size_t>(x) * bytes, info.format, picture.at(x, y), swapped);
        frame.value().extents->rows[y] = {0, static_cast<std::int16_t>(info.width)};
    }
    if (is_narrow(info.format))
        put_narrow(frame.value(), info.format, picture);
    return display.present();
}

} // namespace spangle::bringup
