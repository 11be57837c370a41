// HX8347-D: registers of one byte behind an index, on an 8080 bus or on a serial one with start bytes.
#pragma once

#include <spangle/hal/panel.hpp>

namespace spangle::hal::panels {

namespace hx8347 {

enum : unsigned {
    HIMAX_ID = 0x00,
    DISPLAY_MODE = 0x01,
    COLUMN_START = 0x02, ///< first of the registers 02h to 05h: start and end
    ROW_START = 0x06,    ///< first of the registers 06h to 09h
    MEMORY_ACCESS = 0x16,
    PIXEL_FORMAT = 0x17,
    OSCILLATOR = 0x18,
    OSCILLATOR_ON = 0x19,
    BOOST = 0x1A,
    VREG1 = 0x1B,
    POWER = 0x1F,
    GRAM = 0x22,
    VCOM_OFFSET = 0x23,
    VCOM_HIGH = 0x24,
    VCOM_LOW = 0x25,
    DISPLAY = 0x28,
    PANEL = 0x36,
};

/// Turns on the gates first, and two frames later the sources.
inline constexpr auto light = init_program(cmd(DISPLAY, 0x38), delay_ms(40), cmd(DISPLAY, 0x3C));

/// Register 16h is DCS's MADCTL bit for bit, and MV exchanges the axes as there.
inline constexpr CommandSet commands = {
    .columns = {Axis::Code::registers, COLUMN_START},
    .rows = {Axis::Code::registers, ROW_START},
    .memory_write = GRAM,
    .rewinds = true,
    .settings = {{.command = MEMORY_ACCESS, .mx = dcs::MX, .my = dcs::MY, .mv = dcs::MV, .bgr = dcs::BGR},
                 {.command = PIXEL_FORMAT, .format = true}},
    .setting_count = 2,
    .light = light,
};

/// Registers of supply, gamma and clock, for the modules that there are.
inline constexpr auto setup = init_program(cmd(0xEA, 0x00), cmd(0xEB, 0x20), // power of the source drivers
                                           cmd(0xEC, 0x0C), cmd(0xED, 0xC4), //
                                           cmd(0xE8, 0x40), cmd(0xE9, 0x38), //
                                           cmd(0xF1, 0x01), cmd(0xF2, 0x10), //
                                           cmd(0x27, 0xA3),                  //
                                           cmd(VREG1, 0x1B),                 // VREG1 = 4.65 V
                                           cmd(BOOST, 0x01),                 //
                                           cmd(VCOM_HIGH, 0x2F),             //
                                           cmd(VCOM_LOW, 0x57),              //
                                           cmd(VCOM_OFFSET, 0x8D),           //
                                           cmd(OSCILLATOR, 0x36),            // refresh at 70 Hz
                                           cmd(OSCILLATOR_ON, 0x01),         //
                                           cmd(DISPLAY_MODE, 0x00),          //
                                           cmd(POWER, 0x88), delay_ms(5),    // leaves standby
                                           cmd(POWER, 0x80), delay_ms(5), // turns the boosters on, one by one
                                           cmd(POWER, 0x90), delay_ms(5), //
                                           cmd(POWER, 0xD0), delay_ms(5), // turns VCOM on
                                           cmd(PANEL, 0x00));

} // namespace hx8347

/// A 240x320 TFT behind an HX8347-D.
inline constexpr PanelDesc hx8347_240x320 = panel({
    .name = "HX8347 240x320",
    .controller = Controller::hx8347,
    .memory = {240, 320},
    .glass = {240, 320},
    .mount = dcs::MX | dcs::MY,
    .order = ColorOrder::bgr,
    .serial_bus = BusKind::spi_start,
    .serial = {.rgb565 = 0x05, .rgb666 = 0x06},
    .parallel = {.rgb565 = 0x05, .rgb666 = 0x06},
    .setup = hx8347::setup,
    .commands = &hx8347::commands,
    .timing = {.sleep_out_wait_us = 0,
               .serial_write_ns = 50,
               .parallel_write_ns = 66,
               .parallel_read_ns = 450,
               .practical_serial_mhz = 20},
    .identity = {.command = hx8347::HIMAX_ID,
                 .bytes = 1,
                 .dummy_bits = 0,
                 .parallel_dummy_bits = 0,
                 .id = 0x47,
                 .mask = 0xFF},
});

} // namespace spangle::hal::panels
