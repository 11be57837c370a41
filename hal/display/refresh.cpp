#include <spangle/hal/refresh.hpp>

namespace spangle::hal {
namespace {

/// How many lines after the first safe moment a lagging transfer starts, where there is room for it.
constexpr std::int32_t lag_lines = 8;

} // namespace

std::int32_t SafeStart::slack_lines() const {
    if (refresh_.line <= 0)
        return 0;
    // A line that begins after `earliest_` may begin one whole line later.
    const std::int64_t room = latest_ - refresh_.jitter - earliest_ - refresh_.line;
    const std::int64_t period = refresh_.period();
    return room <= 0 ? 0 : static_cast<std::int32_t>((room < period ? room : period) / refresh_.line);
}

std::int32_t SafeStart::first_line() const {
    std::int64_t first = earliest_ + refresh_.line - 1;
    // The loop takes at most two rounds, because `first` is above -2 periods.
    while (first < 0)
        first += refresh_.period();
    return static_cast<std::int32_t>(first / refresh_.line % refresh_.lines);
}

std::int64_t SafeStart::after_blanking() const {
    const std::int64_t period = refresh_.period();
    std::int64_t first = earliest_ - refresh_.blanking(),
                 last = latest_ - refresh_.jitter - refresh_.blanking();
    for (; last >= period; last -= period)
        first -= period;
    for (; last < 0; last += period)
        first += period;
    if (first <= 0)
        return 0;
    const std::int64_t lag = std::int64_t{lag_lines} * refresh_.line, half = (last - first) / 2;
    return first + (lag < half ? lag : half);
}

} // namespace spangle::hal
