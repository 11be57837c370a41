#include "host_sim/board/scanned_memory.hpp"

#include <algorithm>

namespace spangle::sim {
namespace {

/// Reads a pixel of the format, and writes its red, green and blue as bytes.
void widen(PixelFormat format, const std::uint8_t* p, std::uint8_t* rgb) {
    if (format == PixelFormat::rgb888 || format == PixelFormat::rgba8888) {
        for (int c = 0; c < 3; ++c)
            rgb[c] = p[c];
        return;
    }
    const unsigned word = format == PixelFormat::rgb565_be ? p[0] * 256u + p[1] : p[1] * 256u + p[0];
    rgb[0] = static_cast<std::uint8_t>((word >> 11) * 255 / 31);
    rgb[1] = static_cast<std::uint8_t>((word >> 5 & 63) * 255 / 63);
    rgb[2] = static_cast<std::uint8_t>((word & 31) * 255 / 31);
}

} // namespace

/// Sets the address of the picture that the next refresh scans. The first address counts at once, because
/// nothing was scanned before.
void ScannedMemory::show(const std::uint8_t* pixels) {
    next_address_ = pixels;
    if (address_ == nullptr)
        address_ = pixels;
}

void ScannedMemory::palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) {
    std::copy_n(rgb, 3 * count, palette_[first]);
}

void ScannedMemory::advance(std::uint64_t ns) {
    current_time_ += ns;
    for (; scanned_until_ + timing_.line_ns <= current_time_; scanned_until_ += timing_.line_ns)
        if (!stands_still)
            scan_line();
}

void ScannedMemory::scan_line() {
    if (address_ != nullptr && scan_line_ < timing_.lines) {
        const int bytes = format_info(format_).bytes_per_pixel;
        for (int x = 0; x < glass_.width; ++x) {
            const std::uint8_t* const pixel = address_ + scan_line_ * stride_ + x * bytes;
            if (bytes == 1)
                std::copy_n(palette_[*pixel], 3, glass_.at(x, scan_line_));
            else
                widen(format_, pixel, glass_.at(x, scan_line_));
        }
    }
    if (++scan_line_ == timing_.lines && on_refresh && address_ != nullptr)
        on_refresh(glass_);
    if (scan_line_ == timing_.lines + timing_.blanking) {
        scan_line_ = 0;
        address_ = next_address_;
    }
}

} // namespace spangle::sim
