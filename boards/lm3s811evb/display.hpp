// The SSD0303 of the LM3S811 evaluation board: 96x16 of one bit, drawn in bands of one page.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board lm3s811evb = hal::board({
    .name = "lm3s811evb",
    .summary = "Stellaris LM3S811 evaluation board (8 KB), SSD0303 96x16, I2C, bands of 8 rows",
    .display =
        {.panel = &hal::panels::ssd0303_96x16, .format = PixelFormat::mono, .reset_line = false, .band = 8},
    .bus = hal::BusKind::i2c,
    .write_hz = 400000,
});

} // namespace spangle::boards
