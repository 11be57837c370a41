// The file that carries frames from the process that draws them to the process that judges them. Both
// processes run on one machine and come from one build, so numbers are stored as they lie in memory.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <spangle/reference.hpp>

#include "host_sim/capture/drawn_frame.hpp"
#include "host_sim/output/output.hpp"

namespace spangle::trade {

/// What is known after the last frame.
struct CaptureEnd {
    std::uint64_t frames = 0;
    std::uint64_t mismatches = 0;   ///< pixels whose coverage differs from that of brute force
    std::vector<StageError> stages; ///< errors of the stages, from shadow precisions
    std::string missed;             ///< function of a later OpenGL that was called; empty: none
};

/// Writes a capture file. The file has its name only once finish() was called, so that a process that dies
/// leaves no file.
class CaptureWriter {
  public:
    /// Opens the file. Returns why nothing can be written there, or an empty string.
    std::string open(const std::string& path);
    /// Adds a frame, and the microseconds of processor time that it took. A frame without a picture carries
    /// only the time.
    void add(const DrawnFrame& frame, double microseconds);
    std::string finish(const CaptureEnd& end);

  private:
    sim::Output file_;
};

class CaptureReader {
  public:
    /// Opens the file. Returns why it is no capture file, or an empty string.
    std::string open(const std::string& path);
    /// Reads the next frame. Returns false where no frame is left, so that end() is known, or where the file
    /// is broken.
    bool next(DrawnFrame& frame, double& microseconds);
    const CaptureEnd& end() const { return end_; }
    /// Whether the end was found.
    bool whole() const { return is_complete_; }

  private:
    std::ifstream file_;
    CaptureEnd end_;
    bool is_complete_ = false;

    bool read_end();
};

} // namespace spangle::trade
