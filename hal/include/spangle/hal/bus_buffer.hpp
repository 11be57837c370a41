// Memory of the bus that a transfer may be reading: to draw into it, one must ask first.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>

namespace spangle::hal {

/// The bytes are reached in two ways only: to send them, always; to draw into them, while no transfer reads
/// them. So no code can draw into what is on the [wire](docs/glossary.md#wire).
class BusBuffer {
  public:
    BusBuffer() = default;
    /// Memory that a bus handed out.
    explicit BusBuffer(Buffer memory) : memory_(memory) {}

    /// Whether there is no memory.
    bool empty() const { return memory_.bytes == nullptr; }
    /// The bytes, to draw into them. Null while a transfer that they were lent to is under way.
    std::uint8_t* to_draw(const Bus& bus) const {
        return lent_ && !bus.done(reader_) ? nullptr : memory_.bytes;
    }
    /// The bytes, as lists take them.
    const std::uint8_t* to_send() const { return memory_.bytes; }
    /// Says that the transfer `reader` reads the bytes until it is done.
    void lend(Token reader) {
        reader_ = reader;
        lent_ = true;
    }

  private:
    Buffer memory_;
    Token reader_;
    bool lent_ = false;
};

} // namespace spangle::hal
