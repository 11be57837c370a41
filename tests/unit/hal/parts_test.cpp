// A BoardDisplay links only the parts that its board asks for. On the wire it equals the display that has
// every part.
#include <gtest/gtest.h>

#include <memory>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

using namespace hal_test;

namespace {

constexpr Board with(PanelConfig display, bool te = false) {
    display.panel = &panels::st7789_135x240;
    return {.name = "parts", .display = display, .write_hz = 40000000, .read_hz = 6000000, .has_te = te};
}

// Each of these boards has one reason to have a part.
constexpr Board plain = board(with({}));
constexpr Board two_buffers = board(with({.buffers = 2}));
constexpr Board converted = board(with({.format = PixelFormat::rgba8888, .wire = wires::rgb565}));
constexpr Board read_back = board(with({.read_back = true}));
constexpr Board tear_free = board(with({.wait_te = true}, true));
constexpr Board bands = board(with({.band = 48}));

/// Draws what a program might draw into a frame or a band: one line, and every other time a clear before it.
void draw(const Frame& frame, std::int32_t rows, int n) {
    if (n % 2 == 0) {
        frame.extents->cleared = true;
        for (std::int32_t y = 0; y < rows; ++y)
            frame.extents->rows[y] = RowSpan{};
    }
    const std::int32_t y = n % rows;
    frame.extents->rows[y] = {static_cast<std::int16_t>(n), static_cast<std::int16_t>(n + 20)};
    frame.pixels[y * frame.stride + 2 * n] = static_cast<std::uint8_t>(n);
}

void draw_frame(PanelDisplay& display, int n) {
    const DisplayInfo info = display.info();
    if (info.band_height == 0) {
        const auto frame = display.acquire();
        ASSERT_TRUE(frame.ok()) << frame.error().rule;
        draw(frame.value(), info.height, n);
        ASSERT_TRUE(display.present().ok());
        return;
    }
    for (std::int32_t y = 0; y < info.height; y += info.band_height) {
        const auto frame = display.acquire_band(y, info.band_height);
        ASSERT_TRUE(frame.ok()) << frame.error().rule;
        draw(frame.value(), info.band_height, n);
        ASSERT_TRUE(display.present_band().ok());
    }
}

/// Returns what six frames put on the wire.
std::string wire(PanelDisplay& display, FakePanelBus& bus) {
    const auto ready = display.init();
    EXPECT_TRUE(ready.ok()) << ready.error().rule;
    for (int n = 0; n < 6; ++n)
        draw_frame(display, n);
    EXPECT_TRUE(display.finish().ok());
    return bus.log + std::to_string(bus.pixel_bytes) + " " + std::to_string(bus.te_waits);
}

template <const Board& board, bool Remembers = true> void same_as_with_every_part() {
    constexpr std::int32_t height = book_height(board.display);
    FakePanelBus own_bus(*board.display.panel, bus_caps(board)),
        other_bus(*board.display.panel, bus_caps(board));
    own_bus.te_period_us = other_bus.te_period_us = board.display.panel->timing.frame_us;
    const auto own = std::make_unique<BoardDisplay<board, 64, Remembers>>(own_bus);
    const auto storage = std::make_unique<PanelStorage<PanelSizes{
        .height = height, .buffers = 2, .content = Remembers ? picture_size(board.display).height : 0}>>();
    PanelDisplay other(other_bus, board.display, storage->memory());
    EXPECT_EQ(wire(*own, own_bus), wire(other, other_bus));
    EXPECT_EQ(own_bus.model.memory, other_bus.model.memory);
    EXPECT_EQ(own->counters().sent, other.counters().sent);
    EXPECT_EQ(own->counters().led + own->counters().lagged, other.counters().led + other.counters().lagged);
}

TEST(Parts, OfABoardSendWhatAllOfThemDo) {
    same_as_with_every_part<plain>();
    same_as_with_every_part<two_buffers>();
    same_as_with_every_part<converted>();
    same_as_with_every_part<read_back>();
    same_as_with_every_part<tear_free>();
    same_as_with_every_part<bands>();
    same_as_with_every_part<bands, false>();
}

/// Some rules depend on the actual bus, so init() checks them.
TEST(Parts, ABoardsDisplayChecksItsBus) {
    BusCaps caps = bus_caps(plain);
    caps.write_hz = 0;
    FakePanelBus bus(*plain.display.panel, caps);
    const auto display = std::make_unique<BoardDisplay<plain>>(bus);
    EXPECT_EQ(display->init().error().fault, Fault::unsupported);
}

/// A board's display has the code of the parts that the board asks for, and no other part.
TEST(Parts, AreThoseThatTheBoardAsksFor) {
    constexpr auto of_plain = PanelDisplay::parts_of(plain.display, true),
                   of_te = PanelDisplay::parts_of(tear_free.display, true),
                   of_reads = PanelDisplay::parts_of(read_back.display, true),
                   of_bands = PanelDisplay::parts_of(bands.display, false);
    EXPECT_EQ(of_plain.check, nullptr);
    EXPECT_EQ(of_plain.identify, nullptr);
    EXPECT_EQ(of_plain.sending.sync, nullptr);
    EXPECT_EQ(of_plain.sending.count_ops, nullptr);
    EXPECT_EQ(of_plain.present_band, nullptr);
    EXPECT_EQ(of_bands.present, nullptr);
    EXPECT_NE(of_te.sending.sync, nullptr);
    EXPECT_NE(of_te.measure, nullptr);
    EXPECT_NE(of_reads.identify, nullptr);
}

} // namespace
