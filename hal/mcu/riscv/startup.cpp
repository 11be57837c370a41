// RISC-V: the program, and traps (Privileged specification, 3.1.15).
#include <cstdint>

#include "hal/mcu/start.hpp"

extern "C" {

[[noreturn]] void spangle_start() {
    spangle::mcu::start_program();
}

[[noreturn]] void spangle_trap(std::uint32_t cause, std::uint32_t pc, std::uint32_t address) {
    using namespace spangle::mcu;
    constexpr std::uint32_t interrupt = 1u << 31, load_access = 5, store_access = 7;
    constexpr std::uintptr_t reach = 4096; // bytes that a function's frame may reach beyond the stack
    const std::uintptr_t bottom = reinterpret_cast<std::uintptr_t>(&stack_bottom);
    if ((cause & interrupt) != 0)
        panic({Cause::interrupt, pc, cause});
    const bool below =
        (cause == load_access || cause == store_access) && address < bottom && address >= bottom - reach;
    panic({below ? Cause::stack_overflow : Cause::fault, pc, cause});
}
}
