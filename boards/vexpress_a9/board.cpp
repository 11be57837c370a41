// Versatile Express with a CoreTile Express A9: the tile's PL111 drives a panel of 320x240 pixels at 60 Hz.
#include "boards/board.hpp"

#include <spangle/mcu/cortex_a9.hpp>
#include <spangle/mcu/pl11x.hpp>
#include <spangle/native.hpp>

#include "boards/vexpress_a9/display.hpp"

namespace spangle::board {

namespace {

constexpr hal::MappedConfig panel = boards::vexpress_a9;
constexpr std::uint32_t frame_bytes = panel.width * panel.height * 2;
constexpr mcu::LcdTiming timing = {.width = panel.width,
                                   .height = panel.height,
                                   .h_sync = 10,
                                   .h_front = 10,
                                   .h_back = 10,
                                   .v_sync = 2,
                                   .v_front = 5,
                                   .v_back = 5};
constexpr mcu::GlobalTimer timer{100000000};

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[1024 * 1024];
alignas(32) __attribute__((section(".noinit"))) std::uint8_t frames[2][frame_bytes];
RowSpan touched[panel.height];

constexpr hal::MappedConfig with_memory() {
    hal::MappedConfig config = panel;
    config.buffers[0] = frames[0];
    config.buffers[1] = frames[1];
    config.touched = touched;
    return config;
}

mcu::Pl111<mcu::DataCache, mcu::GlobalTimer> lcd{0x10020000, frame_bytes, {}, timer};
hal::MappedDisplay display{lcd, with_memory()};

} // namespace

const std::uint32_t clock_hz = timer.clock_hz;

hal::Display& start() {
    memory(arena, sizeof arena);
    timer.start();
    lcd.start(timing);
    return display;
}

std::uint32_t bus_bytes() {
    return 0;
}

} // namespace spangle::board
