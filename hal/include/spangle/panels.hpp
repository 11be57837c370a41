// The panels Spangle knows. Registers and times from the ILI9341, ST7789V(W) and ST7735R/S datasheets.
#pragma once

#include <spangle/hal/panel.hpp>

namespace spangle::hal::panels {

// --- ILI9341 ---

namespace ili9341 {

enum : unsigned {
    FRMCTR1 = 0xB1, ///< frame rate: DIVA, RTNA
    DISCTRL = 0xB6, ///< display function: scan direction, lines
    PWCTR1 = 0xC0,
    PWCTR2 = 0xC1,
    VMCTR1 = 0xC5,
    VMCTR2 = 0xC7,
    PWCTRA = 0xCB,
    PWCTRB = 0xCF,
    GMCTRP1 = 0xE0,
    GMCTRN1 = 0xE1,
    DTCA = 0xE8, ///< driver timing
    DTCB = 0xEA,
    PONSEQ = 0xED,
    EN3GAM = 0xF2,
    PUMPCTR = 0xF7,
};

inline constexpr auto setup = init_program(
    cmd(PWCTRB, 0x00, 0xC1, 0x30),             //
    cmd(PONSEQ, 0x64, 0x03, 0x12, 0x81),       //
    cmd(DTCA, 0x85, 0x00, 0x78),               //
    cmd(PWCTRA, 0x39, 0x2C, 0x00, 0x34, 0x02), //
    cmd(PUMPCTR, 0x20),                        // DDVDH = 2 x VCI
    cmd(DTCB, 0x00, 0x00),                     //
    cmd(PWCTR1, 0x23),                         // GVDD 4.60 V
    cmd(PWCTR2, 0x10),                         //
    cmd(VMCTR1, 0x3E, 0x28),                   // VCOMH 4.250 V, VCOML -1.500 V
    cmd(VMCTR2, 0x86),                         //
    cmd(FRMCTR1, 0x00, 0x1B),                  // 615 kHz / (27 clocks x 324 lines) = 70.3 Hz
    cmd(DISCTRL, 0x08, 0x82, 0x27),            // 320 lines, normally white
    cmd(EN3GAM, 0x00),                         //
    cmd(dcs::GAMSET, 0x01),                    //
    cmd(GMCTRP1, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00),
    cmd(GMCTRN1, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F));

} // namespace ili9341

/// Modules show memory mirrored left to right: upright is MADCTL 48h.
inline constexpr PanelDesc ili9341_240x320 = panel({
    .name = "ILI9341 240x320",
    .controller = Controller::ili9341,
    .memory = {240, 320},
    .glass = {240, 320},
    .offset = {0, 0},
    .mount = dcs::MX,
    .order = ColorOrder::bgr,
    .inverted = false,
    .serial = {.rgb565 = 0x55, .rgb666 = 0x66},
    .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
    .setup = ili9341::setup,
    .timing = {.serial_write_ns = 100,
               .serial_read_ns = 150,
               .parallel_write_ns = 66,
               .practical_serial_mhz = 80,
               .frame_us = 14224, // 27 * 324 / 615 kHz
               .scan_lines = 324,
               .porch_lines = 4},
    .identity = {.id = 0x000000, .register_dummy_bits = 1, .pixel_dummy_bits = 8},
    .quirks = {},
});

// --- ST7789V, ST7789VW ---

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
        0xE0),        // wrap at the window's end, 5 -> 6 bits by repeating the top bit, high byte first
    cmd(GCTRL, 0x35), //
    cmd(VCOMS, 0x28), //
    cmd(VDVVRHEN, 0x01, 0xFF), //
    cmd(VRHS, 0x10),           //
    cmd(VDVS, 0x20),           //
    cmd(PWCTRL1, 0xA4, 0xA1),  //
    cmd(PVGAMCTRL, 0xD0, 0x00, 0x02, 0x07, 0x0A, 0x28, 0x32, 0x44, 0x42, 0x06, 0x0E, 0x12, 0x14, 0x17),
    cmd(NVGAMCTRL, 0xD0, 0x00, 0x02, 0x07, 0x0A, 0x28, 0x31, 0x54, 0x47, 0x0E, 0x1C, 0x17, 0x1B, 0x1E));

/// One glass of the many behind the same controller: IPS, colours shown true by INVON.
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
        .serial = {.rgb565 = 0x55, .rgb666 = 0x66},
        .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
        .setup = setup,
        .timing = {.serial_write_ns = 16, // VW; the V is rated 66
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

inline constexpr PanelDesc st7789_240x320 = st7789::on_glass("ST7789 240x320", {240, 320}, {0, 0});
inline constexpr PanelDesc st7789_240x280 = st7789::on_glass("ST7789 240x280", {240, 280}, {0, 20});
inline constexpr PanelDesc st7789_240x240 = st7789::on_glass("ST7789 240x240", {240, 240}, {0, 0});
inline constexpr PanelDesc st7789_172x320 = st7789::on_glass("ST7789 172x320", {172, 320}, {34, 0});
inline constexpr PanelDesc st7789_170x320 = st7789::on_glass("ST7789 170x320", {170, 320}, {35, 0});
inline constexpr PanelDesc st7789_135x240 = st7789::on_glass("ST7789 135x240", {135, 240}, {52, 40});

// --- ST7735R, ST7735S ---

namespace st7735 {

enum : unsigned {
    FRMCTR1 = 0xB1,
    FRMCTR2 = 0xB2,
    FRMCTR3 = 0xB3,
    INVCTR = 0xB4,
    PWCTR1 = 0xC0,
    PWCTR2 = 0xC1,
    PWCTR3 = 0xC2,
    PWCTR4 = 0xC3,
    PWCTR5 = 0xC4,
    VMCTR1 = 0xC5,
    GMCTRP1 = 0xE0,
    GMCTRN1 = 0xE1,
};

inline constexpr auto setup =
    init_program(cmd(FRMCTR1, 0x01, 0x2C, 0x2D), // 850 kHz / (42 clocks x (lines + 44 + 45))
                 cmd(FRMCTR2, 0x01, 0x2C, 0x2D), // idle
                 cmd(FRMCTR3, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D), // partial
                 cmd(INVCTR, 0x07),                                //
                 cmd(PWCTR1, 0xA2, 0x02, 0x84),                    //
                 cmd(PWCTR2, 0xC5),                                //
                 cmd(PWCTR3, 0x0A, 0x00),                          //
                 cmd(PWCTR4, 0x8A, 0x2A),                          //
                 cmd(PWCTR5, 0x8A, 0xEE),                          //
                 cmd(VMCTR1, 0x0E),                                //
                 cmd(GMCTRP1, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00,
                     0x01, 0x03, 0x10),
                 cmd(GMCTRN1, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00,
                     0x00, 0x02, 0x10));

/// The memory depends on the GM pins: 132x162, 128x160 or 132x132. "Tabs" differ in offset and colour order.
consteval PanelDesc on_glass(const char* name, Extent memory, Extent glass, Offset offset, ColorOrder order,
                             bool inverted = false) {
    const unsigned lines = static_cast<unsigned>(memory.height) + 44 + 45;
    return panel({
        .name = name,
        .controller = Controller::st7735,
        .memory = memory,
        .glass = glass,
        .offset = offset,
        .mount = dcs::MX | dcs::MY,
        .order = order,
        .inverted = inverted,
        .serial = {.rgb565 = 0x05, .rgb666 = 0x06},
        .parallel = {.rgb565 = 0x05, .rgb666 = 0x06},
        .setup = setup,
        .timing = {.serial_write_ns = 66,
                   .serial_read_ns = 150,
                   .parallel_write_ns = 66,
                   .practical_serial_mhz = 59,
                   .frame_us = 42 * lines * 1000 / 850,
                   .scan_lines = static_cast<std::uint16_t>(lines),
                   .porch_lines = 44 + 45},
        // R answers 5C xx xx, S 7C 89 F0: the bits both share.
        .identity = {.id = 0x5C0000, .mask = 0xDF0000, .register_dummy_bits = 1, .pixel_dummy_bits = 9},
        .quirks = {},
    });
}

} // namespace st7735

inline constexpr PanelDesc st7735_128x160 =
    st7735::on_glass("ST7735 128x160", {128, 160}, {128, 160}, {0, 0}, ColorOrder::rgb);
inline constexpr PanelDesc st7735_128x160_green =
    st7735::on_glass("ST7735 128x160 green tab", {132, 162}, {128, 160}, {2, 1}, ColorOrder::bgr);
inline constexpr PanelDesc st7735_128x128_green =
    st7735::on_glass("ST7735 128x128 green tab", {132, 132}, {128, 128}, {2, 1}, ColorOrder::bgr);
inline constexpr PanelDesc st7735_80x160 =
    st7735::on_glass("ST7735 80x160", {128, 160}, {80, 160}, {24, 0}, ColorOrder::bgr, true);
inline constexpr PanelDesc st7735_80x160_26 =
    st7735::on_glass("ST7735 80x160 offset 26", {132, 162}, {80, 160}, {26, 1}, ColorOrder::bgr, true);

} // namespace spangle::hal::panels
