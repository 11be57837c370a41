// Presenter by itself: the panel's memory equals the buffer where the damage was, and is untouched elsewhere.
#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal/presenter.hpp>
#include <spangle/panels.hpp>

using namespace hal_test;

namespace {

constexpr const PanelDesc& panel = panels::st7789_135x240;
constexpr std::int32_t width = 135, height = 240;

struct Rig {
    FakePanelBus bus;
    std::vector<Op> ops;
    std::vector<OpParams> params;
    std::uint16_t plan[height];
    PanelLayout layout;
    PanelMemory memory;
    Transfer transfer;
    Pacer pacer;
    Presenter::Parts parts;
    Presenter presenter;
    BusBuffer buffer;
    std::vector<std::uint8_t> pixels;
    std::vector<RowSpan> damage = std::vector<RowSpan>(height);

    explicit Rig(PanelConfig config = {}, std::size_t list = 64)
        : bus(panel, spi()), ops(list), params(list), transfer(bus, layout), pacer(transfer),
          parts(Presenter::parts(tear_free(config), one_list(config))), presenter(memory, transfer, pacer) {
        config.panel = &panel;
        layout = PanelLayout(config);
        layout.resolve();
        transfer.open(spi(), OpList(ops.data(), params.data(), list));
        memory.plan = plan;
        EXPECT_TRUE(presenter.acquire_wire().ok());
        pixels.resize(std::size_t{layout.stride()} * height);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            pixels[i] = static_cast<std::uint8_t>(1 + i * 7 % 250);
        buffer = BusBuffer({pixels.data(), pixels.size()});
        std::fill(bus.model.memory.begin(), bus.model.memory.end(), 0u);
    }
    Result<void> send(std::int32_t first = 0, std::int32_t rows = height) {
        return presenter.send({&buffer, first, rows}, damage.data(), RowHash(), parts);
    }
    void settle() { ASSERT_TRUE(transfer.complete().ok()); }
    /// The pixel of the panel's memory behind column x and row y of the glass.
    std::uint32_t shown(std::int32_t x, std::int32_t y) const {
        return bus.model.memory[static_cast<std::size_t>((y + 40) * panel.memory.width + x + 52)];
    }
    /// The pixel of the buffer.
    std::uint32_t drawn(std::int32_t x, std::int32_t y) const {
        const std::uint8_t* const p = pixels.data() + (static_cast<std::ptrdiff_t>(y) * width + x) * 2;
        return static_cast<std::uint32_t>(p[0] << 8 | p[1]);
    }
};

TEST(PresenterPart, SendsTheDamageAndNothingElse) {
    const auto rig = std::make_unique<Rig>();
    rig->damage[3] = {10, 20}, rig->damage[4] = {10, 20}, rig->damage[200] = {0, width};
    ASSERT_TRUE(rig->send().ok());
    EXPECT_TRUE(rig->transfer.in_flight()) << "it returns while the list is on the wire";
    EXPECT_EQ(rig->buffer.to_draw(rig->bus), nullptr) << "which reads the buffer";
    rig->settle();
    EXPECT_NE(rig->buffer.to_draw(rig->bus), nullptr);
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const RowSpan row = rig->damage[static_cast<std::size_t>(y)];
            ASSERT_EQ(rig->shown(x, y), x >= row.begin && x < row.end ? rig->drawn(x, y) : 0u)
                << x << ',' << y;
        }
    EXPECT_EQ(rig->bus.pixel_bytes, 2 * (10 + 10 + width));
    EXPECT_EQ(rig->pacer.counters().sent, 1u);
    for (RowSpan& row : rig->damage)
        row = {};
    const int submits = rig->bus.submits;
    ASSERT_TRUE(rig->send().ok());
    EXPECT_EQ(rig->bus.submits, submits) << "nothing changed";
    EXPECT_EQ(rig->pacer.counters().sent, 1u);
}

TEST(PresenterPart, PutsABandWhereItBelongs) {
    const auto rig = std::make_unique<Rig>(PanelConfig{.band = 48});
    rig->damage[2] = {1, 4};
    ASSERT_TRUE(rig->send(96, 48).ok());
    rig->settle();
    EXPECT_EQ(rig->shown(1, 98), rig->drawn(1, 2));
    EXPECT_EQ(rig->shown(1, 2), 0u);
    ASSERT_TRUE(rig->presenter.send_all({&rig->buffer, 144, 48}).ok());
    rig->settle();
    EXPECT_EQ(rig->shown(0, 144), rig->drawn(0, 0));
    EXPECT_EQ(rig->shown(width - 1, 191), rig->drawn(width - 1, 47));
    EXPECT_EQ(rig->shown(0, 143), 0u);
}

TEST(PresenterPart, AFrameThatMustBeOneListIsOne) {
    for (const bool must : {false, true}) {
        const auto rig =
            std::make_unique<Rig>(PanelConfig{.buffers = static_cast<std::uint8_t>(must ? 2 : 1)}, 16);
        for (std::size_t y = 0; y < height; y += 12)
            rig->damage[y] = {static_cast<std::int16_t>(y / 4), static_cast<std::int16_t>(y / 4 + 3)};
        ASSERT_TRUE(rig->send().ok());
        rig->settle();
        EXPECT_EQ(rig->bus.submits == 1, must) << rig->bus.submits;
        for (std::int32_t y = 0; y < height; y += 12)
            ASSERT_EQ(rig->shown(y / 4, y), rig->drawn(y / 4, y)) << y;
    }
}

TEST(PresenterPart, ConvertedPixelsLeaveTheBufferFree) {
    const auto rig = std::make_unique<Rig>(PanelConfig{.wire = wires::rgb666});
    rig->bus.colmod = 0x66;
    rig->damage[7] = {30, 32}, rig->damage[90] = {50, 53};
    ASSERT_TRUE(rig->send().ok());
    EXPECT_NE(rig->buffer.to_draw(rig->bus), nullptr) << "the list reads what was converted";
    rig->settle();
    EXPECT_EQ(rig->bus.pixel_bytes, 3 * (2 + 3));
    const auto red = [](std::uint32_t of565) { return of565 >> 11; };
    for (const auto& [x, y] : {std::pair{30, 7}, {31, 7}, {52, 90}})
        EXPECT_EQ(rig->shown(x, y) >> 19, red(rig->drawn(x, y))) << x << ',' << y;
}

TEST(PresenterPart, AnErrorOfTheBusIsHandedOn) {
    const auto rig = std::make_unique<Rig>();
    rig->damage[3] = {10, 20};
    rig->bus.refuse_submits = 1;
    EXPECT_EQ(rig->send().error().fault, Fault::busy);
    EXPECT_EQ(rig->pacer.counters().sent, 0u);
    EXPECT_NE(rig->buffer.to_draw(rig->bus), nullptr);
}

TEST(PresenterPart, ATearFreeFrameBeginsWithAWait) {
    const auto rig = std::make_unique<Rig>(PanelConfig{.wait_te = true});
    rig->bus.te_period_us = panel.timing.frame_us;
    ASSERT_TRUE(rig->pacer.measure().ok());
    rig->damage[3] = {10, 20};
    ASSERT_TRUE(rig->send().ok());
    EXPECT_EQ(rig->bus.last_list.front().kind, Op::Kind::wait_te);
    rig->settle();
    EXPECT_EQ(rig->shown(10, 3), rig->drawn(10, 3));
    EXPECT_EQ(rig->pacer.counters().led + rig->pacer.counters().lagged, 1u);
}

} // namespace
