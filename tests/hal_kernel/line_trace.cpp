#include "tests/hal_kernel/line_trace.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "tests/hal_kernel/files.hpp"

namespace kernel_test {
namespace {

using spangle::sim::Time;

const std::string tracing = "/sys/kernel/tracing/";
constexpr char event[] = "gpio_value: ";
/// The trace tells microseconds: what happened within one is spread by this, slower than any panel's clock.
constexpr Time apart = 200;

void set(const char* file, const char* text) {
    write_text(tracing + file, text);
}

/// "  test_hal_-34  [000] .....  12.345678: gpio_value: 512 set 1"; false: another event, or an input that
/// was read.
bool parse(const std::string& text, unsigned first, LineChange& change) {
    const std::size_t at = text.find(event);
    if (at == std::string::npos)
        return false;
    unsigned number, level;
    char direction[4];
    unsigned long long seconds, micros;
    if (std::sscanf(text.c_str() + at + sizeof event - 1, "%u %3s %u", &number, direction, &level) != 3 ||
        std::sscanf(text.c_str() + text.rfind(' ', at - 2), "%llu.%llu:", &seconds, &micros) != 2)
        throw std::runtime_error("a trace of another form: " + text);
    if (direction != std::string("set") || number < first)
        return false;
    change = {number - first, level != 0, (seconds * 1'000'000 + micros) * 1000};
    return true;
}

} // namespace

LineTrace::LineTrace(const SimChip& chip) : first_(chip.first_number()) {
    set("tracing_on", "0");
    set("trace_clock", "mono"); // the default counts ticks of 10 ms here
    set("buffer_size_kb", "24576");
    set("trace", "0");
    set("events/gpio/gpio_value/enable", "1");
    set("tracing_on", "1");
}

LineTrace::~LineTrace() {
    set("events/gpio/gpio_value/enable", "0");
    set("buffer_size_kb", "4");
}

std::vector<LineChange> LineTrace::take() {
    set("tracing_on", "0");
    std::istringstream text(read_text(tracing + "trace"));
    const std::string statistics = read_text(tracing + "per_cpu/cpu0/stats");
    if (statistics.find("overrun: 0\n") == std::string::npos)
        throw std::runtime_error("the trace lost events:\n" + statistics);
    set("trace", "0");
    set("tracing_on", "1");
    std::vector<LineChange> changes;
    LineChange change;
    for (std::string line; std::getline(text, line);)
        if (parse(line, first_, change)) {
            change.time = last_ = std::max(change.time, last_ + apart);
            changes.push_back(change);
        }
    return changes;
}

void replay(const std::vector<LineChange>& changes, spangle::sim::PinHeader& header, std::uint64_t& levels) {
    for (const LineChange& c : changes) {
        levels = (levels & ~(std::uint64_t{1} << c.line)) | std::uint64_t{c.level} << c.line;
        header.on_change(levels, c.time);
    }
}

} // namespace kernel_test
