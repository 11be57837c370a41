// Pixels of index surfaces get their colours while they are sent. So a new colour damages every pixel that
// shows it.
#include <spangle/hal/panel_display.hpp>

#include "hal/display/row_spans.hpp"

namespace spangle::hal {

/// Sets the initial colours. None of them is stale: a panel that was just initialised is black and shows no
/// index of the buffer.
void PanelDisplay::begin_palette() {
    for (std::int32_t i = 0; i < palette_size; ++i)
        for (int c = 0; c < 3; ++c)
            memory_.palette->color[i][c] = initial_color(i).c[c];
    memory_.palette->all_fresh();
}

Result<void> PanelDisplay::set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) {
    if (!opened_ || !is_indexed(config_.format))
        return Error{Fault::unsupported,
                     "display: its surface is not one of indices, or before init succeeded"};
    if (!in_palette(first, count))
        return Error{Fault::bad_argument, "display: indices of a palette are 0 to 255"};
    for (std::int32_t i = first; i < first + count; ++i)
        for (int c = 0; c < 3; ++c, ++rgb) {
            std::uint8_t& now = memory_.palette->color[i][c];
            if (now != *rgb)
                memory_.palette->stale[i / 32] |= 1u << i % 32;
            now = *rgb;
        }
    return {};
}

/// Adds to the damage of each row the columns from the first to the last pixel whose colour has changed.
/// Returns false where no colour has changed.
bool PanelDisplay::collect_palette_damage() {
    Palette& palette = *memory_.palette;
    if (!palette.any_stale())
        return false;
    const std::uint8_t* row = buffers_[back_].to_send();
    for (std::int32_t y = 0; y < picture_.height; ++y, row += stride()) {
        std::int32_t begin = 0, end = picture_.width;
        while (begin < end && !palette.is_stale(row[begin]))
            ++begin;
        while (begin < end && !palette.is_stale(row[end - 1]))
            --end;
        if (begin < end)
            memory_.damage[y] =
                unite(memory_.damage[y], {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(end)});
    }
    palette.all_fresh();
    return true;
}

} // namespace spangle::hal
