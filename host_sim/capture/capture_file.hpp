// The file that carries frames from the process that draws them to the one that judges them. Both run on one
// machine, and are of one build: numbers lie in it as they lie in memory.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <spangle/reference.hpp>

#include "host_sim/capture/drawn_frame.hpp"
#include "host_sim/output/output.hpp"

namespace spangle::trade {

/// What is known when the last frame is drawn.
struct CaptureEnd {
    std::uint64_t frames = 0;
    std::uint64_t mismatches = 0;   ///< pixels whose coverage is not brute force's
    std::vector<StageError> stages; ///< of shadow precisions
    std::string missed;             ///< a function of later OpenGL that was called; empty: none
};

/// Writes such a file. It has its name once finish() was called, so a process that dies leaves none.
class CaptureWriter {
  public:
    /// Empty, or why nothing can be written there.
    std::string open(const std::string& path);
    /// A frame, and the microseconds of the processor that it took. Frames without a picture carry the time
    /// alone.
    void add(const DrawnFrame& frame, double microseconds);
    std::string finish(const CaptureEnd& end);

  private:
    sim::Output file_;
};

class CaptureReader {
  public:
    /// Empty, or why this is no such file.
    std::string open(const std::string& path);
    /// The next frame. False: there is none any more, and end() is known, or the file is broken.
    bool next(DrawnFrame& frame, double& microseconds);
    const CaptureEnd& end() const { return end_; }
    /// The end was found.
    bool whole() const { return whole_; }

  private:
    std::ifstream file_;
    CaptureEnd end_;
    bool whole_ = false;

    bool read_end();
};

} // namespace spangle::trade
