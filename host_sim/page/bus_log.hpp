// The first bytes of a frame on the bus, as commands with the bytes that follow each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/bus/trace.hpp"

namespace spangle::page {

class BusLog final : public sim::Listener {
  public:
    static constexpr std::size_t most_commands = 48, most_bytes = 12;

    struct Entry {
        std::uint8_t command;
        bool has_command; ///< false: pixels of a display that takes them without a command
        std::uint32_t bytes;
        std::uint8_t first[most_bytes];
    };

    void clear() {
        entries_.clear();
        bytes_ = commands_ = 0;
    }
    const std::vector<Entry>& entries() const { return entries_; }
    std::uint32_t bytes() const { return bytes_; }
    std::uint32_t commands() const { return commands_; }

    void byte(sim::Time, unsigned, bool data, std::uint8_t value, bool) override {
        ++bytes_;
        if (!data || bytes_ == 1) {
            commands_ += data ? 0 : 1;
            counting_ = entries_.size() < most_commands;
            if (counting_)
                entries_.push_back({data ? std::uint8_t{0} : value, !data, 0, {}});
        }
        if (!data || !counting_)
            return;
        Entry& last = entries_.back();
        if (last.bytes < most_bytes)
            last.first[last.bytes] = value;
        ++last.bytes;
    }
    void start(sim::Time, unsigned) override {}
    void stop(sim::Time, unsigned) override {}
    void chip_select(sim::Time, bool) override {}
    void reset(sim::Time, bool) override {}

  private:
    std::vector<Entry> entries_;
    std::uint32_t bytes_ = 0, commands_ = 0;
    bool counting_ = false;
};

} // namespace spangle::page
