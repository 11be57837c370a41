// Stellaris LM3S811 evaluation board: Cortex-M3, 8 KB of RAM.
#include "boards/board.hpp"

#include <spangle/hal/polled_bus.hpp>
#include <spangle/mcu/i2c_port.hpp>
#include <spangle/mcu/stellaris.hpp>
#include <spangle/mcu/stellaris_i2c.hpp>
#include <spangle/mcu/systick.hpp>
#include <spangle/native.hpp>

#include "boards/lm3s811evb/display.hpp"

namespace spangle::board {

namespace {

constexpr const hal::Board& wiring = boards::lm3s811evb;
constexpr std::uint32_t clock = 12500000;
constexpr mcu::StellarisI2c i2c(0x40020000);
constexpr mcu::stellaris::Port port_b{0x40005000};
constexpr std::uint32_t scl_and_sda = 1u << 2 | 1u << 3; // PB2, PB3
constexpr std::uint8_t address = 0x3D;

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[4088];

mcu::I2cPort<mcu::StellarisI2c, mcu::SysTick> port(i2c, address, {clock});
hal::BusMemoryOf<wiring> frames;
hal::PolledBus bus(port, hal::bus_caps(wiring), frames.buffer());
hal::BoardDisplay<wiring, 8, false> display(bus);

} // namespace

const std::uint32_t clock_hz = clock;

hal::Display& start() {
    memory(arena, sizeof arena);
    mcu::stellaris::run_at_12500_khz();
    mcu::stellaris::turn_on(mcu::stellaris::serial_clocks, 1u << 12); // I2C 0
    mcu::stellaris::turn_on(mcu::stellaris::port_clocks, 1u << 1);    // port B
    port_b.give_away(scl_and_sda);
    port_b.open_drain(scl_and_sda);
    i2c.start(1); // 12.5 MHz / 40: 312 kHz
    return display;
}

std::uint32_t bus_bytes() {
    return bus.bytes();
}

} // namespace spangle::board
