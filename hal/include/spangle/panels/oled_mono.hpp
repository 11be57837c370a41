// One-bit OLED panels: SSD1306, SH1106, SSD0303. Eight rows of pixels are a page of bytes.
#pragma once

#include <spangle/hal/panel.hpp>

namespace spangle::hal::panels {

namespace oled {

enum : unsigned {
    MEMORY_MODE = 0x20, ///< order of writing: 0 along columns, 1 along pages
    COLUMN_RANGE = 0x21,
    PAGE_RANGE = 0x22,
    STOP_SCROLL = 0x2E,
    START_LINE = 0x40,
    CONTRAST = 0x81,
    CHARGE_PUMP = 0x8D,
    SEGMENT_REMAP = 0xA0,
    SHOW_MEMORY = 0xA4,
    INVERSE = 0xA6,
    MULTIPLEX = 0xA8,
    DC_DC = 0xAD,
    DISPLAY_OFF = 0xAE,
    DISPLAY_ON = 0xAF,
    PAGE = 0xB0,
    COM_DIRECTION = 0xC0,
    OFFSET = 0xD3,
    CLOCK = 0xD5,
    PRECHARGE = 0xD9,
    COM_PINS = 0xDA,
    VCOMH = 0xDB,
};

/// AFh: the [glass](docs/glossary.md#glass) shows the memory.
inline constexpr auto display_on = init_program(cmd(DISPLAY_ON));

/// A0h or A1h: columns from left or right.
inline constexpr Setting mirror_columns = {.command = SEGMENT_REMAP, .in_command = true, .mx = 0x01};
/// C0h or C8h: rows from top or bottom.
inline constexpr Setting mirror_rows = {.command = COM_DIRECTION, .in_command = true, .my = 0x08};
/// A6h or A7h: lit pixels are ones or zeros.
inline constexpr Setting inverse = {.command = INVERSE, .in_command = true, .inverted = 0x01};

/// The commands of controllers that take ranges of columns and pages, and write along either.
inline constexpr CommandSet ranges = {
    .parameters_are_commands = true,
    .columns = {Axis::Code::pair8, COLUMN_RANGE},
    .rows = {Axis::Code::pair8, PAGE_RANGE},
    .axes_stay = true,
    .mirrors_rows_on_glass = true,
    .settings = {mirror_columns, mirror_rows, {.command = MEMORY_MODE, .mv = 0x01}, inverse},
    .setting_count = 4,
    .light = display_on,
};

/// The commands of controllers that take a page and a column in it, and write to the page's end.
inline constexpr CommandSet pages = {
    .parameters_are_commands = true,
    .columns = {Axis::Code::nibbles, 0x00},
    .rows = {Axis::Code::in_command, PAGE},
    .axes_stay = true,
    .mirrors_rows_on_glass = true,
    .settings = {mirror_columns, mirror_rows, inverse},
    .setting_count = 3,
    .light = display_on,
};

} // namespace oled

namespace ssd1306 {

using namespace oled;

/// `pins`: glass of more than 32 rows has every other row on the other half of the COM pins.
template <unsigned Rows, unsigned Pins, unsigned Contrast>
inline constexpr auto setup = init_program(cmd(DISPLAY_OFF),         //
                                           cmd(CLOCK, 0x80),         //
                                           cmd(MULTIPLEX, Rows - 1), //
                                           cmd(OFFSET, 0x00),        //
                                           cmd(START_LINE),          //
                                           cmd(CHARGE_PUMP, 0x14),   // the chip's converter gives 7.5 V
                                           cmd(COM_PINS, Pins),      //
                                           cmd(CONTRAST, Contrast),  //
                                           cmd(PRECHARGE, 0xF1),     //
                                           cmd(VCOMH, 0x40),         //
                                           cmd(STOP_SCROLL), // memory must not change while it scrolls
                                           cmd(SHOW_MEMORY));

/// Modules are glued in upside down: upright is A1h, C8h.
consteval PanelDesc on_glass(const char* name, Extent glass, Program setup) {
    return panel({
        .name = name,
        .controller = Controller::ssd1306,
        .memory = {128, 64},
        .glass = glass,
        .mount = dcs::MX | dcs::MY,
        .serial = {.mono = 0},
        .parallel = {.mono = 0},
        .setup = setup,
        .commands = &ranges,
        .timing = {.reset_wait_us = 100000, // the datasheet's 3 us are too short for many panels (u8g2)
                   .sleep_out_wait_us = 0,
                   .serial_write_ns = 100,
                   .parallel_write_ns = 300,
                   .i2c_hz = 1000000, // boards run faster than the datasheet's 400 kHz
                   .practical_serial_mhz = 20},
        .quirks = {.no_read_back = true},
    });
}

} // namespace ssd1306

/// The common 0.96" OLED of 128x64.
inline constexpr PanelDesc ssd1306_128x64 =
    ssd1306::on_glass("SSD1306 128x64", {128, 64}, ssd1306::setup<64, 0x12, 0xCF>);
/// The 0.91" OLED of 128x32.
inline constexpr PanelDesc ssd1306_128x32 =
    ssd1306::on_glass("SSD1306 128x32", {128, 32}, ssd1306::setup<32, 0x02, 0x8F>);

namespace sh1106 {

using namespace oled;

enum : unsigned { PUMP_VOLTAGE = 0x30 };

/// The registers that SH1106 modules need after reset.
inline constexpr auto setup = init_program(cmd(DISPLAY_OFF),      //
                                           cmd(CLOCK, 0x80),      //
                                           cmd(MULTIPLEX, 0x3F),  //
                                           cmd(OFFSET, 0x00),     //
                                           cmd(START_LINE),       //
                                           cmd(DC_DC, 0x8B),      // turns the chip's converter on
                                           cmd(PUMP_VOLTAGE + 2), // the converter gives 8.0 V
                                           cmd(COM_PINS, 0x12),   //
                                           cmd(CONTRAST, 0x80),   //
                                           cmd(PRECHARGE, 0x1F),  //
                                           cmd(VCOMH, 0x40),      //
                                           cmd(SHOW_MEMORY));

} // namespace sh1106

/// The 1.3" modules: the glass begins at column 2 of 132.
inline constexpr PanelDesc sh1106_128x64 = panel({
    .name = "SH1106 128x64",
    .controller = Controller::sh1106,
    .memory = {132, 64},
    .glass = {128, 64},
    .offset = {2, 0},
    .mount = dcs::MX | dcs::MY,
    .serial = {.mono = 0},
    .parallel = {.mono = 0},
    .setup = sh1106::setup,
    .commands = &oled::pages,
    .timing = {.reset_wait_us = 100000,
               .sleep_out_wait_us = 0,
               .serial_write_ns = 250,
               .parallel_write_ns = 300,
               .i2c_hz = 400000,
               .practical_serial_mhz = 8},
    .quirks = {.no_read_back = true},
});

namespace ssd0303 {

using namespace oled;

/// The registers that the evaluation board's SSD0303 needs after reset.
inline constexpr auto setup = init_program(cmd(DISPLAY_OFF),     //
                                           cmd(CLOCK, 0x80),     //
                                           cmd(MULTIPLEX, 0x0F), //
                                           cmd(OFFSET, 0x00),    //
                                           cmd(START_LINE),      //
                                           cmd(DC_DC, 0x8B),     //
                                           cmd(COM_PINS, 0x02),  //
                                           cmd(CONTRAST, 0x80),  //
                                           cmd(PRECHARGE, 0x22), //
                                           cmd(VCOMH, 0x40),     //
                                           cmd(SHOW_MEMORY));

} // namespace ssd0303

/// The display of the LM3S811 evaluation board: the glass begins at column 36 of 132.
inline constexpr PanelDesc ssd0303_96x16 = panel({
    .name = "SSD0303 96x16",
    .controller = Controller::ssd0303,
    .memory = {132, 64},
    .glass = {96, 16},
    .offset = {36, 0},
    .serial = {.mono = 0},
    .parallel = {.mono = 0},
    .setup = ssd0303::setup,
    .commands = &oled::pages,
    .timing = {.reset_wait_us = 100000,
               .sleep_out_wait_us = 0,
               .serial_write_ns = 250,
               .parallel_write_ns = 300,
               .i2c_hz = 400000,
               .practical_serial_mhz = 4},
    .quirks = {.no_read_back = true},
});

} // namespace spangle::hal::panels
