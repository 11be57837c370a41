// Tests an OLED on I2C under faults of the bus: the error is right, and the glass is right again afterwards.
#include <cerrno>
#include <chrono>
#include <optional>
#include <thread>

#include <gtest/gtest.h>
#include <spangle/boards/ssd1306_i2c.hpp>
#include <spangle/linux/i2c_bus.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/linux/i2c_adapter.hpp"
#include "tests/unit/hal_linux/oled_picture.hpp"

namespace {

using namespace spangle;
using hal::Fault;

constexpr char path[] = "/dev/i2c-1";

struct Random {
    std::uint32_t state;
    std::uint32_t below(std::uint32_t n) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::uint32_t>((std::uint64_t{state >> 8} * n) >> 24);
    }
};

struct I2cFaults : testing::Test {
    sim::Kernel& kernel = sim::Kernel::instance();
    std::unique_ptr<sim::Controller> oled =
        sim::make_controller(hal::panels::ssd1306_128x64, hal::BusKind::i2c);
    sim::I2cAdapter adapter{0x3C, oled.get()};
    std::optional<hal::I2cBus> bus;
    std::optional<hal::BoardDisplay<boards::ssd1306_i2c>> display;

    void start(bool asynchronous, std::uint16_t message_bytes = 1024) {
        adapter.attach(kernel, path);
        hal::I2cConfig config = hal::i2c_config(boards::ssd1306_i2c, path, 0x3C);
        config.asynchronous = asynchronous;
        config.message_bytes = message_bytes;
        bus.emplace(config);
        ASSERT_TRUE(bus->open().ok());
        display.emplace(*bus);
        ASSERT_TRUE(display->init().ok());
    }
    ~I2cFaults() override {
        display.reset();
        bus.reset();
        EXPECT_EQ(kernel.open_files(), 0);
        kernel.forget_all();
    }

    bool draw(unsigned seed, Rect area) { return linux_test::draw_dots(*display, seed, area); }
    std::string difference() { return linux_test::dots_difference(*display, *oled, kernel.now()); }
    /// Presents, and waits for the end of the transfer.
    hal::Result<void> show() {
        const auto sent = display->present();
        return sent ? display->finish() : sent;
    }
};

TEST_F(I2cFaults, EachErrorIsSaidAndMended) {
    start(false);
    const struct {
        int error;
        Fault fault;
        const char* says;
    } table[] = {{ENXIO, Fault::no_answer, "no acknowledge"},
                 {EREMOTEIO, Fault::no_answer, "no acknowledge"},
                 {EIO, Fault::no_answer, "Input/output error"},
                 {ETIMEDOUT, Fault::timeout, "timed out"}};
    unsigned seed = 1;
    for (const auto& row : table)
        for (const int skip : {0, 1, 2}) { // fails the window, the first data, or the rest
            ASSERT_TRUE(draw(++seed, {0, 0, 128, 64}));
            kernel.set_judge([&, left = skip](const sim::Call& call) mutable {
                const bool hit = call.kind == sim::Call::Kind::write && left-- == 0;
                return sim::CallVerdict{hit ? row.error : 0};
            });
            const auto failed = show();
            EXPECT_EQ(failed.error().fault, row.fault) << row.error;
            EXPECT_NE(std::string(failed.error().rule).find(row.says), std::string::npos)
                << failed.error().rule;
            kernel.set_judge(nullptr);
            oled->forget_violations(); // half a transfer breaks rules of the controller
            EXPECT_TRUE(show().ok());
            EXPECT_EQ(difference(), "") << row.error << " after " << skip;
        }
}

TEST_F(I2cFaults, PulledAndPluggedAgain) {
    start(false);
    ASSERT_TRUE(draw(1, {0, 0, 128, 64}));
    kernel.unplug(path);
    EXPECT_EQ(show().error().fault, Fault::gone);
    EXPECT_EQ(show().error().fault, Fault::gone) << "as long as it is away";
    kernel.plug(path);
    oled = sim::make_controller(hal::panels::ssd1306_128x64, hal::BusKind::i2c); // the OLED lost its power
    adapter.replace(oled.get());
    ASSERT_TRUE(bus->open().ok());
    ASSERT_TRUE(display->init().ok());
    ASSERT_TRUE(show().ok());
    EXPECT_EQ(difference(), "");
    EXPECT_EQ(oled->violations_text(), "");
}

TEST_F(I2cFaults, ShortWritesGoOn) {
    start(false);
    for (const std::size_t limit : {std::size_t{2}, std::size_t{7}, std::size_t{100}}) {
        ASSERT_TRUE(draw(static_cast<unsigned>(limit), {0, 0, 128, 64}));
        kernel.set_judge([&, left = 3](const sim::Call& call) mutable {
            sim::CallVerdict cut;
            if (call.kind == sim::Call::Kind::write && left-- > 0)
                cut.limit = limit;
            return cut;
        });
        EXPECT_TRUE(show().ok());
        EXPECT_EQ(difference(), "");
    }
    ASSERT_TRUE(draw(9, {0, 0, 128, 64}));
    kernel.set_judge([](const sim::Call& call) {
        sim::CallVerdict none;
        none.limit = call.kind == sim::Call::Kind::write ? 0 : SIZE_MAX;
        return none;
    });
    const auto stuck = show();
    EXPECT_EQ(stuck.error().fault, Fault::short_write) << "an error, not a loop";
    kernel.set_judge(nullptr);
    EXPECT_TRUE(show().ok());
    EXPECT_EQ(difference(), "");
}

TEST_F(I2cFaults, SignalsAndPatience) {
    start(false);
    for (const int number : {EINTR, EAGAIN})
        for (const int times : {5, 1000000}) {
            ASSERT_TRUE(draw(static_cast<unsigned>(number + times), {0, 0, 128, 64}));
            kernel.set_judge([&, left = times](const sim::Call& call) mutable {
                const bool hit = call.kind == sim::Call::Kind::write && left-- > 0;
                return sim::CallVerdict{hit ? number : 0};
            });
            const sim::Time before = kernel.now();
            const auto sent = show();
            EXPECT_EQ(sent.ok(), times == 5);
            EXPECT_LT(kernel.now() - before, 2'000'000'000u) << "patience ends";
            kernel.set_judge(nullptr);
            oled->forget_violations();
            EXPECT_TRUE(show().ok());
            EXPECT_EQ(difference(), "");
        }
}

TEST_F(I2cFaults, AHangingTransferEndsInATimeoutAndIsOverLater) {
    start(true);
    ASSERT_TRUE(draw(1, {0, 0, 128, 64}));
    kernel.set_judge([&, left = 1](const sim::Call& call) mutable {
        sim::CallVerdict stall;
        stall.stall = call.kind == sim::Call::Kind::write && left-- == 1;
        return stall;
    });
    const auto start_of = std::chrono::steady_clock::now();
    EXPECT_EQ(show().error().fault, Fault::timeout);
    EXPECT_LT(std::chrono::steady_clock::now() - start_of, std::chrono::seconds(20));
    EXPECT_EQ(bus->open().error().fault, Fault::busy) << "the message is still on its way";
    kernel.release();
    kernel.set_judge(nullptr);
    auto sent = show();
    for (int i = 0; i < 1000 && !sent.ok(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        sent = show();
    }
    ASSERT_TRUE(sent.ok()) << sent.error().rule;
    oled->forget_violations();
    EXPECT_EQ(difference(), "");
}

TEST_F(I2cFaults, BusyAddressesAndPermissions) {
    start(false);
    adapter.taken = true;
    const auto busy = bus->open();
    EXPECT_EQ(busy.error().fault, Fault::busy);
    EXPECT_NE(std::string(busy.error().rule).find("a kernel driver has this device; unbind it"),
              std::string::npos)
        << busy.error().rule;
    adapter.taken = false;
    for (const int number : {EACCES, EPERM}) {
        kernel.set_judge([number](const sim::Call& call) {
            return sim::CallVerdict{call.kind == sim::Call::Kind::open ? number : 0};
        });
        const auto denied = bus->open();
        EXPECT_EQ(denied.error().fault, Fault::denied);
        EXPECT_NE(std::string(denied.error().rule).find("60-spangle.rules and join group 'i2c'"),
                  std::string::npos)
            << denied.error().rule;
    }
    kernel.set_judge(nullptr);
    ASSERT_TRUE(bus->open().ok());
    ASSERT_TRUE(display->init().ok());
    ASSERT_TRUE(draw(5, {0, 0, 128, 64}));
    EXPECT_TRUE(show().ok());
    EXPECT_EQ(difference(), "");
}

TEST_F(I2cFaults, ReplugBetweenFramesIsNoticed) {
    start(false);
    kernel.unplug(path);
    kernel.plug(path); // before the bus noticed that the device was gone
    oled = sim::make_controller(hal::panels::ssd1306_128x64, hal::BusKind::i2c);
    adapter.replace(oled.get());
    ASSERT_TRUE(draw(2, {0, 0, 128, 64}));
    EXPECT_EQ(show().error().fault, Fault::gone) << "the old file is dead";
    ASSERT_TRUE(bus->open().ok());
    ASSERT_TRUE(display->init().ok());
    ASSERT_TRUE(show().ok());
    EXPECT_EQ(difference(), "");
}

TEST_F(I2cFaults, AThousandSequencesAtRandom) {
    start(true, 64);
    const int files = kernel.open_files();
    int failures = 0;
    for (std::uint32_t sequence = 1; sequence <= 1000; ++sequence) {
        Random random{sequence * 2654435761u};
        const std::uint32_t one_in = 24u >> random.below(3);
        kernel.set_judge([&, one_in, faults = random](const sim::Call& call) mutable {
            constexpr int errors[] = {EINTR, EAGAIN, EIO, ETIMEDOUT, ENXIO, EREMOTEIO, EBUSY, ENOMEM};
            sim::CallVerdict verdict;
            if (call.kind != sim::Call::Kind::write || faults.below(one_in) != 0)
                return verdict;
            if (faults.below(12) == 0)
                kernel.unplug(path);
            else if (faults.below(4) == 0)
                verdict.limit = faults.below(64);
            else
                verdict.error = errors[faults.below(8)];
            return verdict;
        });
        for (unsigned frame = 0; frame < 3; ++frame) {
            const auto x = static_cast<std::int32_t>(random.below(120)),
                       y = static_cast<std::int32_t>(random.below(60));
            (void)draw(sequence * 3 + frame, {x, y, 8, 4});
            if (const auto sent = show(); !sent.ok()) {
                ++failures;
                ASSERT_NE(sent.error().rule[0], '\0');
                if (sent.error().fault == Fault::gone) {
                    kernel.plug(path);
                    if (bus->open().ok())
                        (void)display->init();
                }
            }
        }
        kernel.set_judge(nullptr);
        kernel.plug(path);
        oled->forget_violations();
        hal::Result<void> sent = show();
        // The device was gone, or a slow machine missed a deadline.
        for (int i = 0; i < 5 && !sent.ok(); ++i) {
            ASSERT_TRUE(bus->open().ok()) << sequence;
            const auto ready = display->init();
            sent = ready ? show() : ready;
        }
        ASSERT_TRUE(sent.ok()) << sequence << ": " << sent.error().rule;
        ASSERT_EQ(difference(), "") << "sequence " << sequence;
        ASSERT_EQ(kernel.open_files(), files) << "sequence " << sequence;
        adapter.forget();
    }
    EXPECT_GT(failures, 300) << "the faults reach the program";
}

} // namespace
