// What lines did, in the kernel's own order: the trace event gpio_value, which gpiolib writes for each line
// of each call, whoever makes it - the character device, or spi-gpio.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bus/pin_header.hpp"
#include "tests/hal_kernel/sim_chip.hpp"

namespace kernel_test {

struct LineChange {
    unsigned line;
    bool level;
    spangle::sim::Time time; ///< in nanoseconds; no two are at one time
};

class LineTrace {
  public:
    /// From now on, of this chip. Lines of `open_drain` are low, or let go of: then they are high.
    explicit LineTrace(const SimChip& chip, std::vector<unsigned> open_drain = {});
    ~LineTrace();
    LineTrace(const LineTrace&) = delete;
    LineTrace& operator=(const LineTrace&) = delete;

    /// What was driven since the last call; throws when the kernel had no room for all of it.
    std::vector<LineChange> take();

  private:
    unsigned first_;
    std::vector<unsigned> open_drain_;
    spangle::sim::Time last_ = 0;

    bool parse(const std::string& text, LineChange& change) const;
};

/// Lets what hangs on a header see the changes; `levels`: of all lines, before and after.
void replay(const std::vector<LineChange>& changes, spangle::sim::PinHeader& header, std::uint64_t& levels);

} // namespace kernel_test
