// SiFive HiFive1: FE310, RV32IMAC.
#include "boards/board.hpp"

#include <spangle/hal/polled_bus.hpp>
#include <spangle/mcu/fe310_gpio.hpp>
#include <spangle/mcu/fe310_spi.hpp>
#include <spangle/mcu/riscv_timer.hpp>
#include <spangle/mcu/spi_port.hpp>
#include <spangle/native.hpp>

#include "boards/sifive_e/display.hpp"

namespace spangle::board {

namespace {

constexpr const hal::Board& wiring = boards::sifive_e;
constexpr mcu::Fe310Gpio gpio{0x10012000};
constexpr mcu::Fe310Spi spi1(0x10024000);
constexpr mcu::RiscvTimer timer{0x0200BFF8, 32768};
constexpr unsigned data_pin = 0, select_pin = 1;      // header pins 8 and 9
constexpr std::uint32_t spi_pins = 1u << 3 | 1u << 5; // MOSI, SCK: header pins 11 and 13

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[9440];

mcu::SpiPort<mcu::Fe310Spi, mcu::RegisterPin, mcu::RegisterPin, mcu::NoPin, mcu::RiscvTimer>
    port(spi1, gpio.pin(select_pin), gpio.pin(data_pin), {}, timer);
hal::BusMemoryOf<wiring> frames;
hal::PolledBus bus(port, hal::bus_caps(wiring), frames.buffer());
hal::BoardDisplay<wiring, 8, false> display(bus);

} // namespace

const std::uint32_t clock_hz = 16000000;

hal::Display& start() {
    memory(arena, sizeof arena);
    port.end(); // chip select is high before the pin becomes an output
    gpio.output(select_pin);
    gpio.output(data_pin);
    gpio.hardware(spi_pins);
    spi1.start({.divider = 0, .mode = 0});
    return display;
}

std::uint32_t bus_bytes() {
    return bus.bytes();
}

} // namespace spangle::board
