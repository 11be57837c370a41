// Tests bit-banged buses: how they drive the lines, what reads return, and what is refused.
#include "tests/unit/hal_linux/rig.hpp"

namespace {

using namespace linux_test;
using hal::Fault;
using hal::GpioWiring;
using hal::Op;

constexpr Transport bit_banged[] = {Transport::gpio4,      Transport::gpio3,  Transport::gpio8,
                                    Transport::gpio8_read, Transport::gpio16, Transport::gpio16_read};

TEST(GpioBus, OrderOfTheLinesInACallDoesNotMatter) {
    using Settling = sim::GpioChip::Settling;
    for (const Transport t : bit_banged)
        for (const Settling settling : {Settling::together, Settling::ascending, Settling::descending}) {
            Rig rig(t);
            rig.machine.chip.settling = settling;
            rig.start();
            for (unsigned seed = 1; seed < 4; ++seed) {
                ASSERT_TRUE(rig.draw(seed));
                ASSERT_TRUE(rig.display->present().ok());
                EXPECT_EQ(rig.glass_difference(), "") << name_of(t) << " " << static_cast<int>(settling);
            }
        }
}

TEST(GpioBus, TwoCallsACycle) {
    struct Case {
        Transport transport;
        std::uint64_t calls; ///< calls for a frame of 24 x 16 pixels of noise: 768 bytes
    };
    // If data lines can turn round, a cycle takes three calls unless the word stays the same.
    for (const Case c : {Case{Transport::gpio8, 768 * 2}, Case{Transport::gpio16, 384 * 2},
                         Case{Transport::gpio8_read, 768 * 3}, Case{Transport::gpio4, 768 * 16},
                         Case{Transport::gpio3, 768 * 9 * 3}}) {
        Rig rig(c.transport);
        rig.start();
        ASSERT_TRUE(rig.draw(5));
        const std::uint64_t before = rig.machine.kernel.calls();
        ASSERT_TRUE(rig.display->present().ok());
        const std::uint64_t calls = rig.machine.kernel.calls() - before;
        EXPECT_LE(calls, c.calls + 30) << name_of(c.transport);
        EXPECT_GE(calls, c.calls * 6 / 10) << name_of(c.transport);
    }
}

TEST(GpioBus, ReadsAnswers) {
    for (const Transport t :
         {Transport::gpio4, Transport::gpio3, Transport::gpio8_read, Transport::gpio16_read}) {
        SCOPED_TRACE(name_of(t));
        RigOptions options;
        options.read_back = true; // init() checks the panel's identity
        Rig rig(t, options);
        rig.start();
        const auto status = rig.display->status();
        ASSERT_TRUE(status.ok()) << status.error().rule;
        EXPECT_EQ(status.value().id, 0x5C89F0u);
        EXPECT_EQ(status.value().power_mode, 0x9C);
        ASSERT_TRUE(rig.draw(3));
        ASSERT_TRUE(rig.display->present().ok());
        std::uint8_t rgb[24 * 16 * 3] = {};
        ASSERT_TRUE(rig.display->read_back({0, 0, 24, 16}, rgb).ok());
        const auto frame = rig.display->acquire();
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 24; ++x) {
                const std::uint8_t* const p = frame.value().pixels + y * frame.value().stride + 2 * x;
                ASSERT_EQ(rgb[(y * 24 + x) * 3 + 1] >> 2, (p[0] << 8 | p[1]) >> 5 & 63) << x << ", " << y;
            }
        EXPECT_EQ(rig.glass_difference(), "") << "the lines drive again after a read";
    }
}

TEST(GpioBus, LinesRestHighAndAreGivenBack) {
    Rig rig(Transport::gpio8_read);
    ASSERT_TRUE(rig.open().ok());
    for (const unsigned line : {8u, 9u, 11u, 24u, 25u})
        EXPECT_EQ(rig.machine.chip.levels() >> line & 1, 1u) << line;
    rig.gpio.reset();
    for (unsigned line = 0; line < 54; ++line)
        EXPECT_FALSE(rig.machine.chip.is_requested(line)) << line;
}

TEST(GpioBus, TellsItsSpeed) {
    for (const Transport t : bit_banged) {
        Rig rig(t);
        const hal::BusCaps caps = rig.gpio->caps();
        EXPECT_EQ(caps.bits_per_cycle, t >= Transport::gpio16 ? 16 : is_parallel(t) ? 8 : 1);
        EXPECT_EQ(caps.write_hz, t == Transport::gpio3 ? 35555u : 40000u);
        EXPECT_EQ(caps.read_hz, can_read(t) ? 40000u : 0u);
        EXPECT_FALSE(caps.has_te);
    }
}

TEST(GpioBus, WithoutChipSelectItIsTiedLow) {
    Machine machine;
    sim::ModuleWiring wiring = wiring_of(Transport::gpio8);
    wiring.select = sim::ModuleWiring::open;
    sim::PanelModule module(tiny_panel, wiring, machine.chip, machine.kernel);
    hal::GpioBusConfig config;
    config.chip = chip_path;
    config.clock = wiring.clock;
    config.data_command = wiring.data_command;
    std::copy(wiring.data.begin(), wiring.data.end(), config.data);
    config.pins = pins_of(false);
    config.asynchronous = false;
    hal::GpioBus bus(config);
    ASSERT_TRUE(bus.open().ok());
    hal::PanelStorage<hal::PanelSizes{.height = 16}> storage;
    test::OwnedDisplay display(bus, {.panel = &tiny_panel}, storage.memory());
    ASSERT_TRUE(display.init().ok());
    EXPECT_TRUE(module.dcs().display_on());
    EXPECT_EQ(module.violations_text(), "");
}

TEST(GpioBus, WrongWiringIsRefused) {
    Machine machine;
    hal::GpioBusConfig good;
    good.clock = 1;
    good.data_command = 2;
    good.select = 3;
    for (unsigned i = 0; i < 16; ++i)
        good.data[i] = 10 + i;
    good.asynchronous = false;
    EXPECT_TRUE(hal::GpioBus(good).open().ok());
    const auto refused = [](hal::GpioBusConfig config) {
        const auto r = hal::GpioBus(config).open();
        return r.error().fault == Fault::bad_argument;
    };
    hal::GpioBusConfig c = good;
    c.clock = hal::GpioBusConfig::none;
    EXPECT_TRUE(refused(c));
    c = good;
    c.data_command = hal::GpioBusConfig::none;
    EXPECT_TRUE(refused(c));
    c.wiring = GpioWiring::serial3;
    EXPECT_FALSE(refused(c));
    c = good;
    c.select = hal::GpioBusConfig::none;
    c.answer = 4;
    EXPECT_TRUE(refused(c));
    c = good;
    c.cycles_per_second = 0;
    EXPECT_TRUE(refused(c));
    hal::GpioBus closed(good);
    Op op;
    op.kind = Op::Kind::command;
    EXPECT_STREQ(closed.submit(&op, 1).error().rule, "gpio bus: the bus was not opened");
    c = good;
    c.wiring = GpioWiring::parallel16;
    hal::GpioBus wide(c);
    ASSERT_TRUE(wide.open().ok());
    const std::uint8_t three[3] = {};
    op.kind = Op::Kind::repeat;
    op.data = three;
    op.length = 3;
    EXPECT_EQ(wide.submit(&op, 1).error().fault, Fault::unsupported) << "half a word stays behind";
    op.rows = 2;
    EXPECT_TRUE(wide.submit(&op, 1).ok());
}

} // namespace
