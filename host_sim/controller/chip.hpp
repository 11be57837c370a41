// The DCS controllers that the simulator models, as data from their datasheets.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <iterator>

#include <spangle/hal/panel.hpp>

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

/// A command whose parameters open the maker's registers. Where a chip has several keys, the registers open
/// after all of them, in their order. The same command with other parameters locks the registers again.
struct Key {
    std::uint8_t command = 0;
    std::array<std::uint8_t, 3> parameters{};
    std::uint8_t count = 0;
};

/// The answer to a read command other than 04h, which tells this controller from others.
struct MakerId {
    std::uint8_t command = 0; ///< the read command; 0: the chip has none
    std::array<std::uint8_t, 3> bytes{};
    std::uint8_t count = 0;
    std::uint8_t dummy_bits = 0; ///< clocks before the answer on a serial bus
};

/// A set of COLMOD values (3Ah, bits 2..0), a bit 1 << value each.
constexpr std::uint8_t depths(std::initializer_list<int> values) {
    unsigned set = 0;
    for (const int v : values)
        set |= 1u << v;
    return static_cast<std::uint8_t>(set);
}

struct Chip {
    hal::Controller controller{}; ///< the controller that the entry models
    const char* name;
    int width, height; ///< size of the frame memory in cells, as MADCTL 00h addresses it
    std::array<MemorySize, 2> other_sizes{}; ///< further memories that pins of the chip select
    std::array<std::uint8_t, 3> id{};        ///< answer to 04h
    MakerId maker_id{};
    std::array<std::uint8_t, 4> status{0x00, 0x61, 0x00, 0x00}; ///< answer to 09h after reset
    unsigned reset_to_command_ms = 120; ///< ms from a hardware reset to the first command
    unsigned line_ns;                   ///< ns of one scanned line, with the registers' reset values
    int porch_lines;                    ///< lines of vertical blanking, during which TE is high
    unsigned serial_write_ns,
        serial_write_got_ns; ///< shortest clock period, ns: as rated, and as modules are known to take
    unsigned serial_read_ns = 150;
    unsigned parallel_write_ns = 66, parallel_read_ns = 450;
    int register_dummy_bits = 1, pixel_dummy_bits = 8; ///< dummy clocks: of 04h and 09h; of 2Eh
    bool out_of_range_clamps = false; ///< XE, YE beyond the memory are clamped, else pixels there are ignored
    bool low_bit_from_green = false;  ///< reset value of EPF: green gives R and B their missing low bit
    bool reads_write_depth = false;   ///< 2Eh answers in COLMOD's format, else in three bytes a pixel
    std::uint8_t serial_depths = depths({5, 6}), parallel_depths = depths({5, 6}); ///< COLMOD values taken
    std::array<Key, 2> keys{}; ///< turned in this order; without keys the maker's registers are always open
    int key_count = 0;
};

/// The models of hal::Controller's DCS controllers, in the order of that enumeration: its value is the index.
inline constexpr Chip chips[] = {
    // The oscillator has 615 kHz, a line 27 clocks, and a frame 320 + 2 + 2 lines: 70.3 Hz.
    {.controller = hal::Controller::ili9341,
     .name = "ILI9341",
     .width = 240,
     .height = 320,
     .maker_id = {0xD3, {0x00, 0x93, 0x41}, 3, 8},
     .reset_to_command_ms = 5,
     .line_ns = 43902,
     .porch_lines = 4,
     .serial_write_ns = 100,
     .serial_write_got_ns = 12},
    // The refresh rate is 10 MHz / ((250 + 16 * 15) * (320 + 24)), which is 59 Hz.
    {.controller = hal::Controller::st7789,
     .name = "ST7789",
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
    // The refresh rate is 850 kHz / ((1 * 2 + 40) * (162 + 44 + 45)). The GM pins select the size of the
    // memory.
    {.controller = hal::Controller::st7735,
     .name = "ST7735",
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
    // The ILI9342C is an ILI9341 whose memory lies on its side: a line has 27 clocks, too, and a frame has
    // 240 + 2 + 2 lines.
    {.controller = hal::Controller::ili9342c,
     .name = "ILI9342C",
     .width = 320,
     .height = 240,
     .id = {0xE3, 0x00, 0x00},
     .reset_to_command_ms = 5,
     .line_ns = 43902,
     .porch_lines = 4,
     .serial_write_ns = 100,
     .serial_write_got_ns = 25},
    // For chips whose figures of the scan are not known, here and below, 60 Hz and 8 lines of blanking are
    // assumed.
    {.controller = hal::Controller::ili9486,
     .name = "ILI9486",
     .width = 320,
     .height = 480,
     .maker_id = {0xD3, {0x00, 0x94, 0x86}, 3, 8},
     .line_ns = 34153,
     .porch_lines = 8,
     .serial_write_ns = 66,
     .serial_write_got_ns = 31,
     .parallel_write_ns = 50,
     .serial_depths = depths({6})},
    {.controller = hal::Controller::ili9488,
     .name = "ILI9488",
     .width = 320,
     .height = 480,
     .id = {0x54, 0x80, 0x66},
     .line_ns = 34153,
     .porch_lines = 8,
     .serial_write_ns = 50,
     .serial_write_got_ns = 25,
     .parallel_write_ns = 40,
     .serial_depths = depths({6})},
    {.controller = hal::Controller::st7796s,
     .name = "ST7796S",
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
    {.controller = hal::Controller::gc9a01,
     .name = "GC9A01",
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
    {.controller = hal::Controller::hx8357d,
     .name = "HX8357D",
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

/// True if each chip stands where its controller's value says.
constexpr bool chips_are_in_order() {
    for (std::size_t i = 0; i < std::size(chips); ++i)
        if (static_cast<std::size_t>(chips[i].controller) != i)
            return false;
    return true;
}
static_assert(chips_are_in_order(), "chips[] must be in the order of hal::Controller");

/// Returns the chip with a memory of the wanted size, as its pins select it. The width is 0 where the chip
/// has no such memory.
constexpr Chip with_memory_size(const Chip& chip, MemorySize wanted) {
    Chip out = chip;
    bool known = wanted.width == chip.width && wanted.height == chip.height;
    for (const MemorySize& size : chip.other_sizes)
        known = known || (size.width == wanted.width && size.height == wanted.height);
    out.width = known ? wanted.width : 0;
    out.height = known ? wanted.height : 0;
    return out;
}

} // namespace spangle::sim
