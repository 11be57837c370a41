// BBC micro:bit: nRF51822, Cortex-M0.
#include "boards/board.hpp"

#include <spangle/hal/polled_bus.hpp>
#include <spangle/mcu/i2c_port.hpp>
#include <spangle/mcu/nrf51_timer.hpp>
#include <spangle/mcu/nrf51_twi.hpp>
#include <spangle/native.hpp>

#include "boards/microbit/display.hpp"

namespace spangle::board {

namespace {

constexpr const hal::Board& wiring = boards::microbit;
constexpr mcu::Nrf51Twi twi(0x40003000);
constexpr mcu::Nrf51Timer timer{0x40008000};
constexpr unsigned scl_pin = 0, sda_pin = 30; // edge connector 19 and 20
constexpr std::uint8_t address = 0x3C;

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[10176];

mcu::I2cPort<mcu::Nrf51Twi, mcu::Nrf51Timer> port(twi, address, timer);
hal::BusMemoryOf<wiring> frames;
hal::PolledBus bus(port, hal::bus_caps(wiring), frames.buffer());
hal::BoardDisplay<wiring, 8, false> display(bus);

} // namespace

const std::uint32_t clock_hz = 16000000;

hal::Display& start() {
    memory(arena, sizeof arena);
    timer.start();
    twi.start(scl_pin, sda_pin, mcu::Nrf51Twi::khz400);
    return display;
}

std::uint32_t bus_bytes() {
    return bus.bytes();
}

} // namespace spangle::board
