// Cortex-M: vectors, reset, faults. The program runs on the process stack. Overflowing it is a fault: of the
// limit register (Armv8-M), of the MPU (Armv7-M), or of the bus, because RAM begins with it (Armv6-M). The
// handler has a stack of its own.
#include <cstdint>

#include "hal/mcu/start.hpp"
#include <spangle/mcu/registers.hpp>

extern "C" {
extern std::uint32_t handler_stack_top;

#if defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__)
extern char stack_low; // the stack's guard lies from here to stack_bottom

/// One region without access over the guard; the rest of memory stays as it is (Armv7-M ARM, B3.5).
static void close_stack_guard() {
    using spangle::mcu::reg;
    constexpr std::uintptr_t type = 0xE000ED90, control = 0xE000ED94, base = 0xE000ED9C,
                             attributes = 0xE000EDA0;
    constexpr std::uint32_t regions = 0xFF00, valid = 1u << 4, never_execute = 1u << 28, enable = 1u << 0,
                            background = 1u << 2;
    const auto low = reinterpret_cast<std::uintptr_t>(&stack_low);
    const std::uintptr_t size = reinterpret_cast<std::uintptr_t>(&stack_bottom) - low;
    if (size < 32 || (reg(type) & regions) == 0)
        return;
    reg(base) = low | valid;
    reg(attributes) = never_execute | static_cast<std::uint32_t>(__builtin_ctz(size) - 1) << 1 | enable;
    reg(control) = enable | background;
    asm volatile("dsb\nisb" : : : "memory");
}
#else
static void close_stack_guard() {}
#endif

[[noreturn, gnu::used]] void spangle_start() {
    close_stack_guard();
    spangle::mcu::start_program();
}

/// `frame`: the registers that the processor pushed: r0-r3, r12, lr, pc, xPSR (Armv7-M ARM, B1.5.6).
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
