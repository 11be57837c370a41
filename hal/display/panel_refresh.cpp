// Measures how long a refresh of this panel takes.
#include <spangle/hal/panel_display.hpp>

namespace spangle::hal {
namespace {

constexpr std::size_t most_periods = 8;

} // namespace

/// Measures the time of one line. Panels time their lines by an oscillator that is not trimmed, so two panels
/// of one kind differ by some percent. A transfer as long as two refreshes would then miss by dozens of
/// lines. Tear-free displays therefore time a few refreshes once. Where no refresh is seen, or the time is
/// implausible, the datasheet's time is kept. Presents then report what is wrong.
Result<void> PanelDisplay::measure_refresh() {
    const PanelTiming& timing = config_.panel->timing;
    if (!tear_free() || timing.scan_lines == 0)
        return {};
    const auto lines = static_cast<std::int32_t>(timing.scan_lines);
    const auto nominal = static_cast<std::int32_t>(std::int64_t{timing.frame_us} * 1000 / lines);
    line_ns_ = nominal;
    const std::size_t looks = config_.wait_te ? 1 : 2, room = ops_.capacity() / looks - 1;
    const std::size_t periods = room < most_periods ? room : most_periods;
    const std::uint32_t at_most = 2 * timing.frame_us + grace_us;
    const std::uint8_t dummies = register_dummy_bits(caps_, *config_.panel);
    ops_.clear();
    for (std::size_t i = 0; i <= periods; ++i) {
        std::uint32_t* const moment = i == 0 ? &moments_[0] : i == periods ? &moments_[1] : nullptr;
        if (config_.wait_te) {
            ops_.wait_te(at_most, moment);
        } else { // waits until the scan enters a range of lines
            ops_.wait_line(dummies, lines / 2, lines / 4, lines, at_most);
            ops_.wait_line(dummies, 0, lines / 4, lines, at_most, moment);
        }
    }
    moments_[0] = moments_[1] = 0;
    if (const auto r = start(); !r)
        return r;
    if (const auto r = complete(); !r)
        return r.error().fault == Fault::timeout && !in_flight_ ? Result<void>{} : r;
    const std::int64_t took = moments_[1] - moments_[0];
    const auto line = static_cast<std::int32_t>(took * 1000 / (static_cast<std::int64_t>(periods) * lines));
    if (std::int64_t{4} * line >= std::int64_t{3} * nominal &&
        std::int64_t{4} * line <= std::int64_t{5} * nominal)
        line_ns_ = line;
    return {};
}

} // namespace spangle::hal
