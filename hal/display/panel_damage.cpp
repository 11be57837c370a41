// Collects damage: what the panel's memory does not hold yet.
#include <spangle/hal/panel_display.hpp>

#include "hal/display/row_spans.hpp"

namespace spangle::hal {

/// The pixels across and down that share bytes, in the picture or on the wire.
Extent PanelDisplay::shared() const {
    const Extent wire = windows_.shared(),
                 lying = config_.wire.converts() ? Extent{1, 1} : sharing(config_.format);
    return {wire.width > lying.width ? wire.width : lying.width,
            wire.height > lying.height ? wire.height : lying.height};
}

/// Widens the damage, so that windows end at whole bytes: rows that share bytes share the damage.
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

/// Collects what differs between the panel's memory and the frame, by row:
///  - what was drawn now;
///  - after a full clear, what the shown frame held outside its clear value, or everything when that value
///  changed;
///  - with two buffers and no full clear, what the last present changed, since this buffer is one frame
///    older;
///  - what a failed transfer leaves unknown;
///  - what was sent in place, which the other buffer does not have.
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

/// Copies what differs into the second buffer, in the order of the scan.
void PanelDisplay::turn_damage() {
    std::uint8_t* const to = buffers_[1].to_draw(bus_);
    memory_.turner(scan_,
                   {buffers_[0].to_send(), static_cast<std::int32_t>(stride()), picture_.height, to,
                    static_cast<std::int32_t>(sent_stride()), format_info(config_.format).bytes_per_pixel},
                   memory_.damage, memory_.turned);
}

} // namespace spangle::hal
