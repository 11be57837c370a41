// The scan of a DCS controller: the picture that the glass shows, and the row that is scanned at a given
// time.
#include "host_sim/controller/dcs_controller.hpp"

#include <algorithm>

namespace spangle::sim {

/// The row of the memory that is being scanned. Rows from the chip's height on are blanking.
int DcsController::scan_line(Time now) const {
    return static_cast<int>(now % refresh_time() / chip_.line_ns);
}

std::uint64_t DcsController::frames_scanned(Time now) const {
    return now / refresh_time();
}

bool DcsController::te(Time now) {
    scan_until(now);
    if (!has_te_ || !is_awake_)
        return false;
    const int line = scan_line(now);
    if (te_line_ != 0)
        return line == te_line_;
    const bool hblank = te_with_hblank_ && now % chip_.line_ns > chip_.line_ns * 9 / 10;
    return line >= chip_.height || hblank;
}

void DcsController::scan_row(int row) {
    if (row == 0)
        frame_modes_ = {is_awake_ && is_display_on_,
                        is_partial_,
                        is_scrolling_,
                        is_idle_,
                        partial_start_,
                        partial_end_,
                        scroll_start_};
    const auto cell = [this](int r) { return &memory_[static_cast<std::size_t>(r * chip_.width)]; };
    Rgb666* const out = &scanned_memory_[static_cast<std::size_t>(row * chip_.width)];
    const bool outside_wraps = frame_modes_.partial_start > frame_modes_.partial_end;
    const bool in_partial = outside_wraps
                                ? row >= frame_modes_.partial_start || row <= frame_modes_.partial_end
                                : row >= frame_modes_.partial_start && row <= frame_modes_.partial_end;
    if (!frame_modes_.visible || (frame_modes_.partial && !in_partial)) {
        std::fill(out, out + chip_.width, Rgb666{});
        return;
    }
    int source = row;
    if (frame_modes_.scrolling && row >= scroll_top_ && row < scroll_top_ + scroll_height_ &&
        scroll_height_ > 0) {
        const int moved = (row - scroll_top_ + frame_modes_.scroll_start - scroll_top_) % scroll_height_;
        source = scroll_top_ + (moved < 0 ? moved + scroll_height_ : moved);
    }
    std::copy(cell(source), cell(source) + chip_.width, out);
    if (frame_modes_.idle)
        for (int c = 0; c < chip_.width; ++c) {
            const auto one = [](int v) { return static_cast<std::uint8_t>(v >= 32 ? 63 : 0); };
            out[c] = {one(out[c].r), one(out[c].g), one(out[c].b)};
        }
}

void DcsController::begin_line(Time line) {
    const auto row = static_cast<int>(line % Time(chip_.height + chip_.porch_lines));
    if (row >= chip_.height)
        return;
    scan_row(row);
    if (row + 1 == chip_.height && watch_refreshes)
        watch_refreshes(scanned_memory_);
}

void DcsController::scan_until(Time now) {
    if (now <= scanned_to_)
        return;
    const Time lines = Time(chip_.height + chip_.porch_lines);
    Time next = scanned_to_ / chip_.line_ns + 1;
    const Time end = now / chip_.line_ns + 1;
    // Every refresh between the one under way and the last begun looks the same, so it is skipped.
    if (end - next > 2 * lines) {
        for (; next % lines != 0; ++next)
            begin_line(next);
        next = (end / lines - 1) * lines;
    }
    for (; next < end; ++next)
        begin_line(next);
    scanned_to_ = now;
    next_row_at_ = end * chip_.line_ns;
}

std::vector<Rgb666> DcsController::glass(Time now) {
    scan_until(now);
    std::vector<Rgb666> picture;
    picture.reserve(static_cast<std::size_t>(glass_.width * glass_.height));
    const bool complement = is_inverted_ != glass_.normally_inverted;
    const bool exchange = ((madctl_ & dcs::blue_first) != 0) != glass_.bgr_filter;
    for (int y = 0; y < glass_.height; ++y)
        for (int x = 0; x < glass_.width; ++x) {
            const int column = glass_.x + (glass_.mirror_columns ? glass_.width - 1 - x : x);
            const int row = glass_.y + (glass_.mirror_rows ? glass_.height - 1 - y : y);
            Rgb666 p = scanned_memory_[static_cast<std::size_t>(row * chip_.width + column)];
            if (frame_modes_.visible && complement)
                p = {static_cast<std::uint8_t>(63 - p.r), static_cast<std::uint8_t>(63 - p.g),
                     static_cast<std::uint8_t>(63 - p.b)};
            if (exchange)
                std::swap(p.r, p.b);
            picture.push_back(p);
        }
    return picture;
}

} // namespace spangle::sim
