#include "host_sim/bus/trace.hpp"

#include <algorithm>
#include <iterator>

namespace spangle::sim {
namespace {

/// No byte, message or edge takes more bytes of the file, nor does the comment that ends a full dump.
constexpr std::uint64_t longest_entry = 1024;

} // namespace

VcdFile::VcdFile(const std::string& path, hal::BusKind bus, std::uint64_t most_bytes)
    : bus_(bus), byte_limit_(most_bytes) {
    std::fill(std::begin(levels_), std::end(levels_), static_cast<signed char>(-1));
    problem_ = file_.open(path);
    if (!problem_.empty())
        return;
    write("$timescale 1ns $end\n$scope module display $end\n");
    // All wires are declared before the first level of a wire is written.
    struct Named {
        char wire;
        const char* name;
        bool high;
    };
    constexpr Named serial[] = {
        {cs, "CS", true}, {dc, "DC", false}, {clock, "SCK", false}, {line, "SDA", false}};
    constexpr Named started[] = {{cs, "CS", true}, {clock, "SCK", false}, {line, "SDA", false}};
    constexpr Named two[] = {{clock, "SCL", true}, {line, "SDA", true}};
    constexpr Named wide[] = {{cs, "CS", true},   {dc, "DC", false},  {clock, "WR", true}, {'A', "D0", false},
                              {'B', "D1", false}, {'C', "D2", false}, {'D', "D3", false},  {'E', "D4", false},
                              {'F', "D5", false}, {'G', "D6", false}, {'H', "D7", false}};
    const auto declare = [this](const auto& wires) {
        for (const Named& w : wires)
            write(std::string("$var wire 1 ") + w.wire + " " + w.name + " $end\n");
        write(std::string("$var wire 1 ") + static_cast<char>(rst) +
              " RST $end\n$upscope $end\n$enddefinitions $end\n#0\n");
        for (const Named& w : wires)
            set(w.wire, w.high);
        set(rst, true);
    };
    switch (bus_) {
    case hal::BusKind::i8080:
        declare(wide);
        break;
    case hal::BusKind::i2c:
        declare(two);
        break;
    case hal::BusKind::spi_start:
        declare(started);
        break;
    default:
        declare(serial);
        break;
    }
}

/// Whether another entry fits into the file. The first entry that does not fit ends the dump with a comment
/// that says so.
bool VcdFile::has_room() {
    if (is_full_ || !file_.is_open())
        return false;
    is_full_ = file_.size() + longest_entry > byte_limit_;
    if (is_full_)
        write("$comment stopped here: the file has reached its limit $end\n");
    return !is_full_;
}

/// Writes a moment that is later than the last one. Moments never go back, though clocks are rounded whose
/// period is no whole number of nanoseconds.
void VcdFile::write_time(Time t) {
    if (t <= last_event_)
        return;
    write("#" + std::to_string(t) + "\n");
    last_event_ = t;
}

void VcdFile::set(char wire, bool high) {
    signed char& level = levels_[static_cast<unsigned char>(wire)];
    if (level == (high ? 1 : 0))
        return;
    level = high ? 1 : 0;
    const char text[] = {high ? '1' : '0', wire, '\n'};
    write({text, sizeof text});
}

/// Writes one bit: the line changes while the clock is low, and stands still while the clock is high.
void VcdFile::write_clocked_byte(Time begin, unsigned period_ns, bool high) {
    write_time(begin);
    set(clock, false);
    if (is_i2c()) // a change at the clock's edge could look like the end of a message
        write_time(begin + period_ns / 8);
    set(line, high);
    write_time(begin + period_ns / 2);
    set(clock, true);
}

void VcdFile::parallel(Time begin, unsigned period_ns, std::uint8_t value) {
    set(clock, false);
    for (int bit = 0; bit < 8; ++bit)
        set(static_cast<char>(first_line + bit), (value >> bit & 1) != 0);
    write_time(begin + period_ns / 2);
    set(clock, true);
}

void VcdFile::byte(Time begin, unsigned period_ns, bool data, std::uint8_t value, bool heard) {
    if (!has_room())
        return;
    write_time(begin);
    if (bus_ == hal::BusKind::spi4 || bus_ == hal::BusKind::i8080)
        set(dc, data);
    if (bus_ == hal::BusKind::i8080)
        return parallel(begin, period_ns, value);
    for (int bit = 7; bit >= 0; --bit)
        write_clocked_byte(begin + static_cast<Time>(7 - bit) * period_ns, period_ns,
                           (value >> bit & 1) != 0);
    if (is_i2c()) // the target that heard the byte pulls the line low
        write_clocked_byte(begin + Time{8} * period_ns, period_ns, !heard);
}

/// Writes START: the line falls while the clock is high (UM10204, 3.1.4).
void VcdFile::start(Time begin, unsigned period_ns) {
    if (!has_room())
        return;
    write_time(begin + period_ns / 2);
    set(line, false);
}

/// Writes STOP: the line rises while the clock is high.
void VcdFile::stop(Time begin, unsigned period_ns) {
    if (!has_room())
        return;
    write_clocked_byte(begin, period_ns, false);
    write_time(begin + period_ns * 3 / 4);
    set(line, true);
}

void VcdFile::chip_select(Time t, bool selected) {
    if (!has_room())
        return;
    write_time(t);
    if (!selected && bus_ != hal::BusKind::i8080)
        set(clock, false);
    set(cs, !selected);
}

void VcdFile::reset(Time t, bool low) {
    if (!has_room())
        return;
    write_time(t);
    set(rst, !low);
}

/// Readers take a level for one that lasts until the next moment. Without a last moment they would not see
/// the last edge.
std::string VcdFile::commit() {
    constexpr Time moment = 1000;
    if (file_.is_open())
        write_time(last_event_ + moment);
    return file_.commit();
}

} // namespace spangle::sim
