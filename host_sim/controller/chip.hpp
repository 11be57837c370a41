// The DCS controllers that are modelled, as data from their datasheets.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

/// A command with these parameters opens the maker's registers, or, where several are named, the next of
/// them does. The same command with other parameters locks them again.
struct Key {
    std::uint8_t command = 0;
    std::array<std::uint8_t, 3> parameters{};
    std::uint8_t count = 0;
};

/// An answer beside 04h by which the controller is told from others.
struct MakerId {
    std::uint8_t command = 0; ///< 0: none
    std::array<std::uint8_t, 3> bytes{};
    std::uint8_t count = 0;
    std::uint8_t dummy_bits = 0; ///< on a serial bus
};

/// Sets of COLMOD values (3Ah, bits 2..0).
constexpr std::uint8_t depths(std::initializer_list<int> values) {
    unsigned set = 0;
    for (const int v : values)
        set |= 1u << v;
    return static_cast<std::uint8_t>(set);
}

struct Chip {
    const char* name;
    int width, height;                       ///< of the frame memory, MADCTL 00h
    std::array<MemorySize, 2> other_sizes{}; ///< which pins of the chip choose instead
    std::array<std::uint8_t, 3> id{};        ///< 04h
    MakerId maker_id{};
    std::array<std::uint8_t, 4> status{0x00, 0x61, 0x00, 0x00}; ///< 09h after reset
    unsigned reset_to_command_ms = 120;                         ///< after a hardware reset
    unsigned line_ns; ///< of the scan, with the registers' reset values
    int porch_lines;  ///< vertical blanking, TE is high
    unsigned serial_write_ns,
        serial_write_got_ns; ///< shortest clock: rated, and what modules are known to take
    unsigned serial_read_ns = 150;
    unsigned parallel_write_ns = 66, parallel_read_ns = 450;
    int register_dummy_bits = 1, pixel_dummy_bits = 8; ///< of 04h and 09h, and of 2Eh
    bool out_of_range_clamps = false; ///< XE, YE beyond the memory: clamped, else pixels there are ignored
    bool low_bit_from_green = false;  ///< reset value of EPF: the missing low bit of R and B is green's
    bool reads_write_depth = false;   ///< 2Eh answers in COLMOD's format, else three bytes a pixel
    std::uint8_t serial_depths = depths({5, 6}), parallel_depths = depths({5, 6}); ///< what COLMOD may say
    std::array<Key, 2> keys{}; ///< in this order; none: the maker's registers are always open
    int key_count = 0;
};

inline constexpr Chip chips[] = {
    // fosc 615 kHz, 27 clocks a line, 320 + 2 + 2 lines: 70.3 Hz.
    {.name = "ILI9341",
     .width = 240,
     .height = 320,
     .maker_id = {0xD3, {0x00, 0x93, 0x41}, 3, 8},
     .reset_to_command_ms = 5,
     .line_ns = 43902,
     .porch_lines = 4,
     .serial_write_ns = 100,
     .serial_write_got_ns = 12},
    // 10 MHz / ((250 + 16 * 15) * (320 + 24)): 59 Hz.
    {.name = "ST7789",
     .width = 240,
     .height = 320,
     .id = {0x85, 0x85, 0x52},
     .line_ns = 49000,
     .porch_lines = 24,
     .serial_write_ns = 16,
     .serial_write_got_ns = 12,
     .pixel_dummy_bits = 16,
     .out_of_range_clamps = true,
     .low_bit_from_green = true,
     .serial_depths = depths({3, 5, 6}),
     .parallel_depths = depths({3, 5, 6})},
    // fosc 850 kHz / ((1 * 2 + 40) * (162 + 44 + 45)). The GM pins choose the memory.
    {.name = "ST7735",
     .width = 132,
     .height = 162,
     .other_sizes = {{{128, 160}, {132, 132}}},
     .id = {0x5C, 0x89, 0xF0},
     .line_ns = 49412,
     .porch_lines = 89,
     .serial_write_ns = 66,
     .serial_write_got_ns = 16,
     .pixel_dummy_bits = 9,
     .serial_depths = depths({3, 5, 6}),
     .parallel_depths = depths({3, 5, 6})},
    // An ILI9341 whose memory lies on its side: as many clocks a line, 240 + 2 + 2 lines.
    {.name = "ILI9342C",
     .width = 320,
     .height = 240,
     .id = {0xE3, 0x00, 0x00},
     .reset_to_command_ms = 5,
     .line_ns = 43902,
     .porch_lines = 4,
     .serial_write_ns = 100,
     .serial_write_got_ns = 25},
    // Where no figures of the scan are known: 60 Hz and 8 lines of blanking, here and below.
    {.name = "ILI9486",
     .width = 320,
     .height = 480,
     .maker_id = {0xD3, {0x00, 0x94, 0x86}, 3, 8},
     .line_ns = 34153,
     .porch_lines = 8,
     .serial_write_ns = 66,
     .serial_write_got_ns = 31,
     .parallel_write_ns = 50,
     .serial_depths = depths({6})},
    {.name = "ILI9488",
     .width = 320,
     .height = 480,
     .id = {0x54, 0x80, 0x66},
     .line_ns = 34153,
     .porch_lines = 8,
     .serial_write_ns = 50,
     .serial_write_got_ns = 25,
     .parallel_write_ns = 40,
     .serial_depths = depths({6})},
    {.name = "ST7796S",
     .width = 320,
     .height = 480,
     .maker_id = {0xD3, {0x00, 0x77, 0x96}, 3, 8},
     .line_ns = 34153,
     .porch_lines = 8,
     .serial_write_ns = 66,
     .serial_write_got_ns = 12,
     .reads_write_depth = true,
     .keys = {{{0xF0, {0xC3}, 1}, {0xF0, {0x96}, 1}}},
     .key_count = 2},
    {.name = "GC9A01",
     .width = 240,
     .height = 240,
     .id = {0x00, 0x9A, 0x01},
     .line_ns = 67204,
     .porch_lines = 8,
     .serial_write_ns = 10,
     .serial_write_got_ns = 10,
     .pixel_dummy_bits = 16,
     .serial_depths = depths({3, 5, 6}),
     .parallel_depths = depths({3, 5, 6}),
     .keys = {{{0xFE, {}, 0}, {0xEF, {}, 0}}},
     .key_count = 2},
    {.name = "HX8357D",
     .width = 320,
     .height = 480,
     .maker_id = {0xD0, {0x99}, 1, 0},
     .line_ns = 34153,
     .porch_lines = 8,
     .serial_write_ns = 66,
     .serial_write_got_ns = 19,
     .parallel_write_ns = 50,
     .keys = {{{0xB9, {0xFF, 0x83, 0x57}, 3}}},
     .key_count = 1},
};

/// The chip with the memory its pins are strapped to; width 0 when it has no such memory.
constexpr Chip strapped(const Chip& chip, MemorySize wanted) {
    Chip out = chip;
    bool known = wanted.width == chip.width && wanted.height == chip.height;
    for (const MemorySize& size : chip.other_sizes)
        known = known || (size.width == wanted.width && size.height == wanted.height);
    out.width = known ? wanted.width : 0;
    out.height = known ? wanted.height : 0;
    return out;
}

} // namespace spangle::sim
