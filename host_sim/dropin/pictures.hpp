// Converts pixels of surfaces to colours of eight bits a component, and back.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::dropin {

/// Whether a picture can be copied to the format: its pixels are whole bytes that hold colours, not indices.
constexpr bool is_copied(PixelFormat format) {
    return format_info(format).bytes_per_pixel != 0 && format_info(format).index_bits == 0;
}

/// The opaque picture in a frame of a format that is_copied() accepts.
sim::Image picture_of(const hal::Frame& frame, const hal::DisplayInfo& info);

/// Stores red, green and blue as one pixel of a format that is_copied() accepts. Components lose their lower
/// bits (GL 1.3, 2.13.9).
void put_pixel(PixelFormat format, const std::uint8_t* rgb, std::uint8_t* to);

} // namespace spangle::dropin
