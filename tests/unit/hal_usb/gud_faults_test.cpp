// Tests faults on USB: the error is right, nothing hangs or leaks, and the picture is right again afterwards.
#include <cerrno>
#include <chrono>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include "tests/support/random.hpp"
#include "tests/unit/hal_usb/gud_rig.hpp"

namespace {

using namespace gud_test;
using hal::Fault;
using Fate = sim::UsbfsDevice::Fate;

/// `skip` bulk transfers pass, and the next `times` meet this fate.
void meet(GudRig& rig, Fate fate, int skip, int times) {
    rig.usb.fate = [=](std::size_t) mutable {
        if (skip-- > 0 || times-- <= 0)
            return Fate::normal;
        return fate;
    };
}

void expect_mended(GudRig& rig) {
    rig.usb.fate = nullptr;
    const auto again = rig.show();
    ASSERT_TRUE(again.ok()) << again.error().rule;
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(GudFaults, AStallIsClearedAndTheBufferSentAgain) {
    for (const int skip : {0, 1, 3}) {
        GudRig rig;
        rig.size(320, 240);
        ASSERT_TRUE(rig.start().ok());
        ASSERT_TRUE(rig.draw(1));
        meet(rig, Fate::stall, skip, 1);
        const auto sent = rig.show();
        EXPECT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(rig.glass_difference(), "");
        ASSERT_TRUE(rig.draw(2));
        meet(rig, Fate::stall, 0, 1000);
        const auto refused = rig.show();
        EXPECT_EQ(refused.error().fault, Fault::unsupported);
        EXPECT_NE(std::string(refused.error().rule).find("USB display 1d50:614d: send pixels: "),
                  std::string::npos);
        expect_mended(rig);
    }
}

TEST(GudFaults, WhatFollowsAStallIsTakenBack) {
    GudRig rig;
    rig.size(320, 240);
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    rig.usb.fate = [n = 0](std::size_t) mutable { // any other transfer would wait for its timeout
        const int at = n++;
        return at == 0 ? Fate::stall : at < 4 ? Fate::silent : Fate::normal;
    };
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(rig.show().ok());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(2500));
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(GudFaults, CutShort) {
    for (const int times : {1, 1000}) {
        GudRig rig;
        ASSERT_TRUE(rig.start().ok());
        ASSERT_TRUE(rig.draw(1));
        meet(rig, Fate::cut, 0, times);
        const auto cut = rig.show();
        if (times == 1) { // the buffer goes out once more
            EXPECT_TRUE(cut.ok()) << cut.error().rule;
            EXPECT_EQ(rig.glass_difference(), "");
            continue;
        }
        EXPECT_EQ(cut.error().fault, Fault::short_write) << cut.error().rule;
        EXPECT_STREQ(cut.error().rule,
                     "USB display 1d50:614d: send pixels: the device took less than it was sent");
        rig.device.forget_violations(); // half a buffer breaks rules of the device
        expect_mended(rig);
    }
}

/// usbfs repeats no transfer by itself. After any error the host looks for the device again, and sends the
/// whole picture.
TEST(GudFaults, SystemCallsFail) {
    for (const int number : {EINTR, EAGAIN, EIO, ETIMEDOUT, ENOMEM}) {
        GudRig rig;
        ASSERT_TRUE(rig.start().ok());
        ASSERT_TRUE(rig.draw(1));
        rig.kernel.set_judge([number](const sim::Call& call) {
            const bool hit = call.kind == sim::Call::Kind::ioctl && call.request == USBDEVFS_SUBMITURB;
            return sim::CallVerdict{hit ? number : 0};
        });
        const auto failed = rig.show();
        EXPECT_FALSE(failed.ok());
        EXPECT_EQ(std::string(failed.error().rule).rfind("USB display 1d50:614d: ", 0), 0u)
            << failed.error().rule;
        rig.kernel.set_judge(nullptr);
        expect_mended(rig);
        EXPECT_EQ(rig.kernel.open_files(), 1);
    }
}

TEST(GudFaults, ASilentDeviceTimesOut) {
    GudRig rig;
    rig.size(320, 240);
    rig.config.bulk_timeout_ms = 40;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    meet(rig, Fate::silent, 1, 1000);
    const auto start = std::chrono::steady_clock::now();
    const auto late = rig.show();
    EXPECT_EQ(late.error().fault, Fault::timeout) << late.error().rule;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    expect_mended(rig);
}

TEST(GudFaults, PulledInTheMiddleAndPluggedAgain) {
    for (const Fate fate : {Fate::unplug, Fate::error})
        for (const int skip : {0, 1, 4}) {
            GudRig rig;
            rig.size(320, 240);
            ASSERT_TRUE(rig.start().ok());
            ASSERT_TRUE(rig.draw(1));
            ASSERT_TRUE(rig.show().ok());
            ASSERT_TRUE(rig.draw(2, {5, 5, 300, 200}));
            meet(rig, fate, skip, 1000);
            const auto gone = rig.show();
            EXPECT_EQ(gone.error().fault, Fault::gone) << gone.error().rule;
            EXPECT_FALSE(rig.display->connected());
            rig.usb.unplug();
            EXPECT_EQ(rig.kernel.open_files(), 0) << "nothing holds on to a device that went";
            const auto away = rig.show();
            EXPECT_EQ(away.error().fault, Fault::gone);
            EXPECT_NE(std::string(away.error().rule).find("No such file or directory; lsusb lists"),
                      std::string::npos)
                << away.error().rule;
            rig.device.power_cycle();
            rig.usb.plug();
            expect_mended(rig); // without init(), the first present that finds the device sends everything
            EXPECT_TRUE(rig.display->connected());
        }
}

TEST(GudFaults, AnotherSizeThatComesBackNeedsInit) {
    GudRig rig;
    ASSERT_TRUE(rig.start().ok());
    rig.usb.unplug();
    EXPECT_EQ(rig.draw(1), true);
    EXPECT_EQ(rig.show().error().fault, Fault::gone);
    rig.device.power_cycle();
    rig.size(64, 48);
    rig.usb.plug();
    EXPECT_EQ(rig.show().error().fault, Fault::wrong_device);
    EXPECT_EQ(rig.show().error().fault, Fault::bad_argument);
    ASSERT_TRUE(rig.display->init().ok());
    EXPECT_EQ(rig.display->info().width, 64);
    ASSERT_TRUE(rig.draw(3));
    expect_mended(rig);
}

/// The frame that a program holds stays memory of its size that can be read and written, whatever device
/// comes back. A surface may still be drawn to.
TEST(GudFaults, FramesGivenOutStayWhereTheyAre) {
    GudRig rig;
    ASSERT_TRUE(rig.start().ok());
    const hal::Frame old = rig.display->acquire().value();
    for (const auto& [width, height] : {std::pair{64, 48}, {8, 4}, {200, 2}, {40, 30}, {64, 48}}) {
        rig.usb.unplug();
        rig.device.power_cycle();
        rig.size(static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height));
        rig.usb.plug();
        ASSERT_TRUE(rig.display->init().ok());
        const hal::Frame now = rig.display->acquire().value();
        EXPECT_EQ(now.stride, 2 * width);
        EXPECT_EQ(now.extents->height, height);
        EXPECT_EQ(now.pixels == old.pixels, width == 40) << "a size that comes again has its memory again";
        std::fill(old.pixels, old.pixels + std::ptrdiff_t{30} * old.stride, std::uint8_t{0xA5});
        for (int y = 0; y < 30; ++y)
            old.extents->rows[y] = {0, 40};
        ASSERT_TRUE(rig.draw(5));
        expect_mended(rig);
    }
}

TEST(GudFaults, PermissionsAndOtherPrograms) {
    GudRig rig;
    rig.kernel.set_judge([](const sim::Call& call) {
        return sim::CallVerdict{call.kind == sim::Call::Kind::open ? EACCES : 0};
    });
    const auto denied = rig.start();
    EXPECT_EQ(denied.error().fault, Fault::denied);
    EXPECT_STREQ(denied.error().rule, "/dev/bus/usb/001/002: open: Permission denied; install the udev rules "
                                      "60-spangle.rules and join group 'plugdev'");
    rig.kernel.set_judge(nullptr);
    rig.usb.claimed_elsewhere = true;
    const auto busy = rig.start();
    EXPECT_EQ(busy.error().fault, Fault::busy);
    EXPECT_STREQ(busy.error().rule, "USB display 1d50:614d: claim: another program has the device");
    rig.usb.claimed_elsewhere = false;
    EXPECT_TRUE(rig.start().ok());
}

/// A request succeeded if the device says so, and only then.
TEST(GudFaults, AStatusThatCannotBeReadIsNoSuccess) {
    for (const bool empty : {true, false}) {
        GudRig rig;
        rig.device.status_on_set = true;
        const auto lose_status = [&](bool lost) {
            rig.device.empty(lost && empty ? 0 : 0xFE);
            rig.device.refuses_status = lost && !empty;
        };
        lose_status(true);
        const auto up = rig.start();
        EXPECT_EQ(up.error().fault, empty ? Fault::no_answer : Fault::unsupported) << up.error().rule;
        if (empty) {
            EXPECT_STREQ(up.error().rule,
                         "USB display 1d50:614d: SET_STATE_CHECK: GET_STATUS came back without a status");
        }
        EXPECT_EQ(rig.kernel.open_files(), 0);
        lose_status(false);
        ASSERT_TRUE(rig.start().ok());
        ASSERT_TRUE(rig.draw(1));
        lose_status(true);
        EXPECT_FALSE(rig.show().ok()) << "of a frame, too";
        lose_status(false);
        expect_mended(rig);
    }
}

/// Each request of the start needs a status of its own: without it the start fails.
TEST(GudFaults, EachRequestToComeUpNeedsItsStatus) {
    const std::pair<std::uint8_t, const char*> requests[] = {{0x61, "SET_STATE_CHECK"},
                                                             {0x63, "SET_CONTROLLER_ENABLE"},
                                                             {0x62, "SET_STATE_COMMIT"},
                                                             {0x64, "SET_DISPLAY_ENABLE"}};
    for (const auto& [request, name] : requests) {
        GudRig rig;
        rig.device.status_on_set = true;
        rig.device.hide_status_of(request);
        const auto up = rig.start();
        EXPECT_EQ(up.error().fault, Fault::no_answer) << name;
        EXPECT_EQ(std::string(up.error().rule),
                  std::string("USB display 1d50:614d: ") + name + ": GET_STATUS came back without a status");
        EXPECT_EQ(rig.kernel.open_files(), 0);
        rig.device.hide_status_of(0xFE);
        rig.device.refuse(request, 5);
        EXPECT_EQ(rig.start().error().fault, Fault::unsupported) << name;
        EXPECT_TRUE(rig.start().ok());
    }
}

/// A device that stalls is asked why. If it has no answer it still stalled, and the error must not name a
/// reason.
TEST(GudFaults, AStallWithoutAStatusStaysAStall) {
    for (const bool empty : {true, false}) {
        GudRig rig;
        rig.device.refuse(0x61, 4);
        rig.device.refuses_status = !empty;
        rig.device.hide_status_of(empty ? 0x61 : 0xFE);
        const auto up = rig.start();
        EXPECT_FALSE(up.ok());
        EXPECT_STREQ(up.error().rule,
                     "USB display 1d50:614d: SET_STATE_CHECK: the device refused this and gave no reason");
        EXPECT_EQ(rig.kernel.open_files(), 0);
        rig.device.refuses_status = false;
        EXPECT_TRUE(rig.start().ok());
    }
}

/// A device without STATUS_ON_SET is not asked for a status.
TEST(GudFaults, OnlyDevicesThatOfferAStatusAreAskedForIt) {
    GudRig rig;
    rig.device.refuses_status = true;
    rig.device.empty(0x00);
    EXPECT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    expect_mended(rig);
}

/// A reply without bytes is an error with a sentence, and no file stays open.
TEST(GudFaults, EmptyReplies) {
    const struct {
        std::uint8_t request;
        Fault fault; ///< none: an empty list is valid
    } cases[] = {{0x01, Fault::wrong_device}, {0x40, Fault::unsupported}, {0x41, Fault::none},
                 {0x50, Fault::wrong_device}, {0x51, Fault::unsupported}, {0x54, Fault::no_answer},
                 {0x55, Fault::unsupported}};
    for (const auto& c : cases) {
        GudRig rig;
        rig.device.connector_properties.clear();
        rig.device.empty(c.request);
        const auto up = rig.start();
        if (c.request == 0x51 || c.request == 0x41) {
            EXPECT_TRUE(up.ok()) << up.error().rule;
            continue;
        }
        EXPECT_EQ(up.error().fault, c.fault) << int{c.request} << ": " << up.error().rule;
        EXPECT_NE(up.error().rule[0], '\0');
        EXPECT_EQ(rig.kernel.open_files(), 0);
        rig.device.empty(0xFE);
        EXPECT_TRUE(rig.start().ok());
    }
}

/// Descriptors of impossible displays are refused with a sentence, before memory is taken or a band is sent.
TEST(GudFaults, AbsurdDescriptors) {
    const struct {
        std::uint16_t width, height;
        std::uint32_t buffer;
        bool full_update;
        std::uint8_t format;
        const char* cause; ///< null: the display starts
    } cases[] = {
        {32767, 4096, 1, false, 0x40, "the device's modes are too large"},
        {32767, 4096, 0, false, 0x40, "the device's modes are too large"},
        {4097, 4096, 0, false, 0x40, "the device's modes are too large"},
        {32768, 4, 0, false, 0x40, "the device's modes are too large"},
        {65535, 1, 0, false, 0x40, "the device's modes are too large"},
        {4, 4097, 0, false, 0x40, "the device's modes are too large"},
        {65535, 65535, 0xFFFFFFFF, false, 0x40, "the device's modes are too large"},
        {40, 30, 1, false, 0x40, "the device's buffer is too small for its modes"},
        {40, 30, 2, false, 0x50, "the device's buffer is too small for its modes"},
        {40, 30, 3, false, 0x80, "the device's buffer is too small for its modes"},
        {40, 30, 1, false, 0x01, nullptr},
        {40, 30, 2, false, 0x40, nullptr},
        {40, 30, 4, false, 0x80, nullptr},
        // A frame of 16,384 bands is the largest that the host sends; this one would have 16,512.
        {129, 128, 2, false, 0x40, "the device's buffer is too small for its modes"},
        {128, 128, 2, false, 0x40, nullptr},
        {40, 30, 2399, true, 0x40, "the device's buffer is too small for its modes"},
        {40, 30, 2400, true, 0x40, nullptr},
        {40, 30, 0, true, 0x40, nullptr},
        {40, 30, 0xFFFFFFFF, false, 0x40, nullptr},
        {0, 30, 0, false, 0x40, "the device has no mode of this size"},
        {40, 0, 0, false, 0x40, "the device has no mode of this size"},
    };
    for (const auto& c : cases) {
        SCOPED_TRACE(std::to_string(c.width) + "x" + std::to_string(c.height) + ", buffer of " +
                     std::to_string(c.buffer) + ", format " + std::to_string(c.format));
        GudRig rig;
        rig.size(c.width, c.height);
        rig.device.max_buffer_size = c.buffer;
        rig.device.full_update = c.full_update;
        rig.device.formats = {c.format};
        const auto up = rig.start();
        if (c.cause == nullptr) {
            ASSERT_TRUE(up.ok()) << up.error().rule;
            EXPECT_EQ(rig.glass_difference(), "");
            continue;
        }
        EXPECT_EQ(up.error().fault, Fault::unsupported);
        EXPECT_EQ(up.error().rule, std::string("USB display 1d50:614d: GET_CONNECTOR_MODES: ") + c.cause);
        EXPECT_EQ(rig.display->info().width, 0);
        EXPECT_EQ(rig.kernel.open_files(), 0);
    }
}

/// A mode that is too large for the device's buffer is left out; the other modes stay.
TEST(GudFaults, AModeThatCannotBeSentIsPassedOver) {
    GudRig rig;
    rig.device.modes = {{1, 2000, 1000, true}, {1, 60, 40, false}};
    rig.device.limits = {1, 4000, 1, 4000};
    rig.device.max_buffer_size = 100;
    ASSERT_TRUE(rig.start().ok());
    EXPECT_EQ(rig.display->info().width, 60);
    rig.config.width = 2000;
    EXPECT_EQ(
        rig.start().error().rule,
        std::string(
            "USB display 1d50:614d: GET_CONNECTOR_MODES: the device's buffer is too small for its modes"));
}

/// A device whose descriptors claim what it does not describe, or describe nothing at all.
class Braggart final : public sim::UsbFunction {
  public:
    std::vector<std::uint8_t> bytes;

    std::vector<std::uint8_t> descriptors() const override { return bytes; }
    bool control(const sim::UsbSetup&, const std::uint8_t*, std::vector<std::uint8_t>&) override {
        return false;
    }
    bool bulk_out(std::uint8_t, const std::uint8_t*, std::size_t) override { return false; }
    bool bulk_in(std::uint8_t, std::size_t, std::vector<std::uint8_t>&) override { return false; }
    void clear_halt() override {}
};

TEST(GudFaults, DescriptorsThatSayMoreThanTheyDescribe) {
    const std::vector<std::uint8_t> honest = sim::GudDevice().descriptors();
    // The place of bNumInterfaces, behind the descriptor of the device.
    constexpr std::size_t interfaces = 18 + 4;
    for (std::size_t kept = 0; kept <= honest.size(); ++kept)
        for (const unsigned claimed : {1u, 2u, 32u}) {
            Braggart function;
            function.bytes = honest;
            function.bytes[interfaces] = static_cast<std::uint8_t>(claimed);
            // `at` is the offset of bNumEndpoints in each interface.
            for (std::size_t at = 18 + 9; at + 9 <= honest.size(); at += 9)
                if (honest[at + 1] == 4)
                    function.bytes[at + 4] = static_cast<std::uint8_t>(claimed);
            function.bytes.resize(kept);
            sim::Kernel& kernel = sim::Kernel::instance();
            sim::UsbfsDevice usb(function);
            usb.attach(kernel, path);
            {
                hal::GudConfig config;
                config.device_file = path;
                hal::GudDisplay display(config);
                EXPECT_FALSE(display.init().ok());
            }
            EXPECT_EQ(kernel.open_files(), 0);
            kernel.forget_all();
        }
}

TEST(GudFaults, NoDisplayIsPluggedIn) {
    hal::GudDisplay display; // looks for a device
    const auto none = display.init();
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().rule[0], '\0');
    EXPECT_FALSE(display.connected());
}

// --- Random faults

TEST(GudFaults, AThousandSequencesAtRandom) {
    GudRig rig;
    rig.config.bulk_timeout_ms = 20;
    rig.config.poll_ms = 1;
    rig.device.poll_status = true;
    rig.device.max_buffer_size = 600;
    ASSERT_TRUE(rig.start().ok());
    int failures = 0;
    for (std::uint32_t sequence = 1; sequence <= 1000; ++sequence) {
        test::Random random{sequence * 2654435761u};
        {
            const std::lock_guard lock(rig.kernel);
            rig.device.refuse(static_cast<std::uint8_t>(random.below(2) == 0 ? 0x60 : 0xFF), 5);
            rig.usb.fate = [r = random](std::size_t) mutable {
                constexpr Fate fates[] = {Fate::stall, Fate::error, Fate::unplug, Fate::silent};
                const std::uint32_t chance = r.below(60);
                return chance < 15 ? fates[chance % 3] : chance == 15 ? Fate::silent : Fate::normal;
            };
        }
        for (unsigned frame = 0; frame < 3; ++frame) {
            const auto x = static_cast<std::int32_t>(random.below(30)),
                       y = static_cast<std::int32_t>(random.below(20));
            ASSERT_TRUE(rig.draw(sequence * 3 + frame, {x, y, 10, 10}, random.below(2) == 0));
            if (const auto sent = rig.show(); !sent.ok()) {
                ++failures;
                ASSERT_NE(sent.error().rule[0], '\0');
                if (sent.error().fault == Fault::gone)
                    rig.device.power_cycle();
                rig.usb.plug();
            }
        }
        {
            const std::lock_guard lock(rig.kernel);
            rig.usb.fate = nullptr;
            rig.device.refuse(0xFF, 0);
        }
        rig.usb.plug();
        auto sent = rig.show();
        // The poller had not yet noticed that the device went, or the test machine was busy.
        for (int i = 0; i < 5 && (sent.error().fault == Fault::gone || sent.error().fault == Fault::timeout);
             ++i)
            sent = rig.show();
        ASSERT_TRUE(sent.ok()) << sequence << ": " << sent.error().rule;
        ASSERT_EQ(rig.kernel.open_files(), 1) << sequence;
        ASSERT_EQ(rig.glass_difference(), "") << sequence;
    }
    EXPECT_GT(failures, 500);
}

} // namespace
