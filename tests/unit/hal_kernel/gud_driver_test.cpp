// Runs the kernel's own gud driver on the device model that judges Spangle's host. Others wrote the driver
// from the same protocol.
#include <array>
#include <ostream>

#include <fcntl.h>
#include <linux/fb.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "tests/support/random.hpp"
#include "tests/unit/hal_kernel/drm_card.hpp"
#include "tests/unit/hal_kernel/plugged_gud.hpp"

namespace {

using namespace kernel_test;
using namespace spangle;
using Rgb = std::array<int, 3>;

/// Returns what the panel shows of a component of eight bits when it has only the upper `bits`.
int shown(std::uint32_t eight, unsigned bits) {
    return static_cast<int>((eight >> (8 - bits)) * 255 / ((1u << bits) - 1));
}

/// Returns the colour that the panel shows of an XRGB8888 pixel, as the driver converts it
/// (drm_format_helper.c).
Rgb expected(std::uint32_t pixel, std::uint8_t format) {
    const std::uint32_t r = pixel >> 16 & 255, g = pixel >> 8 & 255, b = pixel & 255;
    const std::uint32_t grey = (3 * r + 6 * g + b) / 10;
    switch (format) {
    case 0x01:
        return {shown(grey, 1), shown(grey, 1), shown(grey, 1)};
    case 0x08:
        return {shown(grey, 8), shown(grey, 8), shown(grey, 8)};
    case 0x20:
        return {shown(r, 1), shown(g, 1), shown(b, 1)};
    case 0x30:
        return {shown(r, 3), shown(g, 3), shown(b, 2)};
    case 0x40:
        return {shown(r, 5), shown(g, 6), shown(b, 5)};
    default:
        return {shown(r, 8), shown(g, 8), shown(b, 8)};
    }
}

std::uint32_t widened(std::uint32_t rgb565) {
    return (rgb565 >> 11) << 19 | (rgb565 >> 5 & 63) << 10 | (rgb565 & 31) << 3;
}

/// Returns whether the glass shows exactly the picture pixel(x, y), in XRGB8888.
template <class Pixel> bool shows(PluggedGud& gud, Pixel pixel) {
    const std::lock_guard lock(gud.usb);
    const sim::Image glass = gud.device.glass();
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x) {
            const std::uint8_t* const got = glass.at(x, y);
            if (expected(pixel(x, y), gud.device.formats.front()) != Rgb{got[0], got[1], got[2]})
                return false;
        }
    return glass.width > 0;
}

struct Case {
    const char* name;
    std::uint8_t format;
    unsigned bits = 32;
    bool lz4 = true, full_update = false, status_on_set = false;
    std::uint32_t max_buffer_size = 0;
};
void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class KernelGudDriver : public testing::TestWithParam<Case> {};

TEST_P(KernelGudDriver, DrawsExactly) {
    const Case& c = GetParam();
    PluggedGud gud;
    gud.size(200, 120);
    gud.device.formats = {c.format};
    gud.device.lz4 = c.lz4;
    gud.device.full_update = c.full_update;
    gud.device.status_on_set = c.status_on_set;
    gud.device.max_buffer_size = c.max_buffer_size;
    ASSERT_NO_FATAL_FAILURE(gud.plug());
    DrmCard card(gud_card, c.bits);
    ASSERT_EQ(card.width(), 200);
    ASSERT_EQ(card.height(), 120);
    test::Random random{17};
    for (unsigned i = 0; i < 60; ++i) {
        const int x = static_cast<int>(random.below(200)), y = static_cast<int>(random.below(120));
        const Rect area = {x, y, 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(200 - x))),
                           1 + static_cast<int>(random.below(static_cast<std::uint32_t>(120 - y)))};
        const std::uint32_t flat = random.below(1u << 24);
        for (int row = area.y; row < area.y + area.h; ++row)
            for (int column = area.x; column < area.x + area.w; ++column)
                card.put(column, row, i % 3 == 0 ? flat : random.below(1u << 24));
        card.flush(area);
    }
    await("show the picture", [&] {
        return shows(gud,
                     [&](int x, int y) { return c.bits == 16 ? widened(card.get(x, y)) : card.get(x, y); });
    });
    EXPECT_EQ(gud.violations(), "");
    EXPECT_EQ(gud.device.counters().compressed != 0, c.lz4);
    if (c.max_buffer_size != 0) {
        EXPECT_LE(gud.device.counters().largest_buffer, c.max_buffer_size);
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, KernelGudDriver,
                         testing::Values(Case{"rgb565", 0x40, 16}, Case{"rgb565_from_32_bits", 0x40},
                                         Case{"raw", 0x40, 16, false}, Case{"rgb888", 0x50},
                                         Case{"xrgb8888", 0x80}, Case{"rgb332", 0x30}, Case{"grey", 0x08},
                                         Case{"mono", 0x01}, Case{"xrgb1111", 0x20},
                                         Case{"small_buffer", 0x40, 16, true, false, false, 9000},
                                         Case{"full_update", 0x40, 16, false, true},
                                         Case{"status_on_set", 0x40, 16, true, false, true}),
                         [](const auto& tested) { return tested.param.name; });

/// The kernel's text console draws on the display, and the glass must show what /dev/fb0 holds.
TEST(KernelGudConsole, WritesOnTheGlass) {
    PluggedGud gud;
    gud.size(240, 136);
    ASSERT_NO_FATAL_FAILURE(gud.plug());
    write_text("/dev/tty1",
               "\033[?25l\033[2J\033[H\033[1;33mSpangle\033[0m on the kernel's console\n\r\033[7mgud\033[0m");
    int fb = -1; // the framebuffer comes later than the card
    await("give the console a framebuffer", [&] {
        fb = open("/dev/fb0", O_RDONLY | O_CLOEXEC);
        return fb >= 0;
    });
    fb_var_screeninfo screen{};
    fb_fix_screeninfo memory{};
    ASSERT_EQ(ioctl(fb, FBIOGET_VSCREENINFO, &screen), 0);
    ASSERT_EQ(ioctl(fb, FBIOGET_FSCREENINFO, &memory), 0);
    std::vector<std::uint8_t> bytes(std::size_t{memory.line_length} * screen.yres);
    const auto pixel = [&](int x, int y) {
        const std::uint8_t* const at = &bytes[static_cast<std::size_t>(y) * memory.line_length +
                                              static_cast<std::size_t>(x) * screen.bits_per_pixel / 8];
        const auto low = static_cast<std::uint32_t>(at[0] | at[1] << 8);
        return screen.bits_per_pixel == 16 ? widened(low) : low | std::uint32_t{at[2]} << 16;
    };
    const auto written = [&] { // before, the glass shows an empty console
        int lit = 0, yellow = 0;
        for (int y = 0; y < 136; ++y)
            for (int x = 0; x < 240; ++x) {
                const Rgb shown = expected(pixel(x, y), 0x40);
                lit += shown != Rgb{0, 0, 0};
                yellow += shown[0] > 240 && shown[1] > 240 && shown[2] < 100;
            }
        return lit > 300 && yellow > 50;
    };
    await("show its console", [&] {
        return pread(fb, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()) && written() &&
               shows(gud, pixel);
    });
    close(fb);
    EXPECT_EQ(gud.violations(), "");
}

TEST(KernelGudConsole, DriverSurvivesThePulledPlug) {
    PluggedGud gud;
    ASSERT_NO_FATAL_FAILURE(gud.plug());
    {
        DrmCard card(gud_card, 16);
        {
            const std::lock_guard lock(gud.usb);
            gud.usb.fate = [](std::size_t) { return sim::UsbFate::unplug; };
        }
        card.flush({0, 0, 320, 240});
    }
    gud.pull();
    gud.usb.fate = nullptr;
    gud.device.power_cycle();
    ASSERT_NO_FATAL_FAILURE(gud.plug());
}

} // namespace
