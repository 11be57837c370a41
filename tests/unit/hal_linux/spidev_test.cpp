// Tests what the spidev bus asks of the kernel: messages of the largest size, words, clocks, reads.
#include <cerrno>

#include <linux/spi/spidev.h>

#include "tests/unit/hal_linux/rig.hpp"

namespace {

using namespace linux_test;
using hal::Fault;
using hal::Op;

Op command(std::uint8_t code, const std::uint8_t* data = nullptr, std::uint32_t length = 0) {
    Op op;
    op.kind = Op::Kind::command;
    op.command = code;
    op.data = data;
    op.length = length;
    return op;
}

template <std::size_t N> hal::Result<void> run(hal::Bus& bus, const Op (&ops)[N]) {
    const auto token = bus.submit(ops, N);
    return token ? bus.wait(token.value(), 5000000) : token.error();
}

TEST(Spidev, MessagesFillTheKernelsBuffer) {
    for (const std::size_t bufsiz : {std::size_t{4096}, std::size_t{5000}, std::size_t{65536}}) {
        RigOptions options;
        options.panel = &hal::panels::ili9341_240x320;
        Rig rig(Transport::spi, options);
        rig.spi.bufsiz = bufsiz;
        rig.spi.attach(rig.machine.kernel, spi_path);
        rig.start();
        const std::size_t whole = bufsiz / 128 * 128;
        EXPECT_EQ(rig.spidev->message_bytes(), whole);
        ASSERT_TRUE(rig.draw(1));
        const std::uint64_t before = rig.spi.message_count();
        ASSERT_TRUE(rig.display->present().ok());
        // The panel has the window from the black frame of init(), so a frame is RAMWR and pixels only.
        EXPECT_EQ(rig.spi.message_count() - before, 1 + (240 * 320 * 2 + whole - 1) / whole);
        EXPECT_EQ(rig.spi.largest_message(), whole);
        EXPECT_EQ(rig.glass_difference(), "");
    }
}

TEST(Spidev, WithoutTheModulesParameterTheDefaultIsTaken) {
    Rig rig(Transport::spi);
    rig.machine.kernel.add_text("/sys/module/spidev/parameters/bufsiz", "0\n");
    rig.start();
    EXPECT_EQ(rig.spidev->message_bytes(), 4096u);
}

/// Operations of one window, to count the messages that each list takes.
struct Messages {
    Rig rig;
    const std::uint8_t columns[4] = {0, 5, 0, 28}, rows[4] = {0, 7, 0, 22}, pixels[24 * 2 * 3] = {};
    const Op invoff = command(0x20), normal = command(0x13), caset = command(0x2A, columns, 4),
             raset = command(0x2B, rows, 4), ramwr = command(0x2C);
    Op area, gaps;

    explicit Messages(Transport transport) : rig(transport) {
        rig.start();
        area.kind = Op::Kind::pixels;
        area.data = pixels;
        area.length = 24 * 2;
        area.rows = 3;
        area.stride = 24 * 2;
        gaps = area;
        gaps.length = 40;
    }
    template <class... Ops> std::uint64_t of(const Ops&... ops) {
        const Op list[] = {ops...};
        const std::uint64_t before = rig.spi.message_count();
        EXPECT_TRUE(run(rig.bus(), list).ok());
        return rig.spi.message_count() - before;
    }
};

TEST(Spidev, OperationsOfOneLevelShareAMessage) {
    Messages m(Transport::spi);
    EXPECT_EQ(m.of(m.invoff, m.normal, m.invoff), 1u);
    EXPECT_EQ(m.of(m.caset), 2u);
    EXPECT_EQ(m.of(m.caset, m.raset, m.ramwr, m.area), 6u);
    EXPECT_EQ(m.of(m.ramwr, m.gaps), 2u) << "rows with gaps between them too";
}

TEST(Spidev, ThreeWireListsAreOneMessage) {
    Messages m(Transport::spi3);
    EXPECT_EQ(m.of(m.caset, m.raset, m.ramwr, m.area), 1u) << "D/C travels in the words";
}

TEST(Spidev, ThreeWireTakesNineBitWords) {
    Rig words(Transport::spi3);
    words.start();
    EXPECT_EQ(words.spi.settings().bits, 9);
    EXPECT_EQ(words.spi.settings().mode & SPI_3WIRE, unsigned{SPI_3WIRE}) << "the answer comes on SDA";
    EXPECT_EQ(words.spidev->caps().write_hz, 35555555u) << "eight of nine clocks carry data";
    EXPECT_EQ(words.spidev->caps().command_cost_ns, 0u);
    EXPECT_EQ(words.spidev->caps().read_hz, 6000000u);
}

TEST(Spidev, ThreeWirePacksWordsWhereThereAreOnlyBytes) {
    Rig packed(Transport::spi3_packed);
    packed.start();
    EXPECT_EQ(packed.spi.settings().bits, 8);
    EXPECT_EQ(packed.spidev->message_bytes() % 9, 0u) << "no word crosses a message";
    EXPECT_EQ(packed.spidev->caps().read_hz, 0u);
}

TEST(Spidev, ReadsAtItsOwnClock) {
    for (const Transport t : {Transport::spi, Transport::spi_mode3, Transport::spi3}) {
        RigOptions options;
        options.panel = &hal::panels::ili9341_240x320;
        options.read_back = true;
        Rig rig(t, options);
        rig.start();
        const auto status = rig.display->status();
        ASSERT_TRUE(status.ok()) << status.error().rule;
        EXPECT_EQ(status.value().power_mode, 0x9C) << "awake, normal, on";
        EXPECT_EQ(status.value().status >> 31, 1u) << "behind a dummy clock: booster on";
        EXPECT_EQ(status.value().status >> 20 & 7, 5u) << "16 bits a pixel";
        EXPECT_EQ(status.value().colmod, 0x55) << name_of(t);
        ASSERT_TRUE(rig.draw(7));
        ASSERT_TRUE(rig.display->present().ok());
        std::uint8_t rgb[8 * 2 * 3] = {};
        ASSERT_TRUE(rig.display->read_back({100, 50, 8, 2}, rgb).ok());
        const auto frame = rig.display->acquire();
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 8; ++x) {
                const std::uint8_t* const p =
                    frame.value().pixels + (50 + y) * frame.value().stride + 2 * (100 + x);
                EXPECT_EQ(rgb[(y * 8 + x) * 3 + 1] >> 2, (p[0] << 8 | p[1]) >> 5 & 63);
            }
        EXPECT_EQ(rig.glass_difference(), "");
    }
}

TEST(Spidev, ASlowerControllerSetsTheDeadlines) {
    Rig rig(Transport::spi);
    rig.spi.max_hz = 10000000;
    rig.start();
    EXPECT_EQ(rig.spidev->caps().write_hz, 10000000u);
    EXPECT_EQ(rig.machine.chip.levels() >> 25 & 1, 1u) << "reset rests high";
}

TEST(Spidev, WrongArgumentsAreRefused) {
    Machine machine;
    hal::SpidevConfig config;
    config.write_hz = 1000000;
    config.asynchronous = false;
    config.mode = 1;
    EXPECT_EQ(hal::SpidevBus(config).open().error().fault, Fault::bad_argument);
    config.mode = 0;
    config.write_hz = 0;
    EXPECT_EQ(hal::SpidevBus(config).open().error().fault, Fault::bad_argument);
    config.write_hz = 1000000;
    hal::SpidevBus bus(config);
    const Op ops[] = {command(0x20)};
    EXPECT_STREQ(run(bus, ops).error().rule, "spidev: the bus was not opened");
}

TEST(Spidev, ReadsLongerThanAMessageAreRefused) {
    Rig rig(Transport::spi);
    rig.start();
    std::vector<std::uint8_t> room(8192);
    Op op;
    op.kind = Op::Kind::read;
    op.command = 0x2E;
    op.into = room.data();
    op.length = 4096 - 128 + 1;
    const Op longer[] = {op};
    EXPECT_EQ(run(rig.bus(), longer).error().fault, Fault::unsupported);
    op.length = 4096 - 128;
    const Op longest[] = {op};
    EXPECT_TRUE(run(rig.bus(), longest).ok());
}

TEST(Spidev, ErrorsSayDeviceOperationAndCause) {
    Rig rig(Transport::spi);
    const auto on_spi = [](sim::Call::Kind kind, unsigned long request = 0) {
        return [=](const sim::Call& call) {
            return call.path == spi_path && call.kind == kind && (request == 0 || call.request == request);
        };
    };
    using Kind = sim::Call::Kind;
    rig.machine.fail(EACCES, 1, on_spi(Kind::open));
    EXPECT_STREQ(rig.open().error().rule, "/dev/spidev0.0: open: Permission denied; install the udev rules "
                                          "60-spangle.rules and join group 'spi'");
    rig.machine.fail(EINVAL, 1, on_spi(Kind::ioctl, SPI_IOC_WR_MODE));
    EXPECT_STREQ(rig.open().error().rule, "/dev/spidev0.0: set SPI mode: Invalid argument");
    rig.machine.fail(EINVAL, 1, on_spi(Kind::ioctl, SPI_IOC_WR_BITS_PER_WORD));
    EXPECT_STREQ(rig.open().error().rule, "/dev/spidev0.0: set bits per word: Invalid argument");
    rig.machine.fail(EINVAL, 1, on_spi(Kind::ioctl, SPI_IOC_WR_MAX_SPEED_HZ));
    const auto clock = rig.open();
    EXPECT_STREQ(clock.error().rule, "/dev/spidev0.0: set the clock to 40000000 Hz: Invalid argument");
    EXPECT_EQ(clock.error().fault, Fault::unsupported);
    EXPECT_EQ(rig.machine.kernel.open_files(), 0) << "a bus that did not open holds nothing";
    rig.machine.no_faults();
    rig.machine.kernel.unplug(spi_path);
    EXPECT_STREQ(rig.open().error().rule,
                 "/dev/spidev0.0: open: No such file or directory; is the bus enabled "
                 "(Raspberry Pi: dtparam=spi=on in config.txt)?");
}

TEST(Spidev, AClockBeyondThePanelsIsRefusedElseItIsAViolation) {
    RigOptions options;
    options.spi_hz = 80000000; // an ST7735 is known to work at 59 MHz
    {
        Rig refused(Transport::spi, options);
        ASSERT_TRUE(refused.open().ok());
        const auto ready = refused.display->init();
        EXPECT_EQ(ready.error().fault, Fault::unsupported);
        EXPECT_STREQ(ready.error().rule,
                     "display: the bus's write clock is faster than this panel is known to take");
    }
    hal::PanelDesc daring = tiny_panel;
    daring.timing.practical_serial_mhz = 80;
    options.panel = &daring;
    Rig rig(Transport::spi, options);
    rig.start();
    bool reported = false;
    for (const sim::Violation& v : rig.module.controller().violations())
        reported = reported || v.rule == sim::Rule::write_clock;
    EXPECT_TRUE(reported);
}

} // namespace
