// Tests which calls PolledBus makes to its port for each operation, and how faults are reported.
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <spangle/hal/polled_bus.hpp>

namespace {

using namespace spangle::hal;

/// Logs the calls: "c" and "d" begin commands and data, bytes are in hexadecimal, "." ends.
struct Port final : PolledPort {
    std::string log;
    Fault fault = Fault::none; ///< the fault of the call number `fails_at`
    int fails_at = -1, calls = 0;

    Fault outcome() { return calls++ == fails_at ? fault : Fault::none; }
    Fault begin(bool data) override {
        log += data ? "d" : "c";
        return outcome();
    }
    Fault write(const std::uint8_t* bytes, std::uint32_t count) override {
        for (std::uint32_t i = 0; i < count; ++i) {
            char text[3];
            std::snprintf(text, sizeof text, "%02x", bytes[i]);
            log += text;
        }
        return outcome();
    }
    Fault read(std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count) override {
        log += "r" + std::to_string(dummy_bits);
        std::memset(into, 0x5A, count);
        return outcome();
    }
    void end() override { log += "."; }
    void reset(bool low) override { log += low ? "R" : "r"; }
    void pause(std::uint32_t micros) override { log += "p" + std::to_string(micros); }
};

BusCaps caps(BusKind kind = BusKind::spi4, std::uint32_t read_hz = 1000000) {
    BusCaps c;
    c.kind = kind;
    c.write_hz = 1000000;
    c.read_hz = read_hz;
    return c;
}

Op op(Op::Kind kind) {
    Op o;
    o.kind = kind;
    return o;
}
Op command(std::uint8_t code, const std::uint8_t* data, std::uint32_t length) {
    Op o = op(Op::Kind::command);
    o.command = code;
    o.data = data;
    o.length = length;
    return o;
}

const std::uint8_t bytes[] = {1, 2, 3, 4, 5, 6};

std::string told(const std::vector<Op>& ops, BusKind kind = BusKind::spi4) {
    Port port;
    PolledBus bus(port, caps(kind), {});
    const Result<Token> token = bus.submit(ops.data(), ops.size());
    EXPECT_TRUE(token.ok());
    EXPECT_TRUE(bus.done(token.value()));
    EXPECT_TRUE(bus.wait(token.value(), 0).ok());
    return port.log;
}

TEST(PolledBus, CommandsAndTheirParametersAreOneMessageEach) {
    EXPECT_EQ(told({command(0x2A, bytes, 2), command(0x2C, nullptr, 0)}), "c2ad0102c2c.");
    Op low = command(0x15, bytes, 2);
    low.parameters_are_commands = true;
    EXPECT_EQ(told({low, low}), "c15010215"
                                "0102.");
}

TEST(PolledBus, AStartByteStandsForOneIndex) {
    Op low = command(0x15, bytes, 0);
    EXPECT_EQ(told({low, low}, BusKind::spi_start), "c15c15.");
    EXPECT_EQ(told({low, low}, BusKind::i2c), "c1515.");
}

TEST(PolledBus, RowsOfPixels) {
    Op pixels = op(Op::Kind::pixels);
    pixels.data = bytes;
    pixels.length = 2;
    pixels.rows = 2;
    pixels.stride = 2;
    EXPECT_EQ(told({command(0x2C, nullptr, 0), pixels}), "c2cd01020304.");
    pixels.stride = 4;
    EXPECT_EQ(told({pixels, pixels}), "d0102050601020506.");
    pixels.data = bytes + 4;
    pixels.stride = -4;
    EXPECT_EQ(told({pixels}), "d05060102.");
}

TEST(PolledBus, RepeatsWholePatterns) {
    Op repeat = op(Op::Kind::repeat);
    repeat.data = bytes;
    for (std::uint32_t length = 1; length <= 4; ++length)
        for (const std::uint32_t rows : {0u, 1u, 11u, 12u, 13u, 48u, 49u}) {
            repeat.length = length;
            repeat.rows = rows;
            std::string expected = rows == 0 ? "" : "d";
            for (std::uint32_t i = 0; i < rows; ++i)
                for (std::uint32_t k = 1; k <= length; ++k)
                    expected += "0" + std::to_string(k);
            EXPECT_EQ(told({repeat}), expected + (rows == 0 ? "" : ".")) << length << " x " << rows;
        }
}

TEST(PolledBus, ResetAndDelayEndTheMessage) {
    Op reset = op(Op::Kind::reset), delay = op(Op::Kind::delay);
    reset.micros = 10;
    delay.micros = 5;
    EXPECT_EQ(told({reset, command(0x11, nullptr, 0), delay, command(0x29, nullptr, 0)}), "Rp10rc11.p5c29.");
}

TEST(PolledBus, AnswersAreMessagesOfTheirOwn) {
    std::uint8_t answer[2] = {};
    Op read = op(Op::Kind::read);
    read.command = 0x04;
    read.dummy_bits = 8;
    read.into = answer;
    read.length = 2;
    EXPECT_EQ(told({command(0x11, nullptr, 0), read, command(0x29, nullptr, 0)}), "c11.c04r8.c29.");
    EXPECT_EQ(answer[1], 0x5A);
}

TEST(PolledBus, RefusesWhatItCannotDoWhole) {
    Port port;
    PolledBus bus(port, caps(BusKind::spi4, 0), {});
    Op repeat = op(Op::Kind::repeat);
    repeat.data = bytes;
    repeat.length = 5;
    for (const Op& bad : {op(Op::Kind::wait_te), op(Op::Kind::wait_line), op(Op::Kind::read), repeat}) {
        const Op ops[] = {command(0x11, nullptr, 0), bad};
        EXPECT_FALSE(bus.submit(ops, 2).ok());
    }
    EXPECT_FALSE(bus.submit(nullptr, 1).ok());
    EXPECT_EQ(port.log, "");
    EXPECT_FALSE(bus.wait(Token{}, 0).ok());
}

TEST(PolledBus, AFaultEndsTheListAndIsForgottenWithTheNext) {
    for (int call = 0; call < 4; ++call) {
        Port port;
        port.fault = Fault::no_answer;
        port.fails_at = call;
        PolledBus bus(port, caps(BusKind::i2c), {});
        const Op ops[] = {command(0x2A, bytes, 2), command(0x2C, nullptr, 0)};
        const Token token = bus.submit(ops, 2).value();
        EXPECT_EQ(bus.wait(token, 0).error().fault, Fault::no_answer);
        EXPECT_EQ(port.calls, call + 1);
        EXPECT_EQ(port.log.back(), '.') << "the line is let go";
        const Token next = bus.submit(ops, 1).value();
        EXPECT_TRUE(bus.wait(next, 0).ok());
        EXPECT_FALSE(bus.wait(token, 0).ok()) << "the list before";
    }
}

TEST(PolledBus, CountsWhatItSends) {
    Port port;
    PolledBus bus(port, caps(), {});
    const Op ops[] = {command(0x2A, bytes, 4), command(0x2C, nullptr, 0)};
    ASSERT_TRUE(bus.submit(ops, 2).ok());
    ASSERT_TRUE(bus.submit(ops, 1).ok());
    EXPECT_EQ(bus.bytes(), 11u);
}

TEST(PolledBus, BuffersAreAlignedAndApart) {
    alignas(32) std::uint8_t memory[100];
    Port port;
    PolledBus bus(port, caps(), {memory, sizeof memory});
    const Result<Buffer> a = bus.acquire(33), b = bus.acquire(36), c = bus.acquire(1);
    ASSERT_TRUE(a.ok() && b.ok());
    EXPECT_EQ(a.value().bytes, memory);
    EXPECT_EQ(b.value().bytes, memory + 64);
    EXPECT_FALSE(c.ok());
    EXPECT_FALSE(PolledBus(port, caps(), {}).acquire(1).ok());
}

} // namespace
