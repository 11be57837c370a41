#include "host_sim/dropin/pictures.hpp"

namespace spangle::dropin {

namespace {

/// Widens a component of `most` + 1 = 2^m values to eight bits: value / (2^m - 1) of 255, rounded.
std::uint8_t widened(unsigned value, unsigned most) {
    return static_cast<std::uint8_t>((value * 255 + most / 2) / most);
}

void read_565(unsigned pixel, std::uint8_t* to) {
    to[0] = widened(pixel >> 11, 31);
    to[1] = widened(pixel >> 5 & 63, 63);
    to[2] = widened(pixel & 31, 31);
}

void read_pixel(PixelFormat format, const std::uint8_t* from, std::uint8_t* to) {
    switch (format) {
    case PixelFormat::rgb565_be:
        return read_565(static_cast<unsigned>(from[0] << 8 | from[1]), to);
    case PixelFormat::rgb565_le:
        return read_565(static_cast<unsigned>(from[1] << 8 | from[0]), to);
    case PixelFormat::rgb332:
        to[0] = widened(from[0] >> 5, 7);
        to[1] = widened(from[0] >> 2 & 7, 7);
        to[2] = widened(from[0] & 3, 3);
        return;
    default:
        for (int c = 0; c < 3; ++c)
            to[c] = format == PixelFormat::rgb666 ? widened(from[c] >> 2, 63) : from[c];
    }
}

} // namespace

sim::Image picture_of(const hal::Frame& frame, const hal::DisplayInfo& info) {
    sim::Image out(info.width, info.height);
    const std::ptrdiff_t step = format_info(info.format).bytes_per_pixel;
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            read_pixel(info.format, frame.pixels + std::ptrdiff_t{y} * frame.stride + x * step, out.at(x, y));
    return out;
}

void put_pixel(PixelFormat format, const std::uint8_t* rgb, std::uint8_t* to) {
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    const std::uint8_t high = byte((rgb[0] & 0xF8) | rgb[1] >> 5),
                       low = byte((rgb[1] << 3 & 0xE0) | rgb[2] >> 3);
    switch (format) {
    case PixelFormat::rgb565_be:
        to[0] = high;
        to[1] = low;
        return;
    case PixelFormat::rgb565_le:
        to[0] = low;
        to[1] = high;
        return;
    case PixelFormat::rgb332:
        to[0] = byte((rgb[0] & 0xE0) | (rgb[1] >> 3 & 0x1C) | rgb[2] >> 6);
        return;
    default:
        for (int c = 0; c < 3; ++c)
            to[c] = format == PixelFormat::rgb666 ? byte(rgb[c] & 0xFC) : rgb[c];
        if (format == PixelFormat::rgba8888)
            to[3] = 255;
    }
}

} // namespace spangle::dropin
