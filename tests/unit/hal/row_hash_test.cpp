// Tests the row hash: what it takes for changed, how seldom it errs, and that no error stays. Tests the plan
// of spans: it covers the changed cells in order, and costs no more than the plain way.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "hal/display/span_plan.hpp"
#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal/panel_display.hpp>
#include <spangle/panels.hpp>

using namespace spangle;
using namespace spangle::hal;

namespace {

constexpr std::int32_t width = 72, height = 40; // four and a half cells a row
constexpr std::int32_t cells = RowHash::cells_of(width), stride = width * 2;

struct HashedPicture {
    RowHashStorage<height, width> storage;
    RowHashMemory memory = storage.memory();
    RowHash hash{memory, width, height, 16};
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(stride * height);
    std::vector<RowSpan> damage = std::vector<RowSpan>(height, RowSpan{0, width});

    HashedPicture() { reduce(true); }
    void reduce(bool all = false) { hash.reduce(damage.data(), pixels.data(), stride, all); }
    void damage_everything() { std::fill(damage.begin(), damage.end(), RowSpan{0, width}); }
    int changed_cells() const {
        int n = 0;
        for (std::int32_t y = 0; y < height; ++y)
            n += std::popcount(hash.changed()[y]);
        return n;
    }
};

} // namespace

TEST(RowHash, EveryCellIsSentOnceAndThenThoseThatChange) {
    HashedPicture p;
    EXPECT_EQ(p.changed_cells(), cells * height);
    p.damage_everything();
    p.reduce();
    EXPECT_EQ(p.changed_cells(), 0) << "a frame that sends nothing refreshes nothing";
    EXPECT_EQ(p.damage[3], RowSpan{});
    p.damage_everything();
    p.pixels[7 * stride + 2 * 33] = 1;
    p.pixels[9 * stride + 2 * 71 + 1] = 1; // a pixel of the cell that the row's end cuts
    p.reduce();
    EXPECT_EQ(p.hash.changed()[7], 1u << 2);
    EXPECT_EQ(p.damage[7], (RowSpan{32, 48}));
    EXPECT_EQ(p.hash.changed()[9], 1u << 4);
    EXPECT_EQ(p.damage[9], (RowSpan{64, 72}));
    EXPECT_EQ(p.changed_cells(), 3) << "and one that is refreshed";
    p.damage_everything();
    p.reduce(true);
    EXPECT_EQ(p.changed_cells(), cells * height) << "what the panel holds is not known";
}

TEST(RowHash, OnlyDamageIsLookedAt) {
    HashedPicture p;
    for (std::uint8_t& byte : p.pixels)
        byte = 0x5A;
    std::fill(p.damage.begin(), p.damage.end(), RowSpan{});
    p.damage[4] = {20, 30};
    p.reduce();
    EXPECT_EQ(p.hash.changed()[4], 1u << 1);
    EXPECT_EQ(p.damage[4], (RowSpan{20, 30})) << "the cell's part that was drawn";
}

/// After as many frames as the picture has cells, each cell was refreshed exactly once.
TEST(RowHash, AWrongCellDoesNotStay) {
    HashedPicture p;
    std::set<std::pair<std::int32_t, std::uint32_t>> refreshed;
    for (std::int32_t frame = 0; frame < cells * height; ++frame) {
        std::fill(p.damage.begin(), p.damage.end(), RowSpan{});
        p.damage[0] = {0, 1};
        p.pixels[0] ^= 1; // so that something is sent
        p.reduce();
        for (std::int32_t y = 0; y < height; ++y)
            for (std::uint32_t bits = p.hash.changed()[y]; bits != 0; bits &= bits - 1)
                refreshed.insert({y, bits & (0u - bits)});
    }
    EXPECT_EQ(refreshed.size(), static_cast<std::size_t>(cells * height));
}

/// Two different rows have equal hashes with probability 2^-32, so two million pairs show none, nor do
/// changes of few bits. Each half of a hash alone errs with 2^-16.
TEST(RowHash, CollisionsAreAsRareAsTheoremsSay) {
    std::mt19937 random(5);
    int halves[2] = {};
    for (int n = 0; n < 2000000; ++n) {
        std::uint8_t a[32], b[32];
        for (int i = 0; i < 32; ++i)
            a[i] = b[i] = static_cast<std::uint8_t>(random());
        if (n % 2 == 0)
            for (std::uint8_t& byte : b)
                byte = static_cast<std::uint8_t>(random());
        else
            b[random() % 32] ^= static_cast<std::uint8_t>(1u << random() % 8); // changes one bit
        const std::uint32_t ha = RowHash::hash(a, 32), hb = RowHash::hash(b, 32);
        ASSERT_NE(ha, hb) << n;
        halves[0] += ha >> 16 == hb >> 16;
        halves[1] += (ha & 0xFFFF) == (hb & 0xFFFF);
    }
    for (const int collisions : halves) { // expected 30.5, standard deviation 5.5
        EXPECT_GT(collisions, 5);
        EXPECT_LT(collisions, 65);
    }
}

TEST(RowHash, EveryByteCountsAndSoDoesTheLastOdd) {
    std::uint8_t bytes[64] = {};
    for (const std::int32_t count : {1, 2, 3, 31, 32, 47, 48, 63, 64})
        for (std::int32_t i = 0; i < count; ++i) {
            const std::uint32_t before = RowHash::hash(bytes, count);
            bytes[i] ^= 0x80;
            EXPECT_NE(RowHash::hash(bytes, count), before) << i << " of " << count;
        }
    std::uint8_t longer[3] = {1, 2, 3};
    const std::uint32_t two = RowHash::hash(longer, 2);
    longer[2] = 9;
    EXPECT_EQ(RowHash::hash(longer, 2), two) << "nothing beyond the count is read";
}

TEST(RowHash, StorageIsHeldAgainstThePicture) {
    PanelDesc large = panels::ili9341_240x320;
    large.memory = large.glass = {600, 20};
    hal_test::FakePanelBus bus(large, hal_test::spi());
    PanelStorage<PanelSizes{.height = 20}> storage;
    PanelConfig config;
    config.panel = &large;
    config.row_hash = true;
    PanelDisplay wide(bus, config, storage.memory());
    EXPECT_STREQ(wide.init().error().rule, "display: the row hash serves pictures up to 512 columns");
    PanelDesc fits = large;
    fits.glass.width = 500;
    config.panel = &fits;
    PanelDisplay without(bus, config, storage.memory());
    EXPECT_STREQ(without.init().error().rule, "display: the storage has no room for the row hash");
    PanelStorage<PanelSizes{.height = 20, .hashed_width = 500}> hashed;
    PanelDisplay with(bus, config, hashed.memory());
    EXPECT_TRUE(with.init().ok());
}

// --- The plan of spans

namespace {

using Masks = std::vector<std::uint32_t>;

/// Returns the cost of a window around each maximal block of equal runs below each other.
std::uint64_t plain_cost(const Masks& rows, std::int32_t columns, WindowCost cost) {
    std::uint64_t bytes = 0;
    std::set<std::pair<int, int>> above;
    for (const std::uint32_t mask : rows) {
        std::set<std::pair<int, int>> runs;
        for (int c = 0; c < 32;) {
            if ((mask >> c & 1u) == 0) {
                ++c;
                continue;
            }
            const int first = c;
            while (c < 32 && (mask >> c & 1u) != 0)
                ++c;
            runs.insert({first, c});
            bytes += static_cast<std::uint64_t>(std::min(16 * c, columns) - 16 * first) * cost.pixel;
            bytes += above.count({first, c}) == 0 ? cost.window : 0;
        }
        above = runs;
    }
    return bytes;
}

struct Costs {
    std::uint64_t planned = 0, plain = 0;
};

/// Changed cells, as the row hash leaves them.
struct Changed {
    std::vector<SpanWindow> windows = std::vector<SpanWindow>(RowHashMemory::window_count);
    Masks rows;
    RowHashMemory memory;
    RowHash hash;

    Changed(const Masks& masks, std::int32_t columns)
        : rows(masks), memory{nullptr, rows.data(), windows.data(), 0, &row_hash_code},
          hash(memory, columns, static_cast<std::int32_t>(rows.size()), 2) {}
};

void expect_good_plan(const Masks& rows, std::int32_t columns, WindowCost cost, Costs& costs) {
    const Changed changed(rows, columns);
    SpanPlan plan(changed.hash, cost);
    std::vector<Rect> windows;
    for (Rect w; plan.next(w);)
        windows.push_back(w);
    Masks covered(rows.size(), 0);
    std::uint64_t bytes = 0;
    std::int32_t top = 0;
    for (const Rect& w : windows) {
        ASSERT_GE(w.y, top) << "windows go from the top down";
        top = w.y;
        ASSERT_TRUE(w.x >= 0 && w.w > 0 && w.h > 0 && w.x + w.w <= columns);
        ASSERT_LE(w.y + w.h, static_cast<std::int32_t>(rows.size()));
        bytes += cost.window + static_cast<std::uint64_t>(w.w * w.h) * cost.pixel;
        for (std::int32_t y = w.y; y < w.y + w.h; ++y)
            for (std::int32_t c = w.x / 16; c * 16 < w.x + w.w; ++c)
                covered[static_cast<std::size_t>(y)] |= 1u << c;
    }
    for (std::size_t y = 0; y < rows.size(); ++y)
        ASSERT_EQ(rows[y] & ~covered[y], 0u) << "row " << y;
    EXPECT_EQ(bytes, plan.total_cost());
    const std::uint64_t plain = plain_cost(rows, columns, cost);
    costs.planned += bytes;
    costs.plain += plain;
    const bool cheap = cost.window < 16 * cost.pixel && columns % 16 == 0;
    if (cheap && windows.size() <= 48) { // no window had to be cut
        EXPECT_EQ(bytes, plain);
    }
    EXPECT_LE(bytes, 2 * plain);
    plan.rewind();
    for (const Rect& w : windows) {
        Rect again;
        ASSERT_TRUE(plan.next(again));
        EXPECT_EQ(again, w);
    }
}

} // namespace

TEST(SpanPlan, CoversTheCellsForLess) {
    std::mt19937 random(11);
    Costs cheap, dear;
    for (int n = 0; n < 3000; ++n) {
        const std::int32_t columns = 1 + static_cast<std::int32_t>(random() % 512);
        const std::uint32_t inside = 0xFFFFFFFFu >> (32 - RowHash::cells_of(columns));
        Masks rows(1 + random() % 60);
        std::uint32_t mask = random();
        for (std::uint32_t& row : rows) { // each row resembles its neighbour
            if (random() % 3 == 0)
                mask ^= 1u << random() % 32;
            if (random() % 16 == 0)
                mask = random() & random();
            row = random() % 8 == 0 ? 0 : mask & inside;
        }
        const WindowCost cost = {random() % 2 == 0 ? 11u : static_cast<std::uint32_t>(random() % 800),
                                 2 + static_cast<std::uint32_t>(random() % 2)};
        expect_good_plan(rows, columns, cost, cost.window == 11 ? cheap : dear);
    }
    EXPECT_LE(cheap.planned, cheap.plain + cheap.plain / 500) << "long windows are cut now and then";
    EXPECT_LE(dear.planned, dear.plain * 96 / 100);
}

TEST(SpanPlan, BlocksBesideEachOtherStayApartAndDearCommandsJoinThem) {
    const Masks rows(10, 0x21u);
    const Changed changed(rows, 320);
    SpanPlan cheap(changed.hash, {11, 2});
    Rect w;
    ASSERT_TRUE(cheap.next(w));
    EXPECT_EQ(w, (Rect{0, 0, 16, 10}));
    ASSERT_TRUE(cheap.next(w));
    EXPECT_EQ(w, (Rect{80, 0, 16, 10}));
    EXPECT_FALSE(cheap.next(w));
    EXPECT_EQ(cheap.total_cost(), 2 * (11 + 16 * 10 * 2));
    SpanPlan dear(changed.hash, {2000, 2});
    ASSERT_TRUE(dear.next(w));
    EXPECT_EQ(w, (Rect{0, 0, 96, 10}));
    EXPECT_FALSE(dear.next(w));
}

/// A window that could still grow while a hundred others wait behind it is cut.
TEST(SpanPlan, ManyWindowsBesideALongOneFitTheRing) {
    Masks rows(300, 1);
    for (std::size_t y = 0; y < rows.size(); ++y)
        rows[y] |= y % 2 == 0 ? 0x10u : 0x400u;
    Costs costs;
    expect_good_plan(rows, 320, {11, 2}, costs);
    EXPECT_LT(costs.planned, costs.plain + 8 * 11);
}

TEST(SpanPlan, NothingChangedIsNoWindow) {
    const Masks rows(5, 0);
    const Changed changed(rows, 320);
    SpanPlan plan(changed.hash, {11, 2});
    Rect w;
    EXPECT_FALSE(plan.next(w));
    EXPECT_EQ(plan.total_cost(), 0u);
    EXPECT_EQ(SpanPlan().total_cost(), UINT32_MAX);
}
