// Runs the FTDI example unchanged on a modelled adapter with a modelled panel. (Its main() is called
// example_main here.)

#include <spangle/boards/ili9341_spi.hpp>

#include "tests/support/example_length.hpp"
#include "tests/unit/hal_usb/ftdi_rig.hpp"

int example_main(int argc, char** argv);

namespace {

using namespace ftdi_test;

int run(const char* frames) {
    std::string program = "clock", count = frames, file = path;
    char* words[] = {program.data(), count.data(), file.data(), nullptr};
    return example_main(3, words);
}

TEST(FtdiExample, SaysWhatIsMissing) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run("1"), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "clock: /dev/bus/usb/001/003: open: No such file or "
                                                      "directory; lsusb lists what is plugged in\n");
}

TEST(FtdiExample, DrawsAClock) {
    RigOptions options;
    options.panel = &hal::panels::ili9341_240x320;
    options.orientation = boards::ili9341_spi.display.orientation;
    Rig rig(options);
    rig.usb.attach(rig.kernel, path);
    ASSERT_EQ(run("3"), 0);
    EXPECT_TRUE(rig.module.is_backlight_on());
    const sim::Image glass = rig.module.glass(options.orientation);
    EXPECT_EQ(rig.module.violations_text() + rig.adapter.violations(), "");
    ASSERT_EQ(glass.width, 320);
    int white = 0, blue = 0, red = 0;
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x) {
            const std::uint8_t* const p = glass.at(x, y);
            white += p[0] > 200 && p[1] > 200;
            blue += p[2] > 200 && p[0] < 180;
            red += p[0] > 200 && p[1] < 150;
        }
    EXPECT_GT(red, 100); // the second hand lies on top
    EXPECT_GT(white + blue, 300);
    EXPECT_LT(white + blue + red, 320 * 240 / 8);
}

TEST(FtdiExample, IsShort) {
    spangle::test::expect_short("ftdi_adapter/clock.cpp");
}

} // namespace
