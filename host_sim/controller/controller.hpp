// A display controller of any family, as its bus and a viewer of its glass see it. It takes pins and bytes,
// gives answers and a picture, and records which rules of its protocol were broken.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <spangle/sim/violations.hpp>

namespace spangle::sim {

struct MemorySize {
    int width = 0, height = 0;
};

/// The part of the frame memory that the glass of a module covers. Offsets count columns and rows of the
/// memory.
struct GlassMount {
    int x = 0, y = 0, width = 0, height = 0;
    bool mirror_columns = false, mirror_rows = false; ///< mirrored, seen from the front
    bool bgr_filter = false;                          ///< the colour filter's stripes are blue, green, red
    bool normally_inverted = false;                   ///< IPS glass shows the complement unless INVON is set
    bool round = false;                               ///< only a disc of the glass can be seen
};

/// A colour of 18 bits, six bits each component.
struct Rgb666 {
    std::uint8_t r = 0, g = 0, b = 0;
    friend bool operator==(const Rgb666&, const Rgb666&) = default;
};

class Controller {
  public:
    Controller(const char* name, const GlassMount& glass) : glass_(glass), name_(name) {}
    virtual ~Controller() = default;

    // --- pins of the controller
    virtual void reset(bool low, Time now) = 0;
    virtual void select(bool chip_select, Time now) = 0;
    /// Takes one byte from the bus. `data` is D/C as sampled with the last bit; `period_ns` is the period of
    /// the clock that carried the byte.
    virtual void write(std::uint8_t byte, bool data, Time now, unsigned period_ns) = 0;
    /// Whether a read command is being answered, so that the controller drives its data line.
    virtual bool answers() const { return false; }
    /// Drives the next bit onto the line; the host then takes the bit with read_clock().
    virtual bool drive_bit() { return false; }
    virtual void read_clock(Time, unsigned) {}
    /// Drives bits and clocks them out. A byte is eight clocks of a serial bus, one clock of a parallel bus.
    bool read_bit(Time now, unsigned period_ns);
    std::uint8_t read_byte(Time now, unsigned period_ns);
    virtual bool te(Time) { return false; }

    // --- what a viewer and a test can see
    /// What a viewer in front of the glass sees at `now`, top row first.
    virtual std::vector<Rgb666> glass(Time now) = 0;
    /// The frame memory, in its own order of rows and columns.
    virtual std::vector<Rgb666> cells() const = 0;
    virtual MemorySize memory_size() const = 0;
    /// Nanoseconds of one scanned line, and of a whole scan.
    virtual Time line_time() const = 0;
    virtual Time refresh_time() const = 0;
    const GlassMount& mount() const { return glass_; }

    const Violations& violations() const { return violations_; }
    /// All violations as text, one line each.
    std::string violations_text() const;
    void report(Rule rule, const std::string& text, Time at);
    void forget_violations() { violations_.clear(); }

  protected:
    GlassMount glass_;

  private:
    const char* name_;
    Violations violations_;
};

/// The contents of memory at power-on, which no datasheet promises. Noise makes a forgotten clear visible.
class PowerOnNoise {
  public:
    std::uint32_t next() { return state_ = state_ * 1664525u + 1013904223u; }

  private:
    std::uint32_t state_ = 12345;
};

/// A byte as datasheets write it, such as "2Ch".
std::string hex_text(unsigned v);

} // namespace spangle::sim
