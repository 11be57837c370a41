#include "host_sim/profile/firmware/lines.hpp"

#include <cstdint>
#include <initializer_list>

#include <spangle/mcu/semihosting.hpp>
#include <spangle/mcu/systick.hpp>

extern "C" void measure_nothing(); // nothing_called.cpp, behind a trampoline like a command

namespace spangle::measure {

namespace {

struct Line {
    std::uint32_t address, command, calls;
    std::uint64_t ticks;
};
constexpr std::uint32_t places = 1024, deepest = 16; ///< a power of two; calls within calls

struct Call {
    std::uint32_t address, command, begin;
};

struct Counts {
    Line line[places];
    Call call[deepest];
    std::uint32_t depth, lost;
    bool on;
};
Counts counts;

std::uint32_t now() {
    return mcu::reg(mcu::SysTick::current);
}

/// The line of an address and a command, or null where there is no place for one more.
Line* find(std::uint32_t address, std::uint32_t command) {
    for (std::uint32_t i = 0; i < places; ++i) {
        Line& line = counts.line[((address >> 1) * 2654435761u + command + i) % places];
        if (line.calls == 0)
            line.address = address, line.command = command;
        if (line.address == address && line.command == command)
            return &line;
    }
    return nullptr;
}

} // namespace

void begin_frame() {
    counts.on = true;
    for (int i = 0; i < 256; ++i)
        measure_nothing();
}

void end_frame() {
    counts.on = false;
}

void print_lines() {
    namespace semihosting = mcu::semihosting;
    for (const Line& line : counts.line) {
        if (line.calls == 0)
            continue;
        semihosting::print("line");
        for (const std::uint32_t number :
             {line.address, line.command, line.calls, static_cast<std::uint32_t>(line.ticks)}) {
            semihosting::print(" ");
            semihosting::print_number(number);
        }
        semihosting::print("\n");
    }
    if (counts.lost != 0)
        semihosting::print("lost\n");
}

std::size_t line_bytes() {
    return sizeof counts;
}

} // namespace spangle::measure

// The trampolines that measure.py writes call these around each command.
extern "C" {

void measure_begin(std::uint32_t address, std::uint32_t command) {
    using namespace spangle::measure;
    Call& call = counts.call[counts.depth % deepest];
    ++counts.depth;
    call.address = address;
    call.command = command;
    call.begin = now();
}

/// Where the command returns to. Commands that call others count for themselves alone.
std::uint32_t measure_end() {
    using namespace spangle::measure;
    const std::uint32_t end = now();
    --counts.depth;
    const Call& call = counts.call[counts.depth % deepest];
    if (counts.on && counts.depth == 0) {
        if (Line* const line = find(call.address & ~1u, call.command); line != nullptr) {
            ++line->calls;
            line->ticks += (call.begin - end) & spangle::mcu::SysTick::most_ticks; // it counts down
        } else {
            ++counts.lost;
        }
    }
    return call.address;
}
}
