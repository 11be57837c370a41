// A display on SPI, as its lines are wired: with a D/C line, or with start bytes.
//
// PolledBus takes a port, and FrameDisplay takes the wires themselves.
// `Spi` has write(bytes, count) and read(), `Pin` has set(high), `Timer` has pause(micros).
#pragma once

#include <cstdint>

#include <spangle/hal/polled_bus.hpp>

namespace spangle::mcu {

/// BusKind::spi4: chip select and reset are low when active, D/C is low for commands. `SelectHigh`: chip
/// select comes through an inverter.
template <class Spi, class Select, class Data, class Reset, class Timer, bool SelectHigh = false>
class SpiWires {
  public:
    /// Nothing is acknowledged: writes cannot fail.
    static constexpr bool can_fail = false;

    /// The block and the lines, which are copied.
    constexpr SpiWires(Spi spi, Select select, Data data, Reset reset, Timer timer)
        : spi_(spi), select_(select), data_(data), reset_(reset), timer_(timer) {}

    /// Selects the chip and sets D/C.
    hal::Fault begin(bool data) {
        data_.set(data);
        select_.set(SelectHigh);
        return hal::Fault::none;
    }
    /// Sends bytes, and returns when the last bit has left.
    hal::Fault write(const std::uint8_t* bytes, std::uint32_t count) {
        spi_.write(bytes, count);
        return hal::Fault::none;
    }
    /// Dummy clocks are rounded down to whole bytes here.
    hal::Fault read(std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count) {
        for (unsigned bits = 0; bits + 8 <= dummy_bits; bits += 8)
            spi_.read();
        for (; count != 0; --count)
            *into++ = spi_.read();
        return hal::Fault::none;
    }
    /// Lets the chip go.
    void end() { select_.set(!SelectHigh); }
    /// Drives the reset line.
    void reset(bool low) { reset_.set(!low); }
    /// Lets at least `micros` microseconds pass.
    void pause(std::uint32_t micros) { timer_.pause(micros); }

  private:
    Spi spi_;
    Select select_;
    Data data_;
    Reset reset_;
    Timer timer_;
};
/// The wires of a display on SPI as a PolledPort.
template <class Spi, class Select, class Data, class Reset, class Timer, bool SelectHigh = false>
using SpiPort = hal::PolledPortOf<SpiWires<Spi, Select, Data, Reset, Timer, SelectHigh>>;

/// BusKind::spi_start: behind chip select a byte says what follows (HX8347-D datasheet, serial interface).
template <class Spi, class Select, class Reset, class Timer> class StartByteWires {
  public:
    /// Nothing is acknowledged: writes cannot fail.
    static constexpr bool can_fail = false;

    /// The block and the lines, which are copied.
    constexpr StartByteWires(Spi spi, Select select, Reset reset, Timer timer)
        : spi_(spi), select_(select), reset_(reset), timer_(timer) {}

    /// Selects the chip and sends the start byte.
    hal::Fault begin(bool data) {
        start(data ? write_value : write_index);
        return hal::Fault::none;
    }
    /// Sends bytes, and returns when the last bit has left.
    hal::Fault write(const std::uint8_t* bytes, std::uint32_t count) {
        spi_.write(bytes, count);
        return hal::Fault::none;
    }
    /// Selects the chip with the start byte of a read, and reads.
    hal::Fault read(std::uint8_t, std::uint8_t* into, std::uint32_t count) {
        start(read_value);
        for (; count != 0; --count)
            *into++ = spi_.read();
        return hal::Fault::none;
    }
    /// Lets the chip go.
    void end() { select_.set(true); }
    /// Drives the reset line.
    void reset(bool low) { reset_.set(!low); }
    /// Lets at least `micros` microseconds pass.
    void pause(std::uint32_t micros) { timer_.pause(micros); }

  private:
    static constexpr std::uint8_t write_index = 0x70, write_value = 0x72, read_value = 0x73;

    void start(std::uint8_t byte) {
        select_.set(true);
        select_.set(false);
        spi_.write(&byte, 1);
    }

    Spi spi_;
    Select select_;
    Reset reset_;
    Timer timer_;
};
/// The wires of a display on SPI as a PolledPort.
template <class Spi, class Select, class Reset, class Timer>
using StartBytePort = hal::PolledPortOf<StartByteWires<Spi, Select, Reset, Timer>>;

} // namespace spangle::mcu
