// Cortex-M: vectors, reset, faults. The program runs on the process stack, which ends where RAM begins (or
// at its limit register): overflowing it is a fault, and the handler has a stack of its own.
#include <cstdint>

#include "hal/mcu/start.hpp"
#include <spangle/mcu/registers.hpp>

extern "C" {
extern std::uint32_t handler_stack_top;

[[noreturn, gnu::used]] void spangle_start() {
    spangle::mcu::start_program();
}

/// `frame`: what the processor pushed: r0-r3, r12, lr, pc, xPSR (Armv7-M ARM, B1.5.6).
[[noreturn, gnu::used]] void spangle_fault(const std::uint32_t* frame) {
    using namespace spangle::mcu;
    std::uint32_t status = 0, stack_limit_passed = 0;
#if __ARM_ARCH >= 7
    constexpr std::uintptr_t cfsr = 0xE000ED28;
    status = reg(cfsr);
    stack_limit_passed = status & 1u << 20; // UFSR.STKOF
#endif
    if (stack_limit_passed != 0 || frame < &stack_bottom)
        panic({Cause::stack_overflow, 0, status});
    panic({Cause::fault, frame + 8 <= &stack_top ? frame[6] : 0, status});
}

[[noreturn, gnu::naked]] void reset_handler() {
    asm volatile("ldr r0, =stack_top\n"
                 "msr psp, r0\n"
#if defined(__ARM_ARCH_8M_MAIN__) || defined(__ARM_ARCH_8_1M_MAIN__)
                 "ldr r0, =stack_bottom\n"
                 "msr psplim, r0\n"
#endif
                 "movs r0, #2\n" // SPSEL: the process stack
                 "msr control, r0\n"
                 "isb\n"
                 "bl spangle_start\n"
                 ".ltorg");
}

[[noreturn, gnu::naked]] void fault_handler() {
    asm volatile("mrs r0, psp\n"
                 "bl spangle_fault");
}

[[noreturn]] void unexpected_handler() {
    spangle::mcu::panic({spangle::mcu::Cause::interrupt, 0, 0});
}

using Handler = void (*)();
struct Vectors {
    std::uint32_t* stack;
    Handler handler[15];
};
extern const Vectors vectors;
__attribute__((section(".vectors"), used))
const Vectors vectors = {&handler_stack_top,
                         {reset_handler, unexpected_handler, fault_handler, fault_handler, fault_handler,
                          fault_handler, fault_handler, nullptr, nullptr, nullptr, unexpected_handler,
                          unexpected_handler, nullptr, unexpected_handler, unexpected_handler}};
}
