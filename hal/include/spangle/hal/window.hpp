// Registers and window commands: how pixels lie, and which part of the controller's memory the next ones go
// to.
#pragma once

#include <cstdint>

#include <spangle/hal/op_list.hpp>
#include <spangle/hal/orientation.hpp>

namespace spangle::hal {

/// Keeps the window that the controller holds, so that an axis that stays is not sent again. It is invalid
/// after any transfer that did not end well, because nobody knows which of its bytes arrived.
class Windows {
  public:
    /// A window of no panel: another one must be assigned before it is used.
    Windows() = default;
    /// `format` says how many pixels share a byte. The window's numbers count such groups of pixels.
    constexpr Windows(const PanelDesc& panel, const Placement& placement, WireFormat format);

    /// The operations of a window whose axes are all sent.
    std::uint32_t commands() const { return window_size(*set_).commands; }
    /// How many pixels across and down share a byte.
    Extent shared() const { return shared_; }
    /// The first part of `area` that one window of this controller can name.
    constexpr Rect first_of(const Rect& area) const;

    /// Appends the axes, as far as they change. `area` lies in the placed picture, is not empty, and ends
    /// where bytes do.
    constexpr void select(OpList& ops, const Rect& area);
    /// Does what select() does, then appends the memory write: pixels may follow.
    constexpr void open(OpList& ops, const Rect& area);
    /// Makes the next window send both axes.
    void forget() { columns_ = rows_ = Interval{}; }

  private:
    struct Interval {
        std::uint16_t first = 1, last = 0; ///< `first` above `last` means that the interval is unknown
        friend bool operator==(const Interval&, const Interval&) = default;
    };
    static constexpr Interval interval(std::int32_t first, std::int32_t count, std::int32_t shared);
    constexpr void select_axis(OpList& ops, Axis axis, Interval& held, Interval wanted);

    const CommandSet* set_ = &dcs::commands;
    Offset offset_;
    Extent shared_{1, 1};
    bool exchanged_ = false; ///< true: MV is set, so columns and rows are exchanged
    bool resend_ = false;
    Interval columns_, rows_;
};

constexpr Windows::Windows(const PanelDesc& panel, const Placement& placement, WireFormat format)
    : set_(panel.commands), offset_(placement.offset), exchanged_((placement.madctl & dcs::MV) != 0),
      resend_(panel.quirks.resend_window || !panel.commands->rewinds) {
    const WireInfo info = wire_info(format);
    shared_ = exchanged_ ? Extent{info.rows, info.columns} : Extent{info.columns, info.rows};
}

constexpr Rect Windows::first_of(const Rect& area) const {
    Rect part = area;
    if (names_one(set_->rows) && exchanged_)
        part.w = shared_.width;
    else if (names_one(set_->rows))
        part.h = shared_.height;
    return part;
}

constexpr Windows::Interval Windows::interval(std::int32_t first, std::int32_t count, std::int32_t shared) {
    return {static_cast<std::uint16_t>(first / shared),
            static_cast<std::uint16_t>((first + count) / shared - 1)};
}

constexpr void Windows::select_axis(OpList& ops, Axis axis, Interval& held, Interval wanted) {
    if (held == wanted && !resend_)
        return;
    held = wanted;
    const auto high = [](std::uint16_t v) { return static_cast<std::uint8_t>(v >> 8); };
    const auto low = [](std::uint16_t v) { return static_cast<std::uint8_t>(v & 0xFF); };
    const auto next = [&](unsigned n) { return static_cast<std::uint8_t>(axis.command + n); };
    switch (axis.code) {
    case Axis::Code::pair16:
        ops.command_pair(axis.command, wanted.first, wanted.last);
        break;
    case Axis::Code::pair8:
        ops.command_bytes(axis.command, low(wanted.first), low(wanted.last));
        break;
    case Axis::Code::registers:
        ops.command_byte(axis.command, high(wanted.first));
        ops.command_byte(next(1), low(wanted.first));
        ops.command_byte(next(2), high(wanted.last));
        ops.command_byte(next(3), low(wanted.last));
        break;
    case Axis::Code::nibbles:
        ops.command_byte(next(wanted.first & 15u), next(0x10u + (wanted.first >> 4)));
        break;
    case Axis::Code::in_command:
        ops.command(next(wanted.first));
        break;
    }
}

/// With MV, CASET of DCS names rows; other controllers go on naming columns with it.
constexpr void Windows::select(OpList& ops, const Rect& area) {
    const Interval across = interval(area.x + offset_.x, area.w, shared_.width);
    const Interval down = interval(area.y + offset_.y, area.h, shared_.height);
    const bool crossed = exchanged_ && set_->axes_stay;
    select_axis(ops, set_->columns, columns_, crossed ? down : across);
    select_axis(ops, set_->rows, rows_, crossed ? across : down);
}

constexpr void Windows::open(OpList& ops, const Rect& area) {
    select(ops, area);
    if (set_->memory_write != 0)
        ops.command(set_->memory_write);
}

/// Appends the registers that follow from orientation, colour order, inversion and format.
constexpr void append_settings(OpList& ops, const PanelDesc& panel, const Placement& placement,
                               FormatCode format) {
    for (unsigned i = 0; i < panel.commands->setting_count; ++i) {
        const Setting& setting = panel.commands->settings[i];
        const std::uint8_t value = value_of(setting, placement.madctl, panel, format);
        if (setting.in_command)
            ops.command(static_cast<std::uint8_t>(setting.command ^ value));
        else
            ops.command_byte(setting.command, value);
    }
}

/// Calls `append` for each part of the area that one window can name, from the top left.
template <class Append>
Result<void> for_each_window(const Windows& windows, const Rect& area, Append append) {
    const Rect part = windows.first_of(area);
    for (std::int32_t y = 0; y < area.h; y += part.h)
        for (std::int32_t x = 0; x < area.w; x += part.w)
            if (const Result<void> r = append({area.x + x, area.y + y, part.w, part.h}); !r)
                return r;
    return {};
}

} // namespace spangle::hal
