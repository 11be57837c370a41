// ST7789V and ST7789VW: DCS, 240x320 pixels of memory behind a smaller [glass](docs/glossary.md#glass).
#pragma once

#include <spangle/hal/panel.hpp>

namespace spangle::hal::panels {

namespace st7789 {

enum : unsigned {
    RAMCTRL = 0xB0,
    GCTRL = 0xB7, ///< gate voltages
    VCOMS = 0xBB,
    VDVVRHEN = 0xC2,
    VRHS = 0xC3,
    VDVS = 0xC4,
    PWCTRL1 = 0xD0,
    PVGAMCTRL = 0xE0,
    NVGAMCTRL = 0xE1,
};

/// LCMCTRL (C0h), PORCTRL (B2h) and FRCTRL2 (C6h) keep their reset values: variants differ there, and C0h
/// would exchange red and blue behind MADCTL.
inline constexpr auto setup = init_program(
    cmd(RAMCTRL, 0x00,
        0xE0),        // wraps at the window's end, repeats the top of 5 bits as a sixth, high byte first
    cmd(GCTRL, 0x35), //
    cmd(VCOMS, 0x28), //
    cmd(VDVVRHEN, 0x01, 0xFF), //
    cmd(VRHS, 0x10),           //
    cmd(VDVS, 0x20),           //
    cmd(PWCTRL1, 0xA4, 0xA1),  //
    cmd(PVGAMCTRL, 0xD0, 0x00, 0x02, 0x07, 0x0A, 0x28, 0x32, 0x44, 0x42, 0x06, 0x0E, 0x12, 0x14, 0x17),
    cmd(NVGAMCTRL, 0xD0, 0x00, 0x02, 0x07, 0x0A, 0x28, 0x31, 0x54, 0x47, 0x0E, 0x1C, 0x17, 0x1B, 0x1E));

/// One [glass](docs/glossary.md#glass) of the many behind the same controller: IPS, colours shown true by
/// INVON.
consteval PanelDesc on_glass(const char* name, Extent glass, Offset offset) {
    return panel({
        .name = name,
        .controller = Controller::st7789,
        .memory = {240, 320},
        .glass = glass,
        .offset = offset,
        .mount = 0,
        .order = ColorOrder::rgb,
        .inverted = true,
        .serial = {.rgb565 = 0x55, .rgb666 = 0x66, .rgb444 = 0x53},
        .parallel = {.rgb565 = 0x55, .rgb666 = 0x66, .rgb444 = 0x53},
        .setup = setup,
        .timing = {.serial_write_ns = 16, // time of the ST7789VW; the ST7789V needs 66
                   .serial_read_ns = 150,
                   .parallel_write_ns = 66,
                   .practical_serial_mhz = 80,
                   .frame_us = 16856, // (250 + 16 * 15) * 344 / 10 MHz
                   .scan_lines = 344,
                   .porch_lines = 24},
        .identity = {.id = 0x858552, .register_dummy_bits = 1, .pixel_dummy_bits = 16},
        .quirks = {},
    });
}

} // namespace st7789

/// A 240x320 glass, which shows the whole memory.
inline constexpr PanelDesc st7789_240x320 = st7789::on_glass("ST7789 240x320", {240, 320}, {0, 0});
/// A 240x280 glass, which begins at row 20 of the memory.
inline constexpr PanelDesc st7789_240x280 = st7789::on_glass("ST7789 240x280", {240, 280}, {0, 20});
/// A 240x240 glass, which shows the upper part of the memory.
inline constexpr PanelDesc st7789_240x240 = st7789::on_glass("ST7789 240x240", {240, 240}, {0, 0});
/// A 172x320 glass, which begins at column 34 of the memory.
inline constexpr PanelDesc st7789_172x320 = st7789::on_glass("ST7789 172x320", {172, 320}, {34, 0});
/// A 170x320 glass, which begins at column 35 of the memory.
inline constexpr PanelDesc st7789_170x320 = st7789::on_glass("ST7789 170x320", {170, 320}, {35, 0});
/// A 135x240 glass, which begins at column 52 and row 40 of the memory.
inline constexpr PanelDesc st7789_135x240 = st7789::on_glass("ST7789 135x240", {135, 240}, {52, 40});

} // namespace spangle::hal::panels
