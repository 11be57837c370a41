// Window commands: which part of the controller's memory the next pixels go to.
#pragma once

#include <cstdint>

#include <spangle/hal/op_list.hpp>
#include <spangle/hal/orientation.hpp>

namespace spangle::hal {

/// Remembers the window the controller holds, so that an axis that stays is not sent again. Invalid after any
/// transfer that did not end well, because nobody knows which of its bytes arrived.
class Windows {
  public:
    Windows() = default;
    /// `format`: which pixels share a byte, and with it a number of the window.
    Windows(const PanelDesc& panel, const Placement& placement, WireFormat format);

    /// Ops of a window with nothing remembered.
    std::uint32_t commands() const { return window_size(*set_).commands; }
    /// Pixels across and down that share a byte.
    Extent shared() const { return shared_; }
    /// The first part of `area` that one window of this controller can name.
    Rect first_of(const Rect& area) const;

    /// Appends the axes, as far as they change. `area` lies in the placed picture, is not empty, and ends
    /// where bytes do.
    void select(OpList& ops, const Rect& area);
    /// The same, then the memory write: pixels may follow.
    void open(OpList& ops, const Rect& area);
    void forget() { columns_ = rows_ = Interval{}; }

  private:
    struct Interval {
        std::uint16_t first = 1, last = 0; ///< first > last: unknown
        friend bool operator==(const Interval&, const Interval&) = default;
    };
    static Interval interval(std::int32_t first, std::int32_t count, std::int32_t shared);
    void select_axis(OpList& ops, Axis axis, Interval& held, Interval wanted);

    const CommandSet* set_ = &dcs::commands;
    Offset offset_;
    Extent shared_{1, 1};
    bool exchanged_ = false; ///< MV is set
    bool resend_ = false;
    Interval columns_, rows_;
};

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
