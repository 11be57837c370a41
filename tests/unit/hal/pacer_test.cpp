// Pacer by itself: it measures the refresh, waits for the beam, and puts frames off while the wire is busy.
#include <memory>

#include <gtest/gtest.h>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal/pacer.hpp>
#include <spangle/panels.hpp>

using namespace hal_test;

namespace {

constexpr const PanelDesc& panel = panels::st7789_135x240;

struct Rig {
    FakePanelBus bus;
    Op ops[64];
    OpParams params[64];
    PanelLayout layout;
    Transfer transfer;
    Pacer pacer;

    explicit Rig(PanelConfig config, BusCaps caps = spi())
        : bus(panel, caps), transfer(bus, layout), pacer(transfer) {
        config.panel = &panel;
        layout = PanelLayout(config);
        layout.resolve();
        transfer.open(caps, OpList(ops, params, 64));
    }
    /// Puts a list on the wire.
    void occupy() {
        ASSERT_TRUE(transfer.append(panel.commands->light).ok());
        ASSERT_TRUE(transfer.start().ok());
    }
};

TEST(PacerPart, MeasuresTheRefreshUnlessItIsFarOff) {
    const std::int32_t nominal =
        static_cast<std::int32_t>(std::int64_t{panel.timing.frame_us} * 1000 / panel.timing.scan_lines);
    for (const std::uint32_t percent : {100u, 103u, 80u, 140u, 0u}) {
        Rig rig({.wait_te = true});
        rig.bus.te_period_us = panel.timing.frame_us * percent / 100;
        ASSERT_TRUE(rig.pacer.measure().ok());
        EXPECT_EQ(rig.bus.te_waits, 9) << "eight periods";
        const bool plausible = percent >= 80 && percent <= 120;
        const auto measured =
            static_cast<std::int32_t>(std::int64_t{rig.bus.te_period_us} * 1000 / panel.timing.scan_lines);
        EXPECT_NEAR(rig.pacer.refresh().line, plausible ? measured : nominal, 1) << percent;
        EXPECT_EQ(rig.pacer.refresh().lines, panel.timing.scan_lines);
    }
    Rig missing({.wait_te = true});
    missing.bus.te_missing = true;
    EXPECT_TRUE(missing.pacer.measure().ok()) << "presents report what is wrong";
    EXPECT_EQ(missing.pacer.refresh().line, nominal);
    Rig plain({});
    ASSERT_TRUE(plain.pacer.measure().ok());
    EXPECT_EQ(plain.bus.submits, 0) << "who does not wait for the beam does not measure it";
}

TEST(PacerPart, LeadsLagsOrCountsAsUnsafe) {
    for (const bool te : {true, false}) {
        Rig rig({.wait_te = te, .poll_line = !te});
        rig.bus.te_period_us = panel.timing.frame_us;
        ASSERT_TRUE(rig.pacer.measure().ok());
        const std::int64_t refresh_ns = std::int64_t{panel.timing.frame_us} * 1000;
        rig.bus.te_waits = rig.bus.line_waits = 0;
        SafeStart quick(rig.pacer.refresh()), late(rig.pacer.refresh()), endless(rig.pacer.refresh());
        quick.write(0, 0, refresh_ns / 4), quick.write(239, refresh_ns / 4, refresh_ns / 2);
        late.write(0, 0, refresh_ns / 2), late.write(239, refresh_ns, 3 * refresh_ns / 2);
        endless.write(0, 0, refresh_ns), endless.write(239, 4 * refresh_ns, 5 * refresh_ns);
        ASSERT_TRUE(quick.possible());
        ASSERT_TRUE(late.possible());
        ASSERT_FALSE(endless.possible());
        for (const SafeStart* start : {&quick, &late, &endless})
            rig.pacer.append_sync(*start);
        const PresentCounters& counted = rig.pacer.counters();
        EXPECT_EQ(counted.led + counted.lagged, 2u);
        EXPECT_GE(counted.lagged, 1u);
        EXPECT_EQ(counted.unsafe, 1u);
        ASSERT_TRUE(rig.transfer.run().ok());
        EXPECT_EQ(rig.bus.te_waits, te ? 3 : 0);
        EXPECT_EQ(rig.bus.line_waits, te ? 0 : 2) << "an unsafe frame starts at once";
    }
}

TEST(PacerPart, PutsOffOnlyWhatNeedNotWait) {
    for (const Pacing pacing : {Pacing::block, Pacing::drop, Pacing::coalesce}) {
        Rig rig({.buffers = 2, .pacing = pacing});
        EXPECT_FALSE(rig.pacer.puts_off()) << "the wire is idle";
        rig.occupy();
        EXPECT_EQ(rig.pacer.puts_off(), pacing != Pacing::block);
        rig.pacer.waits(false);
        EXPECT_TRUE(rig.pacer.puts_off()) << "a swap interval of 0 never waits";
        EXPECT_EQ(rig.pacer.counters().put_off, pacing == Pacing::block ? 1u : 2u);
        rig.bus.run_pending();
        EXPECT_FALSE(rig.pacer.puts_off());
    }
}

} // namespace
