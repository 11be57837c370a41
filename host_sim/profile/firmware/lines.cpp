// Counts every call of GL by the address that it returns to. Prints a line "line ADDRESS COMMAND CALLS TICKS"
// for each such address, and "line 0 0 CALLS TICKS" for calls that found no place in the table.
#include "host_sim/profile/firmware/counting.hpp"

#include <cstdint>
#include <initializer_list>

#include MEASURE_BOARD

extern "C" void measure_nothing(); // defined in nothing_called.cpp, behind a trampoline like a command

namespace spangle::measure {

namespace {

struct Line {
    std::uint32_t address, command, calls;
    std::uint64_t ticks;
};
/// The entries of the table of lines, a power of two, and the most commands that call each other.
constexpr std::uint32_t places = 8192, deepest = 16;

struct Call {
    std::uint32_t address, command, begin;
};

struct Counts {
    Line line[places];
    Call call[deepest];
    std::uint32_t depth;
    Line lost; ///< calls that found no place in the table
    bool on;
};
Counts counts;

/// The line of an address and a command, or null where the table has no more place.
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

void tell(const Line& line) {
    if (line.calls == 0)
        return;
    print("line");
    for (const std::uint32_t number :
         {line.address, line.command, line.calls, static_cast<std::uint32_t>(line.ticks)}) {
        print(" ");
        print(number);
    }
    print("\n");
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

void print_counts() {
    for (const Line& line : counts.line)
        tell(line);
    tell(counts.lost);
}

std::size_t counting_bytes() {
    return sizeof counts;
}

} // namespace spangle::measure

// The trampolines that measure.py writes call these two functions around each command.
extern "C" {

void measure_begin(std::uint32_t address, std::uint32_t command) {
    using namespace spangle::measure;
    Call& call = counts.call[counts.depth % deepest];
    ++counts.depth;
    call.address = address;
    call.command = command;
    call.begin = now();
}

/// Returns the address to which the command returns. Only the outermost command counts; its ticks include
/// those of commands that it calls.
std::uint32_t measure_end() {
    using namespace spangle::measure;
    const std::uint32_t end = now();
    --counts.depth;
    const Call& call = counts.call[counts.depth % deepest];
    if (counts.on && counts.depth == 0) {
        Line* const found = find(call.address & ~1u, call.command);
        Line& line = found != nullptr ? *found : counts.lost;
        ++line.calls;
        line.ticks += ticks_between(call.begin, end);
    }
    return call.address;
}
}
