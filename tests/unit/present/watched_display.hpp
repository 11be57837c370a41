// Wraps a board's display, and compares the panel's memory with the surface at every present.
#pragma once

#include <vector>

#include <gtest/gtest.h>
#include <spangle/hal/board.hpp>
#include <spangle/sim/board.hpp>

namespace spangle::test {

class WatchedDisplay final : public hal::Display {
  public:
    WatchedDisplay(sim::SimBoard& sim, const hal::Board& board) : sim_(sim), board_(board) {}

    hal::DisplayInfo info() const override { return sim_.display().info(); }
    hal::Result<void> init() override { return sim_.display().init(); }
    hal::Result<hal::Frame> acquire() override {
        const auto frame = sim_.display().acquire();
        if (frame.ok())
            frame_ = frame.value();
        return frame;
    }
    hal::Result<void> present() override {
        const hal::DisplayInfo size = info();
        surface.assign(frame_.pixels, frame_.pixels + frame_.stride * size.height);
        const std::uint64_t before = sim_.counters().bytes;
        const auto sent = sim_.display().present();
        bytes.push_back(sim_.counters().bytes - before);
        if (sent.ok() && compare)
            hold_against_memory();
        return sent;
    }

    hal::Result<void> finish() override { return sim_.display().finish(); }
    void swap_interval(std::int32_t interval) override { sim_.display().swap_interval(interval); }

    bool compare = true;
    std::vector<std::uint8_t> surface; ///< the picture as it was presented, two bytes a pixel
    std::vector<std::uint64_t> bytes;  ///< bytes on the wire of each present
    long compared = 0;                 ///< number of presents

  private:
    sim::SimBoard& sim_;
    const hal::Board& board_;
    hal::Frame frame_;

    void hold_against_memory() {
        const hal::DisplayInfo size = info();
        const hal::PanelDesc& panel = *board_.display.panel;
        const hal::Placement placed = hal::place(panel, board_.display.orientation);
        const sim::Image memory = sim_.memory();
        int wrong = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                int column = x + placed.offset.x, row = y + placed.offset.y;
                if ((placed.madctl & hal::dcs::MV) != 0)
                    std::swap(column, row);
                if ((placed.madctl & hal::dcs::MX) != 0)
                    column = panel.memory.width - 1 - column;
                if ((placed.madctl & hal::dcs::MY) != 0)
                    row = panel.memory.height - 1 - row;
                const std::uint8_t* const cell = memory.at(column, row);
                const std::uint8_t* const pixel =
                    &surface[static_cast<std::size_t>(y * frame_.stride + 2 * x)];
                const int word = pixel[0] << 8 | pixel[1];
                const int held = cell[0] >> 3 << 11 | cell[1] >> 2 << 5 | cell[2] >> 3;
                if (word != held && wrong++ == 0)
                    ADD_FAILURE() << "present " << compared << ": (" << x << ", " << y << ") the panel holds "
                                  << held << ", the surface " << word;
            }
        EXPECT_EQ(wrong, 0) << "pixels, present " << compared;
        ++compared;
    }
};

} // namespace spangle::test
