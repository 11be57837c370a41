// A display whose every step can be told to fail, and whose memory a test can read.
#pragma once

#include <spangle/EGL/egl.h>
#include <spangle/native.hpp>

#include <vector>

namespace spangle::test {

class FakeDisplay final : public hal::Display {
  public:
    explicit FakeDisplay(PixelFormat format = PixelFormat::rgb565_be, std::int32_t width = 12,
                         std::int32_t height = 9)
        : pixels(static_cast<std::size_t>(width * height * format_info(format).bytes_per_pixel)),
          front(pixels.size()), rows(static_cast<std::size_t>(height)), format_(format), width_(width),
          height_(height) {
        extents.rows = rows.data();
        extents.height = height;
    }

    hal::DisplayInfo info() const override { return {"fake", width_, height_, format_, !two_buffers}; }
    hal::Result<void> init() override {
        ++inits;
        return fail_init ? hal::Error{hal::Fault::no_answer, "fake: the panel does not answer"}
                         : hal::Result<void>{};
    }
    hal::Result<hal::Frame> acquire() override {
        ++acquires;
        if (fail_acquire)
            return hal::Error{hal::Fault::gone, "fake: no buffer"};
        return hal::Frame{pixels.data(), width_ * format_info(format_).bytes_per_pixel, presents == 0 ? 0 : 1,
                          &extents};
    }
    hal::Result<void> present() override {
        if (fail_present)
            return hal::Error{hal::Fault::short_write, "fake: 3 of 7 bytes went out"};
        ++presents;
        shown = pixels;
        shown_extents = rows;
        for (RowSpan& row : rows)
            row = {};
        extents.cleared = false;
        if (two_buffers)
            pixels.swap(front);
        return {};
    }

    hal::Result<void> finish() override {
        ++finishes;
        if (fail_present)
            return hal::Error{hal::Fault::timeout, "fake: the transfer does not end"};
        return {};
    }
    void swap_interval(std::int32_t interval) override { intervals.push_back(interval); }
    hal::Result<void> set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) override {
        palette = {first, count};
        palette.insert(palette.end(), rgb, rgb + 3 * count);
        return {};
    }

    /// Becomes another display, of another size and with its own memory.
    void become(std::int32_t width, std::int32_t height) {
        width_ = width;
        height_ = height;
        pixels = std::vector<std::uint8_t>(
            static_cast<std::size_t>(width * height * format_info(format_).bytes_per_pixel));
        front = pixels;
        rows = std::vector<RowSpan>(static_cast<std::size_t>(height));
        extents = {rows.data(), height, false, 0};
    }

    bool fail_init = false, fail_acquire = false, fail_present = false, two_buffers = false;
    int inits = 0, acquires = 0, presents = 0, finishes = 0;
    std::vector<std::int32_t> intervals;
    std::vector<int> palette; ///< first index, count and colours of the last call
    /// The buffer drawn into, the other buffer, and what was presented.
    std::vector<std::uint8_t> pixels, front, shown;
    std::vector<RowSpan> rows, shown_extents;
    RowExtents extents;

  private:
    PixelFormat format_;
    std::int32_t width_, height_;
};

} // namespace spangle::test
