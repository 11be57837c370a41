// Builds the [op list](docs/glossary.md#op) of one transfer in memory that the owner provides, with room for
// the parameters of short commands. Commands can be listed while a program is compiled, too.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>

namespace spangle::hal {

/// Four parameter bytes: a window command's big-endian pair, or one pixel.
struct OpParams {
    /// The bytes, in the order of the [wire](docs/glossary.md#wire).
    std::uint8_t bytes[4] = {};
};

/// Operations in the order in which they go out. A list that overflows stays so until clear(): submit()
/// refuses it.
class OpList {
  public:
    /// A list that can hold no operation.
    OpList() = default;
    /// A list of at most `capacity` operations, in arrays of so many elements, which must outlive its
    /// transfers.
    constexpr OpList(Op* ops, OpParams* params, std::size_t capacity)
        : ops_(ops), params_(params), capacity_(capacity) {}

    /// The number of operations in the list.
    constexpr std::size_t size() const { return size_; }
    /// The number of operations that the list can hold.
    std::size_t capacity() const { return capacity_; }
    /// The number of operations that can still be appended.
    std::size_t room() const { return capacity_ - size_; }
    /// The first of the size() operations.
    constexpr const Op* data() const { return ops_; }
    /// Empties the list. Its memory may be in use until the transfer before it is done.
    void clear() { size_ = 0, overflow_ = false; }
    /// Says whether parameters of the commands appended from here on travel as commands.
    constexpr void parameters_are_commands(bool so) { parameters_are_commands_ = so; }

    /// `params` must live until the transfer is done.
    constexpr void command(std::uint8_t code, const std::uint8_t* params = nullptr, std::uint32_t count = 0);
    /// A command with one parameter, which is copied.
    constexpr void command_byte(std::uint8_t code, std::uint8_t param);
    /// A command with two numbers of one byte: 15h and 75h of OLED controllers.
    constexpr void command_bytes(std::uint8_t code, std::uint8_t first, std::uint8_t last);
    /// A command with two 16-bit numbers, high bytes first: CASET, RASET.
    constexpr void command_pair(std::uint8_t code, std::uint16_t first, std::uint16_t last);
    /// Appends `rows` rows of `row_bytes` bytes, `stride` bytes apart. They must stay until the transfer is
    /// done.
    void pixels(const std::uint8_t* data, std::uint32_t row_bytes, std::uint32_t rows, std::int32_t stride);
    /// Repeats a pixel of `bytes` <= 4 zero bytes `count` times.
    void repeat_black(std::uint32_t bytes, std::uint32_t count);
    /// Waits for `micros` microseconds.
    void delay(std::uint32_t micros);
    /// Waits for the tearing-effect edge. `moment`, if not null, gets the time of it in microseconds, and
    /// must live until the transfer is done.
    void wait_te(std::uint32_t at_most_micros, std::uint32_t* moment = nullptr);
    /// Waits until RDSCANLINE (45h) answers one of `count` lines from `first` on, of a refresh of `lines`.
    void wait_line(std::uint8_t dummy_bits, std::int32_t first, std::int32_t count, std::int32_t lines,
                   std::uint32_t at_most_micros, std::uint32_t* moment = nullptr);
    /// Reads `count` bytes into `into`, which must live until the transfer is done.
    void read(std::uint8_t code, std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count);
    /// Holds the reset line low for so many microseconds.
    void reset(std::uint32_t low_micros);

    /// Hands the list to the bus. A list that had no room for an op is refused whole: Fault::bad_argument.
    /// Other errors are those of Bus::submit().
    Result<Token> submit(Bus& bus) const;
    /// The number of bytes that the list writes.
    std::uint64_t bytes() const;
    /// How long the list takes on this bus, in microseconds.
    std::uint32_t duration(const BusCaps& caps) const;

  private:
    constexpr Op* append(Op::Kind kind);
    constexpr void command_with(std::uint8_t code, OpParams params, std::uint32_t count);

    Op* ops_ = nullptr;
    OpParams* params_ = nullptr;
    std::size_t capacity_ = 0;
    std::size_t size_ = 0;
    bool overflow_ = false, parameters_are_commands_ = false;
};

constexpr Op* OpList::append(Op::Kind kind) {
    if (size_ == capacity_) {
        overflow_ = true;
        return nullptr;
    }
    Op& op = ops_[size_++];
    op = Op{};
    op.kind = kind;
    return &op;
}

constexpr void OpList::command(std::uint8_t code, const std::uint8_t* params, std::uint32_t count) {
    Op* op = append(Op::Kind::command);
    if (op == nullptr)
        return;
    op->command = code;
    op->parameters_are_commands = parameters_are_commands_;
    op->data = params;
    op->length = count;
}

constexpr void OpList::command_with(std::uint8_t code, OpParams params, std::uint32_t count) {
    if (size_ == capacity_) {
        overflow_ = true;
        return;
    }
    params_[size_] = params;
    command(code, params_[size_].bytes, count);
}

constexpr void OpList::command_byte(std::uint8_t code, std::uint8_t param) {
    command_with(code, {{param}}, 1);
}

constexpr void OpList::command_bytes(std::uint8_t code, std::uint8_t first, std::uint8_t last) {
    command_with(code, {{first, last}}, 2);
}

constexpr void OpList::command_pair(std::uint8_t code, std::uint16_t first, std::uint16_t last) {
    const auto high = [](std::uint16_t v) { return static_cast<std::uint8_t>(v >> 8); };
    const auto low = [](std::uint16_t v) { return static_cast<std::uint8_t>(v & 0xFF); };
    command_with(code, {{high(first), low(first), high(last), low(last)}}, 4);
}

/// Nanoseconds that `bytes` < 2^28 take on a bus that has a clock.
std::int64_t wire_nanoseconds(const BusCaps& caps, std::uint64_t bytes);

/// Microseconds that `bytes` take on a bus, rounded up; 0xFFFFFFFF when it has no clock.
std::uint32_t wire_time(const BusCaps& caps, std::uint64_t bytes);

} // namespace spangle::hal
