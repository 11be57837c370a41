// The part of ESP-IDF's esp_lcd that the adapter uses, declared as its documentation has it.
#pragma once

#include <cstddef>

using esp_err_t = int;
inline constexpr esp_err_t ESP_OK = 0, ESP_FAIL = -1, ESP_ERR_TIMEOUT = 0x107;

using esp_lcd_panel_io_handle_t = struct esp_lcd_panel_io_t*;
struct esp_lcd_panel_io_event_data_t {};
using esp_lcd_panel_io_color_trans_done_cb_t = bool (*)(esp_lcd_panel_io_handle_t,
                                                        esp_lcd_panel_io_event_data_t*, void*);
struct esp_lcd_panel_io_callbacks_t {
    esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
};

esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t,
                                                    const esp_lcd_panel_io_callbacks_t*, void*);
esp_err_t esp_lcd_panel_io_tx_param(esp_lcd_panel_io_handle_t, int command, const void* parameters,
                                    std::size_t);
esp_err_t esp_lcd_panel_io_tx_color(esp_lcd_panel_io_handle_t, int command, const void* color, std::size_t);
