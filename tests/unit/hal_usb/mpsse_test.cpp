// Tests the models of the MPSSE engine and of the chip around it with byte streams alone.
#include <gtest/gtest.h>

#include "host_sim/usb/ftdi_adapter.hpp"

namespace {

using namespace spangle;
using Bytes = std::vector<std::uint8_t>;

struct Mpsse : testing::Test {
    sim::Kernel clock;
    sim::FtdiAdapter chip{clock};
    sim::MpsseEngine& engine = chip.engine;
    std::uint64_t levels = 0;

    Mpsse() {
        engine.restart();
        engine.on_change = [this](std::uint64_t now, sim::Time) { levels = now; };
    }
    void feed(const Bytes& bytes) { engine.feed(bytes.data(), bytes.size()); }
    Bytes answers() { return engine.take_answers(SIZE_MAX); }
};

TEST_F(Mpsse, BadCommandsAreEchoed) {
    feed({0xAA, 0x00, 0xFF, 0x81});
    EXPECT_EQ(answers(), (Bytes{0xFA, 0xAA, 0xFA, 0x00, 0xFA, 0xFF, 0xFF}));
    EXPECT_EQ(engine.bad_commands(), 3u);
}

TEST_F(Mpsse, CommandsMayComeInPieces) {
    for (const std::uint8_t byte : {0x85, 0x80, 0x08, 0x0B, 0x11, 0x01, 0x00, 0xA5}) {
        feed({byte});
        EXPECT_EQ(engine.longest_burst(), 0u);
    }
    feed({0xA5});
    EXPECT_EQ(engine.longest_burst(), 2u);
    feed({0x80, 0x08, 0x1B, 0x80, 0x00});
    EXPECT_EQ(levels & 0xFF, 0xECu) << "the second command waits for its third byte";
    feed({0x1B});
    EXPECT_EQ(levels & 0xFF, 0xE4u);
    EXPECT_EQ(engine.violations(), "");
}

TEST_F(Mpsse, PinsAreInputsUntilTheyAreDriven) {
    EXPECT_EQ(engine.levels(), 0xFFFFu) << "pulled up";
    feed({0x80, 0x00, 0x0B, 0x82, 0x40, 0xC0});
    EXPECT_EQ(levels, 0x7FF4u);
    feed({0x81, 0x83});
    EXPECT_EQ(answers(), (Bytes{0xF4, 0x7F}));
    engine.restart();
    EXPECT_EQ(levels, 0xFFFFu);
}

TEST_F(Mpsse, BitsTakeTheTimeOfTheClock) {
    EXPECT_EQ(engine.clock_hz(), 6000000u) << "12 MHz base, until told otherwise";
    feed({0x8A, 0x85, 0x86, 0x0E, 0x00, 0x80, 0x08, 0x0B});
    EXPECT_EQ(engine.clock_hz(), 2000000u);
    const sim::Time before = clock.now();
    feed({0x11, 0x02, 0x00, 1, 2, 3});
    EXPECT_EQ(clock.now() - before, 24u * 500);
    feed({0x8B});
    EXPECT_EQ(engine.clock_hz(), 400000u);
}

TEST_F(Mpsse, HighBitsFirstAndTakenAtRisingClocks) {
    feed({0x8A, 0x85, 0x80, 0x08, 0x0B});
    std::string out;
    std::uint64_t last = engine.levels();
    engine.on_change = [&](std::uint64_t now, sim::Time) {
        if ((now & ~last & 1) != 0)
            out += (now & 2) != 0 ? '1' : '0';
        last = now;
    };
    unsigned in = 0x3C0u;
    engine.input = [&](unsigned, sim::Time) {
        in <<= 1;
        return (in & 0x800) != 0;
    };
    feed({0x11, 0x00, 0x00, 0xB1});
    EXPECT_EQ(out, "10110001");
    in = 0x3C0u;
    feed({0x20, 0x00, 0x00});
    EXPECT_EQ(answers(), (Bytes{0x78}));
    EXPECT_EQ(out, "1011000111111111") << "the data pin stays as it was";
}

TEST_F(Mpsse, WhatSpiCannotMakeSenseOfIsAViolation) {
    feed({0x80, 0x08, 0x0B, 0x11, 0, 0, 1});
    EXPECT_EQ(engine.violations(), "bits in loopback\n");
    sim::FtdiAdapter high(clock), wrong(clock);
    high.engine.restart();
    wrong.engine.restart();
    const Bytes rests_high = {0x85, 0x80, 0x09, 0x0B, 0x11, 0, 0, 1},
                input = {0x85, 0x80, 0x08, 0x0F, 0x11, 0, 0, 1};
    high.engine.feed(rests_high.data(), rests_high.size());
    EXPECT_EQ(high.violations(), "SCK rests high: that is not mode 0\n");
    wrong.engine.feed(input.data(), input.size());
    EXPECT_EQ(wrong.violations(), "bits while SCK, MOSI or MISO points the wrong way\n");
}

TEST_F(Mpsse, WaitsForItsPin) {
    sim::Time at = 0;
    engine.input = [&](unsigned pin, sim::Time now) {
        return pin == sim::MpsseEngine::wait_pin && now >= at;
    };
    at = clock.now() + 300000;
    feed({0x89, 0x88, 0x81});
    EXPECT_EQ(answers().size(), 1u);
    EXPECT_GE(clock.now(), at);
    EXPECT_LT(clock.now(), at + 5000);
    at = clock.now() + 2500000; // longer than the chip's latency
    feed({0x89, 0x88, 0x81});
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(answers(), Bytes{});
        engine.retry_waiting_stream();
    }
    EXPECT_EQ(answers().size(), 1u);
}

TEST_F(Mpsse, EveryPacketBeginsWithTheModemsStatus) {
    const Bytes status = {0x32, 0x60};
    Bytes in;
    ASSERT_TRUE(chip.bulk_in(0x81, 4096, in));
    EXPECT_EQ(in, status) << "nothing to say";
    feed(Bytes(1100, 0x81)); // 510 + 510 + 80 answers
    in.clear();
    ASSERT_TRUE(chip.bulk_in(0x81, 4096, in));
    ASSERT_EQ(in.size(), 512u + 512 + 82);
    for (const std::size_t at : {0u, 512u, 1024u})
        EXPECT_EQ(Bytes(in.begin() + static_cast<std::ptrdiff_t>(at),
                        in.begin() + static_cast<std::ptrdiff_t>(at + 2)),
                  status);
    EXPECT_FALSE(chip.bulk_in(0x83, 64, in)) << "the other channel";
    EXPECT_FALSE(chip.bulk_out(0x04, status.data(), 2));
}

TEST_F(Mpsse, RequestsForTheOtherChannelAreSeen) {
    Bytes in;
    EXPECT_TRUE(chip.control({0x40, 11, 0x0200, 2, 0}, nullptr, in));
    EXPECT_EQ(chip.violations(), "request 11 to the other channel\n");
    EXPECT_FALSE(chip.control({0x40, 9, 0, 1, 0}, nullptr, in)) << "a latency of nothing";
    EXPECT_FALSE(chip.control({0x40, 77, 0, 1, 0}, nullptr, in));
    EXPECT_FALSE(chip.control({0xC0, 9, 0, 1, 1}, nullptr, in));
}

} // namespace
