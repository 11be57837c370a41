// HX8357-D: DCS, 320x480 pixels.
#pragma once

#include <spangle/hal/panel.hpp>
#include <spangle/panels/half_vga.hpp>

namespace spangle::hal::panels {

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

/// The registers that HX8357-D modules need after reset.
inline constexpr auto setup =
    init_program(cmd(SETEXTC, 0xFF, 0x83, 0x57), delay_ms(300), // unlocks the registers below
                 cmd(SETRGB, 0x80, 0x00, 0x06, 0x06),           //
                 cmd(SETCOM, 0x25),                             // VCOM = -1.52 V
                 cmd(SETOSC, 0x68),                             //
                 cmd(SETPANEL, 0x05),                           // order of subpixels and gates on the glass
                 cmd(SETPOWER, 0x00, 0x15, 0x1C, 0x1C, 0x83, 0xAA),     //
                 cmd(SETSTBA, 0x50, 0x50, 0x01, 0x3C, 0x1E, 0x08),      //
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

} // namespace spangle::hal::panels
