// ILI9341 on a HiFive1, landscape. 16 KB of memory hold only three rows with their depths, so GL draws bands
// of 3 rows.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board sifive_e = hal::board({
    .name = "sifive_e",
    .summary = "HiFive1 (FE310, 16 KB), ILI9341 320x240, SPI, bands of 3 rows",
    .display = {.panel = &hal::panels::ili9341_240x320,
                .orientation = {hal::Rotation::r90},
                .reset_line = false,
                .band = 3},
    .bus = hal::BusKind::spi4,
    .write_hz = 8000000, // 16 MHz / 2
});

} // namespace spangle::boards
