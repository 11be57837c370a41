// What a present hands over: rectangles of the picture as the device wants them, in memory of their own.
#pragma once

#include <vector>

#include <spangle/format.hpp>

#include "hal/usb/gud_protocol.hpp"

namespace spangle::hal {

/// Only the owner of a frame reads and writes it: first the display, which fills it, then the sender. It is
/// never copied.
struct GudFrame {
    struct Band {
        gud::Buffer buffer;
        std::size_t at = 0; ///< where the band's pixels begin in `wire`
    };
    std::vector<Band> bands;
    gud::Bytes wire;
    /// The columns of each row that the bands cover. The device lacks them if bands are lost.
    std::vector<RowSpan> damage;
};

/// The picture as it is drawn: RGB565, little-endian, rows without gaps.
struct GudPicture {
    const std::uint8_t* pixels = nullptr;
    std::int32_t width = 0, height = 0;
};

/// How many bands a whole picture takes. 0: the device's buffer does not hold the least that can be sent.
/// That is the pixels of a byte, or for devices of full updates the picture.
std::uint64_t bands_of(const gud::Descriptor& device, std::uint8_t format, std::int32_t width,
                       std::int32_t height);

/// Fills the frame with bands that cover its damage, each no larger than the device's buffer, where
/// bands_of() is not 0. `plan`: scratch memory, an element for each row.
void cut(GudFrame& frame, const GudPicture& picture, const gud::Descriptor& device, std::uint8_t format,
         std::uint16_t* plan);

} // namespace spangle::hal
