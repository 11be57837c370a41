// Tests what reaches an OLED controller over i2c-dev: control bytes, chunks, and errors.
#include <cerrno>
#include <numeric>
#include <optional>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/i2c-dev.h>
#include <spangle/linux/i2c_bus.hpp>
#include <sys/ioctl.h>
#include <unistd.h>

#include "host_sim/linux/i2c_adapter.hpp"

namespace {

using namespace spangle;
using hal::Fault;
using hal::Op;

constexpr char path[] = "/dev/i2c-1";

struct I2c : testing::Test {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::I2cAdapter adapter{0x3C};
    hal::I2cConfig config;
    std::optional<hal::I2cBus> bus;
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(1024);

    I2c() {
        adapter.attach(kernel, path);
        config.asynchronous = false;
        std::iota(pixels.begin(), pixels.end(), std::uint8_t{0});
    }
    ~I2c() override {
        bus.reset();
        EXPECT_EQ(kernel.open_files(), 0);
        kernel.forget_all();
    }
    hal::Result<void> open() {
        bus.emplace(config);
        return bus->open();
    }
    /// Sends a frame to an SSD1306: the column range, then the whole picture.
    hal::Result<void> frame() {
        static constexpr std::uint8_t range[] = {0, 127};
        Op ops[2];
        ops[0].kind = Op::Kind::command;
        ops[0].command = 0x21;
        ops[0].data = range;
        ops[0].length = 2;
        ops[0].parameters_are_commands = true;
        ops[1].kind = Op::Kind::pixels;
        ops[1].data = pixels.data();
        ops[1].length = static_cast<std::uint32_t>(pixels.size());
        const auto token = bus->submit(ops, 2);
        return token ? bus->wait(token.value(), 1000000) : token.error();
    }
    void expect_frame() {
        std::vector<sim::I2cAdapter::ReceivedByte> want = {{0x21, false}, {0, false}, {127, false}};
        for (const std::uint8_t byte : pixels)
            want.push_back({byte, true});
        EXPECT_EQ(adapter.received(), want);
        EXPECT_EQ(adapter.wrong(), "");
    }
};

TEST_F(I2c, ParametersAreCommandsAndPixelsAreData) {
    ASSERT_TRUE(open().ok());
    ASSERT_TRUE(frame().ok());
    expect_frame();
    EXPECT_EQ(adapter.message_count(), 3u) << "one of commands, 1023 and 1 bytes of data";
    EXPECT_EQ(bus->caps().write_hz, 400000u / 9 * 8 + 3);
    EXPECT_EQ(bus->caps().read_hz, 0u);
}

TEST_F(I2c, ShortMessagesForSmallAdapters) {
    adapter.longest_message = 32;
    ASSERT_TRUE(open().ok());
    EXPECT_EQ(frame().error().fault, Fault::unsupported);
    adapter.forget();
    config.message_bytes = 32;
    ASSERT_TRUE(open().ok());
    ASSERT_TRUE(frame().ok());
    expect_frame();
    EXPECT_EQ(adapter.message_count(), 1u + (1024 + 30) / 31);
}

TEST_F(I2c, AMessageCutShortGoesOnBehindItsOwnControlByte) {
    ASSERT_TRUE(open().ok());
    int cut = 0;
    kernel.set_judge([&](const sim::Call& call) {
        const bool write = call.kind == sim::Call::Kind::write && ++cut % 2 == 0;
        return sim::CallVerdict{0, write ? std::size_t{100} : SIZE_MAX};
    });
    ASSERT_TRUE(frame().ok());
    expect_frame();
    kernel.set_judge([](const sim::Call& call) {
        return sim::CallVerdict{0, call.kind == sim::Call::Kind::write ? std::size_t{1} : SIZE_MAX};
    });
    EXPECT_EQ(frame().error().fault, Fault::short_write) << "no byte beyond the control byte goes out";
}

TEST_F(I2c, ErrorsSayDeviceOperationAndCause) {
    ASSERT_TRUE(open().ok());
    adapter.powered = false;
    const auto silent = frame();
    EXPECT_EQ(silent.error().fault, Fault::no_answer);
    EXPECT_STREQ(
        silent.error().rule,
        "/dev/i2c-1 address 3Ch: write: no acknowledge; is the address right, and the panel powered?");
    adapter.powered = true;
    adapter.forget();
    EXPECT_TRUE(frame().ok());
    expect_frame();
    adapter.taken = true;
    const auto taken = open();
    EXPECT_EQ(taken.error().fault, Fault::busy);
    EXPECT_STREQ(taken.error().rule,
                 "/dev/i2c-1 address 3Ch: address: a kernel driver has this device; unbind it");
    EXPECT_STREQ(frame().error().rule, "i2c: the bus was not opened");
    adapter.taken = false;
    config.address = 0x3D;
    ASSERT_TRUE(open().ok());
    EXPECT_EQ(frame().error().fault, Fault::no_answer) << "nobody has that address";
    config.device = "/dev/i2c-9";
    EXPECT_STREQ(open().error().rule, "/dev/i2c-9 address 3Dh: open: No such file or directory; is the bus "
                                      "enabled (Raspberry Pi: dtparam=i2c_arm=on in config.txt)?");
    config.message_bytes = 1;
    EXPECT_EQ(open().error().fault, Fault::bad_argument);
}

TEST_F(I2c, TheModelNoticesAMissingControlByte) {
    const int file = ::open(path, O_RDWR);
    ASSERT_EQ(ioctl(file, I2C_SLAVE, 0x3Cul), 0);
    const std::uint8_t bare[] = {0xAE}, mixed[] = {0x80, 0x21, 0x80, 0x05, 0xC0, 0x55, 0x40, 0x66, 0x77};
    EXPECT_EQ(::write(file, bare, sizeof bare), 1);
    EXPECT_NE(adapter.wrong().find("rule 14"), std::string::npos);
    EXPECT_TRUE(adapter.received().empty());
    adapter.forget();
    EXPECT_EQ(::write(file, mixed, sizeof mixed), 9);
    const std::vector<sim::I2cAdapter::ReceivedByte> want = {
        {0x21, false}, {0x05, false}, {0x55, true}, {0x66, true}, {0x77, true}};
    EXPECT_EQ(adapter.received(), want);
    EXPECT_EQ(adapter.wrong(), "");
    ::close(file);
}

TEST_F(I2c, LostArbitrationIsTriedAgain) {
    ASSERT_TRUE(open().ok());
    kernel.set_judge([left = 9](const sim::Call& call) mutable {
        return sim::CallVerdict{call.kind == sim::Call::Kind::write && left-- > 0 ? EAGAIN : 0};
    });
    ASSERT_TRUE(frame().ok());
    expect_frame();
}

TEST_F(I2c, PulledInTheMiddle) {
    ASSERT_TRUE(open().ok());
    kernel.unplug(path);
    EXPECT_EQ(frame().error().fault, Fault::gone);
    EXPECT_EQ(bus->open().error().fault, Fault::gone);
    kernel.plug(path);
    ASSERT_TRUE(bus->open().ok());
    adapter.forget();
    ASSERT_TRUE(frame().ok());
    expect_frame();
}

} // namespace
