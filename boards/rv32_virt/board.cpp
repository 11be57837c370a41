// QEMU's RV32 virt machine with bochs-display on its PCI Express bus.
#include "boards/board.hpp"

#include <spangle/mcu/bochs_display.hpp>
#include <spangle/mcu/riscv_timer.hpp>
#include <spangle/native.hpp>

#include "boards/rv32_virt/display.hpp"

namespace spangle::board {

namespace {

constexpr std::uintptr_t ecam = 0x30000000, pci_memory = 0x40000000, pci_registers = 0x42000000;
constexpr hal::MappedConfig screen = boards::rv32_virt;
constexpr std::uint32_t frame_bytes = screen.width * screen.height * 2;
constexpr mcu::RiscvTimer timer{0x0200BFF8, 10000000};

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[1024 * 1024];
RowSpan touched[screen.height];

mcu::BochsDisplay<mcu::RiscvTimer> port{pci_memory, pci_registers, timer};

hal::MappedConfig with_memory() {
    hal::MappedConfig config = screen;
    config.buffers[0] = port.frame(0, frame_bytes);
    config.buffers[1] = port.frame(1, frame_bytes);
    config.touched = touched;
    return config;
}

hal::MappedDisplay display{port, with_memory()};

} // namespace

const std::uint32_t clock_hz = timer.clock_hz;

hal::Display& start() {
    memory(arena, sizeof arena);
    port.start(ecam, screen.width, screen.height);
    return display;
}

std::uint32_t bus_bytes() {
    return 0;
}

} // namespace spangle::board
