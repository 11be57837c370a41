#include "tests/unit/hal_kernel/line_trace.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tests/unit/hal_kernel/files.hpp"

namespace kernel_test {
namespace {

using spangle::sim::Time;

const std::string tracing = "/sys/kernel/tracing/";
/// Least nanoseconds between two changes. The trace tells microseconds, and the machine's load decides how
/// fast lines are clocked, so the times are spread until they are slower than any panel's clock. (Open drain
/// is I2C, with three changes a bit.)
constexpr Time apart = 200, apart_open_drain = 1000;

void set(const char* file, const char* text) {
    write_text(tracing + file, text);
}

} // namespace

LineTrace::LineTrace(const SimChip& chip, std::vector<unsigned> open_drain)
    : first_(chip.first_number()), open_drain_(std::move(open_drain)) {
    set("tracing_on", "0");
    set("trace_clock", "mono"); // the default clock counts ticks of 10 ms here
    set("buffer_size_kb", "24576");
    set("trace", "0");
    set("events/gpio/gpio_value/enable", "1");
    set("events/gpio/gpio_direction/enable", open_drain_.empty() ? "0" : "1");
    set("tracing_on", "1");
}

LineTrace::~LineTrace() {
    set("events/gpio/enable", "0");
    set("buffer_size_kb", "4");
}

/// Parses "  test_hal_-34  [000] .....  12.345678: gpio_value: 512 set 1", or "gpio_direction: 512  in (0)",
/// which is all that an open-drain line shows. Returns false for an input that was read, and for lines
/// without a GPIO.
bool LineTrace::parse(const std::string& text, LineChange& change) const {
    const std::size_t at = text.find(": gpio_");
    if (at == std::string::npos)
        return false;
    char event[16], what[4];
    unsigned number, level = 0;
    unsigned long long seconds, micros;
    if (std::sscanf(text.c_str() + at, ": %15[a-z_]: %u %3s %u", event, &number, what, &level) < 3 ||
        std::sscanf(text.c_str() + text.rfind(' ', at), "%llu.%llu:", &seconds, &micros) != 2)
        throw std::runtime_error("a trace of another form: " + text);
    const std::string kind = event, word = what;
    const bool direction = kind == "gpio_direction";
    if (number < first_ || (!direction && word != "set"))
        return false;
    const unsigned line = number - first_;
    const bool drains = std::find(open_drain_.begin(), open_drain_.end(), line) != open_drain_.end();
    change = {line, direction ? word == "in" : level != 0, (seconds * 1'000'000 + micros) * 1000};
    return direction == drains;
}

std::vector<LineChange> LineTrace::take() {
    set("tracing_on", "0");
    std::istringstream text(read_text(tracing + "trace"));
    const std::string statistics = read_text(tracing + "per_cpu/cpu0/stats");
    if (statistics.find("overrun: 0\n") == std::string::npos)
        throw std::runtime_error("the trace lost events:\n" + statistics);
    set("trace", "0");
    set("tracing_on", "1");
    const Time least = open_drain_.empty() ? apart : apart_open_drain;
    std::vector<LineChange> changes;
    LineChange change;
    for (std::string line; std::getline(text, line);)
        if (parse(line, change)) {
            change.time = last_ = std::max(change.time, last_ + least);
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
