// Collects damage: the pixels that the panel's memory does not hold yet.
#include <spangle/hal/panel_display.hpp>

#include "hal/display/row_spans.hpp"

namespace spangle::hal {

/// The numbers of pixels across and down that share bytes, in the picture or on the wire.
Extent PanelDisplay::shared() const {
    const Extent wire = windows_.shared(),
                 lying = config_.wire.converts() ? Extent{1, 1} : sharing(config_.format);
    return {wire.width > lying.width ? wire.width : lying.width,
            wire.height > lying.height ? wire.height : lying.height};
}

/// Widens the damage, so that windows end at whole bytes. Rows that share bytes get the same damage.
void PanelDisplay::widen_damage() {
    const Extent shared = this->shared();
    if (shared.width == 1 && shared.height == 1)
        return;
    RowSpan* const damage = sent_damage();
    for (std::int32_t y = 0; y < sent_rows(); y += shared.height) {
        RowSpan all;
        for (std::int32_t i = 0; i < shared.height; ++i)
            all = unite(all, damage[y + i]);
        if (all.begin < all.end)
            all = {static_cast<std::int16_t>(all.begin / shared.width * shared.width),
                   static_cast<std::int16_t>((all.end + shared.width - 1) / shared.width * shared.width)};
        for (std::int32_t i = 0; i < shared.height; ++i)
            damage[y + i] = all;
    }
}

/// Collects, row by row, the differences between the panel's memory and the frame:
/// - pixels that were drawn in this frame;
/// - after a full clear, pixels in which the shown frame did not hold its clear value, or all pixels when
///   that value has changed;
/// - with two buffers and no full clear, pixels that the last present changed, because this buffer is one
///   frame older;
/// - pixels that a failed transfer leaves unknown;
/// - pixels that were sent in place, which the other buffer does not have.
void PanelDisplay::collect_damage() {
    const PanelContent& shown = content_[front_];
    PanelContent& drawn = content_[back_];
    const bool cleared = extents_.cleared;
    const bool everything = cleared && extents_.clear_value != shown.clear_value;
    const bool keep = suspect_ || behind_ || (!cleared && canvases() == 2);
    const RowSpan all = {0, picture_.width};
    for (std::int32_t y = 0; y < picture_.height; ++y) {
        const RowSpan now = clip(memory_.touched[y], picture_.width);
        RowSpan damage = keep ? unite(memory_.damage[y], now) : now;
        if (everything)
            damage = all;
        if (cleared)
            damage = unite(damage, shown.rows[y]);
        memory_.damage[y] = damage;
        drawn.rows[y] = cleared ? now : unite(drawn.rows[y], now);
    }
    if (cleared)
        drawn.clear_value = extents_.clear_value;
}

/// Copies the damaged pixels into the second buffer, in the order of the scan.
void PanelDisplay::turn_damage() {
    std::uint8_t* const to = buffers_[1].to_draw(bus_);
    memory_.turner(scan_,
                   {buffers_[0].to_send(), static_cast<std::int32_t>(stride()), picture_.height, to,
                    static_cast<std::int32_t>(sent_stride()), format_info(config_.format).bytes_per_pixel},
                   memory_.damage, memory_.turned);
}

} // namespace spangle::hal
