// Tests tokens of transfers, the thread that carries them out, and the pins beside the bus.
#include <cerrno>
#include <chrono>
#include <cstring>

#include <linux/spi/spidev.h>

#include "tests/unit/hal_linux/rig.hpp"

namespace {

using namespace linux_test;
using hal::Fault;
using hal::Op;
using hal::Token;

bool is_message(const sim::Call& call) {
    return call.kind == sim::Call::Kind::ioctl && call.path == spi_path && _IOC_NR(call.request) == 0;
}

RigOptions asynchronous() {
    RigOptions options;
    options.asynchronous = true;
    return options;
}

Op invoff() {
    Op op;
    op.kind = Op::Kind::command;
    op.command = 0x20;
    return op;
}

Op op_of(Op::Kind kind, const std::uint8_t* data = nullptr, std::uint32_t length = 0,
         std::uint32_t rows = 1) {
    Op op;
    op.kind = kind;
    op.data = data;
    op.length = length;
    op.rows = rows;
    op.stride = static_cast<std::int32_t>(length);
    return op;
}

/// A transfer that hangs in the kernel until release() is called.
struct Hanging {
    explicit Hanging(Rig& r) : rig(r) {
        rig.machine.kernel.set_judge([](const sim::Call& call) {
            sim::CallVerdict verdict;
            verdict.stall = is_message(call);
            return verdict;
        });
        const Op ops[] = {invoff()};
        token = rig.bus().submit(ops, 1).value();
        while (!rig.machine.kernel.has_stalled_calls())
            std::this_thread::yield();
        rig.machine.no_faults();
    }
    ~Hanging() { rig.machine.kernel.release(); }
    Rig& rig;
    Token token;
};

TEST(Transfer, OneIsUnderWayAtATimeAndWaitEndsInTime) {
    Rig rig(Transport::spi, asynchronous());
    rig.start();
    const Op ops[] = {invoff()};
    {
        Hanging hanging(rig);
        EXPECT_FALSE(rig.bus().done(hanging.token));
        const auto start = std::chrono::steady_clock::now();
        const auto late = rig.bus().wait(hanging.token, 20000);
        const auto took = std::chrono::steady_clock::now() - start;
        EXPECT_EQ(late.error().fault, Fault::timeout);
        EXPECT_GE(took, std::chrono::milliseconds(20));
        EXPECT_LT(took, std::chrono::seconds(10));
        EXPECT_EQ(rig.bus().submit(ops, 1).error().fault, Fault::busy);
        EXPECT_EQ(rig.open().error().fault, Fault::busy) << "the device stays open under a transfer";
        rig.machine.kernel.release();
        EXPECT_TRUE(rig.bus().wait(hanging.token, 5000000).ok());
        EXPECT_TRUE(rig.bus().done(hanging.token));
    }
    EXPECT_TRUE(rig.bus().submit(ops, 1).ok());
}

TEST(Transfer, TheDestructorWaitsForTheTransfer) {
    Rig rig(Transport::spi, asynchronous());
    rig.start();
    std::thread releaser;
    {
        Hanging hanging(rig);
        releaser = std::thread([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            rig.machine.kernel.release();
        });
        rig.spidev.reset(); // joins the thread, then closes
    }
    releaser.join();
    EXPECT_EQ(rig.machine.kernel.open_files(), 0);
}

TEST(Transfer, OutcomesAreRemembered) {
    for (const bool threaded : {false, true}) {
        RigOptions options;
        options.asynchronous = threaded;
        Rig rig(Transport::spi, options);
        rig.start();
        const Op ops[] = {invoff()};
        std::vector<Token> tokens;
        for (int i = 0; i < 17; ++i) {
            if (i == 3)
                rig.machine.fail(EIO, 1, is_message);
            tokens.push_back(rig.bus().submit(ops, 1).value());
            const auto outcome = rig.bus().wait(tokens.back(), 5000000);
            EXPECT_EQ(outcome.ok(), i != 3);
            EXPECT_TRUE(rig.bus().done(tokens.back()));
        }
        for (int i = 1; i < 17; ++i) {
            const auto again = rig.bus().wait(tokens[static_cast<unsigned>(i)], 0);
            EXPECT_EQ(again.ok(), i != 3) << i;
            if (i == 3) {
                EXPECT_EQ(again.error().fault, Fault::no_answer);
                EXPECT_STREQ(again.error().rule, "/dev/spidev0.0: write: Input/output error");
            }
        }
        EXPECT_EQ(rig.bus().wait(tokens[0], 0).error().fault, Fault::bad_argument) << "long ago";
        EXPECT_EQ(rig.bus().wait(Token{}, 0).error().fault, Fault::bad_argument);
        EXPECT_EQ(rig.bus().wait(Token{tokens.back().id + 1}, 0).error().fault, Fault::bad_argument);
    }
}

TEST(Transfer, AListIsRefusedWholeBeforeItsFirstByte) {
    hal::SpidevConfig config; // the default has neither pins nor a read clock
    config.write_hz = 1000000;
    config.dc = {chip_path, 24};
    config.asynchronous = false;
    Machine machine;
    sim::PanelModule module(tiny_panel, wiring_of(Transport::spi), machine.chip, machine.kernel);
    sim::SpiDevice spi(module.serial());
    spi.attach(machine.kernel, spi_path);
    hal::SpidevBus bus(config);
    ASSERT_TRUE(bus.open().ok());
    using Kind = Op::Kind;
    const std::uint8_t bytes[8] = {};
    Op read;
    read.kind = Kind::read;
    read.length = 1;
    std::uint8_t room = 0;
    Op readable = read;
    readable.into = &room;
    const struct {
        Op op;
        const char* rule;
    } cases[] = {
        {op_of(Kind::pixels, nullptr, 2), "bus: an operation without data"},
        {op_of(Kind::repeat, bytes, 0), "bus: a repeated pattern has one to four bytes"},
        {op_of(Kind::repeat, bytes, 5), "bus: a repeated pattern has one to four bytes"},
        {read, "bus: a read without room for the answer"},
        {readable, "bus: this bus cannot read"},
        {op_of(Kind::wait_te), "bus: no tearing-effect line is wired"},
        {op_of(Kind::wait_line), "bus: this bus cannot read"},
        {op_of(Kind::reset), "bus: no reset line is wired"},
    };
    for (const auto& c : cases) {
        const Op ops[] = {invoff(), c.op};
        const auto refused = bus.submit(ops, 2);
        EXPECT_EQ(refused.error().fault, Fault::unsupported);
        EXPECT_STREQ(refused.error().rule, c.rule);
    }
    EXPECT_EQ(bus.submit(nullptr, 1).error().fault, Fault::bad_argument);
    EXPECT_EQ(spi.message_count(), 0u);
    EXPECT_EQ(bus.backlight(true).error().fault, Fault::unsupported);
    EXPECT_TRUE(bus.submit(nullptr, 0).ok()) << "nothing is something that can be done";
}

TEST(Transfer, RepeatsAndRowsArriveWhole) {
    for (const Transport t : every_transport) {
        SCOPED_TRACE(name_of(t));
        Rig rig(t);
        rig.start();
        // Pixels of 24 bits on 132 x 162 pixels: the block of a repeated pattern is not a multiple of three
        // bytes.
        const std::uint8_t six = 0x66, columns[] = {0, 0, 0, 131}, rows[] = {0, 0, 0, 161}, upright = 0,
                           pattern[] = {0x80, 0x04, 0xFC};
        Op colmod = op_of(Op::Kind::command, &six, 1), madctl = op_of(Op::Kind::command, &upright, 1),
           caset = op_of(Op::Kind::command, columns, 4), raset = op_of(Op::Kind::command, rows, 4), ramwr;
        colmod.command = 0x3A;
        madctl.command = 0x36;
        caset.command = 0x2A;
        raset.command = 0x2B;
        ramwr = invoff();
        ramwr.command = 0x2C;
        const Op ops[] = {colmod, madctl, caset,
                          raset,  ramwr,  op_of(Op::Kind::repeat, pattern, 3, 132 * 162)};
        const auto token = rig.bus().submit(ops, 6);
        ASSERT_TRUE(token.ok());
        ASSERT_TRUE(rig.bus().wait(token.value(), 5000000).ok());
        const sim::Rgb666 want = {0x20, 0x01, 0x3F};
        for (const sim::Rgb666& pixel : rig.module.dcs().memory())
            ASSERT_EQ(pixel, want);
        // Sends four rows of eight bytes, ten bytes apart. The picture is upside down in memory, so the
        // stride is negative.
        std::vector<std::uint8_t> picture(4 * 10);
        for (std::size_t i = 0; i < picture.size(); ++i)
            picture[i] = static_cast<std::uint8_t>(i * 4);
        const std::uint8_t five = 0x05, few[] = {0, 10, 0, 13}, four[] = {0, 20, 0, 23};
        colmod.data = &five;
        caset.data = few;
        raset.data = four;
        Op area = op_of(Op::Kind::pixels, picture.data() + 30, 8, 4);
        area.stride = -10;
        const Op part[] = {colmod, caset, raset, ramwr, area};
        const auto second = rig.bus().submit(part, 5);
        ASSERT_TRUE(rig.bus().wait(second.value(), 5000000).ok());
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                const std::uint8_t* const p = picture.data() + 30 - 10 * y + 2 * x;
                const auto got = rig.module.dcs().memory()[static_cast<std::size_t>((20 + y) * 132 + 10 + x)];
                EXPECT_EQ(got.g, (p[0] << 8 | p[1]) >> 5 & 63);
            }
    }
}

TEST(Transfer, ThePinsBesideTheBus) {
    Rig rig(Transport::spi);
    const auto level = [&](unsigned line) { return (rig.machine.chip.levels() >> line & 1) != 0; };
    rig.start();
    EXPECT_TRUE(rig.module.is_backlight_on()) << "lit when the bus opens";
    ASSERT_TRUE(rig.bus().backlight(false).ok());
    EXPECT_FALSE(rig.module.is_backlight_on());
    ASSERT_TRUE(rig.bus().backlight(true).ok());
    EXPECT_TRUE(rig.module.is_backlight_on());
    Op reset = op_of(Op::Kind::reset);
    reset.micros = 25;
    // A signal cuts the sleep short; the reset pulse must still be as long as it was asked for.
    rig.machine.fail(EINTR, 3, [](const sim::Call& call) { return call.kind == sim::Call::Kind::sleep; });
    sim::Time fell = 0, rose = 0;
    const auto forward = rig.machine.chip.on_change;
    rig.machine.chip.on_change = [&](std::uint64_t levels, sim::Time now) {
        if ((levels >> 25 & 1) == 0 && fell == 0)
            fell = now;
        if ((levels >> 25 & 1) != 0 && fell != 0)
            rose = now;
        forward(levels, now);
    };
    const auto token = rig.bus().submit(&reset, 1);
    ASSERT_TRUE(rig.bus().wait(token.value(), 1000000).ok());
    EXPECT_GE(rose - fell, 25000u);
    EXPECT_LT(rose - fell, 40000u);
    EXPECT_TRUE(level(25));
    EXPECT_FALSE(rig.module.dcs().display_on()) << "the controller was reset";
}

TEST(Transfer, InvertedPinsDriveTheOtherLevel) {
    Machine machine;
    hal::SpidevConfig config;
    config.write_hz = 1000000;
    config.asynchronous = false;
    config.dc = {chip_path, 24, true};
    config.pins.reset = {chip_path, 25, true};
    config.pins.backlight = {chip_path, 18, true};
    sim::PanelModule module(tiny_panel, wiring_of(Transport::spi), machine.chip, machine.kernel);
    sim::SpiDevice spi(module.serial());
    spi.attach(machine.kernel, spi_path);
    hal::SpidevBus bus(config);
    ASSERT_TRUE(bus.open().ok());
    const auto level = [&](unsigned line) { return (machine.chip.levels() >> line & 1) != 0; };
    EXPECT_FALSE(level(25));
    EXPECT_FALSE(level(18));
    const Op ops[] = {invoff()};
    ASSERT_TRUE(bus.submit(ops, 1).ok());
    EXPECT_TRUE(level(24)) << "a command: D/C low, the line high";
}

TEST(Transfer, BuffersAreTheCallersForTheLifeOfTheBus) {
    Rig rig(Transport::spi);
    const auto first = rig.bus().acquire(1000), second = rig.bus().acquire(10);
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_EQ(first.value().size, 1000u);
    EXPECT_NE(first.value().bytes, second.value().bytes);
    std::memset(first.value().bytes, 1, 1000);
}

} // namespace
