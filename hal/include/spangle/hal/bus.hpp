// The bus, which moves bytes to a display controller. A transfer is one list of operations submitted with a
// token; D/C is part of the operation, so that every back end chooses how to carry it (GPIO, 9-bit words,
// register).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <spangle/hal/result.hpp>

namespace spangle::hal {

/// The wires between a bus and a controller, and how D/C travels on them.
enum class BusKind : std::uint8_t {
    spi4,      ///< 4-wire serial: CS, D/C, SCK, SDA (DBI-C option 3)
    i8080,     ///< 8-bit parallel: CS, D/C, WR, RD, D[7:0] (DBI-B)
    i2c,       ///< SCL, SDA; a control byte stands for D/C (SSD1306 datasheet, 8.1.5)
    spi_start, ///< 3-wire serial: CS, SCK, SDA; behind CS a start byte stands for D/C, 70h or 72h
};

/// One operation of a transfer. `kind` says which of the other members count; the rest are ignored.
struct Op {
    /// What a bus does for an operation.
    enum class Kind : std::uint8_t {
        command,   ///< one command byte, then `length` parameter bytes from `data`
        pixels,    ///< `rows` rows of `length` bytes, `stride` bytes apart, from `data` (bus-owned memory)
        repeat,    ///< the `length` (<= 4) bytes at `data`, sent `rows` times
        delay,     ///< wait `micros`
        wait_te,   ///< wait for the tearing-effect edge, at most `micros`
        wait_line, ///< read the scanned line (`command`, `dummy_bits`, two bytes) again and again until it is
                   ///< one of the `rows` lines from `length` on, of a refresh of `stride` lines; at most
                   ///< `micros`
        read,      ///< command byte, `dummy_bits` clocks, then `length` bytes into `into`, at the read clock;
                   ///< a parallel bus takes `dummy_bits / 8` dummy read cycles instead
        reset,     ///< hardware reset line low for `micros`, then high
    };
    /// The kind of the operation.
    Kind kind = Kind::delay;
    /// The command byte of `command`, `read` and `wait_line`.
    std::uint8_t command = 0;
    /// Clocks between a command and its answer, in which the data line turns round.
    std::uint8_t dummy_bits = 0;
    bool parameters_are_commands = false; ///< D/C is low for parameters, too
    /// The bytes to write. They must stay as they are until the transfer's token is done.
    const std::uint8_t* data = nullptr;
    /// Where the answer of a read goes. wait_te, wait_line: where the moment goes, if not null; see
    /// tell_moment(). The memory must stay until the transfer's token is done.
    std::uint8_t* into = nullptr;
    /// Bytes of a row, of parameters or of an answer; the first line of a wait_line.
    std::uint32_t length = 0;
    /// Rows of `pixels`, repeats of `repeat`, lines of a wait_line.
    std::uint32_t rows = 1;
    /// Bytes from one row to the next one down, which may be negative; the lines of a refresh of a wait_line.
    std::int32_t stride = 0;
    /// Microseconds of a delay or reset, or the deadline of a wait.
    std::uint32_t micros = 0;
};

/// Whether the answer is one of the lines that a wait_line waits for.
constexpr bool line_reached(const Op& op, const std::uint8_t (&answer)[2]) {
    const std::int32_t line = answer[0] << 8 | answer[1];
    const std::int32_t past = line - static_cast<std::int32_t>(op.length);
    return (past < 0 ? past + op.stride : past) < static_cast<std::int32_t>(op.rows);
}

/// Stores when the edge or line came that a wait_te or wait_line waited for: microseconds of any clock, in 32
/// bits that wrap.
inline void tell_moment(const Op& op, std::uint32_t micros) {
    if (op.into != nullptr)
        std::memcpy(op.into, &micros, sizeof micros);
}

/// What a bus can do, and how fast. Displays ask for it once, in init().
struct BusCaps {
    /// The wires that the bus has.
    BusKind kind = BusKind::spi4;
    std::uint32_t write_hz = 0;      ///< serial clock, or write cycles per second of a parallel bus
    std::uint32_t read_hz = 0;       ///< clock of reads; 0: the bus cannot read
    std::uint8_t bits_per_cycle = 1; ///< 1 for SPI, 8 for an 8-bit 8080 bus
    /// The panel's TE output reaches the bus: it takes `wait_te`.
    bool has_te = false;
    std::uint32_t max_transfer = 0; ///< most bytes of one operation; 0: there is no limit
    /// Overhead of one command operation beyond its bytes (D/C, ioctl, CS), in nanoseconds.
    std::uint32_t command_cost_ns = 0;
    /// A transfer is given up after twice its expected time plus this time. The time is long where other
    /// programs share the processor: a transfer that is only late must not look like one that hangs.
    std::uint32_t late_us = 100000;
};

/// An I2C bus at this clock: nine clocks a byte, and start, address and control byte where data follow
/// commands.
constexpr BusCaps i2c_caps(std::uint32_t clock_hz) {
    BusCaps caps;
    caps.kind = BusKind::i2c;
    caps.write_hz = static_cast<std::uint32_t>(std::uint64_t{clock_hz} * 8 / 9);
    caps.command_cost_ns = static_cast<std::uint32_t>(20 * 1000000000ull / (clock_hz | 1u));
    return caps;
}

/// Names one submitted list; tokens of one bus increase, and wrap behind 2^32 - 1.
struct Token {
    /// The number of the list; 0 names no list.
    std::uint32_t id = 0;
};

/// DMA-safe memory that belongs to the bus, and stays for the life of the bus.
struct Buffer {
    /// The first byte; null: there is no memory.
    std::uint8_t* bytes = nullptr;
    /// The number of bytes.
    std::size_t size = 0;
};

/// Carries [op lists](docs/glossary.md#op) to one display controller. A bus runs one list at a time. Its
/// calls come from one thread.
class Bus {
  public:
    /// What this bus can do; the same at each call.
    virtual BusCaps caps() const = 0;
    /// Hands out `size` bytes for the life of the bus. Fault::unsupported: so much memory is not
    /// left.
    virtual Result<Buffer> acquire(std::size_t size) = 0;
    /// Starts the whole list or nothing. The ops are copied; what they point to must stay until the token is
    /// done. Fault::busy: a list is under way. Fault::bad_argument and Fault::unsupported: an operation that
    /// this bus does not take; `rule` says which.
    virtual Result<Token> submit(const Op* ops, std::size_t count) = 0;
    /// Whether the list has ended, well or with a fault. It never waits.
    virtual bool done(Token token) const = 0;
    /// Returns when the token is done, or the error its transfer ended with. Fault::timeout: it is not done
    /// after `timeout_micros`; the transfer may still be under way then. Fault::bad_argument: the token is
    /// not the last that was given.
    virtual Result<void> wait(Token token, std::uint32_t timeout_micros) = 0;

  protected:
    ~Bus() = default;
};

} // namespace spangle::hal
