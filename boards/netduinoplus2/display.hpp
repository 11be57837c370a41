// ILI9341 on a Netduino Plus 2, landscape. 128 KB of memory hold no frame of 150 KB, so GL draws bands of 16
// rows.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board netduinoplus2 = hal::board({
    .name = "netduinoplus2",
    .summary = "Netduino Plus 2 (STM32F405, 128 KB), ILI9341 320x240, SPI, bands of 16 rows",
    .display = {.panel = &hal::panels::ili9341_240x320,
                .orientation = {hal::Rotation::r90},
                .reset_line = false,
                .band = 16},
    .bus = hal::BusKind::spi4,
    .write_hz = 21000000, // 84 MHz / 4
});

} // namespace spangle::boards
