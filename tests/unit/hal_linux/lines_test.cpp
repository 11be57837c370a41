// Tests GPIO lines with the libgpiod of this build: levels, directions, edges, and texts of errors.
#include <cerrno>

#include "tests/unit/hal_linux/rig.hpp"

namespace {

using namespace linux_test;
using hal::Fault;
using testing::Test;

constexpr unsigned three[] = {4, 17, 9};

bool contains(const char* text, const char* part) {
    return std::string(text).find(part) != std::string::npos;
}

#define EXPECT_SAYS(error, part) EXPECT_TRUE(contains((error).rule, part)) << (error).rule

TEST(Lines, OutputsTakeTheirLevelsInOneCall) {
    Machine machine;
    hal::Lines lines;
    int changes = 0;
    std::uint64_t seen = 0;
    machine.chip.on_change = [&](std::uint64_t levels, sim::Time) { ++changes, seen = levels; };
    ASSERT_TRUE(lines.open_outputs(chip_path, three, 0b101).ok());
    EXPECT_EQ(changes, 1);
    const auto level = [&](unsigned line) { return (seen >> line & 1) != 0; };
    EXPECT_TRUE(level(4) && !level(17) && level(9));
    EXPECT_TRUE(machine.chip.is_output(4) && machine.chip.is_output(17) && machine.chip.is_output(9));
    for (std::uint32_t levels = 0; levels < 8; ++levels) {
        changes = 0;
        ASSERT_TRUE(lines.set(levels).ok());
        EXPECT_EQ(changes, 1);
        EXPECT_EQ(level(4), (levels & 1) != 0);
        EXPECT_EQ(level(17), (levels & 2) != 0);
        EXPECT_EQ(level(9), (levels & 4) != 0);
        const auto back = lines.get();
        ASSERT_TRUE(back.ok());
        EXPECT_EQ(back.value(), levels);
    }
    EXPECT_FALSE(machine.chip.is_output(5)) << "no other line is touched";
}

TEST(Lines, ChipsGoByLabelToo) {
    Machine machine;
    sim::GpioChip second("second chip", 8);
    second.attach(machine.kernel, 3); // the numbers of chips have gaps
    hal::Lines lines;
    const unsigned line[] = {2};
    ASSERT_TRUE(lines.open_outputs("second chip", line, 0).ok());
    EXPECT_TRUE(second.is_requested(2));
    EXPECT_FALSE(machine.chip.is_requested(2));
    const auto missing = lines.open_outputs("third chip", line, 0);
    EXPECT_EQ(missing.error().fault, Fault::gone);
    EXPECT_SAYS(missing.error(), "third chip line 2: open:");
    EXPECT_SAYS(missing.error(), "gpiodetect");
    EXPECT_FALSE(second.is_requested(2)) << "opening again gives back what was held";
}

TEST(Lines, TurnRound) {
    Machine machine;
    hal::Lines lines;
    machine.chip.input = [](unsigned line, sim::Time) { return line == 17; };
    ASSERT_TRUE(lines.open_outputs(chip_path, three, 0b101).ok());
    ASSERT_TRUE(lines.float_lines().ok());
    EXPECT_FALSE(machine.chip.is_output(4) || machine.chip.is_output(17));
    EXPECT_EQ(lines.get().value(), 0b010u);
    ASSERT_TRUE(lines.drive(0b001).ok());
    EXPECT_TRUE(machine.chip.is_output(4) && machine.chip.is_output(17));
    EXPECT_EQ(lines.get().value(), 0b001u);
}

TEST(Lines, InputsAreRead) {
    Machine machine;
    hal::Lines lines;
    machine.chip.input = [](unsigned line, sim::Time) { return line != 17; };
    ASSERT_TRUE(lines.open_inputs(chip_path, three).ok());
    EXPECT_EQ(lines.get().value(), 0b101u);
    EXPECT_FALSE(lines.set(1).ok()) << "inputs are not driven";
}

TEST(Lines, ErrorsSayDeviceOperationAndCause) {
    Machine machine;
    hal::Lines lines;
    machine.fail(EACCES, 1, [](const sim::Call& call) { return call.kind == sim::Call::Kind::open; });
    const auto denied = lines.open_outputs(chip_path, three, 0);
    EXPECT_EQ(denied.error().fault, Fault::denied);
    EXPECT_EQ(denied.error().detail, static_cast<std::uint32_t>(EACCES));
    EXPECT_STREQ(
        denied.error().rule,
        "/dev/gpiochip0 lines 4,17,9: open: Permission denied; install the udev rules 60-spangle.rules and "
        "join group 'gpio'");
    machine.no_faults();
    machine.chip.take_line(17, "backlight");
    const auto busy = lines.open_outputs(chip_path, three, 0);
    EXPECT_EQ(busy.error().fault, Fault::busy);
    EXPECT_STREQ(busy.error().rule,
                 "/dev/gpiochip0 lines 4,17,9: request: the line is in use by 'backlight'");
    EXPECT_FALSE(machine.chip.is_requested(4)) << "all lines or none";
    machine.chip.vacate(17);
    const unsigned beyond[] = {54};
    EXPECT_EQ(lines.open_outputs(chip_path, beyond, 0).error().fault, Fault::unsupported);
    ASSERT_TRUE(lines.open_outputs(chip_path, three, 0).ok());
    machine.fail(EIO, 1, [](const sim::Call& call) { return call.kind == sim::Call::Kind::ioctl; });
    EXPECT_STREQ(lines.set(1).error().rule, "/dev/gpiochip0 lines 4,17,9: set: Input/output error");
    machine.kernel.unplug(chip_path);
    const auto gone = lines.set(1);
    EXPECT_EQ(gone.error().fault, Fault::gone);
    EXPECT_SAYS(gone.error(), "No such device");
}

TEST(Lines, WrongArgumentsAreRefused) {
    Machine machine;
    hal::Lines lines;
    EXPECT_EQ(lines.set(0).error().fault, Fault::bad_argument) << "not opened";
    EXPECT_EQ(lines.get().error().fault, Fault::bad_argument);
    EXPECT_EQ(lines.open_outputs(chip_path, {}, 0).error().fault, Fault::bad_argument);
    EXPECT_EQ(lines.open_outputs(nullptr, three, 0).error().fault, Fault::bad_argument);
    unsigned many[hal::Lines::most + 1] = {};
    for (unsigned i = 0; i < hal::Lines::most + 1; ++i)
        many[i] = i;
    EXPECT_EQ(lines.open_outputs(chip_path, many, 0).error().fault, Fault::bad_argument);
    EXPECT_TRUE(lines.open_outputs(chip_path, {many, hal::Lines::most}, 0).ok());
    EXPECT_TRUE(lines.set(0x80000001u).ok());
    EXPECT_EQ(lines.get().value(), 0x80000001u);
}

TEST(Lines, InterruptedCallsAreMadeAgainWithinBounds) {
    Machine machine;
    hal::Lines lines;
    const auto any = [](const sim::Call& call) { return call.kind != sim::Call::Kind::sleep; };
    for (const int error : {EINTR, EAGAIN}) {
        machine.fail(error, 20, any);
        ASSERT_TRUE(lines.open_outputs(chip_path, three, 0).ok()) << error;
        machine.fail(error, 20, any);
        EXPECT_TRUE(lines.set(5).ok()) << error;
        machine.fail(error, 20, any);
        EXPECT_TRUE(lines.get().ok()) << error;
        machine.fail(error, 1000000, any);
        const sim::Time before = machine.kernel.now();
        EXPECT_EQ(lines.set(2).error().fault, Fault::timeout) << error;
        EXPECT_LT(machine.kernel.now() - before, 1'000'000'000u) << error;
        machine.no_faults();
    }
}

// --- Edges

constexpr sim::Time ms = 1'000'000;

/// Returns a level that is high for the last millisecond of every ten.
bool square(sim::Time now) {
    return now % (10 * ms) >= 9 * ms;
}

struct Edges : Test {
    Machine machine;
    hal::EdgeLine line;
    Edges() {
        machine.chip.input = [](unsigned offset, sim::Time now) { return offset == 23 && square(now); };
        machine.kernel.advance(10 * ms - machine.kernel.now() % (10 * ms)); // edges come 9 ms from here
    }
    void TearDown() override { line.close(); }
};

TEST_F(Edges, TheNextOneWithItsTime) {
    ASSERT_TRUE(line.open({chip_path, 23}).ok());
    for (int i = 0; i < 5; ++i) {
        const sim::Time asked = machine.kernel.now();
        const auto edge = line.next_edge(50000);
        ASSERT_TRUE(edge.ok()) << edge.error().rule;
        EXPECT_GE(edge.value(), asked);
        EXPECT_NEAR(static_cast<double>(edge.value() % (10 * ms)), 9.0 * ms, 20000.0);
        EXPECT_NEAR(static_cast<double>(machine.kernel.now() % (10 * ms)), 9.0 * ms, 30000.0);
    }
}

TEST_F(Edges, OnesOfBeforeDoNotCount) {
    ASSERT_TRUE(line.open({chip_path, 23}).ok());
    machine.kernel.advance(995 * ms / 10 * 3); // about 300 ms later the queue of edges is full
    const sim::Time asked = machine.kernel.now();
    const auto edge = line.next_edge(50000);
    ASSERT_TRUE(edge.ok());
    EXPECT_GE(edge.value(), asked);
}

TEST_F(Edges, InvertedLinesFall) {
    ASSERT_TRUE(line.open({chip_path, 23, true}).ok());
    const auto edge = line.next_edge(50000);
    ASSERT_TRUE(edge.ok());
    EXPECT_LT(edge.value() % (10 * ms), 30000u) << "the square falls at whole tens";
}

TEST_F(Edges, NoneInTimeIsATimeout) {
    machine.chip.input = [](unsigned, sim::Time) { return false; };
    ASSERT_TRUE(line.open({chip_label, 23}).ok());
    const sim::Time asked = machine.kernel.now();
    const auto none = line.next_edge(30000);
    EXPECT_EQ(none.error().fault, Fault::timeout);
    EXPECT_SAYS(none.error(),
                "pinctrl-bcm2711 line 23: wait for edge: none came in time; is the panel's TE output");
    EXPECT_GE(machine.kernel.now() - asked, 30 * ms);
    EXPECT_LT(machine.kernel.now() - asked, 31 * ms);
}

TEST_F(Edges, SignalsDoNotEndTheWait) {
    ASSERT_TRUE(line.open({chip_path, 23}).ok());
    machine.fail(EINTR, 30, [](const sim::Call& call) { return call.kind == sim::Call::Kind::poll; });
    EXPECT_TRUE(line.next_edge(50000).ok());
    machine.fail(EIO, 1, [](const sim::Call& call) { return call.kind == sim::Call::Kind::poll; });
    EXPECT_STREQ(line.next_edge(50000).error().rule,
                 "/dev/gpiochip0 line 23: wait for edge: Input/output error");
    machine.fail(EIO, 1, [](const sim::Call& call) { return call.kind == sim::Call::Kind::read; });
    EXPECT_STREQ(line.next_edge(50000).error().rule, "/dev/gpiochip0 line 23: read edge: Input/output error");
}

TEST_F(Edges, ABusyLineNamesItsHolder) {
    machine.chip.take_line(23, "other program");
    const auto busy = line.open({chip_path, 23});
    EXPECT_EQ(busy.error().fault, Fault::busy);
    EXPECT_STREQ(busy.error().rule,
                 "/dev/gpiochip0 line 23: request edges: the line is in use by 'other program'");
    EXPECT_EQ(line.next_edge(1).error().fault, Fault::bad_argument);
}

} // namespace
