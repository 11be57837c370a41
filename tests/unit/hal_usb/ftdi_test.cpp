// Tests panels at an FTDI adapter: the stream byte for byte, the pins, answers, scenes.
#include <gmock/gmock.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "tests/support/scene_player.hpp"
#include "tests/unit/hal_usb/ftdi_rig.hpp"

namespace {

using namespace ftdi_test;
using hal::Fault;
using hal::Op;
using Bytes = std::vector<std::uint8_t>;

hal::Result<void> run(hal::Bus& bus, const std::vector<Op>& ops) {
    const auto token = bus.submit(ops.data(), ops.size());
    return token ? bus.wait(token.value(), 5000000) : hal::Result<void>(token.error());
}

Op command(std::uint8_t code, const Bytes& parameters = {}) {
    Op op;
    op.kind = Op::Kind::command;
    op.command = code;
    op.data = parameters.data();
    op.length = static_cast<std::uint32_t>(parameters.size());
    return op;
}

Op pixels(const Bytes& data) {
    Op op;
    op.kind = Op::Kind::pixels;
    op.data = data.data();
    op.length = static_cast<std::uint32_t>(data.size());
    op.stride = static_cast<std::int32_t>(op.length);
    return op;
}

TEST(Ftdi, TheStreamIsTheseBytes) {
    Rig rig;
    Bytes sent;
    rig.adapter.log = &sent;
    ASSERT_TRUE(rig.open().ok());
    EXPECT_EQ(sent, (Bytes{0xAA, 0x87,             // sends a bad command, to find the engine
                           0x8A, 0x97, 0x8D, 0x85, // 60 MHz, not adaptive, three-phase, looped back
                           0x86, 0x01, 0x00,       // divided by (1 + 1) * 2: 15 MHz
                           0x80, 0xD8, 0xDB,       // nothing selected, no reset, light on
                           0x82, 0x00, 0x00,       // the upper pins are inputs
                           0x81, 0x87}));          // asks whether all is done
    EXPECT_EQ(rig.adapter.engine.clock_hz(), 15000000u);
    EXPECT_EQ(rig.adapter.latency_ms(), 1u);
    EXPECT_EQ(rig.bus->caps().write_hz, 15000000u);
    EXPECT_EQ(rig.bus->caps().read_hz, 6000000u);
    sent.clear();
    const Bytes window = {0, 5, 0, 6}, data = {1, 2, 3, 4, 5};
    ASSERT_TRUE(run(*rig.bus, {command(0x2A, window), command(0x2C), pixels(data)}).ok());
    EXPECT_EQ(sent, (Bytes{0x80, 0xC0, 0xDB, 0x11, 0,   0, 0x2A,             // selected, D/C low
                           0x80, 0xD0, 0xDB, 0x11, 3,   0, 0,    5, 0, 6,    // D/C high
                           0x80, 0xC0, 0xDB, 0x11, 0,   0, 0x2C,             //
                           0x80, 0xD0, 0xDB, 0x11, 4,   0, 1,    2, 3, 4, 5, //
                           0x80, 0xD8, 0xDB, 0x81, 0x87}));                  // no longer selected
    EXPECT_EQ(rig.adapter.violations(), "");
}

TEST(Ftdi, UpperPinsCarrySignalsToo) {
    RigOptions options;
    options.pins.data_command = 9;
    options.pins.reset = 15;
    options.pins.backlight = hal::FtdiPins::none;
    Rig rig(options);
    Bytes sent;
    rig.adapter.log = &sent;
    ASSERT_TRUE(rig.open().ok());
    sent.clear();
    ASSERT_TRUE(run(*rig.bus, {command(0x29, Bytes{7})}).ok());
    EXPECT_EQ(sent, (Bytes{0x80, 0x00, 0x0B, 0x82, 0x80, 0x82, 0x11, 0,    0,    0x29, //
                           0x82, 0x82, 0x82, 0x11, 0,    0,    7,    0x80, 0x08, 0x0B, 0x81, 0x87}));
    rig.make_display();
    ASSERT_TRUE(rig.display->init().ok());
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.display->present().ok());
    EXPECT_EQ(rig.glass_difference(), "");
    EXPECT_EQ(rig.bus->backlight(true).error().fault, Fault::unsupported);
}

TEST(Ftdi, LongBurstsAreSplitAndTwoTransfersAreUnderWay) {
    Rig rig;
    Bytes sent;
    ASSERT_TRUE(rig.open().ok());
    rig.adapter.log = &sent;
    Bytes data(200000);
    for (std::size_t i = 0; i < data.size(); ++i)
        data[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
    int largest = 0;
    rig.usb.fate = [&](std::size_t count) {
        largest = std::max(largest, static_cast<int>(count));
        return sim::UsbfsDevice::Fate::normal;
    };
    ASSERT_TRUE(run(*rig.bus, {command(0x2C), pixels(data)}).ok());
    EXPECT_LE(rig.adapter.engine.longest_burst(), 32768u) << "longer ones are reported to lose bytes";
    EXPECT_GT(rig.adapter.engine.longest_burst(), 32000u);
    EXPECT_EQ(rig.usb.most_under_way, 4) << "libusb makes two requests of each";
    Bytes carried;
    for (std::size_t at = 0; at < sent.size();) {
        if (sent[at] != 0x11) {
            at += sent[at] == 0x80 ? 3 : 1;
            continue;
        }
        const std::size_t count = std::size_t{sent[at + 1]} + 256u * sent[at + 2] + 1;
        carried.insert(carried.end(), sent.begin() + static_cast<std::ptrdiff_t>(at + 3),
                       sent.begin() + static_cast<std::ptrdiff_t>(at + 3 + count));
        at += 3 + count;
    }
    data.insert(data.begin(), 0x2C);
    EXPECT_EQ(carried, data);
}

TEST(Ftdi, AnyLengthNextToTheEndOfATransfer) {
    Rig rig;
    ASSERT_TRUE(rig.start().ok());
    for (std::size_t before = 32730; before < 32770; ++before) {
        const Bytes filler(before, 0), window = {1, 2, 3, 4};
        Bytes sent;
        rig.adapter.log = &sent;
        ASSERT_TRUE(run(*rig.bus, {command(0x00, filler), command(0x00, window)}).ok()) << before;
        EXPECT_EQ(rig.adapter.engine.bad_commands(), 1u) << "but for the one at the start; " << before;
        EXPECT_EQ(std::count(sent.begin(), sent.end(), 0x87), 1);
    }
    EXPECT_EQ(rig.adapter.violations(), "");
}

TEST(Ftdi, ClocksAreNoFasterThanAsked) {
    for (const auto& [asked, divisor, actual] : {std::tuple{60000000u, 0u, 30000000u},
                                                 {30000000u, 0u, 30000000u},
                                                 {29999999u, 1u, 15000000u},
                                                 {10000000u, 2u, 10000000u},
                                                 {9999999u, 3u, 7500000u},
                                                 {400u, 65535u, 457u}}) {
        RigOptions options;
        options.write_hz = asked;
        Rig rig(options);
        Bytes sent;
        rig.adapter.log = &sent;
        ASSERT_TRUE(rig.open().ok());
        EXPECT_EQ(sent[7] + 256u * sent[8], divisor);
        EXPECT_EQ(rig.bus->caps().write_hz, actual);
        EXPECT_EQ(rig.adapter.engine.clock_hz(), actual);
    }
}

TEST(Ftdi, ReadsAtTheirOwnClock) {
    Rig rig;
    ASSERT_TRUE(rig.start().ok());
    Bytes sent;
    rig.adapter.log = &sent;
    const auto status = rig.display->status();
    ASSERT_TRUE(status.ok()) << status.error().rule;
    EXPECT_EQ(status.value().power_mode, 0x9C);
    EXPECT_EQ(rig.adapter.violations() + rig.module.violations_text(), "");
    const Bytes first = {0x86, 4, 0, 0x80, 0xC0, 0xDB, 0x11, 0, 0};
    EXPECT_THAT(Bytes(sent.begin(), sent.begin() + 9), testing::ElementsAreArray(first));
    EXPECT_EQ(rig.adapter.engine.clock_hz(), 15000000u) << "and back";
    // Reads the whole memory with its dummy clocks, as the module's own pins answer.
    ASSERT_TRUE(rig.draw(3));
    ASSERT_TRUE(rig.display->present().ok());
    std::array<std::uint8_t, 24 * 16 * 3> rgb{};
    const auto read = rig.display->read_back({0, 0, 24, 16}, rgb.data());
    ASSERT_TRUE(read.ok()) << read.error().rule;
    const auto frame = rig.display->acquire();
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 24; ++x) {
            const std::uint8_t* const p = frame.value().pixels + y * frame.value().stride + 2 * x;
            EXPECT_EQ(rgb[static_cast<std::size_t>(y * 24 + x) * 3] >> 3, p[0] >> 3) << x << ", " << y;
        }
}

TEST(Ftdi, AnswersLongerThanAPacket) {
    Rig rig;
    ASSERT_TRUE(rig.start().ok());
    Bytes answer(5000, 0x55);
    Op op;
    op.kind = Op::Kind::read;
    op.command = 0x09;
    op.into = answer.data();
    op.length = static_cast<std::uint32_t>(answer.size());
    ASSERT_TRUE(run(*rig.bus, {op}).ok());
    EXPECT_EQ(std::count(answer.begin(), answer.end(), 0x55), 0) << "every byte came, no status among them";
    EXPECT_EQ(std::count(answer.begin(), answer.end(), 0x32), 0);
    op.length = 65537;
    EXPECT_EQ(run(*rig.bus, {op}).error().fault, Fault::unsupported);
}

TEST(Ftdi, PinsThatCannotBe) {
    const auto rule_of = [](auto change) {
        hal::FtdiConfig config;
        config.device_file = path;
        config.write_hz = 1000000;
        config.asynchronous = false;
        change(config);
        hal::FtdiBus bus(config);
        const auto opened = bus.open();
        return opened.error().fault == Fault::bad_argument ? std::string(opened.error().rule) : "";
    };
    using testing::HasSubstr;
    for (const std::uint8_t pin : {0, 1, 2, 3, 6, 7})
        EXPECT_THAT(rule_of([=](auto& c) { c.pins.data_command = pin; }), HasSubstr("on one pin"));
    EXPECT_THAT(rule_of([](auto& c) { c.pins.reset = 5, c.pins.te = true; }), HasSubstr("on one pin"));
    EXPECT_THAT(rule_of([](auto& c) { c.pins.reset = 16; }), HasSubstr("0 to 15"));
    EXPECT_THAT(rule_of([](auto& c) { c.pins.select = hal::FtdiPins::none; }), HasSubstr("must be wired"));
    EXPECT_THAT(rule_of([](auto& c) { c.channel = 2; }), HasSubstr("channels A"));
    EXPECT_THAT(rule_of([](auto& c) { c.write_hz = 0; }), HasSubstr("no write clock"));
    EXPECT_EQ(rule_of([](auto& c) { c.pins.reset = 5; }), "") << "free without TE";
}

TEST(Ftdi, TheOtherChannelOfTwo) {
    Rig rig;
    rig.adapter.two_channels = true;
    rig.adapter.channel = 1;
    rig.config.channel = 1;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(4));
    ASSERT_TRUE(rig.display->present().ok());
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(Ftdi, ChipsWithoutTheEngine) {
    Rig rig;
    rig.adapter.has_mpsse = false;
    rig.config.timeout_ms = 20;
    const auto opened = rig.open();
    EXPECT_EQ(opened.error().fault, Fault::timeout) << opened.error().rule;
    EXPECT_EQ(rig.kernel.open_files(), 0);
    rig.config.channel = 1; // this chip has one channel only
    rig.bus.emplace(rig.config);
    EXPECT_EQ(rig.open().error().fault, Fault::wrong_device);
}

TEST(Ftdi, BacklightAndUnopened) {
    Rig rig;
    rig.usb.attach(rig.kernel, path);
    rig.bus.emplace(rig.config);
    EXPECT_EQ(rig.bus->backlight(false).error().fault, Fault::bad_argument);
    EXPECT_EQ(run(*rig.bus, {command(0x29)}).error().fault, Fault::unsupported);
    ASSERT_TRUE(rig.bus->open().ok());
    EXPECT_TRUE(rig.module.is_backlight_on());
    ASSERT_TRUE(rig.bus->backlight(false).ok());
    EXPECT_FALSE(rig.module.is_backlight_on());
    ASSERT_TRUE(run(*rig.bus, {command(0x29)}).ok());
    EXPECT_FALSE(rig.module.is_backlight_on());
    ASSERT_TRUE(rig.bus->open().ok());
    EXPECT_FALSE(rig.module.is_backlight_on()) << "as it was left";
    ASSERT_TRUE(rig.bus->backlight(true).ok());
    EXPECT_TRUE(rig.module.is_backlight_on());
}

TEST(Ftdi, TheKernelsDriverLetsGo) {
    Rig rig;
    rig.usb.kernel_driver = true; // the kernel's driver ftdi_sio has the adapter
    ASSERT_TRUE(rig.start().ok());
    EXPECT_FALSE(rig.usb.kernel_driver);
    rig.display.reset();
    rig.bus.reset();
    EXPECT_TRUE(rig.usb.kernel_driver) << "and comes back";
}

TEST(Ftdi, WholeScenes) {
    const hal::Board& board = boards::ili9341_spi;
    for (const scenes::Scene& scene : scenes::all()) {
        SCOPED_TRACE(scene.id);
        sim::SimBoard sim(board);
        ASSERT_TRUE(test::play(sim.display(), scene, 3));
        RigOptions options;
        options.panel = board.display.panel;
        options.orientation = board.display.orientation;
        options.buffers = 2;
        options.asynchronous = true;
        options.read_back = true;
        options.write_hz = 10000000;
        Rig rig(options);
        ASSERT_TRUE(rig.open().ok());
        rig.make_display();
        ASSERT_TRUE(test::play(*rig.display, scene, 3));
        ASSERT_TRUE(rig.display->finish().ok());
        EXPECT_EQ(sim::hash(rig.module.glass(options.orientation)), sim::hash(sim.glass()));
        EXPECT_EQ(rig.module.violations_text() + rig.adapter.violations(), "");
    }
}

} // namespace
