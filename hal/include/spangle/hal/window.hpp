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
    Windows(const Placement& placement, Quirks quirks)
        : offset_(placement.offset), resend_(quirks.resend_window) {}

    /// Bytes and commands of a window with nothing remembered: CASET and RASET with four bytes each, RAMWR.
    static constexpr std::uint32_t bytes = 11, commands = 3;

    /// Appends CASET and RASET, as far as they change. `area` lies in the placed picture and is not empty.
    void select(OpList& ops, const Rect& area);
    /// The same, then RAMWR: pixels may follow.
    void open(OpList& ops, const Rect& area);
    void forget() { columns_ = rows_ = Interval{}; }

  private:
    struct Interval {
        std::uint16_t first = 1, last = 0; ///< first > last: unknown
        friend bool operator==(const Interval&, const Interval&) = default;
    };
    void select_axis(OpList& ops, std::uint8_t command, Interval& held, std::int32_t first,
                     std::int32_t count);

    Offset offset_;
    bool resend_ = false;
    Interval columns_, rows_;
};

} // namespace spangle::hal
