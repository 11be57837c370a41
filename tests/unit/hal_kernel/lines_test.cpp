// Tests GPIO lines through the real libgpiod on the kernel's real gpiolib.
#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <spangle/linux/lines.hpp>

#include "tests/support/random.hpp"
#include "tests/unit/hal_kernel/files.hpp"
#include "tests/unit/hal_kernel/line_trace.hpp"

namespace {

using namespace kernel_test;
using namespace spangle;
using hal::Fault;

constexpr char label[] = "expander";
constexpr unsigned offsets[] = {5, 0, 19, 7, 12, 31, 2, 1};
constexpr unsigned count = std::size(offsets);

std::uint32_t seen(const SimChip& chip) {
    std::uint32_t levels = 0;
    for (unsigned i = 0; i < count; ++i)
        levels |= std::uint32_t{chip.level(offsets[i])} << i;
    return levels;
}

TEST(KernelLines, OutputsReachTheirPins) {
    SimChip chip(label, 32);
    const std::string path = chip.path();
    for (const char* name : {path.c_str(), label}) {
        hal::Lines lines;
        const auto opened = lines.open_outputs(name, offsets, 0xA5);
        ASSERT_TRUE(opened.ok()) << opened.error().rule;
        EXPECT_EQ(seen(chip), 0xA5u);
        test::Random random{7};
        for (int i = 0; i < 50; ++i) {
            const std::uint32_t levels = random.below(256);
            ASSERT_TRUE(lines.set(levels).ok());
            EXPECT_EQ(seen(chip), levels);
        }
    }
}

TEST(KernelLines, OneCallDrivesAllLinesInTheirOrder) {
    SimChip chip(label, 32);
    LineTrace trace(chip);
    hal::Lines lines;
    ASSERT_TRUE(lines.open_outputs(label, offsets, 0).ok());
    trace.take();
    ASSERT_TRUE(lines.set(0x5C).ok());
    const auto changes = trace.take();
    ASSERT_EQ(changes.size(), count);
    for (unsigned i = 0; i < count; ++i) {
        EXPECT_EQ(changes[i].line, offsets[i]);
        EXPECT_EQ(changes[i].level, (0x5C >> i & 1) != 0);
    }
}

TEST(KernelLines, InputsReadWhatPullsThem) {
    SimChip chip(label, 32);
    hal::Lines lines;
    ASSERT_TRUE(lines.open_inputs(label, offsets).ok());
    test::Random random{3};
    for (int round = 0; round < 20; ++round) {
        const std::uint32_t levels = random.below(256);
        for (unsigned i = 0; i < count; ++i)
            chip.pull(offsets[i], (levels >> i & 1) != 0);
        const auto got = lines.get();
        ASSERT_TRUE(got.ok()) << got.error().rule;
        EXPECT_EQ(got.value(), levels);
    }
}

TEST(KernelLines, DataLinesTurnRound) {
    SimChip chip(label, 32);
    hal::Lines lines;
    ASSERT_TRUE(lines.open_outputs(label, offsets, 0x00).ok());
    EXPECT_EQ(seen(chip), 0x00u);
    ASSERT_TRUE(lines.float_lines().ok());
    for (unsigned i = 0; i < count; ++i)
        chip.pull(offsets[i], (0x96 >> i & 1) != 0);
    EXPECT_EQ(lines.get().value(), 0x96u);
    ASSERT_TRUE(lines.drive(0x3C).ok());
    EXPECT_EQ(seen(chip), 0x3Cu);
}

TEST(KernelLines, ABusyLineNamesItsHolder) {
    SimChip chip(label, 32);
    hal::Lines first, second;
    const unsigned line[] = {12};
    ASSERT_TRUE(first.open_outputs(label, line, 1).ok());
    const auto refused = second.open_outputs(label, offsets, 0);
    EXPECT_EQ(refused.error().fault, Fault::busy);
    EXPECT_NE(std::string(refused.error().rule).find("the line is in use by 'spangle'"), std::string::npos)
        << refused.error().rule;
    first.close();
    EXPECT_TRUE(second.open_outputs(label, offsets, 0).ok());
}

TEST(KernelLines, WhatIsNotThereIsSaid) {
    SimChip chip(label, 32);
    hal::Lines lines;
    const unsigned beyond[] = {32};
    EXPECT_FALSE(lines.open_outputs(label, beyond, 0).ok());
    const auto none = lines.open_outputs("no-such-chip", offsets, 0);
    EXPECT_EQ(none.error().fault, Fault::gone) << none.error().rule;
}

TEST(KernelLines, AChipThatGoesIsGone) {
    SimChip chip(label, 32);
    hal::Lines lines;
    ASSERT_TRUE(lines.open_outputs(label, offsets, 0).ok());
    chip.remove();
    const auto gone = lines.set(1);
    EXPECT_EQ(gone.error().fault, Fault::gone) << gone.error().rule;
}

// --- Tearing effect

/// A simulated interrupt waits for the kernel's next tick, 10 ms at most, and longer on a busy machine.
constexpr std::chrono::milliseconds later(60);

std::uint64_t now() {
    return static_cast<std::uint64_t>(
        std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count());
}

struct Te {
    SimChip chip{label, 32};
    hal::EdgeLine line;

    explicit Te(bool inverted = false) {
        chip.pull(4, inverted);
        const auto opened = line.open({label, 4, inverted});
        EXPECT_TRUE(opened.ok()) << opened.error().rule;
    }
};

TEST(KernelTe, AnEdgeComesWithTheKernelsTime) {
    Te te;
    for (int frame = 0; frame < 5; ++frame) {
        std::uint64_t before = 0;
        std::thread panel([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            before = now();
            te.chip.pull(4, true);
        });
        const auto edge = te.line.next_edge(1'000'000);
        const std::uint64_t after = now();
        panel.join();
        te.chip.pull(4, false);
        ASSERT_TRUE(edge.ok()) << edge.error().rule;
        EXPECT_GE(edge.value(), before);
        EXPECT_LE(edge.value(), after);
    }
}

TEST(KernelTe, EdgesFromBeforeDoNotCount) {
    Te te;
    for (int i = 0; i < 3; ++i) {
        te.chip.pull(4, true);
        te.chip.pull(4, false);
        std::this_thread::sleep_for(later);
    }
    const auto start = now();
    const auto none = te.line.next_edge(100'000);
    EXPECT_EQ(none.error().fault, Fault::timeout);
    EXPECT_GE(now() - start, 100'000'000u);
}

TEST(KernelTe, FallingEdgesDoNotCountUnlessInverted) {
    for (const bool inverted : {false, true}) {
        Te te(inverted);
        std::uint64_t begins = 0;
        std::thread panel([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            te.chip.pull(4, true);
            std::this_thread::sleep_for(later);
            begins = now();
            te.chip.pull(4, false);
        });
        const auto edge = te.line.next_edge(1'000'000);
        panel.join();
        ASSERT_TRUE(edge.ok()) << edge.error().rule;
        EXPECT_EQ(edge.value() >= begins, inverted);
    }
}

} // namespace
