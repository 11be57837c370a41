// Passes whole frames to a display that keeps track of damage, for builds that do not tell what was drawn.
#pragma once

#include <spangle/hal/display.hpp>

namespace spangle::cli {

class WholeFrames final : public hal::Display {
  public:
    explicit WholeFrames(hal::Display& display) : display_(display) {}

    hal::DisplayInfo info() const override { return display_.info(); }
    hal::Result<void> init() override { return display_.init(); }
    /// Marks the whole frame as drawn, whatever the program draws of it.
    hal::Result<hal::Frame> acquire() override {
        hal::Result<hal::Frame> frame = display_.acquire();
        if (!frame || frame.value().extents == nullptr)
            return frame;
        const hal::DisplayInfo info = display_.info();
        for (std::int32_t y = 0; y < info.height; ++y)
            frame.value().extents->rows[y] = {0, static_cast<std::int16_t>(info.width)};
        hal::Frame whole = frame.value();
        whole.extents = nullptr;
        return whole;
    }
    hal::Result<void> present() override { return display_.present(); }
    hal::Result<void> finish() override { return display_.finish(); }
    void swap_interval(std::int32_t interval) override { display_.swap_interval(interval); }

  private:
    hal::Display& display_;
};

} // namespace spangle::cli
