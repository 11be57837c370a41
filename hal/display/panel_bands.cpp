// Draws frames of a panel in bands. A band is drawn in a buffer of some rows, and is sent while the next band
// is drawn.
#include <spangle/hal/panel_display.hpp>

#include "hal/display/row_spans.hpp"

namespace spangle::hal {

Result<Frame> PanelDisplay::acquire_band(std::int32_t first, std::int32_t rows) {
    if (!ready_)
        return Error{Fault::bad_argument, "display: acquire before init succeeded"};
    if (config_.band == 0)
        return whole_frames();
    return (this->*parts_.acquire_band)(first, rows);
}

Result<Frame> PanelDisplay::acquire_rows(std::int32_t first, std::int32_t rows) {
    const std::int32_t unit = band_unit(config_), left = picture_.height - first;
    if (first < 0 || rows <= 0 || rows > config_.band || rows > left || first % unit != 0 ||
        (rows % unit != 0 && rows != left))
        return Error{Fault::bad_argument,
                     "display: a band of rows of the picture, no more than a buffer holds, that ends where "
                     "bytes do"};
    std::uint8_t* const pixels = buffers_[back_].to_draw(bus_);
    if (pixels == nullptr)
        return Error{Fault::busy, "display: acquire while a late transfer still reads the band"};
    if (first == 0 && is_indexed(config_.format) && memory_.palette->any_stale()) {
        forget_content(); // the buffers whose pixels show the new colours are gone
        memory_.palette->all_fresh();
    }
    band_.first = first;
    band_.rows = rows;
    band_.acquired = true;
    const std::size_t bytes =
        std::size_t{stride()} * static_cast<std::size_t>(stored_rows(config_.format, rows));
    for (std::size_t at = 0; at < bytes; ++at)
        pixels[at] = 0;
    extents_ = {memory_.touched, rows, true, 0};
    for (std::int32_t y = 0; y < rows; ++y)
        memory_.touched[y] = RowSpan{};
    return Frame{pixels, static_cast<std::int32_t>(stride()), 0, &extents_};
}

Result<void> PanelDisplay::present_band() {
    if (!ready_ || !band_.acquired)
        return Error{Fault::bad_argument, "display: a band is presented that was not acquired"};
    return (this->*parts_.present_band)();
}

Result<void> PanelDisplay::present_rows() {
    if (const auto r = settle(); !r)
        return r;
    if (band_.first == 0 && !band_.complete)
        forget_content(); // an incomplete frame leaves bands with different clear values
    band_.acquired = false;
    if (const auto r = (this->*parts_.send_band)(); !r) {
        forget_content();
        return r;
    }
    band_.complete = band_.first + band_.rows == picture_.height;
    if (band_.complete)
        ++frame_;
    if (config_.buffers == 2)
        back_ ^= 1;
    else if (!config_.wire.converts())
        return settle();
    return {};
}

Result<void> PanelDisplay::send_changed_rows() {
    collect_band_damage();
    return send();
}

/// Sends all pixels of a band, because nothing records what the panel shows. Columns are widened to whole
/// bytes, and bands end at whole bytes.
Result<void> PanelDisplay::send_all_rows() {
    const std::int32_t unit = shared().width;
    begin_send();
    if (const auto r =
            append_windows({0, band_.first, (picture_.width + unit - 1) / unit * unit, band_.rows});
        !r)
        return r;
    return end_send();
}

/// Collects the differences between the panel's memory and the band. They are the pixels that were drawn, and
/// pixels in which the panel does not show its clear value. Where that value has changed, all pixels differ.
void PanelDisplay::collect_band_damage() {
    const RowSpan all = {0, picture_.width};
    PanelContent& shown = content_[0];
    if (band_.first == 0)
        band_.clear_value = extents_.clear_value;
    const bool apart = extents_.clear_value != band_.clear_value; // this band has its own clear value
    const bool everything = apart || extents_.clear_value != shown.clear_value || shown.rows == nullptr;
    for (std::int32_t y = 0; y < band_.rows; ++y) {
        const RowSpan now = clip(memory_.touched[y], picture_.width);
        memory_.damage[y] = everything ? all : unite(now, shown.rows[band_.first + y]);
        if (shown.rows != nullptr)
            shown.rows[band_.first + y] = apart ? all : now;
    }
    if (band_.first + band_.rows == picture_.height)
        shown.clear_value = band_.clear_value;
}

/// Forgets what the panel shows, for frames in bands. For whole frames, `damage` holds what is unknown.
void PanelDisplay::forget_content() {
    if (config_.band == 0 || content_[0].rows == nullptr)
        return;
    for (std::int32_t y = 0; y < picture_.height; ++y)
        content_[0].rows[y] = {0, picture_.width};
}

} // namespace spangle::hal
