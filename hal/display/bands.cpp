#include <spangle/hal/bands.hpp>

#include "hal/display/row_spans.hpp"

namespace spangle::hal {

void Bands::open(RowSpan* shown) {
    shown_.rows = shown;
    forget();
}

Result<void> Bands::check(std::int32_t first, std::int32_t rows) const {
    const PanelConfig& config = layout_.config;
    const std::int32_t unit = band_unit(config), left = layout_.picture.height - first;
    if (first < 0 || rows <= 0 || rows > config.band || rows > left || first % unit != 0 ||
        (rows % unit != 0 && rows != left))
        return Error{Fault::bad_argument,
                     "display: a band of rows of the picture, no more than a buffer holds, that ends where "
                     "bytes do"};
    return {};
}

void Bands::begin(std::int32_t first, std::int32_t rows) {
    first_ = first;
    rows_ = rows;
    acquired_ = true;
}

void Bands::hand_over() {
    if (first_ == 0 && !complete_)
        forget(); // an incomplete frame leaves bands with different clear values
    acquired_ = false;
}

/// The damage of a row joins two spans: what was drawn in the band, and what the panel shows there that is
/// not its clear value.
void Bands::collect(const RowExtents& drawn, RowSpan* damage) {
    const std::int16_t width = layout_.picture.width;
    const RowSpan all = {0, width};
    if (first_ == 0)
        clear_value_ = drawn.clear_value;
    const bool apart = drawn.clear_value != clear_value_; // this band's value is not that of the first band
    const bool everything = apart || drawn.clear_value != shown_.clear_value || shown_.rows == nullptr;
    for (std::int32_t y = 0; y < rows_; ++y) {
        const RowSpan now = clip(drawn.rows[y], width);
        damage[y] = everything ? all : unite(now, shown_.rows[first_ + y]);
        if (shown_.rows != nullptr)
            shown_.rows[first_ + y] = apart ? all : now;
    }
    if (first_ + rows_ == layout_.picture.height)
        shown_.clear_value = clear_value_;
}

bool Bands::sent() {
    complete_ = first_ + rows_ == layout_.picture.height;
    return complete_;
}

void Bands::forget() {
    if (shown_.rows == nullptr)
        return;
    for (std::int32_t y = 0; y < layout_.picture.height; ++y)
        shown_.rows[y] = {0, layout_.picture.width};
}

} // namespace spangle::hal
