// A display that takes its buffer back at every chance, and whose memory has exactly the size it needs. A
// stream can make it fail, or become another display.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <spangle/native.hpp>

namespace spangle::test {

class StreamPanel final : public hal::Display {
  public:
    enum Failure : unsigned { no_init = 1, no_frame = 2, no_present = 4, no_finish = 8, no_palette = 16 };

    void become(PixelFormat format, std::int32_t width, std::int32_t height, std::int32_t band, bool keeps) {
        format_ = format;
        width_ = width;
        height_ = height;
        keeps_ = keeps;
        const std::int32_t unit = format_info(format).rows;
        band_ = (band + unit - 1) / unit * unit;
        stale_ = true; // EGL may draw to the buffer until it asks for another one
    }
    void fail(unsigned failures) { failures_ = failures; }

    hal::DisplayInfo info() const override {
        return {"stream", width_,
                height_,  format_,
                keeps_,   hal::WireFormat::none,
                band_,    format_info(format_).rows};
    }
    hal::Result<void> init() override {
        drop();
        return result(no_init);
    }
    hal::Result<hal::Frame> acquire() override { return frame(0, height_); }
    hal::Result<void> present() override {
        if ((failures_ & no_present) != 0)
            return result(no_present);
        if (!keeps_)
            drop();
        return {};
    }
    hal::Result<void> finish() override { return result(no_finish); }
    hal::Result<void> set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) override {
        for (std::int32_t i = 0; i < 3 * count; ++i)
            palette_[static_cast<std::size_t>((3 * first + i) % 768)] = rgb[i];
        return result(no_palette);
    }
    hal::Result<hal::Frame> acquire_band(std::int32_t first, std::int32_t rows) override {
        drop();
        return frame(first, rows);
    }
    hal::Result<void> present_band() override {
        drop();
        return result(no_present);
    }

  private:
    hal::Result<void> result(Failure failure) const {
        return (failures_ & failure) == 0 ? hal::Result<void>{}
                                          : hal::Error{hal::Fault::gone, "stream: as told"};
    }
    hal::Result<hal::Frame> frame(std::int32_t, std::int32_t rows) {
        if ((failures_ & no_frame) != 0)
            return hal::Error{hal::Fault::gone, "stream: no frame, as told"};
        if (stale_)
            drop();
        if (pixels_ == nullptr) {
            pixels_.reset(new std::uint8_t[static_cast<std::size_t>(row_bytes(format_, width_) *
                                                                    stored_rows(format_, rows))]());
            rows_.reset(new RowSpan[static_cast<std::size_t>(rows)]);
            extents_.reset(new RowExtents{rows_.get(), rows, false, 0});
        }
        return hal::Frame{pixels_.get(), row_bytes(format_, width_), keeps_ ? 1 : 0, extents_.get()};
    }
    void drop() {
        stale_ = false;
        pixels_.reset();
        rows_.reset();
        extents_.reset();
    }

    PixelFormat format_{};
    std::int32_t width_ = 1, height_ = 1, band_ = 0;
    bool keeps_ = false, stale_ = false;
    unsigned failures_ = 0;
    std::unique_ptr<std::uint8_t[]> pixels_;
    std::unique_ptr<RowSpan[]> rows_;
    std::unique_ptr<RowExtents> extents_;
    std::uint8_t palette_[768] = {};
};

} // namespace spangle::test
