// What `spangle trade` asks of a program's frames: each whole, with its depth, its coverage and its time, and
// at the end how far the stages were off.
#pragma once

#include <cstdint>
#include <memory>

#include <spangle/reference.hpp>

#include "host_sim/capture/capture_file.hpp"
#include "host_sim/capture/frame_watch.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {
struct Context;
}

namespace spangle::dropin {

class Capture {
  public:
    /// The program's only one; null where nobody asked for a capture.
    static Capture* get();
    /// Writes the file, where there is one.
    static void finish_if_any();

    /// A context that was made now: what it draws is watched. Stages are those of the thread that makes it.
    void watch(gl::Context& context);
    /// A picture is finished. It is a frame where anything was drawn to it since the last; the program ends
    /// after the last frame that was asked for.
    void take(const raster::Surface& picture);
    /// A function was called that Spangle does not have.
    void miss() { missed_ = true; }

  private:
    Capture();
    void finish();

    trade::CaptureWriter file_;
    trade::FrameWatch frames_;
    raster::Counters counters_;
    std::unique_ptr<StageReport> stages_;
    std::uint64_t taken_ = 0;
    double begun_ = 0; ///< microseconds of this thread when the last frame was taken
    bool missed_ = false, finished_ = false;
};

} // namespace spangle::dropin
