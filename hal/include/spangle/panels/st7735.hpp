// ST7735R and ST7735S: DCS, glasses up to 128x160. The tab on the foil tells where the
// [glass](docs/glossary.md#glass) begins.
#pragma once

#include <spangle/hal/panel.hpp>

namespace spangle::hal::panels {

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

/// The registers that ST7735 modules need after reset.
inline constexpr auto setup =
    init_program(cmd(FRMCTR1, 0x01, 0x2C, 0x2D), // 850 kHz / (42 clocks x (lines + 44 + 45))
                 cmd(FRMCTR2, 0x01, 0x2C, 0x2D), // frame rate in idle mode
                 cmd(FRMCTR3, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D), // frame rate in partial mode
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
        .serial = {.rgb565 = 0x05, .rgb666 = 0x06, .rgb444 = 0x03},
        .parallel = {.rgb565 = 0x05, .rgb666 = 0x06, .rgb444 = 0x03},
        .setup = setup,
        .timing = {.serial_write_ns = 66,
                   .serial_read_ns = 150,
                   .parallel_write_ns = 66,
                   .practical_serial_mhz = 59,
                   .frame_us = 42 * lines * 1000 / 850,
                   .scan_lines = static_cast<std::uint16_t>(lines),
                   .porch_lines = 44 + 45},
        // The ST7735R answers 5C xx xx, and the ST7735S 7C 89 F0. The mask has the bits that both share.
        .identity = {.id = 0x5C0000, .mask = 0xDF0000, .register_dummy_bits = 1, .pixel_dummy_bits = 9},
        .quirks = {},
    });
}

} // namespace st7735

/// A 128x160 module whose glass shows memory from its first pixel on.
inline constexpr PanelDesc st7735_128x160 = st7735::on_glass(
    "ST7735 128x160", {128, 160}, {128, 160}, {0, 0}, ColorOrder::rgb); // modules with a red or black tab
/// A 128x160 module with a green tab on its foil.
inline constexpr PanelDesc st7735_128x160_green =
    st7735::on_glass("ST7735 128x160 green tab", {132, 162}, {128, 160}, {2, 1}, ColorOrder::bgr);
/// A 128x128 module with a green tab on its foil.
inline constexpr PanelDesc st7735_128x128_green =
    st7735::on_glass("ST7735 128x128 green tab", {132, 132}, {128, 128}, {2, 1}, ColorOrder::bgr);
/// A 128x128 module with a red tab on its foil.
inline constexpr PanelDesc st7735_128x128_red =
    st7735::on_glass("ST7735 128x128 red tab", {132, 132}, {128, 128}, {2, 3}, ColorOrder::bgr);
/// An 80x160 module with IPS glass.
inline constexpr PanelDesc st7735_80x160 =
    st7735::on_glass("ST7735 80x160", {128, 160}, {80, 160}, {24, 0}, ColorOrder::bgr, true);
/// An 80x160 module whose glass begins at column 26 of the memory.
inline constexpr PanelDesc st7735_80x160_26 =
    st7735::on_glass("ST7735 80x160 offset 26", {132, 162}, {80, 160}, {26, 1}, ColorOrder::bgr, true);

} // namespace spangle::hal::panels
