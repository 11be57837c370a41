// Sends random bytes to the models of OLED controllers and of the HX8347: nothing breaks, and every picture
// has its size.
#include <memory>
#include <random>

#include <gtest/gtest.h>
#include <spangle/panels.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/bus/i2c_target.hpp"

namespace {

using namespace spangle;

TEST(OledStream, RandomBytesBreakNothing) {
    for (const hal::PanelDesc* panel : hal::panels::all) {
        if (panel->commands == &hal::dcs::commands)
            continue; // controller_stream_test.cpp tests these
        for (unsigned seed = 0; seed < 12; ++seed) {
            std::mt19937 random(seed);
            const bool i2c = panel->timing.i2c_hz != 0 && seed % 3 == 2;
            const auto bus = i2c             ? hal::BusKind::i2c
                             : seed % 3 == 1 ? hal::BusKind::i8080
                                             : panel->serial_bus;
            const auto controller = sim::make_controller(*panel, bus);
            sim::I2cTarget target(*controller);
            sim::Time now = 0;
            for (int step = 0; step < 6000; ++step) {
                now += random() % 5000;
                const auto byte = static_cast<std::uint8_t>(random());
                switch (random() % 40) {
                case 0:
                    i2c ? target.stop(now) : controller->select(false, now);
                    break;
                case 1:
                    i2c ? target.start(now) : controller->select(true, now);
                    break;
                case 2:
                    controller->reset(random() % 8 == 0, now);
                    break;
                case 3:
                    controller->read_byte(now, random() % 600);
                    break;
                default:
                    // Most bytes are data, the others commands of one range or another.
                    i2c ? target.byte(byte, now, random() % 3000)
                        : controller->write(byte, random() % 3 != 0, now, random() % 400);
                    break;
                }
            }
            const sim::GlassMount& glass = controller->mount();
            EXPECT_EQ(controller->glass(now).size(), static_cast<std::size_t>(glass.width * glass.height));
            const sim::MemorySize memory = controller->memory_size();
            EXPECT_EQ(controller->cells().size(), static_cast<std::size_t>(memory.width * memory.height));
            EXPECT_FALSE(controller->violations().empty());
            controller->reset(true, now);
            controller->reset(false, now + 1'000'000);
            for (const sim::Rgb666& pixel : controller->glass(now + 1'000'000))
                ASSERT_EQ(pixel, sim::Rgb666{}) << panel->name << " is dark after a reset";
        }
    }
}

} // namespace
