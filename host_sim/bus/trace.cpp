#include "host_sim/bus/trace.hpp"

namespace spangle::sim {

VcdFile::VcdFile(const std::string& path, bool parallel)
    : file_(std::fopen(path.c_str(), "w")), parallel_(parallel) {
    if (file_ == nullptr)
        return;
    std::fputs(
        "$timescale 1ns $end\n$scope module display $end\n$var wire 1 c CS $end\n$var wire 1 d DC $end\n"
        "$var wire 1 r RST $end\n",
        file_);
    std::fputs(parallel_ ? "$var wire 1 w WR $end\n$var wire 8 b D $end\n"
                         : "$var wire 1 k SCK $end\n$var wire 1 s SDA $end\n",
               file_);
    std::fputs("$upscope $end\n$enddefinitions $end\n#0\n1c\n0d\n1r\n", file_);
    std::fputs(parallel_ ? "1w\nb00000000 b\n" : "0k\n0s\n", file_);
}

VcdFile::~VcdFile() {
    if (file_ != nullptr)
        std::fclose(file_);
}

void VcdFile::at(Time t) {
    if (t != last_)
        std::fprintf(file_, "#%llu\n", static_cast<unsigned long long>(t));
    last_ = t;
}

void VcdFile::byte(Time begin, unsigned period_ns, bool data, std::uint8_t value) {
    if (file_ == nullptr)
        return;
    at(begin);
    if (dc_ != (data ? 1 : 0))
        std::fprintf(file_, "%dd\n", dc_ = data ? 1 : 0);
    if (parallel_) {
        std::fputs("0w\nb", file_);
        for (int bit = 7; bit >= 0; --bit)
            std::fputc('0' + (value >> bit & 1), file_);
        std::fputs(" b\n", file_);
        at(begin + period_ns / 2);
        std::fputs("1w\n", file_);
        return;
    }
    for (int bit = 7; bit >= 0; --bit) {
        const Time start = begin + static_cast<Time>(7 - bit) * period_ns;
        at(start);
        const int level = value >> bit & 1;
        std::fputs("0k\n", file_);
        if (level != sda_)
            std::fprintf(file_, "%ds\n", sda_ = level);
        at(start + period_ns / 2);
        std::fputs("1k\n", file_);
    }
}

void VcdFile::chip_select(Time t, bool selected) {
    if (file_ == nullptr)
        return;
    at(t);
    std::fputs(selected ? "0c\n" : "1c\n", file_);
}

void VcdFile::reset(Time t, bool low) {
    if (file_ == nullptr)
        return;
    at(t);
    std::fputs(low ? "0r\n" : "1r\n", file_);
}

} // namespace spangle::sim
