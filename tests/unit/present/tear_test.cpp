// Looks for tears in every refresh that the controller scans out. Tests the whole table of refresh rates and
// clocks, by TE and by polling 45h; without the mechanism there must be tears.
#include <memory>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/bus/sim_bus.hpp"

namespace {

using namespace spangle;
using sim::Time;

enum class Sync { none, te, poll };

struct Setup {
    unsigned line_ns = 43902; ///< time of a line in ns, for 70.3 Hz
    std::uint32_t write_hz = 40000000;
    Sync sync = Sync::te;
    hal::Orientation orientation = {};
    bool turned = false;
    std::uint8_t buffers = 1;
    Rect area = {0, 0, 0, 0}; ///< what each frame draws; empty: everything
    hal::BusKind bus = hal::BusKind::spi4;
    int off_percent = 0; ///< by how much the panel's oscillator is off the datasheet's time of a line
};

struct Seen {
    int refreshes = 0, torn = 0;
    hal::PresentCounters presents;
    std::string violations;
};

/// A board whose panel refreshes at another rate.
struct Rig {
    hal::PanelDesc panel = hal::panels::ili9341_240x320;
    hal::Board board;
    std::unique_ptr<sim::DcsController> controller;
    std::unique_ptr<sim::SimBus> bus;
    hal::PanelStorage<hal::PanelSizes{.height = 320, .buffers = 2, .ops = 512, .turned = true}> storage;
    struct Display final : hal::PanelDisplay {
        using hal::PanelDisplay::PanelDisplay;
    };
    std::unique_ptr<Display> display;

    explicit Rig(const Setup& s) {
        sim::Chip chip = sim::chip_of(panel);
        chip.line_ns = s.line_ns * static_cast<unsigned>(100 + s.off_percent) / 100;
        panel.timing.frame_us = s.line_ns * 324u / 1000u;
        board.display.panel = &panel;
        board.display.orientation = s.orientation;
        board.display.buffers = s.buffers;
        board.display.wait_te = s.sync == Sync::te;
        board.display.poll_line = s.sync == Sync::poll;
        board.display.scan_order = s.turned;
        board.has_te = true;
        board.bus = s.bus;
        board.write_hz = s.write_hz;
        board.read_hz = s.bus == hal::BusKind::spi4 ? 6000000 : 2000000;
        controller =
            std::make_unique<sim::DcsController>(chip, sim::mount_of(panel), s.bus == hal::BusKind::i8080);
        bus = std::make_unique<sim::SimBus>(*controller, hal::bus_caps(board));
        display = std::make_unique<Display>(*bus, board.display, storage.memory());
    }
};

/// Presents frames of one colour each at any phase of the refresh, and counts the refreshes that show two.
Seen play(const Setup& s, int frames = 10, bool until_a_tear = false) {
    Rig rig(s);
    EXPECT_TRUE(rig.display->init().ok());
    const hal::DisplayInfo info = rig.display->info();
    const Rect area = s.area.w == 0 ? Rect{0, 0, info.width, info.height} : s.area;
    std::mt19937 random(s.line_ns + s.write_hz);
    Seen seen;
    // Collects cells of the area in the controller's memory, a few of each row.
    std::vector<std::size_t> cells;
    const hal::Placement placed = hal::place(rig.panel, s.orientation);
    for (int y = area.y; y < area.y + area.h; ++y)
        for (int x = area.x; x < area.x + area.w; ++x) {
            if (y % 16 != 0 && x % 16 != 0)
                continue;
            int column = x, row = y;
            if ((placed.madctl & hal::dcs::MV) != 0)
                std::swap(column, row);
            if ((placed.madctl & hal::dcs::MX) != 0)
                column = 239 - column;
            if ((placed.madctl & hal::dcs::MY) != 0)
                row = 319 - row;
            cells.push_back(static_cast<std::size_t>(row * 240 + column));
        }
    bool watching = false;
    rig.controller->watch_refreshes = [&](const std::vector<sim::Rgb666>& shown) {
        if (!watching)
            return;
        ++seen.refreshes;
        for (const std::size_t cell : cells)
            if (!(shown[cell] == shown[cells[0]])) {
                ++seen.torn;
                return;
            }
    };
    for (int frame = 0; frame < frames && !(until_a_tear && seen.torn != 0); ++frame) {
        const auto acquired = rig.display->acquire();
        EXPECT_TRUE(acquired.ok());
        const hal::Frame f = acquired.value();
        for (int y = area.y; y < area.y + area.h; ++y) {
            for (int x = area.x; x < area.x + area.w; ++x) {
                f.pixels[y * f.stride + 2 * x] = static_cast<std::uint8_t>(37 * (frame + 1));
                f.pixels[y * f.stride + 2 * x + 1] = static_cast<std::uint8_t>(91 * (frame + 1));
            }
            f.extents->rows[y] = {static_cast<std::int16_t>(area.x),
                                  static_cast<std::int16_t>(area.x + area.w)};
        }
        EXPECT_TRUE(rig.display->present().ok());
        EXPECT_TRUE(rig.display->finish().ok());
        rig.bus->pass(3 * rig.controller->refresh_time() + random() % rig.controller->refresh_time());
        rig.controller->te(rig.bus->now()); // scans up to now
        watching = frame >= 1;              // before the first two frames all buffers are known
    }
    seen.presents = rig.display->counters();
    seen.violations = rig.controller->violations_text();
    return seen;
}

/// 615 kHz / (RTNA x 324 lines) for RTNA = 10h, 13h, 18h, 1Bh, 1Fh: 118.6 to 61.2 Hz.
constexpr unsigned lines_ns[] = {26016, 30894, 39024, 43902, 50406};
struct Wire {
    std::uint32_t hz;
    hal::BusKind bus = hal::BusKind::spi4;
};
constexpr Wire wires[] = {
    {15000000}, {20000000}, {27000000}, {40000000}, {62500000}, {80000000}, {15000000, hal::BusKind::i8080}};

struct Regime {
    double write_ms, refresh_ms;

    Regime(unsigned line_ns, const Wire& wire)
        : write_ms(240 * 320 * (wire.bus == hal::BusKind::spi4 ? 16e3 : 2e3) / wire.hz),
          refresh_ms(line_ns * 324e-6) {}
    double ratio() const { return write_ms / refresh_ms; }
    bool lead() const { return ratio() < 0.98; }
    bool possible() const { return ratio() < 1.97; }
    bool on_a_border() const {
        return (ratio() > 0.97 && ratio() < 1.0) || (ratio() > 1.94 && ratio() < 2.0);
    }
    /// The nearer the wire is to the speed of the beam, the fewer phases of the transfer cross the beam.
    int frames_to_see_a_tear() const { return ratio() > 0.85 && ratio() < 1.15 ? 150 : 40; }
};

TEST(Tears, NoneInTheWholeTableWhereNoneNeedsToBe) {
    int led = 0, lagged = 0, impossible = 0;
    for (const unsigned line_ns : lines_ns)
        for (const Wire& wire : wires) {
            const Regime r(line_ns, wire);
            if (r.on_a_border())
                continue;
            SCOPED_TRACE(std::to_string(r.write_ms) + " ms of pixels in refreshes of " +
                         std::to_string(r.refresh_ms) + " ms");
            for (const Sync sync : {Sync::te, Sync::poll}) {
                const Seen seen =
                    play({.line_ns = line_ns, .write_hz = wire.hz, .sync = sync, .bus = wire.bus});
                EXPECT_GE(seen.refreshes, 15);
                if (r.possible()) {
                    EXPECT_EQ(seen.torn, 0) << (sync == Sync::te ? "TE" : "45h");
                    EXPECT_EQ(seen.violations, "");
                    EXPECT_EQ(r.lead() ? seen.presents.led : seen.presents.lagged, 10u);
                } else {
                    EXPECT_GT(seen.torn, 0) << "two refreshes are too short for it";
                    EXPECT_EQ(seen.presents.unsafe, 10u);
                }
            }
            const Seen free =
                play({.line_ns = line_ns, .write_hz = wire.hz, .sync = Sync::none, .bus = wire.bus},
                     r.frames_to_see_a_tear(), true);
            EXPECT_GT(free.torn, 0) << "without the mechanism the test must see tears";
            ++(r.lead() ? led : r.possible() ? lagged : impossible);
        }
    EXPECT_GE(led, 4);
    EXPECT_GE(lagged, 8);
    EXPECT_GE(impossible, 10);
}

/// Panels of one kind differ: this panel does not have the datasheet's refresh rate.
TEST(Tears, NoneWhereTheOscillatorIsOff) {
    for (const int off : {-12, -5, 5, 12})
        for (const unsigned line_ns : lines_ns)
            for (const Wire& wire : wires) {
                const Regime r(line_ns * static_cast<unsigned>(100 + off) / 100, wire);
                if (r.on_a_border() || !r.possible())
                    continue;
                SCOPED_TRACE(std::to_string(off) + " %: " + std::to_string(r.write_ms) +
                             " ms of pixels in refreshes of " + std::to_string(r.refresh_ms) + " ms");
                for (const Sync sync : {Sync::te, Sync::poll}) {
                    const Seen seen = play({.line_ns = line_ns,
                                            .write_hz = wire.hz,
                                            .sync = sync,
                                            .bus = wire.bus,
                                            .off_percent = off});
                    EXPECT_EQ(seen.torn, 0) << (sync == Sync::te ? "TE" : "45h");
                    EXPECT_EQ(r.lead() ? seen.presents.led : seen.presents.lagged, 10u);
                }
            }
}

TEST(Tears, LandscapeIsFreeOfThemOnlyInTheOrderOfTheScan) {
    for (const hal::Orientation o : hal::orientations)
        for (const Sync sync : {Sync::te, Sync::poll}) {
            const bool against = hal::scan_order(hal::panels::ili9341_240x320, o).turns();
            const Seen plain = play({.write_hz = 62500000, .sync = sync, .orientation = o, .buffers = 2});
            if (against) {
                EXPECT_GT(plain.torn, 0) << "columns or rows against the scan";
                EXPECT_EQ(plain.presents.unsafe, 10u);
            } else {
                EXPECT_EQ(plain.torn, 0);
            }
            const Seen turned =
                play({.write_hz = 62500000, .sync = sync, .orientation = o, .turned = true, .buffers = 2});
            EXPECT_EQ(turned.torn, 0);
            EXPECT_EQ(turned.presents.lagged, 10u);
            EXPECT_EQ(turned.violations, "");
        }
}

/// Short damage is sent ahead of the beam, or is safe even against the scan.
TEST(Tears, TheBytesOfTheFrameDecide) {
    const Rect third = {20, 100, 200, 100};
    const Seen small = play({.write_hz = 40000000, .area = third});
    EXPECT_EQ(small.torn, 0);
    EXPECT_EQ(small.presents.unsafe, 1u) << "the first frame, which is the whole memory";
    EXPECT_EQ(small.presents.led, 9u) << "8 ms";
    const Seen slow = play({.write_hz = 25000000, .area = third});
    EXPECT_EQ(slow.torn, 0);
    EXPECT_EQ(slow.presents.lagged, 9u)
        << "12.8 ms: less than a refresh, but the beam needs 4.4 for these rows";
    const Seen slower = play({.write_hz = 15000000, .area = third});
    EXPECT_GT(slower.torn, 0) << "21.3 ms: more than a refresh and these rows";
    EXPECT_EQ(slower.presents.unsafe, 10u);
    const Seen corner =
        play({.write_hz = 40000000, .orientation = {hal::Rotation::r90}, .area = {200, 10, 60, 100}});
    EXPECT_EQ(corner.torn, 0) << "2.4 ms in 60 rows that are written side by side";
    EXPECT_EQ(corner.presents.unsafe, 1u);
}

} // namespace
