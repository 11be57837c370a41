// A program that is known by its calls alone, as a trace has them: a process of its own draws them, the same
// ones each time, in any format and precision.
#pragma once

#include <string>
#include <vector>

#include "host_sim/capture/capture_file.hpp"
#include "host_sim/trade/measure.hpp"

namespace spangle::trade {

class Recording {
  public:
    virtual ~Recording() = default;

    /// Size and frames become those that it has: frames are the first of it, as many as were wished if there
    /// are so many. Empty, or why it cannot be drawn.
    virtual std::string settle(Setting& setting) = 0;
    /// Draws it. Empty, or why not.
    virtual std::string capture(PixelFormat format, EGLint precision, const Setting& setting,
                                CaptureReader& out) = 0;
    /// As frame_times().
    virtual std::vector<double> times(const std::vector<Tier>& chosen, const Format& format,
                                      const Setting& setting) = 0;
};

/// What measure() does with one.
Measured measure_recording(const Program& program, const Tier& tier, const Format& format,
                           const Setting& setting);

} // namespace spangle::trade
