// Tests faults between the host and a panel at an FTDI adapter: the error is right, nothing hangs or leaks,
// and the glass is right again afterwards.
#include <cerrno>
#include <chrono>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include "tests/support/random.hpp"
#include "tests/unit/hal_usb/ftdi_rig.hpp"

namespace {

using namespace ftdi_test;
using hal::Fault;
using sim::Call;
using sim::CallVerdict;
using Fate = sim::UsbfsDevice::Fate;

bool submits(const Call& call) {
    return call.kind == Call::Kind::ioctl && call.request == USBDEVFS_SUBMITURB;
}

/// `skip` bulk transfers pass, and the next `times` meet this fate.
void meet(Rig& rig, Fate fate, int skip, int times) {
    rig.usb.fate = [=](std::size_t) mutable {
        if (skip-- > 0 || times-- <= 0)
            return Fate::normal;
        return fate;
    };
}

/// The next present, with nothing new to draw, must mend the glass.
void expect_mended(Rig& rig) {
    rig.usb.fate = nullptr;
    rig.kernel.set_judge(nullptr);
    rig.module.controller().forget_violations(); // half a transfer breaks rules of the controller
    auto again = rig.display->present();
    for (int i = 0; i < 5 && again.error().fault == Fault::timeout; ++i) // the test machine may be busy
        again = rig.display->present();
    ASSERT_TRUE(again.ok()) << again.error().rule;
    rig.module.controller().forget_violations();
    EXPECT_EQ(rig.glass_difference(), "");
}

void expect_failed_frame(Rig& rig, Fault fault, const char* says) {
    ASSERT_TRUE(rig.draw(2));
    const auto failed = rig.display->present();
    EXPECT_EQ(failed.error().fault, fault) << failed.error().rule;
    EXPECT_NE(std::string(failed.error().rule).find(says), std::string::npos) << failed.error().rule;
    EXPECT_EQ(std::string(failed.error().rule).rfind("FTDI adapter 0403:6014: ", 0), 0u)
        << failed.error().rule;
}

TEST(FtdiFaults, CutShortStalledAndBroken) {
    const struct {
        Fate fate;
        Fault fault;
        const char* says;
    } cases[] = {{Fate::cut, Fault::short_write, "send pixels: the device took less than it was sent"},
                 {Fate::stall, Fault::unsupported, "send pixels: Pipe error"},
                 {Fate::error, Fault::gone, "send pixels: "}};
    for (const auto& c : cases) {
        Rig rig;
        ASSERT_TRUE(rig.start().ok());
        meet(rig, c.fate, 0, 1);
        expect_failed_frame(rig, c.fault, c.says);
        expect_mended(rig); // the engine is started again by itself
    }
}

TEST(FtdiFaults, ASilentAdapterTimesOut) {
    for (const int skip : {0, 1}) { // fails the stream, or the answer that it is done
        Rig rig;
        rig.config.timeout_ms = 30;
        ASSERT_TRUE(rig.start().ok());
        meet(rig, Fate::silent, skip, 1000);
        const auto start = std::chrono::steady_clock::now();
        expect_failed_frame(rig, Fault::timeout, skip == 0 ? "send pixels: " : "read: ");
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
        expect_mended(rig);
    }
}

TEST(FtdiFaults, AHangingTransferEndsInATimeoutAndIsOverLater) {
    RigOptions options;
    options.asynchronous = true;
    Rig rig(options);
    rig.config.timeout_ms = 8000;
    ASSERT_TRUE(rig.start().ok());
    meet(rig, Fate::silent, 0, 1000);
    ASSERT_TRUE(rig.draw(2));
    const auto late = rig.display->present(); // the display stops waiting before the transfer ends
    EXPECT_EQ(late.error().fault, Fault::timeout) << late.error().rule;
    EXPECT_EQ(rig.display->acquire().error().fault, Fault::busy) << "the frame is still being read";
    EXPECT_EQ(rig.bus->backlight(false).error().fault, Fault::busy);
    EXPECT_EQ(rig.bus->open().error().fault, Fault::busy);
    for (int i = 0; i < 4000 && !rig.display->acquire().ok(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    expect_mended(rig);
}

TEST(FtdiFaults, AnEngineOutOfStepIsNoticed) {
    Rig rig;
    ASSERT_TRUE(rig.start().ok());
    rig.adapter.garble_answer();
    expect_failed_frame(rig, Fault::no_answer, "the engine lost its step");
    expect_mended(rig);
    const std::uint8_t stale[] = {0x81, 0x81, 0x87}; // answers to no request
    rig.adapter.engine.feed(stale, sizeof stale);
    expect_failed_frame(rig, Fault::no_answer, "more than it was asked");
    expect_mended(rig);
}

TEST(FtdiFaults, PulledInTheMiddleAndPluggedAgain) {
    for (const int after : {0, 1, 2}) {
        RigOptions options;
        options.panel = &hal::panels::st7789_240x320;
        Rig rig(options);
        ASSERT_TRUE(rig.start().ok());
        ASSERT_TRUE(rig.draw(2));
        meet(rig, Fate::unplug, after, 1);
        const auto gone = rig.display->present();
        EXPECT_EQ(gone.error().fault, Fault::gone) << gone.error().rule;
        EXPECT_EQ(rig.display->present().error().fault, Fault::gone) << "as long as it is away";
        const auto away = rig.open();
        EXPECT_EQ(away.error().fault, Fault::gone);
        EXPECT_STREQ(away.error().rule,
                     "/dev/bus/usb/001/003: open: No such file or directory; lsusb lists what is plugged in");
        EXPECT_EQ(rig.kernel.open_files(), 0);
        rig.plug_in_again();
        ASSERT_TRUE(rig.open().ok());
        ASSERT_TRUE(rig.display->init().ok());
        expect_mended(rig);
    }
}

TEST(FtdiFaults, ReplugBetweenFramesIsNoticed) {
    Rig rig;
    ASSERT_TRUE(rig.start().ok());
    rig.usb.unplug();
    rig.plug_in_again(); // before the bus noticed that the device was gone
    ASSERT_TRUE(rig.draw(2));
    EXPECT_EQ(rig.display->present().error().fault, Fault::gone) << "the old file is dead";
    ASSERT_TRUE(rig.open().ok());
    ASSERT_TRUE(rig.display->init().ok());
    expect_mended(rig);
}

TEST(FtdiFaults, RequestsAreRefused) {
    for (const std::uint8_t request : {0, 9, 11}) { // reset, latency, mode
        Rig rig;
        ASSERT_TRUE(rig.start().ok());
        rig.adapter.refuse(request);
        const auto refused = rig.open();
        EXPECT_EQ(refused.error().fault, Fault::no_answer) << refused.error().rule;
        EXPECT_NE(std::string(refused.error().rule).find("FTDI adapter 0403:6014: set up: "),
                  std::string::npos);
        EXPECT_EQ(rig.kernel.open_files(), 0);
        ASSERT_TRUE(rig.open().ok());
        ASSERT_TRUE(rig.draw(2));
        expect_mended(rig);
    }
}

TEST(FtdiFaults, PermissionsAndOtherPrograms) {
    Rig rig;
    for (const int number : {EACCES, EPERM}) {
        rig.kernel.set_judge(
            [=](const Call& call) { return CallVerdict{call.kind == Call::Kind::open ? number : 0}; });
        const auto denied = rig.open();
        EXPECT_EQ(denied.error().fault, Fault::denied);
        EXPECT_NE(std::string(denied.error().rule).find("60-spangle.rules and join group 'plugdev'"),
                  std::string::npos);
    }
    rig.kernel.set_judge(nullptr);
    rig.usb.claimed_elsewhere = true;
    const auto busy = rig.open();
    EXPECT_EQ(busy.error().fault, Fault::busy);
    EXPECT_STREQ(busy.error().rule, "FTDI adapter 0403:6014: claim: another program has the device");
    rig.usb.claimed_elsewhere = false;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(2));
    expect_mended(rig);
}

TEST(FtdiFaults, SystemCallsFail) {
    for (const int number : {EINTR, EAGAIN, EIO, ENOMEM, ETIMEDOUT}) {
        Rig rig;
        ASSERT_TRUE(rig.start().ok());
        rig.kernel.set_judge([number, times = 1](const Call& call) mutable {
            const bool hit = submits(call) && times-- > 0;
            return CallVerdict{hit ? number : 0};
        });
        expect_failed_frame(rig, number == ENOMEM ? Fault::no_answer : Fault::gone, "send pixels: ");
        expect_mended(rig);
    }
}

TEST(FtdiFaults, TheTearingLineMayBeMissing) {
    RigOptions options;
    options.wait_te = true;
    Rig rig(options);
    rig.config.timeout_ms = 30;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.display->present().ok());
    EXPECT_EQ(rig.glass_difference(), "");
    rig.module.cut_te(true);
    expect_failed_frame(rig, Fault::timeout, "TE output wired");
    rig.module.cut_te(false);
    expect_mended(rig);
}

TEST(FtdiFaults, TheChipItselfWaitsForTheEdge) {
    RigOptions options;
    options.wait_te = true;
    options.panel = &hal::panels::st7789_240x320;
    Rig rig(options);
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(9));
    ASSERT_TRUE(rig.display->present().ok()); // the whole picture, behind the beam
    for (unsigned frame = 0; frame < 5; ++frame) {
        ASSERT_TRUE(rig.draw(frame, {0, 0, 8, 8}));
        rig.kernel.advance(3'000'000);
        if (frame % 2 != 0) { // TE is high already: too late for this blanking
            while (!rig.module.controller().te(rig.kernel.now()))
                rig.kernel.advance(10'000);
            rig.kernel.advance(500'000);
        }
        sim::Time first = 0; // time at which pixels begin: D/C rises after a command
        bool command = false;
        const auto forward = rig.adapter.engine.on_change;
        rig.adapter.engine.on_change = [&](std::uint64_t levels, sim::Time now) {
            if ((levels & 0x19) == 0x11 && command) // SCK is high, and the panel selected
                first = now;
            if ((levels & 1) != 0)
                command = (levels & 0x10) == 0;
            forward(levels, now);
        };
        ASSERT_TRUE(rig.display->present().ok());
        rig.adapter.engine.on_change = forward;
        ASSERT_NE(first, 0u);
        EXPECT_TRUE(rig.module.controller().te(first)) << "the beam is in the blanking";
        EXPECT_FALSE(rig.module.controller().te(first - 200000)) << "which has just begun";
    }
}

TEST(FtdiFaults, AClockTooFastForThePanelShows) {
    hal::PanelDesc slow = test::tiny_panel;
    slow.timing.practical_serial_mhz = 29;
    RigOptions options;
    options.write_hz = 30000000;
    options.panel = &slow;
    Rig rig(options);
    const auto ready = rig.start();
    EXPECT_EQ(ready.error().fault, Fault::unsupported) << ready.error().rule;
    EXPECT_NE(std::string(ready.error().rule).find("write clock is faster"), std::string::npos)
        << ready.error().rule;
}

TEST(FtdiFaults, AReadClockTooFastForThePanelShows) {
    RigOptions options;
    options.read_hz = 30000000;
    Rig unread(options);
    EXPECT_TRUE(unread.start().ok()) << "who does not read does not care";
    options.read_back = true;
    unread.display.reset();
    unread.bus.reset();
    unread.kernel.forget_all();
    Rig rig(options);
    const auto ready = rig.start();
    EXPECT_EQ(ready.error().fault, Fault::unsupported);
    EXPECT_NE(std::string(ready.error().rule).find("read clock is faster"), std::string::npos);
}

// --- Random faults

TEST(FtdiFaults, AThousandSequencesAtRandom) {
    RigOptions options;
    options.asynchronous = true;
    Rig rig(options);
    rig.config.timeout_ms = 20;
    ASSERT_TRUE(rig.start().ok());
    const int files = rig.kernel.open_files();
    int failures = 0;
    for (std::uint32_t sequence = 1; sequence <= 1000; ++sequence) {
        test::Random random{sequence * 2654435761u};
        {
            const std::lock_guard lock(rig.kernel);
            rig.usb.fate = [r = random](std::size_t) mutable {
                constexpr Fate fates[] = {Fate::stall, Fate::error, Fate::unplug, Fate::cut, Fate::cut};
                const std::uint32_t chance = r.below(80);
                return chance < 20 ? fates[chance % 5] : chance == 20 ? Fate::silent : Fate::normal;
            };
            if (random.below(4) == 0)
                rig.adapter.garble_answer();
        }
        rig.kernel.set_judge([r = random](const Call& call) mutable {
            constexpr int errors[] = {EINTR, EIO, ENOMEM, ETIMEDOUT};
            const bool hit = submits(call) && r.below(60) == 0;
            return CallVerdict{hit ? errors[r.below(4)] : 0};
        });
        for (unsigned frame = 0; frame < 3; ++frame) {
            const auto x = static_cast<std::int32_t>(random.below(20)),
                       y = static_cast<std::int32_t>(random.below(14));
            // Drawing is refused while the bus reads a late frame.
            (void)rig.draw(sequence * 3 + frame, {x, y, 4, 2});
            if (const auto sent = rig.display->present(); !sent.ok()) {
                ++failures;
                ASSERT_NE(sent.error().rule[0], '\0');
                rig.usb.plug();
                if (sent.error().fault == Fault::gone && rig.open().ok())
                    (void)rig.display->init();
            }
        }
        {
            const std::lock_guard lock(rig.kernel);
            rig.usb.fate = nullptr;
        }
        rig.kernel.set_judge(nullptr);
        rig.usb.plug();
        hal::Result<void> sent = rig.display->present();
        for (int i = 0; i < 200 && !sent.ok(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // a late transfer ends
            const auto opened = rig.open();
            const auto ready = opened ? rig.display->init() : opened;
            sent = ready ? rig.display->present() : ready;
        }
        ASSERT_TRUE(sent.ok()) << sequence << ": " << sent.error().rule;
        rig.module.controller().forget_violations();
        ASSERT_EQ(rig.glass_difference(), "") << "sequence " << sequence;
        ASSERT_EQ(rig.kernel.open_files(), files) << "sequence " << sequence;
    }
    EXPECT_GT(failures, 500) << "the faults reach the program";
}

} // namespace
