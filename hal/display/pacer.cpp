#include <spangle/hal/pacer.hpp>
#include <spangle/hal/readback.hpp>

namespace spangle::hal {
namespace {

constexpr std::size_t most_periods = 8;

} // namespace

/// Panels time their lines by an oscillator that is not trimmed: of two panels of one kind, one is some
/// percent faster. A transfer as long as two refreshes would miss by dozens of lines. So tear-free displays
/// time a few refreshes once. Where none is seen, or the time is implausible, the datasheet's time stays;
/// presents then report what is wrong.
Result<void> Pacer::measure() {
    const PanelTiming& timing = config().panel->timing;
    if (!tear_free(config()) || timing.scan_lines == 0)
        return {};
    const auto lines = static_cast<std::int32_t>(timing.scan_lines);
    const auto nominal = static_cast<std::int32_t>(std::int64_t{timing.frame_us} * 1000 / lines);
    line_ns_ = nominal;
    OpList& ops = transfer_.list();
    const bool by_te = config().wait_te;
    const std::size_t looks = by_te ? 1 : 2, room = ops.capacity() / looks - 1;
    const std::size_t periods = room < most_periods ? room : most_periods;
    const std::uint32_t at_most = 2 * timing.frame_us + grace_us;
    const std::uint8_t dummies = register_dummy_bits(transfer_.caps(), *config().panel);
    ops.clear();
    for (std::size_t i = 0; i <= periods; ++i) {
        std::uint32_t* const moment = i == 0 ? &moments_[0] : i == periods ? &moments_[1] : nullptr;
        if (by_te) {
            ops.wait_te(at_most, moment);
        } else { // waits until the scan enters a range of lines
            ops.wait_line(dummies, lines / 2, lines / 4, lines, at_most);
            ops.wait_line(dummies, 0, lines / 4, lines, at_most, moment);
        }
    }
    moments_[0] = moments_[1] = 0;
    if (const auto r = transfer_.start(); !r)
        return r;
    if (const auto r = transfer_.complete(); !r)
        return r.error().fault == Fault::timeout && !transfer_.in_flight() ? Result<void>{} : r;
    const std::int64_t took = moments_[1] - moments_[0];
    const auto line = static_cast<std::int32_t>(took * 1000 / (static_cast<std::int64_t>(periods) * lines));
    if (std::int64_t{4} * line >= std::int64_t{3} * nominal &&
        std::int64_t{4} * line <= std::int64_t{5} * nominal)
        line_ns_ = line;
    return {};
}

Refresh Pacer::refresh() const {
    const PanelTiming& timing = config().panel->timing;
    Refresh refresh;
    if (timing.scan_lines != 0) {
        refresh.line = line_ns_;
        refresh.lines = timing.scan_lines;
        refresh.porch = timing.porch_lines;
        // An edge or a line is seen late, by up to one line and the time of two commands.
        refresh.jitter = refresh.line + static_cast<std::int32_t>(2 * transfer_.caps().command_cost_ns);
    }
    return refresh;
}

void Pacer::append_sync(const SafeStart& start) {
    const PanelTiming& timing = config().panel->timing;
    const std::uint32_t at_most = 2 * timing.frame_us + grace_us;
    const std::int64_t delay = start.possible() ? start.after_blanking() : 0;
    ++(!start.possible() ? counters_.unsafe : delay == 0 ? counters_.led : counters_.lagged);
    OpList& ops = transfer_.list();
    if (config().wait_te) {
        ops.wait_te(at_most);
        if (delay != 0)
            ops.delay(static_cast<std::uint32_t>((delay + 999) / 1000));
    } else if (start.possible()) {
        ops.wait_line(register_dummy_bits(transfer_.caps(), *config().panel), start.first_line(),
                      start.slack_lines(), timing.scan_lines, at_most);
    }
}

bool Pacer::puts_off() {
    if (!transfer_.busy() || (waits_ && config().pacing == Pacing::block))
        return false;
    ++counters_.put_off;
    return true;
}

} // namespace spangle::hal
