// Tests a build without libgpiod: buses that need no line work, and the others say what is missing.
#include <gtest/gtest.h>
#include <spangle/linux/gpio_bus.hpp>
#include <spangle/linux/spidev_bus.hpp>

#include "host_sim/bus/pins.hpp"
#include "host_sim/controller/dcs_controller.hpp"
#include "host_sim/linux/spi_device.hpp"

namespace {

using namespace spangle;
using hal::Fault;

constexpr char missing[] =
    "/dev/gpiochip0 line 24: request: this build has no libgpiod; install libgpiod-dev and "
    "configure again";

TEST(WithoutGpiod, ThreeWirePanelsWork) {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::DcsController controller(sim::chips[0], {0, 0, 240, 320}, false);
    sim::SerialPins pins(controller, true);
    sim::SpiDevice spi(pins);
    spi.attach(kernel, "/dev/spidev0.0");
    hal::SpidevConfig config;
    config.write_hz = 10000000;
    {
        hal::SpidevBus bus(config);
        ASSERT_TRUE(bus.open().ok());
        hal::Op ops[2];
        ops[0].kind = ops[1].kind = hal::Op::Kind::command;
        ops[0].command = 0x11;
        ops[1].command = 0x29;
        kernel.advance(1'000'000'000);
        const auto token = bus.submit(ops, 1);
        ASSERT_TRUE(bus.wait(token.value(), 1000000).ok());
        EXPECT_TRUE(controller.is_awake());
    }
    kernel.forget_all();
}

TEST(WithoutGpiod, LinesSayWhatIsMissing) {
    hal::Lines lines;
    const unsigned line[] = {24};
    const auto outputs = lines.open_outputs("/dev/gpiochip0", line, 0);
    EXPECT_EQ(outputs.error().fault, Fault::unsupported);
    EXPECT_STREQ(outputs.error().rule, missing);
    EXPECT_FALSE(lines.set(1).ok());
    EXPECT_FALSE(lines.get().ok());
    EXPECT_FALSE(lines.drive(1).ok());
    EXPECT_FALSE(lines.float_lines().ok());
    hal::EdgeLine edges;
    EXPECT_EQ(edges.open({"/dev/gpiochip0", 24}).error().fault, Fault::unsupported);
    EXPECT_FALSE(edges.next_edge(1).ok());
}

} // namespace
