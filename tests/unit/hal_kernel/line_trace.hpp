// Records what lines did, in the kernel's own order. gpiolib writes the trace event gpio_value for each line
// of each call, from the character device or from spi-gpio.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bus/pin_header.hpp"
#include "tests/unit/hal_kernel/sim_chip.hpp"

namespace kernel_test {

struct LineChange {
    unsigned line;
    bool level;
    spangle::sim::Time time; ///< in nanoseconds; no two changes have one time
};

class LineTrace {
  public:
    /// Traces this chip from now on. Lines of `open_drain` are low, or released and then high.
    explicit LineTrace(const SimChip& chip, std::vector<unsigned> open_drain = {});
    ~LineTrace();
    LineTrace(const LineTrace&) = delete;
    LineTrace& operator=(const LineTrace&) = delete;

    /// Returns what was driven since the last call. Throws an error if the kernel had no room for all of it.
    std::vector<LineChange> take();

  private:
    unsigned first_;
    std::vector<unsigned> open_drain_;
    spangle::sim::Time last_ = 0;

    bool parse(const std::string& text, LineChange& change) const;
};

/// Shows the changes to what is connected to a header. `levels` has all lines, before and after.
void replay(const std::vector<LineChange>& changes, spangle::sim::PinHeader& header, std::uint64_t& levels);

} // namespace kernel_test
