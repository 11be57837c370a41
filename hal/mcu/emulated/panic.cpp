// Ends a program in an emulator by semihosting: it prints the cause and sets the emulator's exit status, that
// of main() or 3.
#include <spangle/mcu/panic.hpp>
#include <spangle/mcu/semihosting.hpp>

namespace spangle::mcu {

[[noreturn]] void panic(const Panic& panic) {
    if (panic.cause == Cause::returned)
        semihosting::exit(static_cast<int>(panic.status));
    semihosting::print("panic: ");
    semihosting::print(name_of(panic.cause));
    semihosting::print(" at ");
    semihosting::print_hex(panic.pc);
    semihosting::print(", status ");
    semihosting::print_hex(panic.status);
    semihosting::print("\n");
    semihosting::exit(3);
}

} // namespace spangle::mcu
