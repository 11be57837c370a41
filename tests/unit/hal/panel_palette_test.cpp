// The palette of a panel display holds 256 colours, and set_palette() writes no byte outside of them.
#include <algorithm>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal/panel_display.hpp>
#include <spangle/panels.hpp>

using namespace hal_test;

namespace {

/// The memory of a display of indices, between bytes that must stay as they are.
struct Fenced {
    std::uint8_t before[64];
    Palette palette;
    std::uint8_t behind[64];
};

TEST(PanelPalette, IndicesOutsideOfItAreAnError) {
    if (!is_drawable(PixelFormat::index8))
        GTEST_SKIP() << "this build has no surfaces of indices";
    const PanelDesc& panel = panels::st7789_135x240;
    FakePanelBus bus(panel, spi());
    const auto storage = std::make_unique<PanelStorage<PanelSizes{.height = 240}>>();
    const auto fenced = std::make_unique<Fenced>();
    std::memset(fenced.get(), 0xC5, sizeof *fenced);
    PanelMemory memory = storage->memory();
    memory.palette = &fenced->palette;
    PanelDisplay display(
        bus, {.panel = &panel, .format = PixelFormat::index8, .wire = wires::rgb565, .reset_line = true},
        memory);
    ASSERT_TRUE(display.init().ok());
    const Palette initial = fenced->palette;
    std::uint8_t rgb[3 * 8];
    std::memset(rgb, 0x37, sizeof rgb);
    struct Range {
        std::int32_t first, count;
    };
    for (const Range wrong :
         {Range{256, 1}, {252, 8}, {255, 2}, {-1, 1}, {-1, 2}, {0, -1}, {257, 0}, {INT32_MAX, 1}}) {
        const auto r = display.set_palette(wrong.first, wrong.count, rgb);
        EXPECT_EQ(r.error().fault, Fault::bad_argument) << wrong.first << ' ' << wrong.count;
        EXPECT_STREQ(r.error().rule, "display: indices of a palette are 0 to 255");
    }
    EXPECT_EQ(std::memcmp(&initial, &fenced->palette, sizeof initial), 0) << "no colour was set";
    const auto untouched = [](std::uint8_t byte) { return byte == 0xC5; };
    EXPECT_TRUE(std::all_of(fenced->before, fenced->before + 64, untouched));
    EXPECT_TRUE(std::all_of(fenced->behind, fenced->behind + 64, untouched));

    ASSERT_TRUE(display.set_palette(248, 8, rgb).ok()) << "the last eight colours";
    EXPECT_EQ(fenced->palette.color[255][2], 0x37);
    EXPECT_TRUE(fenced->palette.is_stale(255));
    EXPECT_FALSE(fenced->palette.is_stale(247));
    EXPECT_TRUE(display.set_palette(256, 0, rgb).ok()) << "no colour at all";
}

} // namespace
