// Runs the Raspberry Pi example unchanged on a modelled Pi. (Its main() is called example_main here.)
#include <cerrno>

#include <gtest/gtest.h>
#include <spangle/boards/ili9341_spi.hpp>

#include "host_sim/linux/gpio_chip.hpp"
#include "host_sim/linux/panel_module.hpp"
#include "host_sim/linux/spi_device.hpp"
#include "tests/support/example_length.hpp"

int example_main(int argc, char** argv);

namespace {

using namespace spangle;

struct Pi {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::GpioChip chip{"pinctrl-bcm2711", 54};
    sim::PanelModule module{hal::panels::ili9341_240x320, wiring(), chip, kernel};
    sim::SpiDevice spi{module.serial()};

    Pi() {
        chip.attach(kernel, 0);
        spi.attach(kernel, "/dev/spidev0.0");
    }
    Pi(const Pi&) = delete;
    Pi& operator=(const Pi&) = delete;
    ~Pi() { kernel.forget_all(); }
    static sim::ModuleWiring wiring() {
        sim::ModuleWiring w;
        w.reset = 25;
        w.backlight = 18;
        w.data_command = 24;
        return w;
    }
    static int run(const char* frames) {
        std::string program = "cube", count = frames;
        char* words[] = {program.data(), count.data(), nullptr};
        return example_main(2, words);
    }
};

TEST(RaspberryPiExample, RefusalsSayWhatToDo) {
    Pi pi;
    pi.kernel.set_judge(
        [](const sim::Call& call) { return sim::CallVerdict{call.path == "/dev/spidev0.0" ? EACCES : 0}; });
    testing::internal::CaptureStderr();
    EXPECT_EQ(Pi::run("1"), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "cube: /dev/spidev0.0: open: Permission denied; install the udev rules 60-spangle.rules and "
              "join group "
              "'spi'\n");
}

TEST(RaspberryPiExample, DrawsACube) {
    Pi pi;
    ASSERT_EQ(Pi::run("20"), 0);
    EXPECT_EQ(pi.kernel.open_files(), 0);
    EXPECT_TRUE(pi.module.is_backlight_on());
    const sim::Image glass = pi.module.glass(boards::ili9341_spi.display.orientation);
    EXPECT_EQ(pi.module.violations_text(), "");
    EXPECT_EQ(glass.width, 320);
    // A corner of the picture is black, and the three visible faces of the cube are lit, each in its colour.
    const std::uint8_t* const corner = glass.at(5, 5);
    EXPECT_EQ(corner[0] + corner[1] + corner[2], 0);
    int red = 0, green = 0, blue = 0;
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x) {
            const std::uint8_t* const p = glass.at(x, y);
            red += p[0] > p[1] && p[0] > p[2];
            green += p[1] > p[0] && p[1] > p[2];
            blue += p[2] > p[0] && p[2] > p[1];
        }
    EXPECT_GT(red, 1000);
    EXPECT_GT(green, 1000);
    EXPECT_GT(blue, 1000);
}

TEST(RaspberryPiExample, IsShort) {
    spangle::test::expect_short("raspberry_pi/cube.cpp");
}

} // namespace
