// Acquires and presents frames of a panel, puts presents off while the wire is busy, and handles the outcomes
// of transfers.
#include <spangle/hal/panel_display.hpp>

#include "hal/display/row_spans.hpp"

namespace spangle::hal {
namespace {

std::uint32_t deadline(std::uint32_t expected, std::uint32_t late) {
    return expected < (UINT32_MAX - late) / 2 ? expected * 2 + late : UINT32_MAX;
}

} // namespace

constexpr PanelDisplay::Parts PanelDisplay::every_part = {
    &PanelDisplay::check_description,
    check_identity,
    &PanelDisplay::measure_refresh,
    &PanelDisplay::append_sync,
    &PanelDisplay::ops_of,
    &PanelDisplay::acquire_frame,
    &PanelDisplay::present_frame,
    &PanelDisplay::show,
    &PanelDisplay::acquire_rows,
    &PanelDisplay::present_rows,
    &PanelDisplay::send_changed_rows,
};

PanelDisplay::PanelDisplay(Bus& bus, const PanelConfig& config, const PanelMemory& memory, const Parts& parts)
    : bus_(bus), config_(config), memory_(memory), parts_(parts) {}

DisplayInfo PanelDisplay::info() const {
    const bool described = config_.panel != nullptr;
    const Extent size = described ? picture_size(config_) : Extent{};
    return {described ? config_.panel->name : "",
            size.width,
            size.height,
            config_.format,
            config_.buffers == 1 || (described && turns(config_)),
            config_.wire.converts() ? config_.wire.format : WireFormat::none,
            described && config_.band > size.height ? size.height : config_.band,
            described ? band_unit(config_) : 1};
}

// --- Transfers ---

/// The longest operation of the bus in bytes. Where pixels have whole bytes, it holds whole pixels.
std::uint32_t PanelDisplay::op_limit() const {
    const std::uint32_t limit = caps_.max_transfer != 0 ? caps_.max_transfer : UINT32_MAX;
    return wire_bits() % 8 == 0 ? limit - limit % (wire_bits() / 8) : limit;
}

/// Sends the operations in the list where there is no room for `ops` more.
Result<void> PanelDisplay::make_room(std::size_t ops) {
    if (ops_.room() >= ops)
        return {};
    if (const auto r = start(); !r)
        return r;
    return complete();
}

Result<void> PanelDisplay::start() {
    if (ops_.size() == 0)
        return {};
    const Result<Token> token = ops_.submit(bus_);
    const std::uint32_t time = ops_.duration(caps_);
    ops_.clear();
    if (!token) {
        windows_.forget();
        return token.error();
    }
    token_ = token.value();
    token_time_ = time;
    in_flight_ = true;
    return {};
}

Result<void> PanelDisplay::complete() {
    const Result<void> done = bus_.wait(token_, deadline(token_time_, caps_.late_us));
    in_flight_ = !done && !bus_.done(token_);
    late_ = in_flight_;
    if (!done) {
        suspect_ = true;
        windows_.forget();
        forget_content();
    }
    return done;
}

Result<void> PanelDisplay::settle() {
    if (!in_flight_)
        return {};
    const bool was_late = late_;
    if (const auto r = complete(); !r)
        return r;
    if (!was_late)
        suspect_ = false;
    return {};
}

Result<void> PanelDisplay::finish() {
    if (const auto r = settle(); !r)
        return r;
    if (parts_.show == nullptr || !owed_ || drawn_since())
        return {};
    if (const auto r = (this->*parts_.show)(true); !r)
        return r;
    return settle();
}

Result<void> PanelDisplay::poll() {
    if (parts_.show == nullptr || !owed_ || drawn_since() || (in_flight_ && !bus_.done(token_)))
        return {};
    if (const auto r = settle(); !r)
        return r;
    return (this->*parts_.show)(false);
}

// --- Frames ---

Result<Frame> PanelDisplay::acquire() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: acquire before init succeeded"};
    if (config_.band != 0)
        return Error{Fault::unsupported, "display: frames of this display are drawn in bands"};
    return (this->*parts_.acquire)();
}

Result<Frame> PanelDisplay::acquire_frame() {
    std::uint8_t* const pixels = buffers_[back_].to_draw(bus_);
    if (pixels == nullptr)
        return Error{Fault::busy, "display: acquire while a late transfer still reads the frame"};
    const std::uint32_t age = drawn_in_[back_] == 0 ? 0 : frame_ - drawn_in_[back_] + 1;
    return Frame{pixels, static_cast<std::int32_t>(stride()), static_cast<std::int32_t>(age), &extents_};
}

Result<void> PanelDisplay::present() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: present before init succeeded"};
    if (config_.band != 0)
        return Error{Fault::unsupported, "display: frames of this display are drawn in bands"};
    return (this->*parts_.present)();
}

Result<void> PanelDisplay::present_frame() {
    if (put_off())
        return {};
    if (const auto r = settle(); !r)
        return r;
    const std::uint8_t drawn = back_;
    if (const auto r = show(false); !r)
        return r;
    drawn_in_[drawn] = ++frame_;
    return {};
}

/// Sends the frame that was drawn. `in_place` says that the next frame is drawn in the same buffer.
Result<void> PanelDisplay::show(bool in_place) {
    restore_extents();
    collect_damage();
    const bool recolored = is_indexed(config_.format) && collect_palette_damage();
    if (turns_)
        turn_damage();
    if (hash_.enabled()) // reduced damage would not be enough for a buffer that is two sends behind
        memory_.hash.code->reduce(hash_, sent_damage(), buffers_[turns_ ? 1 : back_].to_send(),
                                  static_cast<std::int32_t>(sent_stride()), suspect_ || behind_ || recolored);
    if (const auto r = send(); !r)
        return r;
    if (config_.buffers == 1 && !config_.wire.converts()) {
        if (const auto r = settle(); !r)
            return r;
    }
    accept(in_place);
    return {};
}

/// Accepts that the frame was handed over. The next frame starts with nothing touched.
void PanelDisplay::accept(bool in_place) {
    front_ = back_;
    behind_ = in_place && canvases() == 2;
    if (!in_place && canvases() == 2)
        back_ ^= 1;
    forget_extents();
}

// --- Pacing ---

/// Puts this present off if the wire is busy and the present need not wait. Returns true if it was put off.
bool PanelDisplay::put_off() {
    if (!in_flight_ || bus_.done(token_) || (waits_ && config_.pacing == Pacing::block))
        return false;
    drawn_in_[back_] = ++frame_;
    ++counters_.put_off;
    if (config_.pacing != Pacing::drop && memory_.held != nullptr)
        hold_extents();
    return true;
}

/// Keeps what the frame touched in `held`, so that `touched` shows whether more is drawn.
void PanelDisplay::hold_extents() {
    restore_extents();
    held_cleared_ = extents_.cleared;
    held_clear_value_ = extents_.clear_value;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.held[y] = memory_.touched[y];
    forget_extents();
    owed_ = true;
}

void PanelDisplay::restore_extents() {
    if (!owed_)
        return;
    owed_ = false;
    if (extents_.cleared)
        return; // a full clear replaces all pixels of that frame
    extents_.cleared = held_cleared_;
    extents_.clear_value = held_clear_value_;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.touched[y] = unite(memory_.touched[y], memory_.held[y]);
}

void PanelDisplay::forget_extents() {
    extents_.cleared = false;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.touched[y] = RowSpan{};
}

bool PanelDisplay::drawn_since() const {
    bool drawn = extents_.cleared;
    for (std::int32_t y = 0; y < extents_.height && !drawn; ++y)
        drawn = memory_.touched[y].begin < memory_.touched[y].end;
    return drawn;
}

} // namespace spangle::hal
