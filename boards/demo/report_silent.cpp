// Hardware: nobody listens. Scenes follow each other for ever; a display that did not answer is tried again
// with the next one.
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

/// For a debugger to find. A product would reset here.
volatile Panic last_panic;

[[noreturn]] void panic(const Panic& panic) {
    last_panic.cause = panic.cause;
    last_panic.pc = panic.pc;
    last_panic.status = panic.status;
    for (;;)
        asm volatile("wfi");
}

} // namespace spangle::mcu
