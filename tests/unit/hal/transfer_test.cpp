// Transfer by itself: lists that are full go out, pixels are cut as the bus asks, and what failed is
// forgotten.
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal/transfer.hpp>
#include <spangle/panels.hpp>

using namespace hal_test;

namespace {

constexpr const PanelDesc& panel = panels::st7789_135x240;

struct Rig {
    FakePanelBus bus;
    Op ops[8];
    OpParams params[8];
    PanelLayout layout{PanelConfig{.panel = &panel}};
    Transfer transfer{bus, layout};

    explicit Rig(BusCaps caps = spi()) : bus(panel, caps) {
        layout.resolve();
        transfer.open(caps, OpList(ops, params, 8));
    }
    /// Opens a window and sends `pixels` of it.
    Result<void> send(const Rect& window, const std::vector<std::uint8_t>& pixels) {
        if (const auto r = transfer.open_window(window); !r)
            return r;
        const auto bytes = static_cast<std::uint32_t>(pixels.size());
        if (const auto r = transfer.append_pixels(pixels.data(), bytes, 1, bytes); !r)
            return r;
        return transfer.run();
    }
};

TEST(TransferPart, AWindowGoesOutOnceAndAgainAfterAFault) {
    Rig rig;
    const std::vector<std::uint8_t> pixels(8, 0x5A);
    const Rect window{1, 2, 2, 2};
    ASSERT_TRUE(rig.send(window, pixels).ok());
    EXPECT_EQ(rig.bus.log, "2A 00 35 00 36 2B 00 2a 00 2b 2C ") << "the glass begins at column 52, row 40";
    rig.bus.log.clear();
    ASSERT_TRUE(rig.send(window, pixels).ok());
    EXPECT_EQ(rig.bus.log, "2C ") << "the controller holds the window";
    rig.bus.fail_after_bytes = 3;
    EXPECT_EQ(rig.send(window, pixels).error().fault, Fault::short_write);
    EXPECT_FALSE(rig.transfer.in_flight());
    rig.bus.log.clear();
    ASSERT_TRUE(rig.send(window, pixels).ok());
    EXPECT_EQ(rig.bus.log, "2A 00 35 00 36 2B 00 2a 00 2b 2C ") << "nobody knows what arrived";
    rig.bus.refuse_submits = 1;
    EXPECT_EQ(rig.send(window, pixels).error().fault, Fault::busy);
    rig.transfer.forget_window();
    EXPECT_TRUE(rig.send(window, pixels).ok());
}

TEST(TransferPart, AListThatIsFullGoesOut) {
    Rig rig;
    const std::vector<std::uint8_t> pixels(2 * 30, 0x11);
    for (int row = 0; row < 5; ++row) {
        ASSERT_TRUE(rig.transfer.open_window({0, row, 30, 1}).ok());
        ASSERT_TRUE(rig.transfer.append_pixels(pixels.data(), 60, 1, 60).ok());
    }
    EXPECT_EQ(rig.bus.submits, 2) << "three operations a row, and then RASET by itself";
    ASSERT_TRUE(rig.transfer.run().ok());
    EXPECT_EQ(rig.bus.pixel_bytes, 5 * 60);
    EXPECT_EQ(rig.transfer.list().size(), 0u);
}

TEST(TransferPart, PixelsAreCutIntoWholePixelsAndCounted) {
    const std::vector<std::uint8_t> pixels(40 * 10, 0x22);
    for (const std::uint32_t most : {0u, 7u, 40u, 81u}) {
        BusCaps caps = spi();
        caps.max_transfer = most;
        Rig rig(caps);
        for (const std::uint32_t bytes : {20u, 40u}) {
            rig.bus.pixel_bytes = rig.bus.longest_op = 0;
            ASSERT_TRUE(rig.transfer.open_window({0, 0, static_cast<std::int32_t>(bytes / 2), 10}).ok());
            ASSERT_TRUE(rig.transfer.run().ok());
            for (std::uint32_t row = 0; row < 10; row += 2) { // two rows of pixels fit a list of eight
                const std::size_t before = rig.transfer.list().size();
                ASSERT_TRUE(rig.transfer.append_pixels(pixels.data() + row * 40, bytes, 2, 40).ok());
                const std::size_t ops = rig.transfer.list().size() - before;
                if (most == 0 || most >= 40) {
                    EXPECT_EQ(ops, rig.transfer.pixel_ops(bytes, 2)) << most;
                }
                ASSERT_TRUE(rig.transfer.run().ok());
            }
            EXPECT_EQ(rig.bus.pixel_bytes, static_cast<long>(10 * bytes));
            EXPECT_EQ(rig.bus.cut_pixels, 0) << most;
            if (most != 0) {
                EXPECT_LE(rig.bus.longest_op, most);
            }
        }
    }
    BusCaps caps = spi();
    caps.max_transfer = 7;
    EXPECT_EQ(Rig(caps).transfer.pixel_ops(20, 3), 4u * 3) << "pieces of six bytes";
}

TEST(TransferPart, AListThatIsLateStaysInFlight) {
    Rig rig;
    ASSERT_TRUE(rig.transfer.append(panel.commands->light).ok());
    ASSERT_TRUE(rig.transfer.start().ok());
    EXPECT_TRUE(rig.transfer.in_flight());
    EXPECT_TRUE(rig.transfer.busy());
    rig.bus.late_waits = 1;
    EXPECT_EQ(rig.transfer.complete().error().fault, Fault::timeout);
    EXPECT_TRUE(rig.transfer.in_flight());
    EXPECT_TRUE(rig.transfer.late());
    rig.bus.run_pending();
    EXPECT_FALSE(rig.transfer.busy());
    ASSERT_TRUE(rig.transfer.complete().ok());
    EXPECT_FALSE(rig.transfer.in_flight());
    EXPECT_FALSE(rig.transfer.late());
    EXPECT_TRUE(rig.bus.on);
}

TEST(TransferPart, ACommandThatNoOperationCarriesIsAnError) {
    BusCaps caps = spi();
    caps.max_transfer = 6;
    Rig rig(caps);
    EXPECT_EQ(rig.transfer.append(panel.setup).error().fault, Fault::unsupported);
    ASSERT_TRUE(rig.transfer.append_black({0, 0, 4, 2}, 16).ok());
    ASSERT_TRUE(rig.transfer.run().ok());
    EXPECT_EQ(rig.bus.repeats, 8) << "pixels of two bytes, three an operation";
}

} // namespace
