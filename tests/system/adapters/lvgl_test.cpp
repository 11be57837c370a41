// Tests the LVGL adapter on a simulated board: what LVGL flushes is shown on the glass.
#include <vector>

#include <gtest/gtest.h>
#include <spangle/adapters/lvgl.hpp>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

/// A stub of LVGL's display: what LVGL keeps of it, and how it flushes.
struct lv_display {
    std::int32_t width, height;
    lv_color_format_t format;
    void *user, *buffer;
    std::uint32_t bytes;
    lv_display_flush_cb_t flush;
    bool last = false;
    int ready = 0;
};
static lv_display lvgl;

lv_display_t* lv_display_create(std::int32_t width, std::int32_t height) {
    lvgl = {};
    lvgl.width = width;
    lvgl.height = height;
    return &lvgl;
}
void lv_display_set_color_format(lv_display_t* d, lv_color_format_t format) {
    d->format = format;
}
void lv_display_set_user_data(lv_display_t* d, void* user) {
    d->user = user;
}
void* lv_display_get_user_data(lv_display_t* d) {
    return d->user;
}
void lv_display_set_flush_cb(lv_display_t* d, lv_display_flush_cb_t flush) {
    d->flush = flush;
}
void lv_display_set_buffers(lv_display_t* d, void* first, void*, std::uint32_t bytes,
                            lv_display_render_mode_t) {
    d->buffer = first;
    d->bytes = bytes;
}
bool lv_display_flush_is_last(lv_display_t* d) {
    return d->last;
}
void lv_display_flush_ready(lv_display_t* d) {
    ++d->ready;
}

namespace {

using namespace spangle;

constexpr unsigned red = 0xF800, green = 0x07E0;

void flush(lv_area_t area, unsigned color, bool last) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < (area.x2 - area.x1 + 1) * (area.y2 - area.y1 + 1); ++i) {
        pixels.push_back(static_cast<std::uint8_t>(color));
        pixels.push_back(static_cast<std::uint8_t>(color >> 8));
    }
    lvgl.last = last;
    lvgl.flush(&lvgl, &area, pixels.data());
}

TEST(Lvgl, WhatItFlushesIsOnTheGlass) {
    sim::SimBoard board(boards::st7789_240);
    ASSERT_TRUE(board.display().init().ok());
    std::vector<std::uint8_t> buffer(240 * 24 * 2);
    adapters::LvglDisplay adapter(board.display(), buffer.data(), static_cast<std::uint32_t>(buffer.size()));
    EXPECT_EQ(adapter.lvgl(), &lvgl);
    EXPECT_EQ(lvgl.width, 240);
    EXPECT_EQ(lvgl.buffer, buffer.data());
    const auto before = board.counters().pixel_bytes;
    flush({10, 20, 29, 39}, red, false);
    EXPECT_EQ(board.counters().pixel_bytes, before) << "the frame is shown when it is whole";
    flush({100, 30, 109, 33}, green, true);
    EXPECT_TRUE(adapter.result().ok());
    EXPECT_EQ(lvgl.ready, 2);
    const sim::Image glass = board.glass();
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x) {
            const std::uint8_t* const p = glass.at(x, y);
            const bool in_red = x >= 10 && x < 30 && y >= 20 && y < 40,
                       in_green = x >= 100 && x < 110 && y >= 30 && y < 34;
            ASSERT_EQ(p[0] > 200, in_red) << x << ", " << y;
            ASSERT_EQ(p[1] > 200, in_green) << x << ", " << y;
            ASSERT_LT(p[2], 8); // blue's lowest bit repeats green's
        }
    const auto shown = board.counters().pixel_bytes;
    flush({0, 0, 3, 0}, green, true);
    EXPECT_LT(board.counters().pixel_bytes - shown, 100u) << "only what changed";
    EXPECT_EQ(board.violations_text(), "");
}

TEST(Lvgl, ErrorsAreKept) {
    sim::SimBoard board(boards::st7789_240);
    adapters::LvglDisplay early(board.display(), nullptr, 0);
    flush({0, 0, 1, 1}, red, true);
    EXPECT_FALSE(early.result().ok()) << "no init yet";
    EXPECT_EQ(lvgl.ready, 1) << "LVGL never waits for ever";
    hal::Board two = boards::st7789_240;
    two.display.buffers = 2;
    sim::SimBoard pair(two);
    ASSERT_TRUE(pair.display().init().ok());
    adapters::LvglDisplay adapter(pair.display(), nullptr, 0);
    for (int frame = 0; frame < 4; ++frame)
        flush({0, 0, 1, 1}, red, true);
    EXPECT_EQ(adapter.result().error().fault, hal::Fault::unsupported);
}

} // namespace
