// Panels of Ilitek: ILI9341, ILI9342C, ILI9486 and ILI9488. They speak DCS and name their own registers
// alike.
#pragma once

#include <spangle/hal/panel.hpp>
#include <spangle/panels/half_vga.hpp>

namespace spangle::hal::panels {

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

/// The registers that ILI9341 modules need after reset.
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
    cmd(DISCTRL, 0x08, 0x82, 0x27),            // scans 320 lines, normally white
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
               .frame_us = 14224, // 27 clocks * 324 lines / 615 kHz
               .scan_lines = 324,
               .porch_lines = 4},
    .identity = {.id = 0x000000, .register_dummy_bits = 1, .pixel_dummy_bits = 8},
    .quirks = {},
});

namespace ili9342c {

enum : unsigned { IFMODE = 0xB0, DISCTRL = 0xB6, PWCTR1 = 0xC0, PWCTR2 = 0xC1, SETEXTC = 0xC8, IFCTL = 0xF6 };

/// The registers that ILI9342C modules need after reset.
inline constexpr auto setup = init_program(cmd(SETEXTC, 0xFF, 0x93, 0x42), // unlocks the registers below
                                           cmd(PWCTR1, 0x12, 0x12),        //
                                           cmd(PWCTR2, 0x03),              //
                                           cmd(IFMODE, 0xE0),              //
                                           cmd(IFCTL, 0x01, 0x00, 0x00), // writing wraps at the window's end
                                           cmd(DISCTRL, 0x08, 0x82, 0x1D, 0x04), // scans 240 lines
                                           cmd(ili9341::GMCTRP1, 0x00, 0x0C, 0x11, 0x04, 0x11, 0x08, 0x37,
                                               0x89, 0x4C, 0x06, 0x0C, 0x0A, 0x2E, 0x34, 0x0F),
                                           cmd(ili9341::GMCTRN1, 0x00, 0x0B, 0x11, 0x05, 0x13, 0x09, 0x33,
                                               0x67, 0x48, 0x07, 0x0E, 0x0B, 0x2E, 0x33, 0x0F));

} // namespace ili9342c

/// The [glass](docs/glossary.md#glass) lies on its side in memory, so that upright is landscape. It is IPS.
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
               .frame_us = 10712, // 27 clocks * 244 lines / 615 kHz
               .scan_lines = 244,
               .porch_lines = 4},
    .identity = {.id = 0xE30000, .mask = 0xFF0000},
    .quirks = {},
});

namespace ili9486 {

enum : unsigned { PWCTR3 = 0xC2, VMCTR1 = 0xC5 };

/// The registers that ILI9486 modules need after reset.
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

/// The registers that ILI9488 modules need after reset.
inline constexpr auto setup = init_program(cmd(PWCTR1, 0x17, 0x15),              //
                                           cmd(PWCTR2, 0x41),                    //
                                           cmd(VMCTR1, 0x00, 0x12, 0x80),        //
                                           cmd(IFMODE, 0x00),                    // SDO is used
                                           cmd(FRMCTR1, 0xA0),                   // refresh at 60.76 Hz
                                           cmd(INVTR, 0x02),                     // two-dot inversion
                                           cmd(DISCTRL, 0x02, 0x22, 0x3B),       // scans 480 lines
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

} // namespace spangle::hal::panels
