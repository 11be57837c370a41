#include <spangle/hal/refresh.hpp>

namespace spangle::hal {
namespace {

/// How far behind the first safe moment a lagging transfer starts, where there is room for it.
constexpr std::int32_t lag_lines = 8;

} // namespace

std::int32_t SafeStart::slack_lines() const {
    const std::int64_t room = latest_ - earliest_ - 2 * std::int64_t{refresh_.line};
    if (room <= 0 || refresh_.line <= 0)
        return 0;
    const std::int64_t period = refresh_.period();
    return static_cast<std::int32_t>((room < period ? room : period) / refresh_.line);
}

std::int32_t SafeStart::first_line() const {
    std::int64_t first = earliest_ + 2 * std::int64_t{refresh_.line} - 1; // whole lines from here on
    while (first < 0) // earliest_ is a row's scan less a time within the transfer, which is below two periods
        first += refresh_.period();
    return static_cast<std::int32_t>(first / refresh_.line % refresh_.lines);
}

std::int64_t SafeStart::after_blanking() const {
    const std::int64_t period = refresh_.period();
    std::int64_t first = earliest_ - refresh_.blanking(),
                 last = latest_ - refresh_.blanking() - refresh_.line;
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
