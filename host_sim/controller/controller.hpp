// A display controller as its bus and the person in front of the glass see it, whatever its family: pins and
// bytes in, answers and a picture out, and the rules of its protocol that were broken.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <spangle/sim/violations.hpp>

namespace spangle::sim {

struct MemorySize {
    int width = 0, height = 0;
};

/// The part of the frame memory that glass covers, as the module's maker glued it. Offsets count in memory
/// columns and rows.
struct GlassMount {
    int x = 0, y = 0, width = 0, height = 0;
    bool mirror_columns = false, mirror_rows = false; ///< seen from the front
    bool bgr_filter = false;                          ///< the colour filter's stripes are blue, green, red
    bool normally_inverted = false;                   ///< IPS: the glass shows the complement unless INVON
    bool round = false;                               ///< a disc is seen of it
};

/// 18-bit colour, six bits each.
struct Rgb666 {
    std::uint8_t r = 0, g = 0, b = 0;
    friend bool operator==(const Rgb666&, const Rgb666&) = default;
};

class Controller {
  public:
    Controller(const char* name, const GlassMount& glass) : glass_(glass), name_(name) {}
    virtual ~Controller() = default;

    // --- the pins
    virtual void reset(bool low, Time now) = 0;
    virtual void select(bool chip_select, Time now) = 0;
    /// One byte clocked in, `data`: D/C as sampled with its last bit; `period_ns`: of the clock that carried
    /// it.
    virtual void write(std::uint8_t byte, bool data, Time now, unsigned period_ns) = 0;
    /// A read command is being answered: the controller drives its data line.
    virtual bool answers() const { return false; }
    /// The next bit onto the line; the host then takes it with a clock of that period.
    virtual bool drive_bit() { return false; }
    virtual void read_clock(Time, unsigned) {}
    /// Both at once; a byte is eight clocks of a serial bus, one of a parallel one.
    bool read_bit(Time now, unsigned period_ns);
    std::uint8_t read_byte(Time now, unsigned period_ns);
    virtual bool te(Time) { return false; }

    // --- views
    /// What a person in front of the glass sees, top row first, at `now`.
    virtual std::vector<Rgb666> glass(Time now) = 0;
    /// The frame memory in its own order.
    virtual std::vector<Rgb666> cells() const = 0;
    virtual MemorySize memory_size() const = 0;
    /// Of one scanned line, and of a whole scan.
    virtual Time line_time() const = 0;
    virtual Time refresh_time() const = 0;
    const GlassMount& mount() const { return glass_; }

    const Violations& violations() const { return violations_; }
    /// All of them, a line each.
    std::string violations_text() const;
    void report(Rule rule, const std::string& text, Time at);
    void forget_violations() { violations_.clear(); }

  protected:
    GlassMount glass_;

  private:
    const char* name_;
    Violations violations_;
};

/// What memory holds at power-on is anybody's guess; noise makes a forgotten clear visible.
class PowerOnNoise {
  public:
    std::uint32_t next() { return state_ = state_ * 1664525u + 1013904223u; }

  private:
    std::uint32_t state_ = 12345;
};

/// As datasheets write bytes.
std::string hex(unsigned v);

} // namespace spangle::sim
