// Grey and colour OLED panels whose memory is written through a window of columns (15h) and rows (75h):
// SSD1327, SSD0323; SSD1351, SSD1331.
#pragma once

#include <spangle/hal/panel.hpp>

namespace spangle::hal::panels {

namespace oled {

enum : unsigned {
    COLUMNS = 0x15,
    ROWS = 0x75,
    WRITE_RAM = 0x5C, ///< the command before pixels, on the SSD1351 only
    REMAP = 0xA0,
    FIRST_LINE = 0xA1,
    FIRST_COM = 0xA2,
    NORMAL = 0xA4, ///< shows memory as it is; A7h shows its inverse
    LOCK = 0xFD,
};

/// AFh: the [glass](docs/glossary.md#glass) shows the memory.
inline constexpr auto windowed_on = init_program(cmd(0xAF));

/// Two columns share a byte, the left one in the high nibble: A0h bit 1. Where columns are mirrored, the pair
/// is exchanged, too.
inline constexpr CommandSet grey = {
    .parameters_are_commands = true,
    .columns = {Axis::Code::pair8, COLUMNS},
    .rows = {Axis::Code::pair8, ROWS},
    .axes_stay = true,
    .mirrors_rows_on_glass = true,
    .settings = {{.command = REMAP, .base = 0x42, .mx = 0x03, .my = 0x10, .mv = 0x04},
                 {.command = NORMAL, .in_command = true, .inverted = 0x03}},
    .setting_count = 2,
    .light = windowed_on,
};

} // namespace oled

namespace ssd1327 {

using namespace oled;

/// The registers that SSD1327 modules need after reset.
inline constexpr auto setup = init_program(cmd(LOCK, 0x12),       // unlocks the registers
                                           cmd(0xAE),             //
                                           cmd(0xA8, 0x7F),       // scans 128 lines
                                           cmd(FIRST_LINE, 0x00), //
                                           cmd(FIRST_COM, 0x00),  //
                                           cmd(0xAB, 0x01),       // the chip makes VDD itself
                                           cmd(0xB1, 0xF1),       // lengths of the drive phases
                                           cmd(0xB3, 0x00),       // refreshes at 80 Hz
                                           cmd(0xB6, 0x0F),       // length of the second precharge
                                           cmd(0xB9),             // greys in equal steps
                                           cmd(0xBC, 0x08),       // precharge voltage
                                           cmd(0xBE, 0x0F),       // VCOMH
                                           cmd(0xD5, 0x62),       // turns the second precharge on
                                           cmd(0x81, 0x80));      // contrast

} // namespace ssd1327

/// A grey OLED of 128x128 with 16 steps.
inline constexpr PanelDesc ssd1327_128x128 = panel({
    .name = "SSD1327 128x128",
    .controller = Controller::ssd1327,
    .memory = {128, 128},
    .glass = {128, 128},
    .mount = dcs::MX | dcs::MY,
    .serial = {.grey4 = 0},
    .parallel = {.grey4 = 0},
    .setup = ssd1327::setup,
    .commands = &oled::grey,
    .timing = {.reset_wait_us = 100000,
               .sleep_out_wait_us = 0,
               .serial_write_ns = 100,
               .parallel_write_ns = 300,
               .i2c_hz = 400000,
               .practical_serial_mhz = 10},
    .quirks = {.no_read_back = true},
});

namespace ssd0323 {

using namespace oled;

/// The registers that the evaluation board's SSD0323 needs after reset.
inline constexpr auto setup =
    init_program(cmd(0xAE),             //
                 cmd(0xA8, 0x3F),       // scans 64 lines
                 cmd(FIRST_LINE, 0x00), //
                 cmd(FIRST_COM, 0x4C),  // the first COM pin of the glass
                 cmd(0x81, 0x40),       // contrast
                 cmd(0x86),             // lets the full current flow
                 cmd(0xAD, 0x03),       // turns the chip's converter off: VCC comes from outside
                 cmd(0xB1, 0x22),       // lengths of the drive phases
                 cmd(0xB2, 0x46),       // clocks of a row
                 cmd(0xB3, 0x41),       // frequency and divider of the clock
                 cmd(0xB8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76), // grey steps
                 cmd(0xBC, 0x08),                                           // precharge voltage
                 cmd(0xBE, 0x1C),                                           // VCOMH
                 cmd(0xBF, 0x0F));                                          // VSL

} // namespace ssd0323

/// The display of the LM3S6965 evaluation board.
inline constexpr PanelDesc ssd0323_128x64 = panel({
    .name = "SSD0323 128x64",
    .controller = Controller::ssd0323,
    .memory = {128, 80},
    .glass = {128, 64},
    .mount = dcs::MY,
    .serial = {.grey4 = 0},
    .parallel = {.grey4 = 0},
    .setup = ssd0323::setup,
    .commands = &oled::grey,
    .timing = {.reset_wait_us = 100000,
               .sleep_out_wait_us = 0,
               .serial_write_ns = 250,
               .parallel_write_ns = 300,
               .i2c_hz = 400000,
               .practical_serial_mhz = 4},
    .quirks = {.no_read_back = true},
});

namespace ssd1351 {

using namespace oled;

/// The SSD1351's commands: parameters are data, pixels follow a command of their own, and A6h is normal.
inline constexpr CommandSet commands = {
    .columns = {Axis::Code::pair8, COLUMNS},
    .rows = {Axis::Code::pair8, ROWS},
    .memory_write = WRITE_RAM,
    .axes_stay = true,
    .mirrors_rows_on_glass = true,
    .settings = {{.command = REMAP,
                  .base = 0x24, // COM pins are split, and red is first
                  .mx = 0x02,
                  .my = 0x10,
                  .mv = 0x01,
                  .bgr = 0x04,
                  .format = true},
                 {.command = 0xA6, .in_command = true, .inverted = 0x01}},
    .setting_count = 2,
    .light = windowed_on,
};

/// The registers that SSD1351 modules need after reset.
inline constexpr auto setup = init_program(cmd(LOCK, 0x12),             // unlocks the registers
                                           cmd(LOCK, 0xB1),             // unlocks the registers of the supply
                                           cmd(0xAE),                   //
                                           cmd(0xB3, 0xF1),             // frequency and divider of the clock
                                           cmd(0xCA, 0x7F),             // scans 128 lines
                                           cmd(FIRST_LINE, 0x00),       //
                                           cmd(FIRST_COM, 0x00),        // a reset sets 60h
                                           cmd(0xAB, 0x01),             // the chip makes VDD itself
                                           cmd(0xB4, 0xA0, 0xB5, 0x55), // VSL comes from outside
                                           cmd(0xC1, 0xC8, 0x80, 0xC8), // contrast of red, green, blue
                                           cmd(0xC7, 0x0F),             // lets the full current flow
                                           cmd(0xB1, 0x32),             // lengths of the drive phases
                                           cmd(0xBE, 0x05));            // VCOMH

} // namespace ssd1351

/// A colour OLED of 128x128.
inline constexpr PanelDesc ssd1351_128x128 = panel({
    .name = "SSD1351 128x128",
    .controller = Controller::ssd1351,
    .memory = {128, 128},
    .glass = {128, 128},
    .mount = dcs::MY,
    .serial = {.rgb565 = 0x40, .rgb332 = 0x00},
    .parallel = {.rgb565 = 0x40, .rgb332 = 0x00},
    .setup = ssd1351::setup,
    .commands = &ssd1351::commands,
    .timing = {.reset_wait_us = 100000,
               .sleep_out_wait_us = 0,
               .serial_write_ns = 50,
               .parallel_write_ns = 300,
               .practical_serial_mhz = 20},
    .quirks = {.no_read_back = true},
});

namespace ssd1331 {

using namespace oled;

/// The SSD1331's commands: parameters are commands, too, and pixels need none.
inline constexpr CommandSet commands = {
    .parameters_are_commands = true,
    .columns = {Axis::Code::pair8, COLUMNS},
    .rows = {Axis::Code::pair8, ROWS},
    .axes_stay = true,
    .mirrors_rows_on_glass = true,
    .settings = {{.command = REMAP,
                  .base = 0x20, // COM pins are split
                  .mx = 0x02,
                  .my = 0x10,
                  .mv = 0x01,
                  .bgr = 0x04,
                  .format = true},
                 {.command = NORMAL, .in_command = true, .inverted = 0x03}},
    .setting_count = 2,
    .light = windowed_on,
};

/// The registers that SSD1331 modules need after reset.
inline constexpr auto setup = init_program(cmd(0xAE),             //
                                           cmd(FIRST_LINE, 0x00), //
                                           cmd(FIRST_COM, 0x00),  //
                                           cmd(0xA8, 0x3F),       // scans 64 lines
                                           cmd(0xAD, 0x8E),       // VCC comes from outside
                                           cmd(0xB0, 0x0B),       // turns power save off
                                           cmd(0xB1, 0x31),       // lengths of the drive phases
                                           cmd(0xB3, 0xF0),       // frequency and divider of the clock
                                           cmd(0x8A, 0x64),       // second precharge of red
                                           cmd(0x8B, 0x78),       // second precharge of green
                                           cmd(0x8C, 0x64),       // second precharge of blue
                                           cmd(0xBB, 0x3A),       // precharge voltage
                                           cmd(0xBE, 0x3E),       // VCOMH
                                           cmd(0x87, 0x06),       // limits the current
                                           cmd(0x81, 0x91),       // contrast of red
                                           cmd(0x82, 0x50),       // contrast of green
                                           cmd(0x83, 0x7D));      // contrast of blue

} // namespace ssd1331

/// A colour OLED of 96x64.
inline constexpr PanelDesc ssd1331_96x64 = panel({
    .name = "SSD1331 96x64",
    .controller = Controller::ssd1331,
    .memory = {96, 64},
    .glass = {96, 64},
    .mount = dcs::MX | dcs::MY,
    .serial = {.rgb565 = 0x40, .rgb332 = 0x00},
    .parallel = {.rgb565 = 0x40, .rgb332 = 0x00},
    .setup = ssd1331::setup,
    .commands = &ssd1331::commands,
    .timing = {.reset_wait_us = 100000,
               .sleep_out_wait_us = 0,
               .serial_write_ns = 150,
               .parallel_write_ns = 300,
               .practical_serial_mhz = 6},
    .quirks = {.no_read_back = true},
});

} // namespace spangle::hal::panels
