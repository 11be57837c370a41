// On hardware nobody listens to reports. The scenes follow each other for ever; if the display did not
// answer, the next scene tries again.
#include "boards/demo/report.hpp"

#include <spangle/mcu/panic.hpp>

namespace spangle::demo {

Watcher& watcher() {
    static class Nobody final : public Watcher {
    } nobody;
    return nobody;
}

int frames_to_show() {
    return 180;
}

void begin(const scenes::Scene&) {}

void end(const char*) {}

bool again() {
    return true;
}

} // namespace spangle::demo

namespace spangle::mcu {

/// A debugger finds the cause of the last panic here. A product would reset instead.
volatile Panic last_panic;

[[noreturn]] void panic(const Panic& panic) {
    last_panic.cause = panic.cause;
    last_panic.pc = panic.pc;
    last_panic.status = panic.status;
    for (;;)
        asm volatile("wfi");
}

} // namespace spangle::mcu
