// Tests frames of a GUD display that are under way while the next frames are drawn.
#include <condition_variable>
#include <mutex>

#include "tests/unit/hal_usb/gud_rig.hpp"

namespace {

using namespace gud_test;
using hal::Fault;
using hal::Pacing;
using Fate = sim::UsbfsDevice::Fate;

/// Stops the wire until the gate opens. After ten seconds the test has failed, and the wire goes on.
class Gate {
  public:
    explicit Gate(GudRig& rig, Fate fate = Fate::normal) {
        rig.usb.fate = [this, fate](std::size_t) {
            std::unique_lock lock(mutex_);
            late_ = late_ || !changed_.wait_for(lock, std::chrono::seconds(10), [this] { return open_; });
            changed_.notify_all();
            return fate;
        };
    }
    void open() {
        const std::lock_guard lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }
    bool late() {
        const std::lock_guard lock(mutex_);
        return late_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = false, late_ = false;
};

sim::Image picture_of(GudRig& rig) {
    const auto frame = rig.display->acquire().value();
    const hal::DisplayInfo info = rig.display->info();
    sim::Image image(info.width, info.height);
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x) {
            const std::uint8_t* const p = frame.pixels + y * frame.stride + 2 * x;
            const auto rgb =
                expected_pixel(rig.device, static_cast<unsigned>(p[0] | p[1] << 8), x, info.height - 1 - y);
            for (std::size_t c = 0; c < 3; ++c)
                image.at(x, y)[c] = static_cast<std::uint8_t>(rgb[c]);
        }
    return image;
}

bool same(const sim::Image& a, const sim::Image& b) {
    return a == b;
}

TEST(GudOverlap, TheNextFrameIsDrawnWhileOneIsOnTheWire) {
    GudRig rig;
    ASSERT_TRUE(rig.start().ok());
    Gate gate(rig);
    ASSERT_TRUE(rig.draw(1));
    const sim::Image first = picture_of(rig);
    ASSERT_TRUE(rig.display->present().ok()) << "does not wait for the wire";
    ASSERT_TRUE(rig.draw(2)); // draws while the frame before is on the wire
    gate.open();
    ASSERT_TRUE(rig.display->finish().ok());
    EXPECT_FALSE(gate.late());
    EXPECT_TRUE(same(rig.device.glass(), first)) << "nothing of the second frame was in the first";
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(GudOverlap, ALostFrameIsReportedByTheNextPresentWhichSendsNothing) {
    GudRig rig;
    rig.size(320, 240);
    ASSERT_TRUE(rig.start().ok());
    Gate gate(rig, Fate::stall);
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.display->present().ok());
    gate.open();
    ASSERT_TRUE(rig.draw(2, {5, 6, 7, 8}));
    const auto told = rig.display->present();
    EXPECT_EQ(told.error().fault, Fault::unsupported);
    rig.usb.fate = nullptr;
    EXPECT_TRUE(rig.display->present().ok());
    EXPECT_TRUE(rig.display->finish().ok());
    EXPECT_EQ(rig.glass_difference(), "") << "both frames are there";
}

TEST(GudOverlap, FinishTellsToo) {
    GudRig rig;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    rig.usb.fate = [](std::size_t) { return Fate::stall; };
    ASSERT_TRUE(rig.display->present().ok());
    EXPECT_EQ(rig.display->finish().error().fault, Fault::unsupported);
    EXPECT_TRUE(rig.display->finish().ok()) << "once";
    rig.usb.fate = nullptr;
    EXPECT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.glass_difference(), "");
}

/// Presents three frames; the second and third come while the first is on the wire.
struct Paced {
    GudRig rig;
    sim::Image second, third;
    bool late = false;
    Paced(Pacing pacing, std::int32_t interval) {
        rig.config.pacing = pacing;
        EXPECT_TRUE(rig.start().ok());
        rig.display->swap_interval(interval);
        Gate gate(rig);
        EXPECT_TRUE(rig.draw(1));
        EXPECT_TRUE(rig.display->present().ok());
        EXPECT_TRUE(rig.draw(2, {0, 0, 20, 30}));
        EXPECT_TRUE(rig.display->present().ok());
        second = picture_of(rig);
        EXPECT_TRUE(rig.draw(3, {30, 0, 10, 10}));
        EXPECT_TRUE(rig.display->present().ok());
        third = picture_of(rig);
        gate.open();
        settle();
        late = gate.late();
        rig.usb.fate = nullptr;
    }
    void settle() { EXPECT_TRUE(rig.display->finish().ok()); }
};

TEST(GudOverlap, Coalesces) {
    Paced paced(Pacing::coalesce, 1);
    EXPECT_FALSE(paced.late);
    EXPECT_TRUE(same(paced.rig.device.glass(), paced.third)) << "the last one was owed";
}

TEST(GudOverlap, Drops) {
    Paced paced(Pacing::drop, 1);
    EXPECT_FALSE(paced.late);
    EXPECT_FALSE(same(paced.rig.device.glass(), paced.third)) << "neither was sent";
    ASSERT_TRUE(paced.rig.show().ok());
    EXPECT_EQ(paced.rig.glass_difference(), "") << "the next one carries what they changed";
}

TEST(GudOverlap, IntervalNoughtDoesNotWaitWhateverThePacing) {
    Paced paced(Pacing::block, 0);
    EXPECT_FALSE(paced.late);
    EXPECT_TRUE(same(paced.rig.device.glass(), paced.third));
}

TEST(GudOverlap, HalfAFrameIsNotShown) {
    GudRig rig;
    rig.config.pacing = Pacing::coalesce;
    ASSERT_TRUE(rig.start().ok());
    Gate gate(rig);
    ASSERT_TRUE(rig.draw(1));
    const sim::Image first = picture_of(rig);
    ASSERT_TRUE(rig.display->present().ok());
    ASSERT_TRUE(rig.draw(2));
    ASSERT_TRUE(rig.display->present().ok()); // this frame is put off
    ASSERT_TRUE(rig.draw(3, {1, 1, 5, 5}));   // draws over the frame that was put off
    gate.open();
    ASSERT_TRUE(rig.display->finish().ok());
    EXPECT_TRUE(same(rig.device.glass(), first));
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST(GudOverlap, TheLastFrameArrivesBeforeTheDisplayGoesDark) {
    GudRig rig;
    ASSERT_TRUE(rig.start().ok());
    ASSERT_TRUE(rig.draw(1));
    const std::uint64_t before = rig.device.counters().bulk_bytes;
    ASSERT_TRUE(rig.display->present().ok());
    rig.display.reset();
    EXPECT_EQ(rig.device.counters().bulk_bytes - before, 40u * 30 * 2);
    EXPECT_FALSE(rig.device.enabled());
    EXPECT_EQ(rig.device.violations(), "");
}

TEST(GudOverlap, PulledWhileTheNextFrameIsDrawn) {
    GudRig rig;
    rig.size(320, 240);
    ASSERT_TRUE(rig.start().ok());
    Gate gate(rig, Fate::unplug);
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.display->present().ok());
    ASSERT_TRUE(rig.draw(2, {0, 0, 50, 50}));
    gate.open();
    EXPECT_EQ(rig.display->present().error().fault, Fault::gone);
    EXPECT_FALSE(rig.display->connected());
    EXPECT_EQ(rig.kernel.open_files(), 0);
    rig.usb.fate = nullptr;
    rig.device.power_cycle();
    rig.usb.plug();
    ASSERT_TRUE(rig.show().ok());
    EXPECT_EQ(rig.glass_difference(), "") << "the whole picture";
    EXPECT_TRUE(rig.display->connected());
}

TEST(GudOverlap, ADisplayOfOneBufferForEgl) {
    GudRig rig;
    ASSERT_TRUE(rig.start().ok());
    EXPECT_TRUE(rig.display->info().keeps_buffer);
    const std::uint8_t* const pixels = rig.display->acquire().value().pixels;
    ASSERT_TRUE(rig.draw(1));
    ASSERT_TRUE(rig.display->present().ok());
    EXPECT_EQ(rig.display->acquire().value().pixels, pixels);
    EXPECT_EQ(rig.display->acquire().value().age, 1);
}

} // namespace
