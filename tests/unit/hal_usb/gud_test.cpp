// Tests the GUD host against the device: how it starts, what it sends, what it never sends.
#include <cerrno>
#include <chrono>
#include <thread>

#include <linux/usbdevice_fs.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "tests/support/scene_player.hpp"
#include "tests/unit/hal_usb/gud_rig.hpp"

namespace {

using namespace gud_test;
using hal::Fault;

TEST(Gud, ComesUpBlackAndGoesDownDark) {
    GudRig rig;
    const auto ready = rig.start();
    ASSERT_TRUE(ready.ok()) << ready.error().rule;
    EXPECT_TRUE(rig.device.enabled());
    EXPECT_TRUE(rig.display->connected());
    const hal::DisplayInfo info = rig.display->info();
    EXPECT_EQ(info.width, 40);
    EXPECT_EQ(info.height, 30);
    EXPECT_EQ(info.format, PixelFormat::rgb565_le);
    EXPECT_EQ(rig.glass_difference(), "");
    rig.display.reset();
    EXPECT_FALSE(rig.device.enabled());
    EXPECT_EQ(rig.device.violations(), "");
}

TEST(Gud, EveryFormat) {
    for (const std::uint8_t format : {0x01, 0x08, 0x20, 0x30, 0x40, 0x50, 0x80, 0x81})
        for (const std::uint32_t most : {0u, 1000u, 61u, 8u}) {
            SCOPED_TRACE("format " + std::to_string(format) + ", buffers of " + std::to_string(most));
            GudRig rig;
            rig.device.formats = {format};
            rig.device.max_buffer_size = most;
            ASSERT_TRUE(rig.start().ok());
            ASSERT_TRUE(rig.draw(1));
            ASSERT_TRUE(rig.show().ok());
            EXPECT_EQ(rig.glass_difference(), "");
            for (const Rect part : {Rect{3, 5, 7, 9}, Rect{39, 0, 1, 30}, Rect{13, 29, 27, 1}}) {
                ASSERT_TRUE(rig.draw(2, part));
                ASSERT_TRUE(rig.show().ok());
                EXPECT_EQ(rig.glass_difference(), "");
            }
            EXPECT_LE(rig.device.counters().largest_buffer, most != 0 ? most : 40u * 30 * 4);
        }
}

TEST(Gud, TakesTheFormatThatLosesLeast) {
    const struct {
        std::vector<std::uint8_t> offered;
        std::uint32_t bytes; ///< bytes of a frame of 40 x 30
    } cases[] = {{{0x80, 0x40, 0x08}, 2400},
                 {{0x01, 0x80, 0x30}, 4800},
                 {{0x50, 0x80}, 3600},
                 {{0x08, 0x01}, 1200},
                 {{0x99, 0x01, 0x20}, 600}};
    for (const auto& c : cases) {
        GudRig rig;
        rig.device.formats = c.offered;
        ASSERT_TRUE(rig.start().ok());
        EXPECT_EQ(rig.device.counters().largest_buffer, c.bytes);
    }
    GudRig rig;
    rig.device.formats = {0x99};
    const auto none = rig.start();
    EXPECT_EQ(none.error().fault, Fault::unsupported);
    EXPECT_STREQ(none.error().rule,
                 "USB display 1d50:614d: GET_FORMATS: none of the device's pixel formats is known");
}

TEST(Gud, ChoosesAMode) {
    GudRig rig;
    rig.device.modes = {{1, 64, 32, false}, {1, 20, 10, true}, {1, 64, 48, false}};
    rig.device.limits = {10, 64, 10, 48};
    ASSERT_TRUE(rig.start().ok());
    EXPECT_EQ(rig.display->info().width, 20) << "the preferred one";
    rig.config.height = 48;
    ASSERT_TRUE(rig.start().ok());
    EXPECT_EQ(rig.display->info().width, 64);
    EXPECT_EQ(rig.display->info().height, 48);
    rig.config.height = 47;
    EXPECT_EQ(rig.start().error().fault, Fault::unsupported);
    EXPECT_EQ(rig.display->acquire().error().fault, Fault::bad_argument);
    EXPECT_EQ(rig.show().error().fault, Fault::bad_argument);
    rig.config.height = 0;
    rig.device.limits = {10, 64, 10, 31};
    rig.device.modes.erase(rig.device.modes.begin() + 1);
    EXPECT_EQ(rig.start().error().fault, Fault::unsupported) << "beyond what the device can";
    EXPECT_EQ(rig.device.violations(), "");
}

TEST(Gud, ReadsTheModeFromAnEdid) {
    GudRig rig;
    rig.device.modes.clear();
    rig.device.limits = {1, 2000, 1, 2000};
    rig.device.edid.assign(128, 0);
    // A timing of 800 x 480 with blanking of 256 x 45 (VESA E-EDID 1.4, 3.10.2).
    const std::uint8_t timing[] = {0x10, 0x0B, 0x20, 0x00, 0x31, 0xE0, 0x2D, 0x10, 0x28, 0x80, 0xA3, 0x00};
    std::copy(std::begin(timing), std::end(timing), rig.device.edid.begin() + 54);
    ASSERT_TRUE(rig.start().ok());
    EXPECT_EQ(rig.display->info().width, 800);
    EXPECT_EQ(rig.display->info().height, 480);
    rig.device.edid.resize(100);
    EXPECT_EQ(rig.start().error().fault, Fault::unsupported) << "half an EDID";
}

TEST(Gud, EveryPropertyIsInTheState) {
    GudRig rig;
    rig.device.properties = {{50, 1}};
    rig.device.connector_properties = {{1, 7}, {12, 3}, {5, 0x123456}};
    rig.config.brightness = 42;
    ASSERT_TRUE(rig.start().ok());
    EXPECT_EQ(rig.device.value_of(50), 1u);
    EXPECT_EQ(rig.device.value_of(1), 7u);
    EXPECT_EQ(rig.device.value_of(5), 0x123456u);
    EXPECT_EQ(rig.device.value_of(12), 42u) << "the backlight is the program's";
    EXPECT_EQ(rig.device.violations(), "");
}

TEST(Gud, CompressesOnlyWhatShrinks) {
    GudRig rig;
    ASSERT_TRUE(rig.start().ok());
    const auto before = rig.device.counters();
    EXPECT_EQ(before.compressed, before.flushes) << "black";
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.device.counters().compressed, before.compressed) << "noise";
    EXPECT_EQ(rig.device.counters().bulk_bytes - before.bulk_bytes, 40u * 30 * 2);
    ASSERT_TRUE(rig.draw(2, true));
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.device.counters().compressed, before.compressed + 1);
    EXPECT_LT(rig.device.counters().bulk_bytes - before.bulk_bytes, 40u * 30 * 2 + 100);
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(Gud, CompressesOnlyWhereBothWantTo) {
    for (const bool host : {false, true}) {
        GudRig plain;
        plain.config.compress = host;
        plain.device.lz4 = !host;
        ASSERT_TRUE(plain.start().ok());
        EXPECT_EQ(plain.device.counters().compressed, 0u);
        EXPECT_EQ(plain.device.violations(), "");
    }
}

TEST(Gud, SendsWhatChanged) {
    GudRig rig;
    rig.size(200, 100);
    ASSERT_TRUE(rig.start().ok());
    const auto bytes = [&] {
        const std::uint64_t before = rig.device.counters().bulk_bytes;
        EXPECT_TRUE(rig.show().ok());
        EXPECT_EQ(rig.glass_difference(), "");
        return rig.device.counters().bulk_bytes - before;
    };
    EXPECT_EQ(bytes(), 0u) << "black is there already";
    ASSERT_TRUE(rig.draw(1));
    EXPECT_EQ(bytes(), 200u * 100 * 2);
    EXPECT_EQ(bytes(), 0u);
    ASSERT_TRUE(rig.draw(2, {10, 20, 30, 40}));
    EXPECT_EQ(bytes(), 30u * 40 * 2);
    EXPECT_EQ(rig.display->acquire().value().age, 1);
    // A full clear to the same colour damages what was drawn before; a clear to another colour damages
    // everything.
    const auto clear = [&](std::uint8_t value) {
        const auto frame = rig.display->acquire().value();
        std::fill(frame.pixels, frame.pixels + 200 * 100 * 2, value);
        std::fill(frame.extents->rows, frame.extents->rows + 100, RowSpan{});
        frame.extents->cleared = true;
        frame.extents->clear_value = value;
    };
    clear(0);
    EXPECT_GT(bytes(), 0u) << "200 x 100 of noise go";
    ASSERT_TRUE(rig.draw(3, {50, 50, 20, 10}));
    EXPECT_EQ(bytes(), 20u * 10 * 2);
    rig.config.compress = false;
    clear(0);
    const std::uint64_t erased = bytes();
    EXPECT_GT(erased, 0u);
    EXPECT_LT(erased, 20u * 10 * 2) << "flat, compressed, and no more than was there";
    clear(7);
    EXPECT_GT(bytes(), 0u);
    clear(7);
    EXPECT_EQ(bytes(), 0u);
}

TEST(Gud, DevicesThatAnswerAfterEverySet) {
    GudRig rig;
    rig.device.status_on_set = true;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.glass_difference(), "");
    rig.device.refuse(0x60, 1);
    ASSERT_TRUE(rig.draw(2));
    EXPECT_TRUE(rig.show().ok()) << "busy once: the buffer goes out again";
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(Gud, RefusalsSpeakTheDevicesWord) {
    for (const bool on_set : {false, true}) {
        GudRig rig;
        rig.device.status_on_set = on_set;
        rig.device.refuse(0x61, 4);
        const auto refused = rig.start();
        EXPECT_EQ(refused.error().fault, Fault::unsupported);
        EXPECT_STREQ(refused.error().rule, "USB display 1d50:614d: SET_STATE_CHECK: invalid parameter");
        EXPECT_TRUE(rig.start().ok());
    }
    GudRig rig;
    rig.device.refuse(0x01, 2);
    EXPECT_STREQ(rig.start().error().rule, "USB display 1d50:614d: GET_DESCRIPTOR: request not supported");
}

TEST(Gud, DevicesOfFullUpdatesGetWholeFrames) {
    GudRig rig;
    rig.device.full_update = true;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.show().ok());
    ASSERT_TRUE(rig.draw(2, {3, 3, 2, 2}));
    const std::uint64_t before = rig.device.counters().bulk_bytes;
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.device.counters().bulk_bytes - before, 40u * 30 * 2);
    EXPECT_EQ(rig.device.counters().buffers, 0u) << "no SET_BUFFER";
    EXPECT_EQ(rig.glass_difference(), "");
    rig.device.stall_bulk();
    ASSERT_TRUE(rig.draw(3));
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.device.counters().buffers, 1u) << "but one after a failure";
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(Gud, TheKernelsDriverLetsGoAndComesBack) {
    GudRig rig;
    rig.usb.kernel_driver = true;
    ASSERT_TRUE(rig.start().ok());
    EXPECT_FALSE(rig.usb.kernel_driver);
    rig.display.reset();
    EXPECT_TRUE(rig.usb.kernel_driver);
}

TEST(Gud, KeepsDevicesCompanyThatWantIt) {
    for (const bool wanted : {true, false}) {
        GudRig rig;
        rig.device.poll_status = wanted;
        rig.config.poll_ms = 5;
        ASSERT_TRUE(rig.start().ok());
        const auto polls = [&] {
            const std::lock_guard lock(rig.kernel); // keeps the poller from running
            return rig.device.counters().status_polls;
        };
        const std::uint64_t before = polls();
        for (int i = 0; i < 1000 && wanted && polls() < before + 5; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (!wanted)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        EXPECT_EQ(polls() >= before + 5, wanted);
        if (!wanted)
            continue;
        {
            const std::lock_guard lock(rig.kernel);
            rig.device.connected = false;
        }
        for (int i = 0; i < 1000 && rig.display->connected(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        EXPECT_FALSE(rig.display->connected());
    }
}

TEST(Gud, TwoTransfersAreInFlight) {
    GudRig rig;
    rig.size(320, 240);
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.usb.most_under_way, 4) << "libusb makes two requests of each";
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(Gud, WrongDevicesAreSaidSo) {
    struct NotGud final : sim::UsbFunction {
        sim::GudDevice like;
        bool vendor_class = true;
        std::vector<std::uint8_t> descriptors() const override {
            auto d = like.descriptors();
            d[18 + 9 + 5] = vendor_class ? 0xFF : 8;
            return d;
        }
        bool control(const sim::UsbSetup& setup, const std::uint8_t* out,
                     std::vector<std::uint8_t>& in) override {
            const bool answered = like.control(setup, out, in);
            if (setup.request == 1 && !in.empty())
                in[0] ^= 1;
            return answered;
        }
        bool bulk_out(std::uint8_t, const std::uint8_t*, std::size_t) override { return false; }
        bool bulk_in(std::uint8_t, std::size_t, std::vector<std::uint8_t>&) override { return false; }
        void clear_halt() override {}
    } other;
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::UsbfsDevice usb(other);
    usb.attach(kernel, path);
    hal::GudConfig config;
    config.device_file = path;
    {
        hal::GudDisplay display(config);
        EXPECT_STREQ(display.init().error().rule,
                     "USB display 1d50:614d: GET_DESCRIPTOR: this is no GUD display of version 1");
        other.vendor_class = false;
        EXPECT_EQ(display.init().error().fault, Fault::wrong_device);
        EXPECT_EQ(kernel.open_files(), 0);
    }
    kernel.forget_all();
}

// --- Scenes

TEST(Gud, ShowsScenesAsABoardDoes) {
    for (const char* const id : {"S6", "HUD"}) {
        const scenes::Scene& scene = *scenes::find(id);
        sim::SimBoard board(boards::ili9341_spi);
        ASSERT_TRUE(test::play(board.display(), scene, 3));
        GudRig rig;
        rig.size(320, 240);
        rig.device.max_buffer_size = 40000; // bytes; less than a frame, as in gud-pico
        rig.usb.attach(rig.kernel, path);
        rig.display.emplace(rig.config);
        ASSERT_TRUE(test::play(*rig.display, scene, 3));
        ASSERT_TRUE(rig.display->finish().ok());
        EXPECT_EQ(sim::compare_565(rig.device.glass(), board.glass()).identical_percent(), 100.0) << id;
        EXPECT_EQ(rig.device.violations(), "");
    }
}

} // namespace
