// Who listens to the wires, and the file for those who look at them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <spangle/hal/bus.hpp>
#include <spangle/sim/violations.hpp>

#include "host_sim/output/output.hpp"

namespace spangle::sim {

class Listener {
  public:
    virtual ~Listener() = default;
    /// I2C: `data` is what the bus makes of the bytes, no wire; eight bits, and the acknowledge of `heard`.
    virtual void byte(Time begin, unsigned period_ns, bool data, std::uint8_t value, bool heard) = 0;
    /// I2C: a message begins, and ends, one period long each.
    virtual void start(Time begin, unsigned period_ns) = 0;
    virtual void stop(Time begin, unsigned period_ns) = 0;
    virtual void chip_select(Time at, bool selected) = 0;
    virtual void reset(Time at, bool low) = 0;
};

/// Value change dump for GTKWave, PulseView and sigrok. 4-wire serial: CS DC SCK SDA RST; with start bytes:
/// CS SCK SDA RST; parallel: CS DC WR D0 to D7 RST; I2C: SCL SDA RST.
class VcdFile final : public Listener {
  public:
    /// Where a dump ends unless asked otherwise: some ten whole frames of 320x240.
    static constexpr std::uint64_t usual_limit = std::uint64_t{512} << 20;

    /// The dump ends before it is longer than `most_bytes`.
    VcdFile(const std::string& path, hal::BusKind bus, std::uint64_t most_bytes = usual_limit);
    /// Empty, or why nothing can be written there.
    const std::string& problem() const { return problem_; }
    /// The limit was reached, and then nothing more was written.
    bool is_full() const { return full_; }
    /// The last moment that something happened, before commit().
    Time end() const { return last_; }
    /// The file has its name from here on. Empty, or what went wrong.
    std::string commit();

    void byte(Time begin, unsigned period_ns, bool data, std::uint8_t value, bool heard) override;
    void start(Time begin, unsigned period_ns) override;
    void stop(Time begin, unsigned period_ns) override;
    void chip_select(Time at, bool selected) override;
    void reset(Time at, bool low) override;

  private:
    /// The wires by the character that names each in the file.
    enum Wire : char { cs = 'c', dc = 'd', rst = 'r', clock = 'k', line = 's', first_line = 'A' };

    Output file_;
    hal::BusKind bus_;
    std::uint64_t most_bytes_;
    std::string problem_;
    bool full_ = false;
    Time last_ = 0;
    signed char levels_[128]; ///< of each wire; -1: not told yet

    bool is_i2c() const { return bus_ == hal::BusKind::i2c; }
    bool room();
    void at(Time t);
    void set(char wire, bool high);
    void write(std::string_view text) { file_.write(text); }
    void clocked(Time begin, unsigned period_ns, bool high);
    void parallel(Time begin, unsigned period_ns, std::uint8_t value);
};

} // namespace spangle::sim
