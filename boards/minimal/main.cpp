// The smallest useful program: start-up, one display, EGL, and a model that turns for ever.
#include "boards/minimal/rocket.hpp"
#include "boards/minimal/screen.hpp"

#include <spangle/mcu/panic.hpp>

int main() {
    using namespace spangle;
    if (!minimal::open(minimal::start()))
        return 1;
    for (unsigned step = 0; minimal::show(step); ++step) {
    }
    return 2;
}

/// Stops the processor after a fault, or when main() returned. A product would reset here.
[[noreturn]] void spangle::mcu::panic(const Panic&) {
    for (;;)
        asm volatile("wfi");
}
