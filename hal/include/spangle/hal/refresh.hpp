// The refresh of a panel, and when a frame may start so that none shows parts of two frames.
#pragma once

#include <cstdint>

namespace spangle::hal {

/// Times in nanoseconds. Row 0 of the memory is scanned first; blanking follows the last.
struct Refresh {
    std::int32_t line = 0;   ///< time of one line
    std::int32_t lines = 0;  ///< lines of a refresh, porches included
    std::int32_t porch = 0;  ///< lines of vertical blanking
    std::int32_t jitter = 0; ///< longest time from the awaited moment to the first byte

    /// The time of one refresh, in nanoseconds.
    std::int64_t period() const { return std::int64_t{line} * lines; }
    /// The time at which TE rises, counted from the start of the scan.
    std::int64_t blanking() const { return std::int64_t{line} * (lines - porch); }
};

/// The phases of the refresh at which a transfer may start. A row must be written after one scan of it and
/// before the next, and all rows between the same two. So a transfer that is faster than the beam starts in
/// the blanking and leads it; a slower one lags behind it, and must end before the beam comes round again:
/// where that is impossible, no phase is left.
class SafeStart {
  public:
    /// All phases are free until write() is called.
    explicit SafeStart(const Refresh& refresh) : refresh_(refresh) {}

    /// Adds a row that is written from `begin` to `end`, counted from the start of the transfer.
    void write(std::int32_t row, std::int64_t begin, std::int64_t end) {
        const std::int64_t after = (std::int64_t{row} + 1) * refresh_.line - begin;
        const std::int64_t before = refresh_.period() + std::int64_t{row} * refresh_.line - end;
        earliest_ = after > earliest_ ? after : earliest_;
        latest_ = before < latest_ ? before : latest_;
    }

    /// Whole lines in which a transfer may be told to start.
    std::int32_t slack_lines() const;
    /// Whether some start is free of tears.
    bool possible() const { return slack_lines() > 0; }
    /// How many nanoseconds a transfer waits after TE rises.
    std::int64_t after_blanking() const;
    /// The first of the slack_lines() lines in which a transfer may start. It may be one of a later refresh.
    std::int32_t first_line() const;

  private:
    Refresh refresh_;
    /// The starts that are allowed, counted from the scan of row 0. Without rows: any time.
    std::int64_t earliest_ = INT64_MIN / 2, latest_ = INT64_MAX / 2;
};

} // namespace spangle::hal
