// Cortex-A9: memory map, then the program; faults. RAM is cached, everything else is a device, and the
// megabyte below the stack is not there, so that overflowing it is a fault (Armv7-A ARM, B3.5).
#include <cstdint>

#include "hal/mcu/start.hpp"

extern "C" {
// The linker script puts ram_begin and ram_end at whole megabytes.
extern char ram_begin, ram_end;

/// The first-level table, with one word for each megabyte.
alignas(16384) __attribute__((section(".noinit"))) std::uint32_t translation_table[4096];

void map_memory() {
    constexpr std::uint32_t section = 2, read_write = 3u << 10, cached = 1u << 12 | 1u << 3 | 1u << 2,
                            device = 1u << 4 | 1u << 2; // memory of devices, not executable
    const auto megabyte = [](const void* p) { return reinterpret_cast<std::uintptr_t>(p) >> 20; };
    for (std::uint32_t i = 0; i < 4096; ++i)
        translation_table[i] = i << 20 | section | read_write |
                               (i >= megabyte(&ram_begin) && i < megabyte(&ram_end) ? cached : device);
    translation_table[megabyte(&stack_bottom) - 1] = 0;

    constexpr std::uint32_t client_of_domain_0 = 1, mmu = 1u << 0, data_cache = 1u << 2,
                            instruction_cache = 1u << 12;
    std::uint32_t control;
    asm volatile("mcr p15, 0, %0, c2, c0, 0\n" // TTBR0
                 "mcr p15, 0, %1, c3, c0, 0\n" // DACR
                 "mcr p15, 0, %2, c8, c7, 0\n" // TLBIALL
                 "mcr p15, 0, %2, c7, c5, 0\n" // ICIALLU
                 "dsb\nisb"
                 :
                 : "r"(translation_table), "r"(client_of_domain_0), "r"(0)
                 : "memory");
    asm volatile("mrc p15, 0, %0, c1, c0, 0" : "=r"(control)); // SCTLR
    control |= mmu | data_cache | instruction_cache;
    asm volatile("mcr p15, 0, %0, c1, c0, 0\nisb" : : "r"(control) : "memory");
}

[[noreturn]] void spangle_start() {
    map_memory();
    spangle::mcu::start_program();
}

/// `kind`: 0 undefined instruction, 1 prefetch abort, 2 data abort.
[[noreturn]] void spangle_fault(std::uint32_t pc, std::uint32_t kind) {
    using namespace spangle::mcu;
    std::uint32_t status = 0, address = 0;
    if (kind == 1)
        asm volatile("mrc p15, 0, %0, c5, c0, 1" : "=r"(status)); // IFSR
    if (kind == 2)
        asm volatile("mrc p15, 0, %0, c5, c0, 0\nmrc p15, 0, %1, c6, c0, 0" // DFSR, DFAR
                     : "=r"(status), "=r"(address));
    const std::uintptr_t bottom = reinterpret_cast<std::uintptr_t>(&stack_bottom);
    const bool below = kind == 2 && address < bottom && address >= bottom - 0x100000;
    panic({below ? Cause::stack_overflow : Cause::fault, pc, status});
}

[[noreturn]] void spangle_unexpected() {
    spangle::mcu::panic({spangle::mcu::Cause::interrupt, 0, 0});
}
}
