// Runs the GUD device as a Linux gadget, with Spangle's host and with the kernel's driver, through another
// pair of controllers.
#include <chrono>
#include <mutex>
#include <optional>

#include <gtest/gtest.h>

#include "tests/unit/hal_kernel/drm_card.hpp"
#include "tests/unit/hal_kernel/gadget.hpp"
#include "tests/unit/hal_kernel/gud_driver.hpp"
#include "tests/unit/hal_usb/gud_picture.hpp"

namespace {

using namespace kernel_test;
using namespace spangle;
using hal::Fault;
using Fate = Gadget::Fate;

struct GudGadget {
    static constexpr char name[] = "1-1"; ///< the only port of dummy_hcd's bus

    sim::GudDevice device;
    std::optional<Gadget> gadget;
    hal::GudConfig config;
    std::optional<hal::GudDisplay> display;

    GudGadget() {
        device.status_on_set = true;    // a Linux gadget cannot refuse what it has read
        device.tells_by_length = false; // the kernel's driver may compress to the same length
        gadget.emplace(device);
    }
    ~GudGadget() {
        display.reset();
        try {
            dismiss_gud_driver(name);
            gadget->unplug();
            await_no_device(name);
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
    }

    void plug() {
        gadget->plug();
        await_gud_driver();
    }
    void start() {
        plug();
        display.emplace(config);
        const auto ready = display->init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
    }
    hal::Result<void> show(unsigned seed, bool flat = false) {
        const hal::DisplayInfo info = display->info();
        EXPECT_TRUE(gud_test::draw_pattern(*display, seed, {0, 0, info.width, info.height}, flat));
        return gud_test::show(*display);
    }
    /// The host is done when the controller has the last packet, which the program behind it must still read.
    void expect_shown() {
        std::string difference;
        for (int tries = 0; tries < 1000; ++tries) {
            {
                const std::lock_guard lock(*gadget);
                difference = gud_test::glass_difference(*display, device);
            }
            if (difference.empty())
                return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ADD_FAILURE() << difference;
    }
    void expect_mended() {
        gadget->misbehave(Fate::normal, 0);
        const auto again = gud_test::show(*display);
        ASSERT_TRUE(again.ok()) << again.error().rule;
        expect_shown();
    }
};

TEST(KernelGadget, OurHostDrawsExactly) {
    GudGadget gud;
    ASSERT_NO_FATAL_FAILURE(gud.start());
    for (unsigned seed = 1; seed < 5; ++seed) {
        const auto sent = gud.show(seed, seed % 2 == 0);
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        gud.expect_shown();
    }
}

TEST(KernelGadget, TheKernelsDriverDrawsExactly) {
    GudGadget gud;
    gud.device.formats = {0x80};
    gud.plug();
    DrmCard picture(gud_card, 32);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            picture.put(x, y, static_cast<std::uint32_t>(x * 40503 ^ y * 9973) & 0xFFFFFF);
    picture.flush({0, 0, picture.width(), picture.height()});
    await("show the picture", [&] {
        const std::lock_guard lock(*gud.gadget);
        const sim::Image glass = gud.device.glass();
        for (int y = 0; y < glass.height; ++y)
            for (int x = 0; x < glass.width; ++x) {
                const std::uint8_t* const got = glass.at(x, y);
                if (picture.get(x, y) != (std::uint32_t{got[0]} << 16 | std::uint32_t{got[1]} << 8 | got[2]))
                    return false;
            }
        return glass.width == picture.width();
    });
    EXPECT_EQ(gud.device.violations(), "");
}

TEST(KernelGadget, AHaltedPipeIsClearedAndTheBufferSentAgain) {
    GudGadget gud;
    ASSERT_NO_FATAL_FAILURE(gud.start());
    for (const std::size_t after : {512u, 40960u}) {
        gud.gadget->misbehave(Fate::stall, after);
        const auto sent = gud.show(static_cast<unsigned>(after));
        EXPECT_TRUE(sent.ok()) << sent.error().rule;
        gud.expect_shown();
    }
}

TEST(KernelGadget, ASilentDeviceTimesOut) {
    GudGadget gud;
    gud.config.bulk_timeout_ms = 300;
    ASSERT_NO_FATAL_FAILURE(gud.start());
    gud.gadget->misbehave(Fate::silent, 20480);
    const auto start = std::chrono::steady_clock::now();
    const auto late = gud.show(3);
    EXPECT_EQ(late.error().fault, Fault::timeout) << late.error().rule;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    gud.config.bulk_timeout_ms = 3000;
    gud.expect_mended();
}

TEST(KernelGadget, PulledInTheMiddleAndPluggedAgain) {
    GudGadget gud;
    ASSERT_NO_FATAL_FAILURE(gud.start());
    gud.gadget->misbehave(Fate::unplug, 30000);
    const auto gone = gud.show(5);
    EXPECT_EQ(gone.error().fault, Fault::gone) << gone.error().rule;
    EXPECT_FALSE(gud.display->connected());
    await_no_device(GudGadget::name);
    gud.device.power_cycle();
    gud.plug();
    gud.expect_mended(); // without init(), the first present that finds the device sends everything
}

} // namespace
