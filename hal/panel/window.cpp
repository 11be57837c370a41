#include <spangle/hal/window.hpp>

namespace spangle::hal {

void Windows::select_axis(OpList& ops, std::uint8_t command, Interval& held, std::int32_t first,
                          std::int32_t count) {
    const Interval wanted = {static_cast<std::uint16_t>(first),
                             static_cast<std::uint16_t>(first + count - 1)};
    if (held == wanted && !resend_)
        return;
    ops.command_pair(command, wanted.first, wanted.last);
    held = wanted;
}

void Windows::select(OpList& ops, const Rect& area) {
    select_axis(ops, dcs::CASET, columns_, area.x + offset_.x, area.w);
    select_axis(ops, dcs::RASET, rows_, area.y + offset_.y, area.h);
}

void Windows::open(OpList& ops, const Rect& area) {
    select(ops, area);
    ops.command(dcs::RAMWR);
}

} // namespace spangle::hal
