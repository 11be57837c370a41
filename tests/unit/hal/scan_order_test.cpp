// Turned pictures use the same memory cells, send rows in the order of the scan, and have their damage where
// the pixels went.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/unit/hal/dcs_model.hpp"
#include <spangle/hal/scan_order.hpp>
#include <spangle/panels.hpp>

using namespace spangle;
using namespace spangle::hal;

namespace {

/// Returns the memory cell behind the host's address (x, y).
std::pair<int, int> cell(const PanelDesc& panel, const Placement& placed, int x, int y) {
    int column = x + placed.offset.x, row = y + placed.offset.y;
    if ((placed.madctl & dcs::MV) != 0)
        std::swap(column, row);
    if ((placed.madctl & dcs::MX) != 0)
        column = panel.memory.width - 1 - column;
    if ((placed.madctl & dcs::MY) != 0)
        row = panel.memory.height - 1 - row;
    return {column, row};
}

} // namespace

TEST(ScanOrder, TheSameCellsInTheOrderOfTheScan) {
    const PanelDesc* const all[] = {&panels::ili9341_240x320, &panels::st7789_135x240,
                                    &panels::st7735_128x160_green, &panels::st7789_240x280};
    for (const PanelDesc* panel : all)
        for (const Orientation o : orientations) {
            const Placement placed = place(*panel, o);
            const ScanOrder order = scan_order(*panel, o);
            EXPECT_EQ(order.placement.madctl & (dcs::MV | dcs::MY), 0);
            EXPECT_EQ(order.turns(), (placed.madctl & (dcs::MV | dcs::MY)) != 0);
            for (const int x : {0, 1, 17, placed.size.width - 1})
                for (const int y : {0, 2, 50, placed.size.height - 1}) {
                    const int column = order.swapped ? y : x, row = order.row_of(order.swapped ? x : y);
                    ASSERT_EQ(cell(*panel, order.placement, column, row), cell(*panel, placed, x, y))
                        << panel->name << " " << x << "," << y;
                }
        }
}

TEST(ScanOrder, TurnsDamageAndNothingElse) {
    std::mt19937 random(2);
    for (const std::int32_t bytes : {2, 3})
        for (const Orientation o : orientations) {
            const PanelDesc& panel = panels::st7735_80x160;
            const Extent picture = place(panel, o).size;
            const ScanOrder order = scan_order(panel, o);
            const Extent buffer = order.placement.size;
            const std::int32_t from_stride = picture.width * bytes, to_stride = buffer.width * bytes;
            std::vector<std::uint8_t> from(static_cast<std::size_t>(from_stride * picture.height));
            std::vector<std::uint8_t> to(static_cast<std::size_t>(to_stride * buffer.height), 0xEE);
            for (std::uint8_t& byte : from)
                byte = static_cast<std::uint8_t>(random() % 0xEE);
            std::vector<RowSpan> damage(static_cast<std::size_t>(picture.height)),
                turned(static_cast<std::size_t>(buffer.height), RowSpan{3, 9});
            for (RowSpan& row : damage)
                if (random() % 3 != 0) {
                    const int a = static_cast<int>(random()) & 63, b = static_cast<int>(random()) & 63;
                    row = {static_cast<std::int16_t>(std::min(a, b)),
                           static_cast<std::int16_t>(std::max(a, b))};
                }
            turn(order, {from.data(), from_stride, picture.height, to.data(), to_stride, bytes},
                 damage.data(), turned.data());
            std::vector<RowSpan> wanted(turned.size());
            std::vector<std::uint8_t> copied(to.size(), 0xEE);
            for (std::int32_t y = 0; y < picture.height; ++y)
                for (std::int32_t x = damage[static_cast<std::size_t>(y)].begin;
                     x < damage[static_cast<std::size_t>(y)].end; ++x) {
                    const std::int32_t column = order.swapped ? y : x,
                                       row = order.row_of(order.swapped ? x : y);
                    RowSpan& span = wanted[static_cast<std::size_t>(row)];
                    span.begin = std::min(span.begin, static_cast<std::int16_t>(column));
                    span.end = std::max(span.end, static_cast<std::int16_t>(column + 1));
                    for (std::int32_t b = 0; b < bytes; ++b)
                        copied[static_cast<std::size_t>(row * to_stride + column * bytes + b)] =
                            from[static_cast<std::size_t>(y * from_stride + x * bytes + b)];
                }
            EXPECT_EQ(to, copied);
            EXPECT_EQ(turned, wanted);
        }
}
