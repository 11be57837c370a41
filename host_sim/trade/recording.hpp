// A program that is known by its calls alone, as a trace has them. A process of its own makes the same calls
// each time, in any format and precision.
#pragma once

#include <string>
#include <vector>

#include "host_sim/capture/capture_file.hpp"
#include "host_sim/trade/measure.hpp"

namespace spangle::trade {

class Recording {
  public:
    virtual ~Recording() = default;

    /// Sets the size to that of the program, and the number of frames to at most the number it has. The first
    /// frames are used. Returns why it cannot be drawn, or an empty string.
    virtual std::string settle(Setting& setting) = 0;
    /// Draws the program into a capture. Returns what went wrong, or an empty string.
    virtual std::string capture(PixelFormat format, EGLint precision, const Setting& setting,
                                CaptureReader& out) = 0;
    /// Microseconds of a frame in each tier, as frame_times() returns them.
    virtual std::vector<double> times(const std::vector<Tier>& chosen, const Format& format,
                                      const Setting& setting) = 0;
};

/// Measures a recorded program, as measure() measures others.
Measured measure_recording(const Program& program, const Tier& tier, const Format& format,
                           const Setting& setting);

} // namespace spangle::trade
