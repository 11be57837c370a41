// Tests the model of the HX8347 by the datasheet's rules: byte streams go in; memory, glass and violations
// come out.
#include <gtest/gtest.h>

#include "host_sim/controller/hx8347_controller.hpp"

namespace {

using namespace spangle::sim;

constexpr Rgb666 red{62, 0, 0}, green{0, 63, 0}, blue{0, 0, 62};

struct Host {
    Hx8347Controller chip;
    RegisterBus bus;
    Time now = 0;
    unsigned period = 100;

    explicit Host(RegisterBus b = RegisterBus::parallel) : chip({0, 0, 240, 320}, b), bus(b) {
        reset(20'000);
        now += 10'000'000;
    }
    void reset(Time low) {
        chip.reset(true, now);
        chip.reset(false, now += low);
    }
    /// Sends a message after a falling CS.
    void message(bool data, std::initializer_list<int> bytes) {
        chip.select(true, now);
        if (bus == RegisterBus::start_byte)
            chip.write(data ? 0x72 : 0x70, false, now += 8 * period, period);
        for (const int b : bytes)
            chip.write(static_cast<std::uint8_t>(b), data, now += 8 * period, period);
        chip.select(false, now);
    }
    void index(int i) { message(false, {i}); }
    void set(int i, int value) {
        index(i);
        message(true, {value});
    }
    void window(int x0, int x1, int y0, int y1) {
        const int numbers[] = {x0, x1, y0, y1};
        for (int n = 0; n < 4; ++n) {
            set(2 + 2 * n, numbers[n] >> 8);
            set(3 + 2 * n, numbers[n] & 255);
        }
    }
    Rgb666 cell(int column, int row) { return chip.cells()[static_cast<std::size_t>(row * 240 + column)]; }
    std::string broken() {
        std::string rules;
        for (const Violation& v : chip.violations())
            rules += (rules.empty() ? "" : " ") + std::to_string(static_cast<int>(v.rule));
        chip.forget_violations();
        return rules;
    }
};

TEST(Hx8347, EveryAddressOrderOnBothBuses) {
    for (const auto bus : {RegisterBus::parallel, RegisterBus::start_byte})
        for (int order = 0; order < 8; ++order) {
            const bool my = (order & 4) != 0, mx = (order & 2) != 0, mv = (order & 1) != 0;
            Host h(bus);
            h.set(0x17, 0x05);
            h.set(0x16, (my ? 0x80 : 0) | (mx ? 0x40 : 0) | (mv ? 0x20 : 0));
            h.window(10, 11, 20, 21);
            h.index(0x22);
            h.message(true, {0xF8, 0, 0x07, 0xE0});
            h.message(true, {0, 0x1F, 0xFF, 0xFF}); // further values go to the same index
            const auto at = [&](int x, int y) {
                const int c = mv ? y : x, r = mv ? x : y;
                return h.cell(mx ? 239 - c : c, my ? 319 - r : r);
            };
            EXPECT_EQ(at(10, 20), red) << order;
            EXPECT_EQ(at(11, 20), green) << order;
            EXPECT_EQ(at(10, 21), blue) << order;
            EXPECT_EQ(at(11, 21), (Rgb666{62, 63, 62})) << order;
            h.index(0x22); // back to the window's start
            h.message(true, {0, 0x1F, 0, 0x1F, 0, 0x1F, 0, 0x1F});
            EXPECT_EQ(at(10, 20), blue) << order;
            h.set(0x28, 0x3C);
            EXPECT_EQ(h.broken(), "") << order;
        }
}

TEST(Hx8347, LitWithAllBitsOfTheDisplayRegister) {
    Host h;
    h.set(0x17, 0x06);
    h.window(0, 0, 0, 0);
    h.index(0x22);
    h.message(true, {0xFC, 0x04, 0x80});
    EXPECT_EQ(h.chip.glass(h.now)[0], Rgb666{});
    h.set(0x28, 0x38);
    EXPECT_EQ(h.chip.glass(h.now)[0], Rgb666{}) << "the source drivers are off";
    h.set(0x28, 0x3C);
    EXPECT_EQ(h.chip.glass(h.now)[0], (Rgb666{63, 1, 32}));
    h.set(0x16, 0x08);
    EXPECT_EQ(h.chip.glass(h.now)[0], (Rgb666{32, 1, 63}));
    EXPECT_EQ(h.broken(), "");
}

TEST(Hx8347, AnswersWhatARegisterHolds) {
    Host h;
    h.set(0x1B, 0x5A);
    for (const auto& [index, value] : {std::pair{0x00, 0x47}, std::pair{0x1B, 0x5A}}) {
        h.chip.select(true, h.now);
        h.chip.write(static_cast<std::uint8_t>(index), false, h.now += 800, 100);
        EXPECT_EQ(h.chip.read_byte(h.now += 500, 500), value);
        h.chip.select(false, h.now);
    }
    EXPECT_EQ(h.broken(), "");
    h.chip.select(true, h.now);
    h.chip.write(0x00, false, h.now += 800, 100);
    h.chip.read_byte(h.now += 100, 100);
    EXPECT_EQ(h.broken(), "8") << "faster than it answers";
}

TEST(Hx8347, RulesThatStreamsBreak) {
    Host h;
    h.reset(9'000);
    EXPECT_EQ(h.broken(), "2");
    h.index(0x17);
    EXPECT_EQ(h.broken(), "1") << "5 ms after the reset";
    h.now += 5'000'000;
    h.index(0x16);
    EXPECT_EQ(h.broken(), "5") << "17h got no value";
    h.message(true, {0, 0});
    h.set(0x17, 0x05);
    EXPECT_EQ(h.broken(), "5") << "16h got two";
    h.set(0x17, 0x03);
    EXPECT_EQ(h.broken(), "12");
    h.set(0x17, 0x05);
    h.window(0, 240, 0, 0);
    h.index(0x22);
    EXPECT_EQ(h.broken(), "6");
    h.window(0, 1, 0, 0);
    h.index(0x22);
    h.message(true, {1, 2, 3});
    h.set(0x28, 0);
    EXPECT_EQ(h.broken(), "10 7");
    h.index(0x22);
    h.message(true, {1, 2, 3, 4, 5, 6});
    h.set(0x28, 0);
    EXPECT_EQ(h.broken(), "7 7") << "at once, and at the end";
    h.period = 65;
    h.set(0x28, 0);
    EXPECT_EQ(h.broken(), "9");
}

TEST(Hx8347, SerialMessagesBeginWithAStartByte) {
    Host h(RegisterBus::start_byte);
    h.chip.select(true, h.now);
    h.chip.write(0x22, false, h.now += 800, 100);
    h.chip.select(false, h.now);
    EXPECT_EQ(h.broken(), "14");
    h.set(0x17, 0x05);
    h.window(0, 0, 0, 0);
    h.index(0x22);
    h.message(true, {0xF8});
    EXPECT_EQ(h.broken(), "10") << "a pixel cut by CS is lost";
    h.message(true, {0x07, 0xE0});
    EXPECT_EQ(h.cell(0, 0), green);
}

} // namespace
