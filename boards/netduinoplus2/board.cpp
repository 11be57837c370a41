// Netduino Plus 2: STM32F405, Cortex-M4.
#include "boards/board.hpp"

#include <spangle/hal/polled_bus.hpp>
#include <spangle/mcu/spi_port.hpp>
#include <spangle/mcu/stm32_gpio.hpp>
#include <spangle/mcu/stm32_spi.hpp>
#include <spangle/mcu/stm32f4_clock.hpp>
#include <spangle/mcu/systick.hpp>
#include <spangle/native.hpp>

#include "boards/netduinoplus2/display.hpp"

namespace spangle::board {

namespace {

constexpr const hal::Board& wiring = boards::netduinoplus2;
constexpr mcu::Stm32Gpio port_a{0x40020000}, port_b{0x40020400};
constexpr mcu::Stm32Spi spi1(0x40013000);
constexpr unsigned data_pin = 0, select_pin = 1, clock_pin = 5, mosi_pin = 7; // PB0, PB1, PA5, PA7
constexpr std::uint32_t spi_function = 5;                                     // AF5

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[72 * 1024];

mcu::SpiPort<mcu::Stm32Spi, mcu::Stm32Pin, mcu::Stm32Pin, mcu::NoPin, mcu::SysTick>
    port(spi1, {port_b.base, select_pin}, {port_b.base, data_pin}, {}, {168000000});
hal::BusMemoryOf<wiring> frames;
hal::PolledBus bus(port, hal::bus_caps(wiring), frames.buffer());
hal::BoardDisplay<wiring> display(bus);

} // namespace

const std::uint32_t clock_hz = 168000000;

hal::Display& start() {
    memory(arena, sizeof arena);
    mcu::stm32f4::run_at_168_mhz(25);
    mcu::stm32f4::turn_on(0x3, 1u << 12); // ports A and B, SPI1
    port.end();                           // chip select is high before the pin becomes an output
    port_b.output(select_pin);
    port_b.output(data_pin);
    port_a.alternate(clock_pin, spi_function);
    port_a.alternate(mosi_pin, spi_function);
    spi1.start({.divider = 1, .mode = 0});
    return display;
}

std::uint32_t bus_bytes() {
    return bus.bytes();
}

} // namespace spangle::board
