// A flush callback that shows what LVGL 9 draws on any Spangle display. The program provides lvgl.h.
#pragma once

#include <cstddef>
#include <cstdint>

#include <lvgl.h>
#include <spangle/hal/display.hpp>

namespace spangle::adapters {

/// LVGL's display on a Spangle display of 16-bit pixels with one buffer.
class LvglDisplay {
  public:
    /// `display` must be initialised. LVGL draws into `buffer` of `bytes` bytes, which is aligned to
    /// LV_DRAW_BUF_ALIGN. Two bytes for each of a tenth of the screen's pixels are enough.
    LvglDisplay(hal::Display& display, void* buffer, std::uint32_t bytes) : display_(display) {
        const hal::DisplayInfo info = display.info();
        lvgl_ = lv_display_create(info.width, info.height);
        lv_display_set_color_format(lvgl_, LV_COLOR_FORMAT_RGB565);
        lv_display_set_user_data(lvgl_, this);
        lv_display_set_flush_cb(lvgl_, &flush);
        lv_display_set_buffers(lvgl_, buffer, nullptr, bytes, LV_DISPLAY_RENDER_MODE_PARTIAL);
    }
    /// A display is not copied, because LVGL holds its address.
    LvglDisplay(const LvglDisplay&) = delete;
    /// A display is not assigned, because LVGL holds its address.
    LvglDisplay& operator=(const LvglDisplay&) = delete;

    /// LVGL's handle, for its own calls.
    lv_display_t* lvgl() { return lvgl_; }
    /// The result of the last refresh. After an error, the next refresh sends again what did not arrive.
    hal::Result<void> result() const { return result_; }

  private:
    hal::Display& display_;
    lv_display_t* lvgl_ = nullptr;
    hal::Result<void> result_;

    static void flush(lv_display_t* lvgl, const lv_area_t* area, std::uint8_t* pixels) {
        LvglDisplay& self = *static_cast<LvglDisplay*>(lv_display_get_user_data(lvgl));
        self.result_ = self.take(*area, pixels);
        if (self.result_ && lv_display_flush_is_last(lvgl))
            self.result_ = self.display_.present();
        lv_display_flush_ready(lvgl);
    }

    /// Copies an area into the frame. LVGL's pixels are RGB565 with the low byte first, in rows without gaps;
    /// the corners of `area` are inclusive.
    hal::Result<void> take(const lv_area_t& area, const std::uint8_t* pixels) {
        const hal::Result<hal::Frame> acquired = display_.acquire();
        if (!acquired)
            return acquired.error();
        const hal::Frame& frame = acquired.value();
        const PixelFormat format = display_.info().format;
        if (format != PixelFormat::rgb565_be && format != PixelFormat::rgb565_le)
            return hal::Error{hal::Fault::unsupported, "lvgl: the display's pixels have not 16 bits"};
        if (frame.age > 1)
            return hal::Error{hal::Fault::unsupported,
                              "lvgl: draws only what changed, so the display needs one buffer"};
        const unsigned high = format == PixelFormat::rgb565_be ? 0 : 1;
        const std::int32_t width = area.x2 - area.x1 + 1;
        for (std::int32_t y = area.y1; y <= area.y2; ++y) {
            std::uint8_t* to = frame.pixels + std::ptrdiff_t{y} * frame.stride + std::ptrdiff_t{2} * area.x1;
            for (std::int32_t x = 0; x < width; ++x, to += 2, pixels += 2) {
                to[high] = pixels[1];
                to[1 - high] = pixels[0];
            }
            RowSpan& row = frame.extents->rows[y];
            const auto begin = static_cast<std::int16_t>(area.x1),
                       end = static_cast<std::int16_t>(area.x2 + 1);
            row = {begin < row.begin ? begin : row.begin, end > row.end ? end : row.end};
        }
        return {};
    }
};

} // namespace spangle::adapters
