// Pixels of surfaces as colours of eight bits, and back.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::dropin {

/// Formats whose pixels are whole bytes that hold colours: what a picture can be copied to.
constexpr bool is_copied(PixelFormat format) {
    return format_info(format).bytes_per_pixel != 0 && format_info(format).index_bits == 0;
}

/// What is in a frame of such a format, opaque.
sim::Image picture_of(const hal::Frame& frame, const hal::DisplayInfo& info);

/// One pixel of such a format, of red, green and blue: the upper bits (GL 1.3, 2.13.9).
void put_pixel(PixelFormat format, const std::uint8_t* rgb, std::uint8_t* to);

} // namespace spangle::dropin
