// The panels Spangle knows. Registers and times from the controllers' datasheets; where a datasheet leaves
// the set-up to the module's maker, the values that modules are known to come up with.
#pragma once

#include <spangle/hal/panel.hpp>
#include <spangle/panels/hx8347.hpp>
#include <spangle/panels/oled_mono.hpp>
#include <spangle/panels/oled_windowed.hpp>

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

/// What ILI9341 modules come up with.
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

/// 240x320, the whole memory.
inline constexpr PanelDesc st7789_240x320 = st7789::on_glass("ST7789 240x320", {240, 320}, {0, 0});
/// 240x280: the glass begins at row 20.
inline constexpr PanelDesc st7789_240x280 = st7789::on_glass("ST7789 240x280", {240, 280}, {0, 20});
/// 240x240: the upper part of the memory.
inline constexpr PanelDesc st7789_240x240 = st7789::on_glass("ST7789 240x240", {240, 240}, {0, 0});
/// 172x320: the glass begins at column 34.
inline constexpr PanelDesc st7789_172x320 = st7789::on_glass("ST7789 172x320", {172, 320}, {34, 0});
/// 170x320: the glass begins at column 35.
inline constexpr PanelDesc st7789_170x320 = st7789::on_glass("ST7789 170x320", {170, 320}, {35, 0});
/// 135x240: the glass begins at column 52, row 40.
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

/// What ST7735 modules come up with.
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
        // R answers 5C xx xx, S 7C 89 F0: the bits both share.
        .identity = {.id = 0x5C0000, .mask = 0xDF0000, .register_dummy_bits = 1, .pixel_dummy_bits = 9},
        .quirks = {},
    });
}

} // namespace st7735

/// 128x160, without an offset.
inline constexpr PanelDesc st7735_128x160 =
    st7735::on_glass("ST7735 128x160", {128, 160}, {128, 160}, {0, 0}, ColorOrder::rgb); // red, black tab
/// 128x160 with a green tab on its foil.
inline constexpr PanelDesc st7735_128x160_green =
    st7735::on_glass("ST7735 128x160 green tab", {132, 162}, {128, 160}, {2, 1}, ColorOrder::bgr);
/// 128x128 with a green tab.
inline constexpr PanelDesc st7735_128x128_green =
    st7735::on_glass("ST7735 128x128 green tab", {132, 132}, {128, 128}, {2, 1}, ColorOrder::bgr);
/// 128x128 with a red tab.
inline constexpr PanelDesc st7735_128x128_red =
    st7735::on_glass("ST7735 128x128 red tab", {132, 132}, {128, 128}, {2, 3}, ColorOrder::bgr);
/// 80x160, IPS.
inline constexpr PanelDesc st7735_80x160 =
    st7735::on_glass("ST7735 80x160", {128, 160}, {80, 160}, {24, 0}, ColorOrder::bgr, true);
/// 80x160 whose glass begins at column 26.
inline constexpr PanelDesc st7735_80x160_26 =
    st7735::on_glass("ST7735 80x160 offset 26", {132, 162}, {80, 160}, {26, 1}, ColorOrder::bgr, true);

// --- ILI9342C ---

namespace ili9342c {

enum : unsigned { IFMODE = 0xB0, DISCTRL = 0xB6, PWCTR1 = 0xC0, PWCTR2 = 0xC1, SETEXTC = 0xC8, IFCTL = 0xF6 };

/// What ILI9342C modules come up with.
inline constexpr auto setup = init_program(cmd(SETEXTC, 0xFF, 0x93, 0x42),       // opens the registers below
                                           cmd(PWCTR1, 0x12, 0x12),              //
                                           cmd(PWCTR2, 0x03),                    //
                                           cmd(IFMODE, 0xE0),                    //
                                           cmd(IFCTL, 0x01, 0x00, 0x00),         // wrap at the window's end
                                           cmd(DISCTRL, 0x08, 0x82, 0x1D, 0x04), // 240 lines
                                           cmd(ili9341::GMCTRP1, 0x00, 0x0C, 0x11, 0x04, 0x11, 0x08, 0x37,
                                               0x89, 0x4C, 0x06, 0x0C, 0x0A, 0x2E, 0x34, 0x0F),
                                           cmd(ili9341::GMCTRN1, 0x00, 0x0B, 0x11, 0x05, 0x13, 0x09, 0x33,
                                               0x67, 0x48, 0x07, 0x0E, 0x0B, 0x2E, 0x33, 0x0F));

} // namespace ili9342c

/// The glass lies on its side in memory, so that upright is landscape. It is IPS.
inline constexpr PanelDesc ili9342c_320x240 = panel({
    .name = "ILI9342C 320x240",
    .controller = Controller::ili9342c,
    .memory = {320, 240},
    .glass = {320, 240},
    .mount = 0,
    .order = ColorOrder::bgr,
    .inverted = true,
    .serial = {.rgb565 = 0x55, .rgb666 = 0x66},
    .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
    .setup = ili9342c::setup,
    .timing = {.practical_serial_mhz = 40,
               .frame_us = 10712, // 27 * 244 / 615 kHz
               .scan_lines = 244,
               .porch_lines = 4},
    .identity = {.id = 0xE30000, .mask = 0xFF0000},
    .quirks = {},
});

// --- 320x480: ILI9486, ILI9488, ST7796S, HX8357D ---

namespace half_vga {

/// 60 Hz and 8 lines of blanking: the registers' reset values or near them.
consteval PanelTiming timing(std::uint16_t serial_write_ns, std::uint16_t practical_serial_mhz,
                             std::uint16_t parallel_write_ns) {
    return {.serial_write_ns = serial_write_ns,
            .parallel_write_ns = parallel_write_ns,
            .practical_serial_mhz = practical_serial_mhz,
            .frame_us = 16667,
            .scan_lines = 488,
            .porch_lines = 8};
}

} // namespace half_vga

namespace ili9486 {

enum : unsigned { PWCTR3 = 0xC2, VMCTR1 = 0xC5 };

/// What ILI9486 modules come up with.
inline constexpr auto setup = init_program(cmd(PWCTR3, 0x44),                   //
                                           cmd(VMCTR1, 0x00, 0x00, 0x00, 0x00), //
                                           cmd(ili9341::GMCTRP1, 0x0F, 0x1F, 0x1C, 0x0C, 0x0F, 0x08, 0x48,
                                               0x98, 0x37, 0x0A, 0x13, 0x04, 0x11, 0x0D, 0x00),
                                           cmd(ili9341::GMCTRN1, 0x0F, 0x32, 0x2E, 0x0B, 0x0D, 0x05, 0x47,
                                               0x75, 0x37, 0x06, 0x10, 0x03, 0x24, 0x20, 0x00));

} // namespace ili9486

/// This panel takes byte-wide commands; shields that shift 16 bits into a parallel bus are another bus.
inline constexpr PanelDesc ili9486_320x480 = panel({
    .name = "ILI9486 320x480",
    .controller = Controller::ili9486,
    .memory = {320, 480},
    .glass = {320, 480},
    .mount = dcs::MX,
    .order = ColorOrder::bgr,
    .serial = {.rgb666 = 0x66},
    .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
    .setup = ili9486::setup,
    .timing = half_vga::timing(66, 32, 50),
    .identity = {.command = 0xD3, .dummy_bits = 8, .id = 0x009486},
    .quirks = {},
});

namespace ili9488 {

enum : unsigned {
    IFMODE = 0xB0,
    FRMCTR1 = 0xB1,
    INVTR = 0xB4,
    DISCTRL = 0xB6,
    ETMOD = 0xB7,
    PWCTR1 = 0xC0,
    PWCTR2 = 0xC1,
    VMCTR1 = 0xC5,
    ADJCTL3 = 0xF7,
};

/// What ILI9488 modules come up with.
inline constexpr auto setup = init_program(cmd(PWCTR1, 0x17, 0x15),              //
                                           cmd(PWCTR2, 0x41),                    //
                                           cmd(VMCTR1, 0x00, 0x12, 0x80),        //
                                           cmd(IFMODE, 0x00),                    // SDO in use
                                           cmd(FRMCTR1, 0xA0),                   // 60.76 Hz
                                           cmd(INVTR, 0x02),                     // two-dot inversion
                                           cmd(DISCTRL, 0x02, 0x22, 0x3B),       // 480 lines
                                           cmd(ETMOD, 0xC6),                     //
                                           cmd(ADJCTL3, 0xA9, 0x51, 0x2C, 0x82), //
                                           cmd(ili9341::GMCTRP1, 0x00, 0x03, 0x09, 0x08, 0x16, 0x0A, 0x3F,
                                               0x78, 0x4C, 0x09, 0x0A, 0x08, 0x16, 0x1A, 0x0F),
                                           cmd(ili9341::GMCTRN1, 0x00, 0x16, 0x19, 0x03, 0x0F, 0x05, 0x32,
                                               0x45, 0x46, 0x04, 0x0E, 0x0D, 0x35, 0x37, 0x0F));

} // namespace ili9488

/// A serial bus takes 18 bits only. The data line is never let go: a shared bus needs a buffer behind it.
inline constexpr PanelDesc ili9488_320x480 = panel({
    .name = "ILI9488 320x480",
    .controller = Controller::ili9488,
    .memory = {320, 480},
    .glass = {320, 480},
    .mount = dcs::MX,
    .order = ColorOrder::bgr,
    .serial = {.rgb666 = 0x66},
    .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
    .setup = ili9488::setup,
    .timing = half_vga::timing(50, 40, 40),
    .identity = {.id = 0x548066},
    .quirks = {},
});

namespace st7796s {

enum : unsigned {
    INVTR = 0xB4,
    DISCTRL = 0xB6,
    PWCTR2 = 0xC1,
    PWCTR3 = 0xC2,
    VMCTR1 = 0xC5,
    PGC = 0xE0,
    NGC = 0xE1,
    DOCA = 0xE8, ///< output timing
    CSCON = 0xF0,
};

/// What ST7796S modules come up with.
inline constexpr auto setup = init_program(
    cmd(CSCON, 0xC3),                                          // opens command table 2:
    cmd(CSCON, 0x96),                                          // both halves of the key
    cmd(INVTR, 0x01),                                          // one-dot inversion
    cmd(DISCTRL, 0x80, 0x22, 0x3B),                            // 480 lines
    cmd(DOCA, 0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33), //
    cmd(PWCTR2, 0x06),                                         //
    cmd(PWCTR3, 0xA7),                                         //
    cmd(VMCTR1, 0x18), delay_ms(120),                          //
    cmd(PGC, 0xF0, 0x09, 0x0B, 0x06, 0x04, 0x15, 0x2F, 0x54, 0x42, 0x3C, 0x17, 0x14, 0x18, 0x1B), //
    cmd(NGC, 0xE0, 0x09, 0x0B, 0x06, 0x04, 0x03, 0x2B, 0x43, 0x42, 0x3B, 0x16, 0x14, 0x17, 0x1B), //
    delay_ms(120), cmd(CSCON, 0x3C), cmd(CSCON, 0x69)); // closes command table 2

} // namespace st7796s

/// A 320x480 TFT behind an ST7796S.
inline constexpr PanelDesc st7796s_320x480 = panel({
    .name = "ST7796S 320x480",
    .controller = Controller::st7796s,
    .memory = {320, 480},
    .glass = {320, 480},
    .mount = dcs::MX,
    .order = ColorOrder::bgr,
    .serial = {.rgb565 = 0x55, .rgb666 = 0x66},
    .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
    .setup = st7796s::setup,
    .timing = half_vga::timing(66, 80, 66),
    .identity = {.command = 0xD3, .dummy_bits = 8, .id = 0x007796},
    .quirks = {.reads_write_depth = true},
});

namespace hx8357d {

enum : unsigned {
    SETOSC = 0xB0,
    SETPOWER = 0xB1,
    SETRGB = 0xB3,
    SETCYC = 0xB4,
    SETCOM = 0xB6,
    SETEXTC = 0xB9,
    SETSTBA = 0xC0,
    SETPANEL = 0xCC,
    SETGAMMA = 0xE0,
};

/// What HX8357-D modules come up with.
inline constexpr auto setup =
    init_program(cmd(SETEXTC, 0xFF, 0x83, 0x57), delay_ms(300),     // opens the registers below
                 cmd(SETRGB, 0x80, 0x00, 0x06, 0x06),               //
                 cmd(SETCOM, 0x25),                                 // VCOM -1.52 V
                 cmd(SETOSC, 0x68),                                 //
                 cmd(SETPANEL, 0x05),                               // stripes and gate direction of the glass
                 cmd(SETPOWER, 0x00, 0x15, 0x1C, 0x1C, 0x83, 0xAA), //
                 cmd(SETSTBA, 0x50, 0x50, 0x01, 0x3C, 0x1E, 0x08),  //
                 cmd(SETCYC, 0x02, 0x40, 0x00, 0x2A, 0x2A, 0x0D, 0x78), //
                 cmd(SETGAMMA, 0x02, 0x0A, 0x11, 0x1D, 0x23, 0x35, 0x41, 0x4B, 0x4B, 0x42, 0x3A, 0x27, 0x1B,
                     0x08, 0x09, 0x03, 0x02, 0x0A, 0x11, 0x1D, 0x23, 0x35, 0x41, 0x4B, 0x4B, 0x42, 0x3A, 0x27,
                     0x1B, 0x08, 0x09, 0x03, 0x00, 0x01));

} // namespace hx8357d

/// A 320x480 TFT behind an HX8357-D.
inline constexpr PanelDesc hx8357d_320x480 = panel({
    .name = "HX8357D 320x480",
    .controller = Controller::hx8357d,
    .memory = {320, 480},
    .glass = {320, 480},
    .mount = dcs::MX | dcs::MY,
    .order = ColorOrder::rgb,
    .serial = {.rgb565 = 0x55, .rgb666 = 0x66},
    .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
    .setup = hx8357d::setup,
    .timing = half_vga::timing(66, 52, 50),
    .identity = {.command = 0xD0, .bytes = 1, .dummy_bits = 0, .id = 0x99, .mask = 0xFF},
    .quirks = {},
});

// --- GC9A01 ---

namespace gc9a01 {

/// The maker names none of these registers; FEh and EFh open them.
inline constexpr auto setup = init_program(
    cmd(0xFE), cmd(0xEF), cmd(0xEB, 0x14), cmd(0x84, 0x40), cmd(0x85, 0xFF), cmd(0x86, 0xFF), cmd(0x87, 0xFF),
    cmd(0x88, 0x0A), cmd(0x89, 0x21), cmd(0x8A, 0x00), cmd(0x8B, 0x80), cmd(0x8C, 0x01), cmd(0x8D, 0x01),
    cmd(0x8E, 0xFF), cmd(0x8F, 0xFF), cmd(0xB6, 0x00, 0x20), cmd(0x90, 0x08, 0x08, 0x08, 0x08),
    cmd(0xBD, 0x06), cmd(0xBC, 0x00), cmd(0xFF, 0x60, 0x01, 0x04), cmd(0xC3, 0x13), cmd(0xC4, 0x13),
    cmd(0xC9, 0x22), cmd(0xBE, 0x11), cmd(0xE1, 0x10, 0x0E), cmd(0xDF, 0x21, 0x0C, 0x02),
    cmd(0xF0, 0x45, 0x09, 0x08, 0x08, 0x26, 0x2A), cmd(0xF1, 0x43, 0x70, 0x72, 0x36, 0x37, 0x6F),
    cmd(0xF2, 0x45, 0x09, 0x08, 0x08, 0x26, 0x2A), cmd(0xF3, 0x43, 0x70, 0x72, 0x36, 0x37, 0x6F),
    cmd(0xED, 0x1B, 0x0B), cmd(0xAE, 0x77), cmd(0xCD, 0x63),
    cmd(0x70, 0x07, 0x07, 0x04, 0x0E, 0x0F, 0x09, 0x07, 0x08, 0x03), cmd(0xE8, 0x34),
    cmd(0x62, 0x18, 0x0D, 0x71, 0xED, 0x70, 0x70, 0x18, 0x0F, 0x71, 0xEF, 0x70, 0x70),
    cmd(0x63, 0x18, 0x11, 0x71, 0xF1, 0x70, 0x70, 0x18, 0x13, 0x71, 0xF3, 0x70, 0x70),
    cmd(0x64, 0x28, 0x29, 0xF1, 0x01, 0xF1, 0x00, 0x07),
    cmd(0x66, 0x3C, 0x00, 0xCD, 0x67, 0x45, 0x45, 0x10, 0x00, 0x00, 0x00),
    cmd(0x67, 0x00, 0x3C, 0x00, 0x00, 0x00, 0x01, 0x54, 0x10, 0x32, 0x98),
    cmd(0x74, 0x10, 0x85, 0x80, 0x00, 0x00, 0x4E, 0x00), cmd(0x98, 0x3E, 0x07));

} // namespace gc9a01

/// The round 1.28" TFT of 240x240.
inline constexpr PanelDesc gc9a01_240x240 = panel({
    .name = "GC9A01 240x240 round",
    .controller = Controller::gc9a01,
    .memory = {240, 240},
    .glass = {240, 240},
    .mount = 0,
    .order = ColorOrder::bgr,
    .inverted = true,
    .serial = {.rgb565 = 0x55, .rgb666 = 0x66, .rgb444 = 0x53},
    .parallel = {.rgb565 = 0x55, .rgb666 = 0x66, .rgb444 = 0x53},
    .setup = gc9a01::setup,
    .timing = {.serial_write_ns = 10,
               .practical_serial_mhz = 80,
               .frame_us = 16667,
               .scan_lines = 248,
               .porch_lines = 8},
    .identity = {.id = 0x009A01, .pixel_dummy_bits = 16},
    .quirks = {},
    .round = true,
});

/// Every panel, as one table.
inline constexpr const PanelDesc* all[] = {
    &ili9341_240x320,    &st7789_240x320,  &st7789_240x280,   &st7789_240x240,       &st7789_172x320,
    &st7789_170x320,     &st7789_135x240,  &st7735_128x160,   &st7735_128x160_green, &st7735_128x128_green,
    &st7735_128x128_red, &st7735_80x160,   &st7735_80x160_26, &ili9342c_320x240,     &ili9486_320x480,
    &ili9488_320x480,    &st7796s_320x480, &hx8357d_320x480,  &gc9a01_240x240,       &ssd1306_128x64,
    &ssd1306_128x32,     &sh1106_128x64,   &ssd0303_96x16,    &ssd1327_128x128,      &ssd0323_128x64,
    &ssd1351_128x128,    &ssd1331_96x64,   &hx8347_240x320,
};

} // namespace spangle::hal::panels
