// DamageBook by itself: what it collects is never less than what differs, whatever failed or was put off.
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <spangle/hal/damage_book.hpp>
#include <spangle/panels.hpp>

using namespace spangle;
using namespace spangle::hal;

namespace {

constexpr RowSpan all{0, 135};

struct Rig {
    PanelStorage<PanelSizes{
        .height = 240, .buffers = 2, .hashed_width = 135, .turned = true, .held = true, .indexed = true}>
        storage;
    const PanelMemory memory = storage.memory();
    PanelLayout layout;
    DamageBook book{layout, memory};

    explicit Rig(PanelConfig config = {}) {
        config.panel = &panels::st7789_135x240;
        layout = PanelLayout(config);
        layout.resolve();
        for (std::uint8_t i = 0; i < config.buffers; ++i)
            book.open_content(i);
        book.open_buffers(layout.picture.height);
        book.open();
    }
    void draw(RowSpan columns) { book.extents().rows[5] = columns; }
    void clear(std::uint32_t value = 0) {
        book.forget_drawn();
        book.extents().cleared = true;
        book.extents().clear_value = value;
    }
    /// Shows a frame that arrives.
    void show(std::uint8_t shown, std::uint8_t drawn) {
        book.collect(shown, drawn);
        book.accept(false);
        book.trust();
    }
    RowSpan row() const { return book.damage()[5]; }
};

bool nothing(RowSpan row) {
    return row.begin >= row.end;
}

TEST(DamageBookPart, CollectsWhatWasDrawnAndWhatIsCleared) {
    const auto rig = std::make_unique<Rig>();
    rig->book.collect(0, 0);
    EXPECT_EQ(rig->row(), all) << "nothing is known of the panel";
    rig->book.accept(false), rig->book.trust();
    rig->clear(), rig->draw({10, 20});
    rig->show(0, 0);
    EXPECT_EQ(rig->row(), all) << "the buffer held anything";
    rig->draw({15, 30});
    rig->show(0, 0);
    EXPECT_EQ(rig->row(), (RowSpan{15, 30})) << "drawn over what was there";
    rig->clear(), rig->draw({40, 50});
    rig->show(0, 0);
    EXPECT_EQ(rig->row(), (RowSpan{10, 50})) << "what was there is cleared";
    EXPECT_TRUE(nothing(rig->book.damage()[6]));
    rig->clear(9);
    rig->show(0, 0);
    EXPECT_EQ(rig->book.damage()[6], all) << "another clear value";
}

TEST(DamageBookPart, KeepsWhatIsInDoubt) {
    const auto rig = std::make_unique<Rig>();
    rig->show(0, 0);
    rig->draw({10, 20});
    rig->book.collect(0, 0);
    rig->book.doubt(), rig->book.accept(false);
    rig->draw({30, 40});
    rig->book.collect(0, 0);
    EXPECT_EQ(rig->row(), (RowSpan{10, 40})) << "what failed goes out again";
    rig->book.accept(false), rig->book.trust();
    rig->show(0, 0);
    EXPECT_TRUE(nothing(rig->row()));
}

TEST(DamageBookPart, ASecondBufferLacksTheFrameBefore) {
    const auto rig = std::make_unique<Rig>(PanelConfig{.buffers = 2});
    for (std::uint8_t n = 0; n < 4; ++n) {
        rig->clear();
        rig->show(n % 2 != 0 ? 0 : 1, n % 2);
    }
    rig->draw({10, 20});
    rig->show(1, 0);
    rig->draw({30, 40});
    rig->show(0, 1);
    EXPECT_EQ(rig->row(), (RowSpan{10, 40})) << "buffer 1 does not have what buffer 0 drew";
    rig->show(1, 1);
    rig->book.accept(true);
    rig->clear();
    rig->show(1, 0);
    EXPECT_FALSE(nothing(rig->row())) << "what was sent in place is not in the other buffer";
}

TEST(DamageBookPart, WhatWasPutOffComesBackUnlessItWasCleared) {
    for (const bool cleared : {false, true}) {
        const auto rig = std::make_unique<Rig>();
        rig->clear();
        rig->show(0, 0);
        rig->draw({10, 20});
        EXPECT_TRUE(rig->book.drawn_since());
        rig->book.hold_back();
        EXPECT_TRUE(rig->book.owed());
        EXPECT_FALSE(rig->book.drawn_since());
        if (cleared)
            rig->clear();
        rig->draw({30, 40});
        rig->show(0, 0);
        EXPECT_EQ(rig->row(), cleared ? (RowSpan{30, 40}) : (RowSpan{10, 40}));
        EXPECT_FALSE(rig->book.owed());
    }
}

TEST(DamageBookPart, WidensToWholeBytes) {
    const auto rig = std::make_unique<Rig>();
    rig->show(0, 0);
    rig->draw({11, 20});
    rig->show(0, 0);
    rig->book.widen({2, 8}, 240);
    EXPECT_EQ(rig->row(), (RowSpan{10, 20}));
    EXPECT_EQ(rig->book.damage()[0], (RowSpan{10, 20})) << "rows of a page share it";
    EXPECT_EQ(rig->book.damage()[7], (RowSpan{10, 20}));
    EXPECT_TRUE(nothing(rig->book.damage()[8]));
}

TEST(DamageBookPart, ColoursThatChangedAreDamageWhereTheyShow) {
    const auto rig = std::make_unique<Rig>(PanelConfig{.format = PixelFormat::index8, .wire = wires::rgb565});
    std::vector<std::uint8_t> pixels(std::size_t{135} * 240, 1);
    pixels[5 * 135 + 70] = pixels[5 * 135 + 90] = 7;
    rig->memory.palette->begin();
    rig->show(0, 0);
    rig->book.collect(0, 0);
    EXPECT_FALSE(rig->book.collect_recolored(pixels.data()));
    const std::uint8_t rgb[3] = {1, 2, 3};
    rig->memory.palette->set(7, 1, rgb);
    EXPECT_TRUE(rig->book.collect_recolored(pixels.data()));
    EXPECT_EQ(rig->row(), (RowSpan{70, 91}));
    EXPECT_TRUE(nothing(rig->book.damage()[6]));
    EXPECT_FALSE(rig->book.collect_recolored(pixels.data())) << "once";
}

TEST(DamageBookPart, HashesTakeOutWhatIsDrawnAgainUnchanged) {
    const auto rig = std::make_unique<Rig>(PanelConfig{.row_hash = true});
    ASSERT_TRUE(rig->book.hash().enabled());
    std::vector<std::uint8_t> pixels(std::size_t{270} * 240, 1);
    rig->book.collect(0, 0);
    rig->book.reduce(pixels.data(), false);
    EXPECT_EQ(rig->row(), all) << "nothing is known of the panel";
    rig->book.accept(false), rig->book.trust();
    pixels[5 * 270 + 2 * 50] = 2;
    rig->draw(all);
    rig->book.collect(0, 0);
    rig->book.reduce(pixels.data(), false);
    EXPECT_EQ(rig->row(), (RowSpan{48, 64})) << "the cell that changed";
    rig->draw(all);
    rig->book.collect(0, 0);
    rig->book.reduce(pixels.data(), true);
    EXPECT_EQ(rig->row(), all);
}

} // namespace
