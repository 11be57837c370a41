// Bands by itself: which rows can be a band, and what of a band the panel lacks.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <spangle/hal/bands.hpp>
#include <spangle/panels.hpp>

using namespace spangle;
using namespace spangle::hal;

namespace {

constexpr RowSpan all{0, 135};

struct Rig {
    PanelLayout layout;
    std::vector<RowSpan> shown = std::vector<RowSpan>(240), touched = std::vector<RowSpan>(48),
                         damage = std::vector<RowSpan>(48);
    Bands bands{layout};

    explicit Rig(PanelConfig config = {.band = 48}, bool remembers = true) {
        config.panel = &panels::st7789_135x240;
        layout = PanelLayout(config);
        layout.resolve();
        bands.open(remembers ? shown.data() : nullptr);
    }
    /// Draws a band in one row of it, and returns the damage of that row and of the one below.
    std::array<RowSpan, 2> band(std::int32_t first, RowSpan drawn, std::uint32_t clear_value = 0) {
        EXPECT_TRUE(bands.check(first, 48).ok());
        bands.begin(first, 48);
        EXPECT_TRUE(bands.acquired());
        bands.hand_over();
        EXPECT_FALSE(bands.acquired());
        std::fill(touched.begin(), touched.end(), RowSpan{});
        touched[5] = drawn;
        bands.collect({touched.data(), 48, true, clear_value}, damage.data());
        EXPECT_EQ(bands.sent(), first == 192);
        return {damage[5], damage[6]};
    }
    void frame(RowSpan drawn) {
        for (std::int32_t first = 0; first < 240; first += 48)
            band(first, drawn);
    }
};

TEST(BandsPart, TakesRowsThatABufferHoldsAndThatEndWithBytes) {
    const Rig rig;
    for (const auto& [first, rows] : {std::pair{0, 48}, {0, 1}, {239, 1}, {192, 48}})
        EXPECT_TRUE(rig.bands.check(first, rows).ok()) << first << ' ' << rows;
    for (const auto& [first, rows] : {std::pair{-1, 1}, {0, 0}, {0, 49}, {193, 48}, {240, 1}})
        EXPECT_EQ(rig.bands.check(first, rows).error().fault, Fault::bad_argument) << first << ' ' << rows;
    PanelLayout pages(PanelConfig{.panel = &panels::ssd1306_128x64, .wire = wires::mono, .band = 16});
    pages.resolve();
    const Bands bands(pages);
    EXPECT_TRUE(bands.check(8, 16).ok());
    EXPECT_FALSE(bands.check(4, 8).ok());
    EXPECT_FALSE(bands.check(8, 4).ok());
}

TEST(BandsPart, SendsWhatWasDrawnAndWhatThePanelStillShows) {
    Rig rig;
    EXPECT_EQ(rig.band(0, {3, 9})[1], all) << "nothing is known of the panel";
    Rig known;
    known.frame({10, 20});
    EXPECT_EQ(known.band(0, {30, 40})[0], (RowSpan{10, 40})) << "what was there is cleared";
    EXPECT_EQ(known.band(48, {})[0], (RowSpan{10, 20}));
    EXPECT_GE(known.damage[6].begin, known.damage[6].end) << "a row that was clear and is";
}

TEST(BandsPart, SendsEverythingWhereTheClearValueChanged) {
    Rig rig;
    rig.frame({10, 20});
    EXPECT_EQ(rig.band(0, {10, 20}, 7)[1], all);
    EXPECT_EQ(rig.band(48, {10, 20}, 7)[1], all);
    for (std::int32_t first = 96; first < 240; first += 48)
        rig.band(first, {10, 20}, 7);
    EXPECT_EQ(rig.band(0, {11, 12}, 7)[0], (RowSpan{10, 20})) << "the whole frame has the new value";
}

TEST(BandsPart, ForgetsAFrameThatEndedEarly) {
    Rig rig;
    rig.frame({10, 20});
    rig.band(0, {10, 20}, 7);
    EXPECT_EQ(rig.band(0, {10, 20})[1], all);
    rig.bands.forget();
    EXPECT_EQ(rig.band(48, {10, 20})[1], all);
}

TEST(BandsPart, WithoutARecordEverythingIsSent) {
    Rig rig({.band = 48}, false);
    rig.frame({10, 20});
    EXPECT_EQ(rig.band(0, {10, 20})[1], all);
    rig.bands.forget();
}

} // namespace
