// LM3S6965 evaluation board. SSI0 (PA2 clock, PA5 data) leads to the OLED; D/C is PC7, chip select is PA3.
#include "boards/board.hpp"

#include <spangle/hal/polled_bus.hpp>
#include <spangle/mcu/pl022.hpp>
#include <spangle/mcu/spi_port.hpp>
#include <spangle/mcu/stellaris.hpp>
#include <spangle/mcu/systick.hpp>
#include <spangle/native.hpp>

#include "boards/lm3s6965evb/display.hpp"

namespace spangle::board {

namespace {

using namespace mcu::stellaris;

constexpr Port port_a{0x40004000}, port_c{0x40006000};
constexpr Pin data_command{port_c, 7}, chip_select{port_a, 3};
constexpr std::uint32_t ssi_clock = 1u << 2, ssi_out = 1u << 5;
constexpr mcu::Pl022 ssi0{0x40008000};
constexpr mcu::SysTick timer{12500000}; // 200 MHz PLL / 16

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[46 * 1024];

mcu::SpiPort<mcu::Pl022, Pin, Pin, mcu::NoPin, mcu::SysTick> port{ssi0, chip_select, data_command, {}, timer};
hal::BusMemoryOf<boards::lm3s6965evb> frames;
hal::PolledBus bus{port, hal::bus_caps(boards::lm3s6965evb), frames.buffer()};
hal::BoardDisplay<boards::lm3s6965evb> display{bus};

} // namespace

const std::uint32_t clock_hz = timer.clock_hz;

hal::Display& start() {
    memory(arena, sizeof arena);
    turn_on(serial_clocks, 1u << 4);
    turn_on(port_clocks, 1u << 0 | 1u << 2);
    port_a.give_away(ssi_clock | ssi_out);
    chip_select.set(true);
    port_a.output(1u << chip_select.bit);
    port_c.output(1u << data_command.bit);
    ssi0.start({.prescale = 4, .rate = 0, .mode = 3});
    return display;
}

std::uint32_t bus_bytes() {
    return bus.bytes();
}

} // namespace spangle::board
