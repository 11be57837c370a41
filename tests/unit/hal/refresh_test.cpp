// Tests when a transfer may start. The test plays the race of writer and beam row by row.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include <spangle/hal/op_list.hpp>
#include <spangle/hal/refresh.hpp>

using namespace spangle::hal;

namespace {

struct Write {
    std::int32_t row;
    std::int64_t begin, end;
};

/// Returns the number of refreshes that show both old and new rows, or a row in between, when the transfer
/// starts at `phase`.
int torn(const Refresh& r, const std::vector<Write>& writes, std::int64_t phase) {
    int count = 0;
    for (int scan = -1; scan < 6; ++scan) {
        bool shows_old = false, shows_new = false;
        for (const Write& w : writes) {
            const std::int64_t from = scan * r.period() + std::int64_t{w.row} * r.line, to = from + r.line;
            const bool before = to <= phase + w.begin, after = from >= phase + w.end;
            shows_old = shows_old || !after;
            shows_new = shows_new || !before;
        }
        count += shows_old && shows_new;
    }
    return count;
}

SafeStart safe(const Refresh& r, const std::vector<Write>& writes) {
    SafeStart s(r);
    for (const Write& w : writes)
        s.write(w.row, w.begin, w.end);
    return s;
}

/// Returns writes of `rows` rows from `top` on, or from the bottom up with `up`. Each row takes `time`.
std::vector<Write> block(std::int32_t top, std::int32_t rows, std::int64_t time, bool up = false) {
    std::vector<Write> out;
    for (std::int32_t i = 0; i < rows; ++i)
        out.push_back({up ? top + rows - 1 - i : top + i, i * time, (i + 1) * time});
    return out;
}

constexpr Refresh ili9341 = {43902, 324, 4, 43902};

} // namespace

TEST(SafeStart, LeadsWhenFasterThanTheBeamLagsWhenSlower) {
    const SafeStart fast = safe(ili9341, block(0, 320, 40000));
    ASSERT_TRUE(fast.possible());
    EXPECT_EQ(fast.after_blanking(), 0);
    const SafeStart slow = safe(ili9341, block(0, 320, 60000));
    ASSERT_TRUE(slow.possible());
    EXPECT_EQ(slow.after_blanking(), std::int64_t{43902} * (4 + 1 + 8)) << "eight lines behind the first row";
    EXPECT_FALSE(safe(ili9341, block(0, 320, 90000)).possible()) << "more than two refreshes";
    EXPECT_FALSE(safe(ili9341, block(0, 320, 40000, true)).possible()) << "against the scan";
    EXPECT_TRUE(safe({43902, 344, 24, 43902}, block(0, 320, 400, true)).possible())
        << "all of it in the blanking";
    EXPECT_TRUE(SafeStart(ili9341).possible()) << "nothing to write";
}

/// Safe starts tear no refresh: in the middle of the remaining time, right after TE, or at the reported
/// lines. If no safe start is left, every start tears.
TEST(SafeStart, NoRefreshIsTornAndNoneIsMissed) {
    std::mt19937 random(3);
    int possible = 0, impossible = 0;
    for (int n = 0; n < 4000; ++n) {
        const std::int32_t lines = 20 + static_cast<std::int32_t>(random() % 60);
        const Refresh r = {1000, lines, 2 + static_cast<std::int32_t>(random() % 8), 1000};
        const std::int32_t rows = lines - r.porch;
        std::vector<Write> writes;
        std::int64_t at = random() % 500;
        for (unsigned windows = 1 + random() % 3; windows > 0; --windows) {
            const std::int32_t top = static_cast<std::int32_t>(random()) % rows,
                               height = 1 + static_cast<std::int32_t>(random() % 20);
            const std::int64_t time = 100 + random() % 2500;
            for (Write w :
                 block(std::abs(top), std::min(height, rows - std::abs(top)), time, random() % 5 == 0))
                writes.push_back({w.row, at + w.begin, at + w.end});
            at = writes.back().end > at ? writes.back().end + random() % 300 : at;
        }
        const SafeStart s = safe(r, writes);
        if (s.possible()) {
            ++possible;
            const std::int64_t start = r.blanking() + s.after_blanking();
            ASSERT_EQ(torn(r, writes, start), 0) << n;
            ASSERT_EQ(torn(r, writes, start + r.line), 0) << n << ": a line late";
            for (std::int32_t i = 0; i < s.slack_lines(); ++i) {
                const std::int64_t line = (s.first_line() + i) % lines;
                ASSERT_EQ(torn(r, writes, line * r.line), 0) << n << " line " << line;
                ASSERT_EQ(torn(r, writes, (line + 1) * r.line), 0) << n << " at the end of line " << line;
            }
        } else {
            ++impossible;
            int clean = 0;
            for (std::int64_t phase = 0; phase < r.period(); phase += r.line / 4)
                clean += torn(r, writes, phase) == 0;
            ASSERT_LE(clean, 4 * 3) << n << ": less than the three lines that are not told";
        }
    }
    EXPECT_GT(possible, 500);
    EXPECT_GT(impossible, 500);
}

TEST(SafeStart, LinesAreAskedForRoundTheEndOfTheRefresh) {
    Op op;
    op.length = 320;
    op.rows = 10;
    op.stride = 324;
    const auto reached = [&op](int line) {
        const std::uint8_t answer[2] = {static_cast<std::uint8_t>(line >> 8),
                                        static_cast<std::uint8_t>(line)};
        return line_reached(op, answer);
    };
    EXPECT_FALSE(reached(319));
    EXPECT_TRUE(reached(320));
    EXPECT_TRUE(reached(323));
    EXPECT_TRUE(reached(0));
    EXPECT_TRUE(reached(5));
    EXPECT_FALSE(reached(6));
}
