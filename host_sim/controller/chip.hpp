// The controllers that are modelled, as data from their datasheets.
#pragma once

#include <array>
#include <cstdint>

namespace spangle::sim {

struct Chip {
    const char* name;
    int width, height;                  ///< of the frame memory, MADCTL 00h
    std::array<std::uint8_t, 3> id;     ///< 04h
    std::array<std::uint8_t, 4> status; ///< 09h after reset
    unsigned reset_to_command_ms;       ///< after a hardware reset
    unsigned line_ns;                   ///< of the scan, with the registers' reset values
    int porch_lines;                    ///< vertical blanking, TE is high
    unsigned serial_write_ns,
        serial_write_got_ns; ///< shortest clock: rated, and what modules are known to take
    unsigned serial_read_ns;
    unsigned parallel_write_ns, parallel_read_ns;
    int register_dummy_bits, pixel_dummy_bits; ///< of 04h and 09h, and of 2Eh
    bool out_of_range_clamps; ///< XE, YE beyond the memory: clamped, else pixels there are ignored
    bool low_bit_from_green;  ///< reset value of EPF: the missing low bit of R and B is green's
    bool takes_444;           ///< COLMOD 3: two pixels in three bytes
};

inline constexpr Chip chips[] = {
    // fosc 615 kHz, 27 clocks a line, 320 + 2 + 2 lines: 70.3 Hz.
    {.name = "ILI9341",
     .width = 240,
     .height = 320,
     .id = {0x00, 0x00, 0x00},
     .status = {0x00, 0x61, 0x00, 0x00},
     .reset_to_command_ms = 5,
     .line_ns = 43902,
     .porch_lines = 4,
     .serial_write_ns = 100,
     .serial_write_got_ns = 12,
     .serial_read_ns = 150,
     .parallel_write_ns = 66,
     .parallel_read_ns = 450,
     .register_dummy_bits = 1,
     .pixel_dummy_bits = 8,
     .out_of_range_clamps = false,
     .low_bit_from_green = false,
     .takes_444 = false},
    // 10 MHz / ((250 + 16 * 15) * (320 + 24)): 59 Hz.
    {.name = "ST7789",
     .width = 240,
     .height = 320,
     .id = {0x85, 0x85, 0x52},
     .status = {0x00, 0x61, 0x00, 0x00},
     .reset_to_command_ms = 120,
     .line_ns = 49000,
     .porch_lines = 24,
     .serial_write_ns = 16,
     .serial_write_got_ns = 12,
     .serial_read_ns = 150,
     .parallel_write_ns = 66,
     .parallel_read_ns = 450,
     .register_dummy_bits = 1,
     .pixel_dummy_bits = 16,
     .out_of_range_clamps = true,
     .low_bit_from_green = true,
     .takes_444 = true},
    // fosc 850 kHz / ((1 * 2 + 40) * (162 + 44 + 45)).
    {.name = "ST7735",
     .width = 132,
     .height = 162,
     .id = {0x5C, 0x89, 0xF0},
     .status = {0x00, 0x61, 0x00, 0x00},
     .reset_to_command_ms = 120,
     .line_ns = 49412,
     .porch_lines = 89,
     .serial_write_ns = 66,
     .serial_write_got_ns = 16,
     .serial_read_ns = 150,
     .parallel_write_ns = 66,
     .parallel_read_ns = 450,
     .register_dummy_bits = 1,
     .pixel_dummy_bits = 9,
     .out_of_range_clamps = false,
     .low_bit_from_green = false,
     .takes_444 = true},
};

} // namespace spangle::sim
