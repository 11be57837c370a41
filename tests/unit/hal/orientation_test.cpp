// With every geometry in every orientation, pixels land where a person who looks at the glass expects them,
// and nowhere else.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/hal/dcs_model.hpp"
#include <spangle/hal/orientation.hpp>
#include <spangle/panels.hpp>

using namespace spangle::hal;

namespace {

struct Point {
    int x, y;
};

/// Returns where a picture's pixel is on upright glass of w x h: the picture is mirrored left to right, then
/// turned clockwise.
Point seen_at(Point p, Orientation o, int glass_w, int glass_h) {
    const bool sideways = o.rotation == Rotation::r90 || o.rotation == Rotation::r270;
    const int width = sideways ? glass_h : glass_w;
    if (o.mirrored)
        p.x = width - 1 - p.x;
    switch (o.rotation) {
    case Rotation::r0:
        return p;
    case Rotation::r90: // right in the picture is down on the glass, down is left
        return {glass_w - 1 - p.y, p.x};
    case Rotation::r180:
        return {glass_w - 1 - p.x, glass_h - 1 - p.y};
    case Rotation::r270:
        return {p.y, glass_h - 1 - p.x};
    }
    return {};
}

/// Returns the memory cell behind a point of upright glass.
std::uint32_t shown(const hal_test::DcsModel& model, const PanelDesc& panel, Point p) {
    const int gx = panel.mount & 0x40 ? panel.glass.width - 1 - p.x : p.x;
    const int gy = panel.mount & 0x80 ? panel.glass.height - 1 - p.y : p.y;
    return model.at(panel.offset.x + gx, panel.offset.y + gy);
}

void write_window(hal_test::DcsModel& model, const Placement& placed, int x, int y, int w, int h,
                  std::uint32_t tag) {
    model.madctl = placed.madctl;
    model.xs = x + placed.offset.x, model.xe = model.xs + w - 1;
    model.ys = y + placed.offset.y, model.ye = model.ys + h - 1;
    model.ramwr();
    for (int v = 0; v < h; ++v)
        for (int u = 0; u < w; ++u)
            model.pixel(tag + static_cast<std::uint32_t>((y + v) * 1024 + x + u));
}

} // namespace

TEST(Orientation, EveryPixelOfEveryWindowLandsWhereItIsSeen) {
    std::mt19937 random(1);
    long checked = 0;
    for (const PanelDesc* panel : panels::all) {
        if (panel->commands != &dcs::commands)
            continue; // DcsModel addresses memory in this way only
        for (const Orientation o : orientations) {
            const Placement placed = place(*panel, o);
            hal_test::DcsModel model(panel->memory.width, panel->memory.height);
            std::vector<std::uint32_t> picture(
                static_cast<std::size_t>(placed.size.width * placed.size.height));
            for (int n = 0; n < 41; ++n) {
                int x = 0, y = 0, w = placed.size.width, h = placed.size.height;
                if (n > 0) {
                    x = static_cast<int>(random()) & 0x7FFF, y = static_cast<int>(random()) & 0x7FFF;
                    x %= placed.size.width, y %= placed.size.height;
                    w = 1 + (static_cast<int>(random()) & 0x7FFF) % (placed.size.width - x);
                    h = 1 + (static_cast<int>(random()) & 0x7FFF) % (placed.size.height - y);
                }
                const std::uint32_t tag = static_cast<std::uint32_t>(n) << 20;
                write_window(model, placed, x, y, w, h, tag);
                for (int v = y; v < y + h; ++v)
                    for (int u = x; u < x + w; ++u)
                        picture[static_cast<std::size_t>(v * placed.size.width + u)] =
                            tag + static_cast<std::uint32_t>(v * 1024 + u);
            }
            ASSERT_EQ(model.stray, 0) << panel->name;
            ASSERT_EQ(model.overrun, 0) << panel->name;
            for (int y = 0; y < placed.size.height; ++y) {
                for (int x = 0; x < placed.size.width; ++x, ++checked) {
                    const Point p = seen_at({x, y}, o, panel->glass.width, panel->glass.height);
                    ASSERT_EQ(shown(model, *panel, p),
                              picture[static_cast<std::size_t>(y * placed.size.width + x)])
                        << panel->name << " rotation " << static_cast<int>(o.rotation) << " mirrored "
                        << o.mirrored << " at " << x << "," << y;
                }
            }
            long outside = 0;
            for (std::uint32_t cell : model.memory)
                outside += cell == 0xDEADBEEF;
            ASSERT_EQ(outside,
                      panel->memory.width * panel->memory.height - panel->glass.width * panel->glass.height)
                << panel->name << ": written outside the glass";
        }
    }
    EXPECT_GT(checked, 3000000);
}

TEST(Orientation, OffsetsOfSt7789Behind135x240) {
    struct {
        unsigned madctl;
        int x, y;
    } const vectors[] = {{0x00, 52, 40}, {0x80, 52, 40}, {0x20, 40, 52}, {0xA0, 40, 52},
                         {0x40, 53, 40}, {0xC0, 53, 40}, {0x60, 40, 53}, {0xE0, 40, 53}};
    unsigned seen = 0;
    for (const Orientation o : orientations) {
        const Placement placed = place(panels::st7789_135x240, o);
        for (const auto& v : vectors) {
            if (v.madctl != placed.madctl)
                continue;
            ++seen;
            EXPECT_EQ(placed.offset.x, v.x) << std::hex << v.madctl;
            EXPECT_EQ(placed.offset.y, v.y) << std::hex << v.madctl;
        }
    }
    EXPECT_EQ(seen, 8u);
}

TEST(Orientation, MadctlOfIli9341ModulesIsTheOneEverybodyUses) {
    const auto madctl = [](Rotation r) {
        return place(panels::ili9341_240x320, {r, false}).madctl | dcs::BGR;
    };
    EXPECT_EQ(madctl(Rotation::r0), 0x48);
    EXPECT_EQ(madctl(Rotation::r90), 0x28);
    EXPECT_EQ(madctl(Rotation::r180), 0x88);
    EXPECT_EQ(madctl(Rotation::r270), 0xE8);
}

TEST(Orientation, IsConstant) {
    constexpr Placement placed = place(panels::st7789_240x240, {Rotation::r180, false});
    constexpr bool as_manuals_say = placed.offset.x == 0 && placed.offset.y == 80 && placed.madctl == 0xC0;
    EXPECT_TRUE(as_manuals_say);
    constexpr Placement turned = place(panels::st7789_240x240, {Rotation::r90, true});
    constexpr int width = turned.size.width;
    EXPECT_EQ(width, 240);
}
