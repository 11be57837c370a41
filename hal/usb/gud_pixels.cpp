#include "hal/usb/gud_pixels.hpp"

#include <cstring>
#include <initializer_list>

#include <spangle/dither.hpp>

namespace spangle::hal::gud {
namespace {

/// A pixel of RGB565: k / 31, k / 63 and k / 31, and these rounded to eight bits.
struct Pixel {
    std::uint32_t r, g, b;
    explicit Pixel(const std::uint8_t* pixel) {
        const unsigned word = pixel[0] | pixel[1] * 256u;
        r = word >> 11, g = word >> 5 & 63, b = word & 31;
    }
    std::uint32_t red() const { return (r * 255 + 15) / 31; }
    std::uint32_t green() const { return (g * 255 + 31) / 63; }
    std::uint32_t blue() const { return (b * 255 + 15) / 31; }
    std::uint32_t grey() const { return luma(red(), green(), blue()); }
};

std::uint32_t convert(std::uint8_t format, const Pixel& c, std::uint32_t threshold) {
    switch (format) {
    case R1:
        return dithered_step<1, 255>(c.grey(), threshold);
    case R8:
        return c.grey();
    case XRGB1111:
        return dithered_step<1, 31>(c.r, threshold) << 2 | dithered_step<1, 63>(c.g, threshold) << 1 |
               dithered_step<1, 31>(c.b, threshold);
    case RGB332:
        return dithered_step<3, 31>(c.r, threshold) << 5 | dithered_step<3, 63>(c.g, threshold) << 2 |
               dithered_step<2, 31>(c.b, threshold);
    default:
        return 0xFF000000u | c.red() << 16 | c.green() << 8 | c.blue();
    }
}

} // namespace

std::uint8_t best_format(const std::uint8_t* offered, std::size_t count) {
    for (const std::uint8_t wanted : {RGB565, RGB888, XRGB8888, ARGB8888, RGB332, R8, XRGB1111, R1})
        if (count != 0 && std::memchr(offered, wanted, count) != nullptr)
            return wanted;
    return 0;
}

std::uint32_t bits_per_pixel(std::uint8_t format) {
    switch (format) {
    case R1:
        return 1;
    case XRGB1111:
        return 4;
    case R8:
    case RGB332:
        return 8;
    case RGB565:
        return 16;
    case RGB888:
        return 24;
    default:
        return 32;
    }
}

std::uint32_t pixels_per_byte(std::uint8_t format) {
    const std::uint32_t bits = bits_per_pixel(format);
    return bits < 8 ? 8 / bits : 1;
}

std::size_t row_bytes(std::uint8_t format, std::uint32_t width) {
    return (std::size_t{width} * bits_per_pixel(format) + 7) / 8;
}

void convert_row(std::uint8_t format, const std::uint8_t* rgb565, std::int32_t first, std::int32_t y,
                 std::uint32_t width, std::uint8_t* to) {
    if (format == RGB565) {
        std::memcpy(to, rgb565, std::size_t{width} * 2);
        return;
    }
    const std::uint32_t bits = bits_per_pixel(format);
    if (bits < 8)
        std::memset(to, 0, row_bytes(format, width));
    const std::uint32_t thresholds = dither_row(y);
    for (std::uint32_t x = 0; x < width; ++x) {
        const std::uint32_t word =
            convert(format, Pixel(rgb565 + std::size_t{x} * 2),
                    dither_threshold(thresholds, first + static_cast<std::int32_t>(x)));
        std::uint8_t* const at = to + std::size_t{x} * bits / 8;
        if (bits < 8)
            *at = static_cast<std::uint8_t>(*at | word << (8 - bits - x * bits % 8));
        for (std::uint32_t byte = 0; byte < bits / 8; ++byte)
            at[byte] = static_cast<std::uint8_t>(word >> 8 * byte);
    }
}

} // namespace spangle::hal::gud
