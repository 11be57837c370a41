#include <spangle/hal/window.hpp>

namespace spangle::hal {
namespace {

std::uint8_t high(std::uint16_t v) {
    return static_cast<std::uint8_t>(v >> 8);
}

std::uint8_t low(std::uint16_t v) {
    return static_cast<std::uint8_t>(v & 0xFF);
}

std::uint8_t next(Axis axis, unsigned n) {
    return static_cast<std::uint8_t>(axis.command + n);
}

} // namespace

Windows::Windows(const PanelDesc& panel, const Placement& placement, WireFormat format)
    : set_(panel.commands), offset_(placement.offset), exchanged_((placement.madctl & dcs::MV) != 0),
      resend_(panel.quirks.resend_window || !panel.commands->rewinds) {
    const WireInfo info = wire_info(format);
    shared_ = exchanged_ ? Extent{info.rows, info.columns} : Extent{info.columns, info.rows};
}

Rect Windows::first_of(const Rect& area) const {
    Rect part = area;
    if (names_one(set_->rows) && exchanged_)
        part.w = shared_.width;
    else if (names_one(set_->rows))
        part.h = shared_.height;
    return part;
}

Windows::Interval Windows::interval(std::int32_t first, std::int32_t count, std::int32_t shared) {
    return {static_cast<std::uint16_t>(first / shared),
            static_cast<std::uint16_t>((first + count) / shared - 1)};
}

void Windows::select_axis(OpList& ops, Axis axis, Interval& held, Interval wanted) {
    if (held == wanted && !resend_)
        return;
    held = wanted;
    switch (axis.code) {
    case Axis::Code::pair16:
        ops.command_pair(axis.command, wanted.first, wanted.last);
        break;
    case Axis::Code::pair8:
        ops.command_bytes(axis.command, low(wanted.first), low(wanted.last));
        break;
    case Axis::Code::registers:
        ops.command_byte(axis.command, high(wanted.first));
        ops.command_byte(next(axis, 1), low(wanted.first));
        ops.command_byte(next(axis, 2), high(wanted.last));
        ops.command_byte(next(axis, 3), low(wanted.last));
        break;
    case Axis::Code::nibbles:
        ops.command_byte(next(axis, wanted.first & 15u), next(axis, 0x10u + (wanted.first >> 4)));
        break;
    case Axis::Code::in_command:
        ops.command(next(axis, wanted.first));
        break;
    }
}

/// MV of DCS makes CASET name rows; others go on naming columns with it.
void Windows::select(OpList& ops, const Rect& area) {
    const Interval across = interval(area.x + offset_.x, area.w, shared_.width);
    const Interval down = interval(area.y + offset_.y, area.h, shared_.height);
    const bool crossed = exchanged_ && set_->axes_stay;
    select_axis(ops, set_->columns, columns_, crossed ? down : across);
    select_axis(ops, set_->rows, rows_, crossed ? across : down);
}

void Windows::open(OpList& ops, const Rect& area) {
    select(ops, area);
    if (set_->memory_write != 0)
        ops.command(set_->memory_write);
}

} // namespace spangle::hal
