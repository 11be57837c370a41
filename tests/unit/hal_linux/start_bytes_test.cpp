// Tests a controller without a D/C pin behind spidev; its messages begin with a start byte.
#include <cerrno>

#include <gtest/gtest.h>
#include <spangle/boards/hx8347_spi.hpp>

#include "tests/unit/hal_linux/rig.hpp"

namespace {

using namespace linux_test;
using hal::Fault;

struct StartBytes : testing::Test {
    Machine machine;
    sim::PanelModule module{hal::panels::hx8347_240x320, wiring(), machine.chip, machine.kernel};
    sim::SpiDevice spi{module.serial()};
    hal::SpidevConfig config =
        hal::spidev_config(boards::hx8347_spi, spi_path, {}, {{chip_path, 25}, {}, {}});
    std::optional<hal::SpidevBus> bus;
    std::optional<hal::BoardDisplay<boards::hx8347_spi>> display;

    static sim::ModuleWiring wiring() {
        sim::ModuleWiring w;
        w.reset = 25;
        return w;
    }
    void start() {
        spi.attach(machine.kernel, spi_path);
        config.asynchronous = false;
        bus.emplace(config);
        const auto opened = bus->open();
        ASSERT_TRUE(opened.ok()) << opened.error().rule;
        display.emplace(*bus);
        const auto ready = display->init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
    }
    void draw(Rect area) {
        const auto frame = display->acquire();
        ASSERT_TRUE(frame.ok());
        for (int y = area.y; y < area.y + area.h; ++y) {
            for (int i = 2 * area.x; i < 2 * (area.x + area.w); ++i)
                frame.value().pixels[y * frame.value().stride + i] =
                    static_cast<std::uint8_t>(static_cast<unsigned>(y * 977 + i) * 2654435761u >> 24);
            frame.value().extents->rows[y] = {static_cast<std::int16_t>(area.x),
                                              static_cast<std::int16_t>(area.x + area.w)};
        }
    }
    void expect_glass() {
        const auto frame = display->acquire();
        const sim::Image glass = module.glass(boards::hx8347_spi.display.orientation);
        int wrong = 0;
        for (int y = 0; y < 240; ++y)
            for (int x = 0; x < 320; ++x) {
                const std::uint8_t* const want = frame.value().pixels + y * frame.value().stride + 2 * x;
                const int word = want[0] << 8 | want[1];
                const std::uint8_t* const got = glass.at(x, y);
                wrong += got[0] >> 3 != word >> 11 || got[1] >> 2 != (word >> 5 & 63) ||
                         got[2] >> 3 != (word & 31);
            }
        EXPECT_EQ(wrong, 0);
        EXPECT_EQ(module.violations_text(), "");
    }
};

TEST_F(StartBytes, MessagesOfAnyLengthHoldWholePixels) {
    start();
    EXPECT_EQ(bus->caps().kind, hal::BusKind::spi_start);
    EXPECT_EQ(bus->caps().read_hz, 0u);
    draw({0, 0, 320, 240});
    ASSERT_TRUE(display->present().ok());
    expect_glass();
    draw({17, 9, 5, 31});
    ASSERT_TRUE(display->present().ok());
    expect_glass();
}

TEST_F(StartBytes, AMessageCutShortIsAnErrorAndMended) {
    start();
    draw({0, 0, 320, 240});
    machine.kernel.set_judge([left = 20](const sim::Call& call) mutable {
        const bool hit = call.kind == sim::Call::Kind::ioctl && call.path == spi_path && left-- == 0;
        return sim::CallVerdict{0, hit ? std::size_t{100} : SIZE_MAX};
    });
    EXPECT_EQ(display->present().error().fault, Fault::short_write) << "the rest has no start byte";
    machine.no_faults();
    module.controller().forget_violations();
    ASSERT_TRUE(display->present().ok());
    module.controller().forget_violations(); // the cut window broke rules
    expect_glass();
}

TEST_F(StartBytes, ALineForThemIsAMistake) {
    config.dc = {chip_path, 24};
    bus.emplace(config);
    EXPECT_EQ(bus->open().error().fault, Fault::bad_argument);
}

} // namespace
