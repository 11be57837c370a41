// Listeners to the wires of a simulated bus, and the dump of the wires in a file.
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
    /// A byte was on the wire. On I2C the bus knows `data` from the bytes before, as there is no such wire;
    /// eight bits and the acknowledge `heard` are on the wire.
    virtual void byte(Time begin, unsigned period_ns, bool data, std::uint8_t value, bool heard) = 0;
    /// A message begins, and ends, on I2C; each takes one period.
    virtual void start(Time begin, unsigned period_ns) = 0;
    virtual void stop(Time begin, unsigned period_ns) = 0;
    virtual void chip_select(Time t, bool selected) = 0;
    virtual void reset(Time t, bool low) = 0;
};

/// A value change dump for GTKWave, PulseView and sigrok. Wires of 4-wire serial: CS DC SCK SDA RST; of
/// serial with start bytes: CS SCK SDA RST; of parallel: CS DC WR D0 to D7 RST; of I2C: SCL SDA RST.
class VcdFile final : public Listener {
  public:
    /// The most bytes of a dump unless asked otherwise, which hold some ten whole frames of 320x240.
    static constexpr std::uint64_t usual_limit = std::uint64_t{512} << 20;

    /// Opens the file of a dump, which ends before it is longer than `most_bytes`.
    VcdFile(const std::string& path, hal::BusKind bus, std::uint64_t most_bytes = usual_limit);
    /// Why nothing can be written to the file; empty if it can.
    const std::string& problem() const { return problem_; }
    /// Whether the limit was reached; nothing more was written from then on.
    bool is_full() const { return is_full_; }
    /// The last moment at which something happened, in ns, before commit().
    Time end() const { return last_event_; }
    /// Gives the file its name. Returns what went wrong, or an empty string.
    std::string commit();

    void byte(Time begin, unsigned period_ns, bool data, std::uint8_t value, bool heard) override;
    void start(Time begin, unsigned period_ns) override;
    void stop(Time begin, unsigned period_ns) override;
    void chip_select(Time t, bool selected) override;
    void reset(Time t, bool low) override;

  private:
    /// The wires, by the character that stands for each in the file.
    enum Wire : char { cs = 'c', dc = 'd', rst = 'r', clock = 'k', line = 's', first_line = 'A' };

    Output file_;
    hal::BusKind bus_;
    std::uint64_t byte_limit_;
    std::string problem_;
    bool is_full_ = false;
    Time last_event_ = 0;
    signed char levels_[128]; ///< level of each wire, 0 or 1; -1: not written yet

    bool is_i2c() const { return bus_ == hal::BusKind::i2c; }
    bool has_room();
    void write_time(Time t);
    void set(char wire, bool high);
    void write(std::string_view text) { file_.write(text); }
    void write_clocked_byte(Time begin, unsigned period_ns, bool high);
    void parallel(Time begin, unsigned period_ns, std::uint8_t value);
};

} // namespace spangle::sim
