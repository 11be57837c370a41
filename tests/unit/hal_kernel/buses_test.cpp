// Presents whole frames over real spidev and real GPIO lines. The kernel's trace tells what the lines did, in
// the kernel's order. This drives the pins of the controller model, and the glass is compared to the bit.
#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/unit/hal_kernel/files.hpp"
#include "tests/unit/hal_kernel/line_trace.hpp"
#include "tests/unit/hal_linux/transports.hpp"

namespace {

using namespace kernel_test;
using namespace linux_test;
using namespace spangle;

/// With this panel a frame takes two messages of spidev's default size.
constexpr hal::PanelDesc panel =
    hal::panels::st7735::on_glass("small", {132, 162}, {64, 48}, {5, 7}, hal::ColorOrder::rgb);

class KernelRig {
  public:
    explicit KernelRig(Transport transport, RigOptions wanted = {})
        : chip(is_spidev(transport) ? SimChip::header_label : chip_label, 54), options(complete(wanted)),
          wiring(wiring_with_lines(transport)), trace(chip), module(panel, wiring, header, kernel) {
        if (is_spidev(transport))
            spidev.emplace(spidev_of(transport, options));
        else
            gpio.emplace(gpio_of(transport, options));
        display.emplace(bus(), panel_of(options), storage.memory());
    }

    sim::Kernel kernel; ///< the clock of the module; no system call goes through it
    SimChip chip;
    RigOptions options;
    sim::ModuleWiring wiring;
    LineTrace trace;
    sim::PinHeader header;
    sim::PanelModule module;
    std::optional<hal::SpidevBus> spidev;
    std::optional<hal::GpioBus> gpio;
    hal::PanelStorage<hal::PanelSizes{.height = 320, .buffers = 2}> storage;
    std::optional<test::OwnedDisplay> display;
    std::uint64_t levels = ~std::uint64_t{0};

    hal::TransferBus& bus() {
        return spidev ? static_cast<hal::TransferBus&>(*spidev) : static_cast<hal::TransferBus&>(*gpio);
    }
    void start() {
        const auto opened = spidev ? spidev->open() : gpio->open();
        ASSERT_TRUE(opened.ok()) << opened.error().rule;
        const auto ready = display->init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
    }
    void present() {
        const auto sent = display->present();
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        const auto arrived = display->finish();
        ASSERT_TRUE(arrived.ok()) << arrived.error().rule;
    }
    std::vector<LineChange> catch_up() {
        const auto changes = trace.take();
        replay(changes, header, levels);
        if (!changes.empty() && changes.back().time > kernel.now())
            kernel.advance(changes.back().time - kernel.now());
        return changes;
    }
    std::string glass_difference() {
        catch_up();
        const std::string wrong = test::glass_difference(*display, module.glass(options.orientation));
        return wrong.empty() ? module.violations_text() : wrong;
    }

  private:
    RigOptions complete(RigOptions given) {
        given.panel = &panel;
        given.spi_hz = 4000000;
        given.path = chip.path().c_str();
        given.label = chip.label().c_str();
        return given;
    }
    /// spi-gpio is the SPI controller, so chip select is a line, too.
    static sim::ModuleWiring wiring_with_lines(Transport transport) {
        sim::ModuleWiring w = wiring_of(transport);
        if (is_spidev(transport)) {
            w.select = 8;
            w.clock = 11;
            w.data[0] = 10;
        }
        return w;
    }
};

class KernelBus : public testing::TestWithParam<Transport> {};

TEST_P(KernelBus, FramesArriveToTheBit) {
    KernelRig rig(GetParam());
    ASSERT_NO_FATAL_FAILURE(rig.start());
    rig.catch_up();
    EXPECT_TRUE(rig.module.is_backlight_on());
    ASSERT_TRUE(test::draw_pattern(*rig.display, 1));
    ASSERT_NO_FATAL_FAILURE(rig.present());
    EXPECT_EQ(rig.glass_difference(), "");
    ASSERT_TRUE(test::draw_pattern(*rig.display, 2, {7, 5, 30, 9}));
    ASSERT_NO_FATAL_FAILURE(rig.present());
    EXPECT_EQ(rig.glass_difference(), "");
}

// The transports have no line for answers: the trace tells only what was driven, and a pulled line cannot
// answer in time.
INSTANTIATE_TEST_SUITE_P(Every, KernelBus,
                         testing::Values(Transport::spi, Transport::spi_mode3, Transport::spi3,
                                         Transport::gpio4, Transport::gpio3, Transport::gpio8,
                                         Transport::gpio16),
                         [](const auto& tested) { return name_of(tested.param); });

/// Only a real kernel can prove this rule, because two of its drivers change the lines: D/C changes between
/// messages only.
TEST(KernelSpidev, DataCommandChangesBetweenMessagesOnly) {
    KernelRig rig(Transport::spi);
    const unsigned select = rig.wiring.select, data_command = rig.wiring.data_command;
    ASSERT_NO_FATAL_FAILURE(rig.start());
    ASSERT_TRUE(test::draw_pattern(*rig.display, 3));
    ASSERT_NO_FATAL_FAILURE(rig.present());
    bool selected = false, data = false;
    int messages = 0, changes = 0;
    for (const LineChange& c : rig.catch_up()) {
        if (c.line == select) {
            messages += !selected && !c.level;
            selected = !c.level;
        }
        if (c.line == data_command && c.level != data) {
            EXPECT_FALSE(selected) << "D/C changed while CS was low";
            data = c.level;
            ++changes;
        }
    }
    EXPECT_GT(messages, changes);
    EXPECT_GT(changes, 10);
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(KernelSpidev, MessagesAreAsLongAsTheKernelSays) {
    KernelRig rig(Transport::spi);
    ASSERT_NO_FATAL_FAILURE(rig.start());
    EXPECT_EQ(std::to_string(rig.spidev->message_bytes()), read_text("/sys/module/spidev/parameters/bufsiz"));
    EXPECT_LT(rig.spidev->message_bytes(), std::size_t{64 * 48 * 2}) << "then a frame is one message";
}

TEST(KernelSpidev, AnAnswerIsClockedIn) {
    KernelRig rig(Transport::spi);
    ASSERT_NO_FATAL_FAILURE(rig.start());
    for (const bool high : {false, true}) {
        rig.chip.pull(9, high);
        std::uint8_t answer[3] = {0x55, 0x55, 0x55};
        hal::Op read;
        read.kind = hal::Op::Kind::read;
        read.command = 0xDA;
        read.into = answer;
        read.length = sizeof answer;
        const auto token = rig.bus().submit(&read, 1);
        ASSERT_TRUE(token.ok()) << token.error().rule;
        const auto done = rig.bus().wait(token.value(), 1'000'000);
        ASSERT_TRUE(done.ok()) << done.error().rule;
        for (const std::uint8_t byte : answer)
            EXPECT_EQ(byte, high ? 0xFF : 0x00);
    }
}

TEST(KernelSpidev, AHeldDcLineIsNamed) {
    KernelRig rig(Transport::spi);
    hal::Lines other;
    const unsigned line[] = {24};
    ASSERT_TRUE(other.open_outputs(SimChip::header_label, line, 0).ok());
    const auto refused = rig.spidev->open();
    EXPECT_EQ(refused.error().fault, hal::Fault::busy) << refused.error().rule;
    other.close();
    ASSERT_NO_FATAL_FAILURE(rig.start());
}

/// No bit is clocked before the edge of TE.
TEST(KernelSpidev, PresentsBeginAtTheTearingLinesEdge) {
    RigOptions options;
    options.wait_te = true;
    KernelRig rig(Transport::spi, options);
    ASSERT_NO_FATAL_FAILURE(rig.start());
    for (unsigned frame = 1; frame <= 3; ++frame) {
        ASSERT_TRUE(test::draw_pattern(*rig.display, frame, {0, 0, 16, 8}));
        hal::Result<void> sent;
        int tries = 0;
        do { // a busy machine may be late with the edge
            rig.catch_up();
            std::thread presenting([&] {
                sent = rig.display->present();
                if (sent)
                    sent = rig.display->finish();
            });
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            EXPECT_TRUE(rig.catch_up().empty());
            rig.chip.pull(23, true);
            presenting.join();
            rig.chip.pull(23, false);
        } while (sent.error().fault == hal::Fault::timeout && ++tries < 10);
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_FALSE(rig.catch_up().empty());
    }
    // The model's scan does not follow this TE line, so the model's rules about the beam are not checked.
    EXPECT_EQ(test::glass_difference(*rig.display, rig.module.glass({})), "");
}

TEST(KernelSpidev, AMissingTearingLineTimesOut) {
    RigOptions options;
    options.wait_te = true;
    KernelRig rig(Transport::spi, options);
    ASSERT_NO_FATAL_FAILURE(rig.start());
    ASSERT_TRUE(test::draw_pattern(*rig.display, 1));
    const auto begun = rig.display->present();
    const auto missing = begun ? rig.display->finish() : begun;
    EXPECT_EQ(missing.error().fault, hal::Fault::timeout) << missing.error().rule;
}

} // namespace
