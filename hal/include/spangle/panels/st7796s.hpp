// ST7796S: DCS, 320x480 pixels.
#pragma once

#include <spangle/hal/panel.hpp>
#include <spangle/panels/half_vga.hpp>

namespace spangle::hal::panels {

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

/// The registers that ST7796S modules need after reset.
inline constexpr auto setup = init_program(
    cmd(CSCON, 0xC3),                                          // first half of a key: unlocks command table 2
    cmd(CSCON, 0x96),                                          // second half of the key
    cmd(INVTR, 0x01),                                          // one-dot inversion
    cmd(DISCTRL, 0x80, 0x22, 0x3B),                            // scans 480 lines
    cmd(DOCA, 0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33), //
    cmd(PWCTR2, 0x06),                                         //
    cmd(PWCTR3, 0xA7),                                         //
    cmd(VMCTR1, 0x18), delay_ms(120),                          //
    cmd(PGC, 0xF0, 0x09, 0x0B, 0x06, 0x04, 0x15, 0x2F, 0x54, 0x42, 0x3C, 0x17, 0x14, 0x18, 0x1B), //
    cmd(NGC, 0xE0, 0x09, 0x0B, 0x06, 0x04, 0x03, 0x2B, 0x43, 0x42, 0x3B, 0x16, 0x14, 0x17, 0x1B), //
    delay_ms(120), cmd(CSCON, 0x3C), cmd(CSCON, 0x69)); // two keys that lock command table 2

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

} // namespace spangle::hal::panels
