// Rules that datasheets set for a bus, and [violations](docs/glossary.md#violation) of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spangle::sim {

/// Virtual time in nanoseconds since power-on.
using Time = std::uint64_t;

/// The rules of the protocol, numbered as the reports name them.
enum class Rule : std::uint8_t {
    too_early = 1,        ///< a command too soon after a reset, SLPIN or SLPOUT
    reset_pulse = 2,      ///< reset low for less than the chip needs (10 us; OLED: chip's own)
    write_in_sleep = 3,   ///< RAMWR while asleep (a warning: the memory takes it)
    dc_in_byte = 4,       ///< D/C changed while a byte was under way
    parameter_count = 5,  ///< too few or too many parameters of a known command, or an unknown one
    window = 6,           ///< start behind end, outside of the memory, or outside of the glass
    pixel_count = 7,      ///< more or fewer pixels than the window holds
    read = 8,             ///< read faster than the read clock, or without the dummy clocks
    write_clock = 9,      ///< clock faster than the controller takes
    half_pixel = 10,      ///< the pixel stream ends inside a pixel
    buffer_changed = 11,  ///< the source changed between submit and the wire
    color_format = 12,    ///< pixels of another size than COLMOD says, or a format that this bus lacks
    tear = 13,            ///< the write crossed the scan line while TE is used
    control_byte = 14,    ///< I2C or start byte: a message, or its next part, without a valid control byte
    locked_register = 15, ///< a maker's register written without the key that opens it
    busy = 16,            ///< memory written while the controller itself moves or draws in it
};

/// One thing that a bus did and a data sheet forbids.
struct Violation {
    /// The rule that was broken.
    Rule rule;
    /// A sentence for people, with the numbers.
    std::string text;
    /// The time of the violation.
    Time at;
};

/// Violations in order of time.
using Violations = std::vector<Violation>;

} // namespace spangle::sim
