// Sends frames to a simulated board, to a real display, or nowhere, and reports about them when the program
// ends.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/dropin/target.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::dropin {

class Stage {
  public:
    struct Size {
        std::int32_t width = 0, height = 0;
    };
    /// The only stage of the program, made when it is first asked for.
    static Stage& get();
    /// Does what finish() does, if there is a stage.
    static void finish_if_any();

    bool has_board() const { return target_.display() != nullptr; }
    /// The size in pixels that windows get: SPANGLE_SIZE, or that of the glass. 0: windows keep their own
    /// size.
    Size window_size() const;
    /// The pixel format of windows.
    PixelFormat format() const { return format_; }
    /// Takes a frame of a window or pbuffer that was swapped. The program ends after the last frame that was
    /// asked for.
    void show(const hal::Frame& frame, const hal::DisplayInfo& info);
    /// The picture on the simulated glass, or else the last frame.
    sim::Image picture() const;
    /// Writes the picture and the figures that were asked for.
    void finish();

    raster::Counters* counters() { return &counters_; }

  private:
    Stage();
    void send(const hal::Frame& frame, const hal::DisplayInfo& info);
    void write_report() const;

    Target target_;
    Size glass_;
    PixelFormat format_ = PixelFormat::rgba8888;
    sim::Image last_picture_;
    long frame_count_ = 0;
    bool is_finished_ = false;
    raster::Counters counters_;
    std::uint64_t triangle_count_ = 0, fragment_count_ = 0;
};

} // namespace spangle::dropin
