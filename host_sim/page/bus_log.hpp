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
        byte_count_ = command_count_ = 0;
    }
    const std::vector<Entry>& entries() const { return entries_; }
    std::uint32_t bytes() const { return byte_count_; }
    std::uint32_t commands() const { return command_count_; }

    void byte(sim::Time, unsigned, bool data, std::uint8_t value, bool) override {
        ++byte_count_;
        if (!data || byte_count_ == 1) {
            command_count_ += data ? 0 : 1;
            is_counting_ = entries_.size() < most_commands;
            if (is_counting_)
                entries_.push_back({data ? std::uint8_t{0} : value, !data, 0, {}});
        }
        if (!data || !is_counting_)
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
    std::uint32_t byte_count_ = 0, command_count_ = 0;
    bool is_counting_ = false;
};

} // namespace spangle::page
