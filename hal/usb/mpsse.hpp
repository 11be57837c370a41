// Commands of FTDI's Multi-Protocol Synchronous Serial Engine (AN_108), those that SPI in mode 0 takes: data
// changes at falling clocks and is taken at rising ones, high bits first.
#pragma once

#include <cstdint>

namespace spangle::hal::mpsse {

enum Command : std::uint8_t {
    WRITE_BYTES = 0x11, ///< followed by count - 1 in 16 bits, low byte first, and by the bytes (3.3.2)
    READ_BYTES = 0x20,  ///< followed by count - 1 in 16 bits, low byte first (3.3.5)
    SET_LOW = 0x80,     ///< followed by levels and directions of ADBUS, where 1 is an output (3.6.1)
    GET_LOW = 0x81,
    SET_HIGH = 0x82, ///< followed by levels and directions of ACBUS
    LOOPBACK_OFF = 0x85,
    SET_DIVISOR = 0x86,    ///< followed by 16 bits; the clock is 60 MHz / ((1 + divisor) * 2) (3.8.1)
    SEND_IMMEDIATE = 0x87, ///< sends at once what the host may read
    WAIT_HIGH = 0x88,      ///< waits until ADBUS5 is high (3.7)
    WAIT_LOW = 0x89,
    FULL_SPEED_BASE = 0x8A, ///< the divisor's base is 60 MHz instead of 12
    THREE_PHASE_OFF = 0x8D,
    ADAPTIVE_OFF = 0x97,
    BAD_COMMAND = 0xAA, ///< not a command, so the engine answers ECHO and this byte (3.9)
    ECHO = 0xFA,
};

inline constexpr std::uint32_t base_hz = 60'000'000, fastest_hz = base_hz / 2;

/// The divisor for the fastest clock that is no faster than `hz`.
constexpr std::uint16_t divisor_for(std::uint32_t hz) {
    const std::uint32_t wanted = hz < fastest_hz ? hz : fastest_hz;
    const std::uint32_t steps = wanted == 0 ? 0x10000 : (fastest_hz + wanted - 1) / wanted;
    return static_cast<std::uint16_t>((steps < 0x10000 ? steps : 0x10000) - 1);
}
constexpr std::uint32_t clock_of(std::uint16_t divisor) {
    return fastest_hz / (std::uint32_t{divisor} + 1);
}

} // namespace spangle::hal::mpsse
