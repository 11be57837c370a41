// The part of LVGL 9's interface that the adapter uses, declared as its documentation has it.
#pragma once

#include <cstdint>

using lv_display_t = struct lv_display;
struct lv_area_t {
    std::int32_t x1, y1, x2, y2;
};
using lv_display_flush_cb_t = void (*)(lv_display_t*, const lv_area_t*, std::uint8_t*);
enum lv_color_format_t { LV_COLOR_FORMAT_RGB565 = 0x12 };
enum lv_display_render_mode_t { LV_DISPLAY_RENDER_MODE_PARTIAL };

lv_display_t* lv_display_create(std::int32_t width, std::int32_t height);
void lv_display_set_color_format(lv_display_t*, lv_color_format_t);
void lv_display_set_user_data(lv_display_t*, void*);
void* lv_display_get_user_data(lv_display_t*);
void lv_display_set_flush_cb(lv_display_t*, lv_display_flush_cb_t);
void lv_display_set_buffers(lv_display_t*, void* first, void* second, std::uint32_t bytes,
                            lv_display_render_mode_t);
bool lv_display_flush_is_last(lv_display_t*);
void lv_display_flush_ready(lv_display_t*);
