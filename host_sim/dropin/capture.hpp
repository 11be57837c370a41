// Writes the file from which `spangle trade` judges a program: each whole frame with its depth, coverage and
// time, and at the end how far the stages were off.
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
    /// The only capture of the program; null where nobody asked for one.
    static Capture* get();
    /// Completes the file, if a capture was asked for.
    static void finish_if_any();

    /// Watches what a new context draws. The stages are those of the thread that makes the context.
    void watch(gl::Context& context);
    /// Takes a finished picture. It counts as a frame if anything was drawn since the picture before. The
    /// program ends after the last frame that was asked for.
    void take(const raster::Surface& picture);
    /// Notes that the program called a function which Spangle does not have.
    void note_missing_function() { has_missing_function_ = true; }

  private:
    Capture();
    void finish();

    trade::CaptureWriter file_;
    trade::FrameWatch frames_;
    raster::Counters counters_;
    std::unique_ptr<StageReport> stages_;
    std::uint64_t frame_count_ = 0;
    double frame_begin_us_ = 0; ///< us of this thread's time, when the last frame was taken
    bool has_missing_function_ = false, is_finished_ = false;
};

} // namespace spangle::dropin
