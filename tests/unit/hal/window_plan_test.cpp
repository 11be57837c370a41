// Compares the window plan with the optimum of all partitions, and tests its promises on bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "hal/display/window_plan.hpp"
#include <spangle/panels.hpp>

using namespace spangle;
using namespace spangle::hal;

namespace {

bool filled(RowSpan r) {
    return r.begin < r.end;
}

std::vector<Rect> windows_of(const std::vector<RowSpan>& rows, WindowCost cost) {
    std::vector<std::uint16_t> links(rows.size() + 1, 0xFFFF);
    WindowPlan plan(rows.data(), static_cast<std::int32_t>(rows.size()), cost, links.data());
    std::vector<Rect> windows;
    for (Rect w; plan.next(w);)
        windows.push_back(w);
    EXPECT_EQ(links.back(), 0xFFFF) << "scratch beyond the last row was written";
    return windows;
}

std::uint64_t price(const std::vector<Rect>& windows, WindowCost cost) {
    std::uint64_t bytes = 0;
    for (const Rect& w : windows)
        bytes += cost.window + static_cast<std::uint64_t>(w.w) * static_cast<std::uint64_t>(w.h) * cost.pixel;
    return bytes;
}

/// Returns the least cost of all partitions into groups of consecutive rows. The search takes O(n^2) and
/// leaves nothing out.
std::uint64_t optimum(const std::vector<RowSpan>& rows, WindowCost cost) {
    std::vector<std::uint64_t> best(rows.size() + 1, 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        best[i + 1] = filled(rows[i]) ? UINT64_MAX : best[i];
        int b = INT16_MAX, e = 0;
        for (std::size_t j = i + 1; j-- > 0;) {
            if (filled(rows[j]))
                b = std::min<int>(b, rows[j].begin), e = std::max<int>(e, rows[j].end);
            if (b >= e)
                continue;
            const auto area = static_cast<std::uint64_t>(e - b) * (i + 1 - j);
            best[i + 1] = std::min(best[i + 1], best[j] + cost.window + area * cost.pixel);
        }
    }
    return best.back();
}

void expect_covers(const std::vector<RowSpan>& rows, const std::vector<Rect>& windows) {
    std::size_t y = 0;
    const auto expect_empty_until = [&](std::size_t end) {
        for (; y < end; ++y)
            ASSERT_FALSE(filled(rows[y])) << "row " << y << " is in no window";
    };
    for (const Rect& w : windows) {
        ASSERT_GT(w.w, 0);
        ASSERT_GT(w.h, 0);
        ASSERT_GE(static_cast<std::size_t>(w.y), y) << "windows overlap or go up";
        expect_empty_until(static_cast<std::size_t>(w.y));
        for (; y < static_cast<std::size_t>(w.y + w.h); ++y) {
            if (!filled(rows[y]))
                continue;
            ASSERT_LE(w.x, rows[y].begin);
            ASSERT_GE(w.x + w.w, rows[y].end);
        }
    }
    expect_empty_until(rows.size());
}

RowSpan span(int begin, int end) {
    return {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(end)};
}

int pick(std::mt19937& random, int below) {
    return static_cast<int>(random() % static_cast<unsigned>(below));
}

/// Returns damage of a shape that matters: noise, slanted edges, discs, blocks with gaps.
std::vector<RowSpan> shape(std::mt19937& random, int height, int width) {
    std::vector<RowSpan> rows(static_cast<std::size_t>(height));
    const int kind = pick(random, 4), slope = pick(random, 7) - 3, size = 1 + pick(random, width);
    int x = pick(random, width);
    for (int y = 0; y < height; ++y) {
        RowSpan& row = rows[static_cast<std::size_t>(y)];
        if (kind == 0 && pick(random, 3) != 0) {
            const int b = pick(random, width);
            row = span(b, b + 1 + pick(random, width - b));
        } else if (kind == 1) {
            x = std::clamp(x + slope, 0, width - 1);
            row = span(x, std::min(width, x + size));
        } else if (kind == 2) {
            const int half = height / 2, d = y - half, r2 = half * half - d * d;
            int r = 0;
            while ((r + 1) * (r + 1) <= r2)
                ++r;
            if (r > 0)
                row = span(std::max(0, width / 2 - r), std::min(width, width / 2 + r));
        } else if (kind == 3) {
            if (pick(random, 8) == 0)
                x = pick(random, width), row = RowSpan{};
            if ((y / 5) % 3 != 0)
                row = span(x, std::min(width, x + size));
        }
    }
    return rows;
}

} // namespace

TEST(WindowPlan, IsOptimalWithinItsReach) {
    std::mt19937 random(7);
    for (int n = 0; n < 4000; ++n) {
        const auto rows = shape(random, 1 + pick(random, WindowPlan::reach), 64);
        const WindowCost cost = {11u + static_cast<unsigned>(pick(random, 4) * pick(random, 60)),
                                 2u + static_cast<unsigned>(pick(random, 2))};
        const auto windows = windows_of(rows, cost);
        expect_covers(rows, windows);
        if (HasFatalFailure())
            return;
        ASSERT_EQ(price(windows, cost), optimum(rows, cost)) << "case " << n;
    }
}

TEST(WindowPlan, IsWithinTwoPercentOfTheOptimumOnTallPictures) {
    std::mt19937 random(8);
    double worst = 1;
    for (int n = 0; n < 400; ++n) {
        const auto rows = shape(random, 240 + pick(random, 81), 240);
        const WindowCost cost = {11u + static_cast<unsigned>(pick(random, 3) * pick(random, 200)), 2};
        const auto windows = windows_of(rows, cost);
        expect_covers(rows, windows);
        if (HasFatalFailure())
            return;
        const auto best = optimum(rows, cost);
        if (best != 0)
            worst = std::max(worst, double(price(windows, cost)) / double(best));
    }
    RecordProperty("worst_over_optimum", std::to_string(worst));
    EXPECT_LE(worst, 1.02);
}

TEST(WindowPlan, NeverCostsMoreThanRowByRow) {
    std::mt19937 random(9);
    for (int n = 0; n < 2000; ++n) {
        const auto rows = shape(random, 320, 240);
        const WindowCost cost = {11, 2};
        std::uint64_t union_bytes = 0, lines = 0;
        for (RowSpan r : rows)
            if (filled(r))
                union_bytes += static_cast<std::uint64_t>(r.end - r.begin) * 2, ++lines;
        ASSERT_LE(double(price(windows_of(rows, cost), cost)),
                  1.02 * double(union_bytes) + double(lines * 11));
    }
}

TEST(WindowPlan, ARectangleIsOneWindow) {
    std::vector<RowSpan> rows(320);
    for (int y = 10; y < 300; ++y)
        rows[static_cast<std::size_t>(y)] = span(30, 200);
    EXPECT_EQ(windows_of(rows, {11, 2}), (std::vector<Rect>{{30, 10, 170, 290}}));
}

TEST(WindowPlan, JoinsWhatItsReachCut) {
    std::vector<RowSpan> rows(320); // rows differ by one pixel: each is a run, and one window is cheapest
    for (int y = 0; y < 320; ++y)
        rows[static_cast<std::size_t>(y)] = span(0, 100 + y % 2);
    EXPECT_EQ(windows_of(rows, {11, 2}), (std::vector<Rect>{{0, 0, 101, 320}}));
}

TEST(WindowPlan, NothingIsNoWindow) {
    EXPECT_TRUE(windows_of(std::vector<RowSpan>(320), {11, 2}).empty());
    EXPECT_TRUE(windows_of({}, {11, 2}).empty());
}

TEST(WindowPlan, DearCommandsMakeOneRectangle) {
    std::vector<RowSpan> rows(100);
    for (int y = 0; y < 100; ++y)
        rows[static_cast<std::size_t>(y)] = span(y, y + 10);
    EXPECT_EQ(windows_of(rows, {1u << 18, 2}).size(), 1u);
    EXPECT_GT(windows_of(rows, {11, 2}).size(), 10u);
}

TEST(WindowCost, ComesFromTheBus) {
    BusCaps spi;
    spi.write_hz = 40000000;
    EXPECT_EQ(window_cost(spi, dcs::commands, 16).window, 11u * 8);
    spi.command_cost_ns = 10000; // an ioctl takes as long as 50 bytes at 5 MB/s
    EXPECT_EQ(window_cost(spi, dcs::commands, 16).window, (11u + 3 * 50) * 8);
    BusCaps parallel;
    parallel.write_hz = 15000000;
    parallel.bits_per_cycle = 8;
    parallel.command_cost_ns = 1000;
    EXPECT_EQ(window_cost(parallel, dcs::commands, 16).window, (11u + 3 * 15) * 8);
    spi.command_cost_ns = UINT32_MAX;
    EXPECT_EQ(window_cost(spi, dcs::commands, 16).window, 1u << 18)
        << "clamped, so that sums stay below 2^32";
    EXPECT_EQ(window_cost(spi, dcs::commands, 12).pixel, 12u);
    spi.command_cost_ns = 0;
    EXPECT_EQ(window_cost(spi, panels::oled::ranges, 1).window, 6u * 8);
    EXPECT_EQ(window_cost(spi, panels::hx8347::commands, 16).window, 17u * 8);
    EXPECT_EQ(window_cost(spi, panels::oled::pages, 1).window, 0u) << "each page is one anyway";
}
