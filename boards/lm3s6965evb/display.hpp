// The OLED of the LM3S6965 evaluation board. GL draws in the panel's own sixteen greys, so a frame has 4 KB.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board lm3s6965evb = hal::board({
    .name = "lm3s6965evb",
    .summary = "TI/Luminary LM3S6965 evaluation board, SSD0323 128x64, 16 greys, SPI",
    .display = {.panel = &hal::panels::ssd0323_128x64,
                .format = PixelFormat::grey4,
                .reset_line = false}, // the panel is reset with the processor
    .bus = hal::BusKind::spi4,
    .write_hz = 3125000, // 12.5 MHz / 4
});

} // namespace spangle::boards
