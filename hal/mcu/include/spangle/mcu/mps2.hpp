// The display connector of Arm's MPS2 and MPS3 boards: a PL022 and, in the FPGA's I/O block, chip select,
// reset and back light (AN385, 4.3, "FPGAIO MISC": bits 0, 3, 6).
#pragma once

#include <cstdint>

#include <spangle/hal/board.hpp>
#include <spangle/hal/polled_bus.hpp>
#include <spangle/mcu/pl022.hpp>
#include <spangle/mcu/registers.hpp>
#include <spangle/mcu/spi_port.hpp>
#include <spangle/mcu/systick.hpp>

namespace spangle::mcu {

/// The addresses at which an FPGA image puts the blocks, and its clock.
struct Mps2 {
    /// The PL022's address, and that of the FPGA's I/O block.
    std::uintptr_t spi, fpgaio;
    /// The processor's clock.
    std::uint32_t clock_hz;

    /// A bit of FPGAIO MISC as a line.
    constexpr RegisterPin misc(unsigned bit) const { return {fpgaio + 0x4C, bit}; }
};

/// Puts the display's lines at rest, and turns its back light on.
inline void start_display(const Mps2& blocks) {
    blocks.misc(0).set(true); // deselects the controller
    Pl022(blocks.spi).start({.prescale = 2, .rate = 0, .mode = 3});
    blocks.misc(6).set(true); // turns the backlight on
}

/// An MPS2 board's own display; `board` says how it is turned.
template <const hal::Board& board, const Mps2& blocks> class Mps2Display {
  public:
    /// Puts the lines at rest and returns the display, which init() sets up.
    hal::Display& start() {
        start_display(blocks);
        return display_;
    }
    /// The number of bytes sent so far, modulo 2^32.
    std::uint32_t bus_bytes() const { return bus_.bytes(); }

  private:
    StartBytePort<Pl022, RegisterPin, RegisterPin, SysTick> port_{Pl022(blocks.spi), blocks.misc(0),
                                                                  blocks.misc(3), SysTick{blocks.clock_hz}};
    hal::BusMemoryOf<board> frames_;
    hal::PolledBus bus_{port_, hal::bus_caps(board), frames_.buffer()};
    hal::BoardDisplay<board> display_{bus_};
};

} // namespace spangle::mcu
