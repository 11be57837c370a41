// Where frames go: to a simulated board, to a real display, or nowhere; and what is told about them when the
// program ends.
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
    /// The program's only one, made when it is first asked for.
    static Stage& get();
    /// What finish() does, where there is one.
    static void finish_if_any();

    bool has_board() const { return target_.display() != nullptr; }
    /// What windows get: SPANGLE_SIZE, or the glass's size; 0: they keep theirs.
    Size window_size() const;
    /// Pixels that windows have.
    PixelFormat format() const { return format_; }
    /// A frame of a window or of a pbuffer was swapped. After the last one that was asked for the program
    /// ends.
    void show(const hal::Frame& frame, const hal::DisplayInfo& info);
    /// What is to be seen: the simulated glass, or the last frame.
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
    sim::Image last_;
    long frames_ = 0;
    bool finished_ = false;
    raster::Counters counters_;
    std::uint64_t triangles_ = 0, fragments_ = 0;
};

} // namespace spangle::dropin
