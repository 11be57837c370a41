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
};

inline constexpr Chip chips[] = {
    // fosc 615 kHz, 27 clocks a line, 320 + 2 + 2 lines: 70.3 Hz.
    {"ILI9341",
     240,
     320,
     {0x00, 0x00, 0x00},
     {0x00, 0x61, 0x00, 0x00},
     5,
     43902,
     4,
     100,
     12,
     150,
     66,
     450,
     1,
     8,
     false,
     false},
    // 10 MHz / ((250 + 16 * 15) * (320 + 24)): 59 Hz.
    {"ST7789",
     240,
     320,
     {0x85, 0x85, 0x52},
     {0x00, 0x61, 0x00, 0x00},
     120,
     49000,
     24,
     16,
     12,
     150,
     66,
     450,
     1,
     16,
     true,
     true},
    // fosc 850 kHz / ((1 * 2 + 40) * (162 + 44 + 45)).
    {"ST7735",
     132,
     162,
     {0x5C, 0x89, 0xF0},
     {0x00, 0x61, 0x00, 0x00},
     120,
     49412,
     89,
     66,
     16,
     150,
     66,
     450,
     1,
     9,
     false,
     false},
};

} // namespace spangle::sim
