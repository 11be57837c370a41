// The commands of a family of controllers, as data. It says which of them name a window, an orientation and a
// pixel format, and whether their parameters travel as data or as commands.
#pragma once

#include <cstdint>

#include <spangle/hal/dcs.hpp>
#include <spangle/hal/init_program.hpp>

namespace spangle::hal {

/// How an axis of the window is sent. Its numbers count groups of pixels that share a byte: pages, pairs of
/// columns.
struct Axis {
    /// How the first and last number of an axis are encoded.
    enum class Code : std::uint8_t {
        pair16,    ///< the command, then the first and the last number, high bytes first
        pair8,     ///< the command, then the first and the last number, a byte each
        registers, ///< four commands from `command` on, each with one byte: first high, low, last high, low
        nibbles,   ///< two commands with nibbles of the first number: the low one, 10h further the high one
        in_command ///< a single number, in the command itself: a window has one row or page
    };
    /// How the two numbers are encoded.
    Code code = Code::pair16;
    /// The command, or the first of several.
    std::uint8_t command = 0;
};

/// Whether a window of this controller has one row, or one page, only.
constexpr bool names_one(Axis axis) {
    return axis.code == Axis::Code::in_command;
}

/// A register that follows from orientation, colour order, inversion and pixel format. Its value is `base`.
/// Each property that holds changes bits of it, and the format adds its code.
struct Setting {
    /// The register's command. With `in_command` it is the command without the bits of the value.
    std::uint8_t command = 0;
    bool in_command = false; ///< true: the value is part of the command; false: it is a parameter
    /// The value where no property holds.
    std::uint8_t base = 0;
    std::uint8_t mx = 0, my = 0, mv = 0; ///< bits that MX, MY, MV of the orientation's MADCTL change
    /// Bits that change where the [glass](docs/glossary.md#glass) is wired blue first, and where
    /// PanelDesc::inverted is set.
    std::uint8_t bgr = 0, inverted = 0;
    /// The value holds the code of the pixel format, FormatCode::code, in its low bits.
    bool format = false;
};

/// The commands of a controller family, and the quirks of its addressing. `dcs::commands` is that of MIPI
/// DCS.
struct CommandSet {
    bool parameters_are_commands = false; ///< D/C is low for parameters, too
    /// How columns and rows of a window are sent.
    Axis columns, rows;
    std::uint8_t memory_write = 0; ///< the command before pixels; 0: all data are pixels
    bool rewinds = false;   ///< memory_write goes to the window's start, so unchanged axes are not sent
    bool axes_stay = false; ///< with MV set, columns and rows keep their names; the order of writing changes
    bool mirrors_rows_on_glass = false; ///< MY turns the scan round; rows of memory keep their numbers
    bool status_registers = false;      ///< the controller has the status registers 09h to 0Fh
    /// The registers that the driver computes, in the order in which they are sent.
    Setting settings[4] = {};
    /// How many of `settings` are used, at most 4.
    std::uint8_t setting_count = 0;
    Program soft_reset{}; ///< resets panels without a reset line; empty: no command does
    Program tearing{};    ///< turns the TE output on; empty: there is no such output
    Program wake{};       ///< sent before the first pixel; PanelTiming::sleep_out_wait_us follows
    Program light{};      ///< turns the glass on
};

/// The bytes and commands of a window whose axes are all sent.
struct WindowSize {
    /// Bytes on the [wire](docs/glossary.md#wire), commands included, and the number of commands among them.
    std::uint32_t bytes = 0, commands = 0;
};

/// What one axis of a window costs on the wire.
constexpr WindowSize axis_size(Axis axis) {
    constexpr WindowSize sizes[] = {{5, 1}, {3, 1}, {8, 4}, {2, 1}, {1, 1}};
    return sizes[static_cast<unsigned>(axis.code)];
}

/// What a whole window costs, the command for pixels included.
constexpr WindowSize window_size(const CommandSet& set) {
    const WindowSize columns = axis_size(set.columns), rows = axis_size(set.rows);
    const std::uint32_t write = set.memory_write != 0 ? 1 : 0;
    return {columns.bytes + rows.bytes + write, columns.commands + rows.commands + write};
}

namespace dcs {

/// SWRESET (DCS 1.02, 01h), for boards without a reset line.
inline constexpr auto software_reset = init_program(cmd(SWRESET));
/// TEON (35h) with parameter 0: TE is high in vertical blanking only.
inline constexpr auto te_at_vertical_blanking = init_program(cmd(TEON, 0x00));
/// SLPOUT (11h): the controller wakes.
inline constexpr auto sleep_out = init_program(cmd(SLPOUT));
/// DISPON (29h): the glass shows the memory.
inline constexpr auto display_on = init_program(cmd(DISPON));

/// The MIPI display command set, which most colour controllers speak.
inline constexpr CommandSet commands = {
    .columns = {Axis::Code::pair16, CASET},
    .rows = {Axis::Code::pair16, RASET},
    .memory_write = RAMWR,
    .rewinds = true,
    .status_registers = true,
    .settings = {{.command = MADCTL, .mx = MX, .my = MY, .mv = MV, .bgr = BGR},
                 {.command = COLMOD, .format = true},
                 {.command = INVOFF, .in_command = true, .inverted = INVON ^ INVOFF}},
    .setting_count = 3,
    .soft_reset = software_reset,
    .tearing = te_at_vertical_blanking,
    .wake = sleep_out,
    .light = display_on,
};

} // namespace dcs
} // namespace spangle::hal
