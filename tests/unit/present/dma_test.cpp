// Tests the bus of microcontrollers with a port that runs by events in virtual time. Scenes are drawn while
// the last frame is sent, and show what the simulated board shows. Faults are reported, and no memory is
// changed too early.
#include <functional>
#include <memory>

#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <spangle/hal/dma_bus.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/board/module.hpp"
#include "tests/support/scene_player.hpp"

namespace {

using namespace spangle;
using sim::Time;

/// An SPI block whose interrupts come at their time.
class EventPort final : public hal::DmaPort {
  public:
    EventPort(sim::Controller& controller, const hal::BusCaps& caps) : controller_(controller), caps_(caps) {}

    hal::DmaBus* bus = nullptr;
    Time now = 0, busy = 0;
    hal::Fault fail_write = hal::Fault::none; ///< the fault of the next write
    bool te_missing = false, dead = false;    ///< te_missing: no edge of TE comes; dead: no interrupt comes
    int writes = 0;

    /// Lets time pass while the program draws, with interrupts in between.
    void pass(Time ns) {
        const Time until = now + ns;
        while (pending_ && !dead && due_ <= until)
            fire();
        now = std::max(now, until);
    }

    void write(bool data, const std::uint8_t* bytes, std::uint32_t count) override {
        ++writes;
        const Time byte = Time(8'000'000'000) / caps_.write_hz;
        busy += byte * count;
        const hal::Fault fault = std::exchange(fail_write, hal::Fault::none);
        later(byte * count, [=, this] {
            for (std::uint32_t i = 0; i < count; ++i) // DMA may read the memory as late as now
                controller_.write(bytes[i], data, now, static_cast<unsigned>(byte / 8));
            bus->step(fault);
        });
    }
    void read(std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count) override {
        const unsigned bit = 1'000'000'000u / caps_.read_hz;
        later(Time(bit) * (dummy_bits + 8 * count), [=, this] {
            for (int i = 0; i < dummy_bits; ++i)
                controller_.read_bit(now, bit);
            for (std::uint32_t i = 0; i < count; ++i)
                into[i] = controller_.read_byte(now, bit);
            bus->step();
        });
    }
    void pause(std::uint32_t micros) override {
        later(Time(micros) * 1000, [this] { bus->step(); });
    }
    void wait_te(std::uint32_t at_most_micros) override {
        Time at = now;
        const Time end = now + Time(at_most_micros) * 1000;
        while (at < end && controller_.te(at))
            at += 1000;
        while (at < end && (te_missing || !controller_.te(at)))
            at += te_missing ? 1000000 : 1000;
        later(at - now, [=, this] { bus->step(at < end ? hal::Fault::none : hal::Fault::timeout); });
    }
    void select(bool selected) override { controller_.select(selected, now); }
    void reset(bool low) override { controller_.reset(low, now); }
    std::uint32_t micros() override { return static_cast<std::uint32_t>(now / 1000); }
    void sleep() override {
        if (pending_ && !dead)
            fire();
        else
            now += 1'000'000;
    }

  private:
    sim::Controller& controller_;
    hal::BusCaps caps_;
    std::function<void()> what_;
    Time due_ = 0;
    bool pending_ = false;

    void later(Time delay, std::function<void()> what) {
        EXPECT_FALSE(pending_) << "two things at once";
        pending_ = true;
        due_ = now + delay;
        what_ = std::move(what);
    }
    void fire() {
        pending_ = false;
        now = std::max(now, due_);
        std::exchange(what_, nullptr)();
    }
};

struct Firmware {
    hal::Board board;
    std::unique_ptr<sim::Controller> controller;
    EventPort port;
    std::vector<std::uint8_t> memory;
    hal::Op ops[512];
    hal::DmaBus bus;
    hal::PanelStorage<hal::PanelSizes{.height = 320, .buffers = 2, .ops = 512, .turned = true, .held = true}>
        storage;
    struct Display final : hal::PanelDisplay {
        using hal::PanelDisplay::PanelDisplay;
    } display;

    explicit Firmware(const hal::Board& b)
        : board(b), controller(sim::make_controller(*b.display.panel, b.bus)),
          port(*controller, hal::bus_caps(b)), memory(2 * 320 * 240 * 2 + 64),
          bus(port, hal::bus_caps(b), {memory.data(), memory.size(), ops, 512}),
          display(bus, board.display, storage.memory()) {
        port.bus = &bus;
    }
    sim::Image glass() {
        port.now += 2 * controller->refresh_time();
        const hal::Extent size = board.display.panel->glass;
        return sim::upright(sim::picture_of(controller->glass(port.now), size.width, size.height),
                            board.display.orientation);
    }
};

hal::Board board_of(bool tear_free) {
    hal::Board board = boards::ili9341_spi;
    board.display.buffers = 2;
    board.has_te = true;
    board.display.wait_te = tear_free;
    board.display.scan_order = tear_free;
    return board;
}

TEST(DmaBus, ScenesAreDrawnWhileTheLastFrameIsMoved) {
    for (const bool tear_free : {false, true})
        for (const char* const id : {"S6", "HUD"}) {
            SCOPED_TRACE(id);
            const hal::Board board = board_of(tear_free);
            sim::SimBoard sim(board);
            ASSERT_TRUE(test::play(sim.display(), *scenes::find(id), 6));
            Firmware firmware(board);
            Time from = 0, busy = 0;
            ASSERT_TRUE(test::play(firmware.display, *scenes::find(id), 6, [&] {
                if (from == 0)
                    from = firmware.port.now, busy = firmware.port.busy;
                firmware.port.pass(20'000'000);
            }));
            const Time took = firmware.port.now - from, wire = firmware.port.busy - busy;
            ASSERT_TRUE(firmware.display.finish().ok());
            if (!tear_free) {
                EXPECT_LT(took, std::max<Time>(wire, 6 * 20'000'000) + 40'000'000);
            }
            EXPECT_EQ(sim::hash(firmware.glass()), sim::hash(sim.glass()));
            for (const sim::Violation& v : firmware.controller->violations())
                // Only the first frame, which is sent whole, may tear.
                EXPECT_TRUE(tear_free && v.rule == sim::Rule::tear) << v.text;
        }
}

/// These controllers take everything but pixels with D/C low, and pixels go out in another format than GL's.
TEST(DmaBus, DrivesPanelsOfEveryKindOfCommand) {
    for (const hal::Board* board : {&boards::ssd1306_spi, &boards::ssd1327_spi, &boards::ssd1351_spi,
                                    &boards::ssd1331_spi, &boards::st7735_128x160}) {
        SCOPED_TRACE(board->name);
        hal::Board two = *board;
        two.display.buffers = two.display.wire.converts() ? 1 : 2;
        sim::SimBoard sim(two);
        ASSERT_TRUE(test::play(sim.display(), *scenes::find("HUD"), 3));
        Firmware firmware(two);
        ASSERT_TRUE(
            test::play(firmware.display, *scenes::find("HUD"), 3, [&] { firmware.port.pass(20'000'000); }));
        ASSERT_TRUE(firmware.display.finish().ok());
        EXPECT_EQ(sim::hash(firmware.glass()), sim::hash(sim.glass()));
        EXPECT_TRUE(firmware.controller->violations().empty())
            << firmware.controller->violations().front().text;
    }
}

/// Logs what the port was told to send, and ends each transfer at once.
struct LoggingPort final : hal::DmaPort {
    struct Piece {
        bool data;
        std::vector<std::uint8_t> bytes;
        bool operator==(const Piece&) const = default;
    };
    hal::DmaBus* bus = nullptr;
    std::vector<Piece> pieces;
    void write(bool data, const std::uint8_t* bytes, std::uint32_t count) override {
        pieces.push_back({data, {bytes, bytes + count}});
    }
    void read(std::uint8_t, std::uint8_t*, std::uint32_t) override {}
    void pause(std::uint32_t) override {}
    void wait_te(std::uint32_t) override {}
    void select(bool) override {}
    void reset(bool) override {}
    std::uint32_t micros() override { return 0; }
};

std::vector<LoggingPort::Piece> moved(const hal::Op& op) {
    LoggingPort port;
    hal::Op ops[1];
    hal::DmaBus bus(port, {}, {nullptr, 0, ops, 1});
    const auto token = bus.submit(&op, 1);
    EXPECT_TRUE(token.ok());
    for (int interrupts = 0; !bus.done(token.value()) && interrupts < 1000; ++interrupts)
        bus.step();
    EXPECT_TRUE(bus.done(token.value()));
    return port.pieces;
}

TEST(DmaBus, RowsAndPatternsArriveWhole) {
    std::uint8_t bytes[40];
    for (int i = 0; i < 40; ++i)
        bytes[i] = static_cast<std::uint8_t>(i + 1);
    hal::Op op;
    op.kind = hal::Op::Kind::pixels;
    op.data = bytes;
    op.length = 6;
    op.rows = 5;
    for (const std::int32_t stride : {6, 8, -6}) {
        SCOPED_TRACE(stride);
        op.stride = stride;
        op.data = stride < 0 ? bytes + 30 : bytes;
        const auto pieces = moved(op);
        EXPECT_EQ(pieces.size(), stride == 6 ? 1u : 5u) << "rows that touch are one piece";
        std::vector<std::uint8_t> all, wanted;
        for (const auto& piece : pieces) {
            EXPECT_TRUE(piece.data);
            all.insert(all.end(), piece.bytes.begin(), piece.bytes.end());
        }
        for (int row = 0; row < 5; ++row)
            wanted.insert(wanted.end(), op.data + row * stride, op.data + row * stride + 6);
        EXPECT_EQ(all, wanted);
    }
    op.kind = hal::Op::Kind::repeat;
    op.data = bytes;
    for (const std::uint32_t length : {1u, 2u, 3u, 4u})
        for (const std::uint32_t rows : {1u, 12u, 16u, 17u, 24u, 25u, 48u, 49u, 101u}) {
            op.length = length;
            op.rows = rows;
            std::vector<std::uint8_t> all;
            for (const auto& piece : moved(op))
                all.insert(all.end(), piece.bytes.begin(), piece.bytes.end());
            ASSERT_EQ(all.size(), std::size_t{length} * rows);
            for (std::size_t i = 0; i < all.size(); ++i)
                ASSERT_EQ(all[i], bytes[i % length]) << length << ", " << rows << " at " << i;
        }
    op.kind = hal::Op::Kind::command;
    op.command = 0xAA;
    op.length = 2;
    using Pieces = std::vector<LoggingPort::Piece>;
    EXPECT_EQ(moved(op), (Pieces{{false, {0xAA}}, {true, {1, 2}}}));
    op.parameters_are_commands = true;
    EXPECT_EQ(moved(op), (Pieces{{false, {0xAA}}, {false, {1, 2}}}));
}

TEST(DmaBus, ReadsPollsAndWaits) {
    hal::Board board = board_of(false);
    board.display.poll_line = true;
    Firmware firmware(board);
    ASSERT_TRUE(firmware.display.init().ok());
    const auto line = firmware.display.scanline();
    ASSERT_TRUE(line.ok());
    EXPECT_LT(line.value(), 324);
    std::uint32_t moments[3] = {};
    hal::Op waits[3];
    for (int i = 0; i < 3; ++i) {
        waits[i].kind = hal::Op::Kind::wait_te;
        waits[i].micros = 100000;
        waits[i].into = reinterpret_cast<std::uint8_t*>(&moments[i]);
    }
    Firmware with_te(board_of(true));
    ASSERT_TRUE(with_te.display.init().ok());
    const auto edges = with_te.bus.submit(waits, 3);
    ASSERT_TRUE(edges.ok());
    ASSERT_TRUE(with_te.bus.wait(edges.value(), 1000000).ok());
    const auto period = static_cast<std::uint32_t>(with_te.controller->refresh_time() / 1000);
    EXPECT_NEAR(moments[2], with_te.port.micros(), 1);
    EXPECT_NEAR(moments[2] - moments[1], period, 2);
    hal::Op never;
    never.kind = hal::Op::Kind::wait_line;
    never.command = 0x45;
    never.dummy_bits = 1;
    never.length = 5000;
    never.stride = 9000;
    never.micros = 3000;
    const auto token = firmware.bus.submit(&never, 1);
    ASSERT_TRUE(token.ok());
    EXPECT_FALSE(firmware.bus.done(token.value()));
    EXPECT_EQ(firmware.bus.submit(&never, 1).error().fault, hal::Fault::busy);
    EXPECT_EQ(firmware.bus.wait(token.value(), 1000000).error().fault, hal::Fault::timeout);
    EXPECT_TRUE(firmware.bus.done(token.value()));
}

TEST(DmaBus, FaultsAreTold) {
    Firmware firmware(board_of(true));
    ASSERT_TRUE(firmware.display.init().ok());
    const auto present = [&] {
        const auto frame = firmware.display.acquire();
        EXPECT_TRUE(frame.ok());
        frame.value().extents->rows[3] = {0, 9};
        frame.value().pixels[3 * frame.value().stride] ^= 0xFF;
        const auto sent = firmware.display.present();
        return sent.ok() ? firmware.display.finish() : sent;
    };
    ASSERT_TRUE(present().ok());
    firmware.port.fail_write = hal::Fault::short_write;
    EXPECT_EQ(present().error().fault, hal::Fault::short_write);
    firmware.port.te_missing = true;
    EXPECT_EQ(present().error().fault, hal::Fault::timeout);
    firmware.port.te_missing = false;
    EXPECT_TRUE(present().ok());
    firmware.port.dead = true; // the interrupt never comes
    const auto stuck = present();
    EXPECT_EQ(stuck.error().fault, hal::Fault::timeout);
    EXPECT_EQ(firmware.bus.submit(nullptr, 0).error().fault, hal::Fault::busy);
    firmware.port.dead = false;
    EXPECT_TRUE(present().ok());

    std::uint8_t bytes[64];
    EventPort port(*firmware.controller, {});
    hal::Op op;
    hal::DmaBus small(port, {}, {bytes, sizeof bytes, &op, 1});
    const auto buffer = small.acquire(8);
    ASSERT_TRUE(buffer.ok());
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.value().bytes) % hal::DmaBus::alignment, 0u);
    EXPECT_FALSE(small.acquire(64).ok());
    const hal::Op two[2] = {};
    EXPECT_EQ(small.submit(two, 2).error().fault, hal::Fault::bad_argument);
    op.kind = hal::Op::Kind::wait_te;
    const hal::Op te = op;
    EXPECT_EQ(small.submit(&te, 1).error().fault, hal::Fault::unsupported);
    EXPECT_EQ(small.wait({7}, 1).error().fault, hal::Fault::bad_argument);
}

} // namespace
