// FrameDisplay sends byte for byte what PanelDisplay sends of frames that changed everywhere, and survives
// faults.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <spangle/hal/board.hpp>
#include <spangle/hal/frame_display.hpp>
#include <spangle/hal/polled_bus.hpp>
#include <spangle/panels.hpp>

namespace {

using namespace spangle;
using namespace spangle::hal;

/// Logs each byte with the way it was sent, and adds up the pauses.
template <bool fails> struct PortThat final : PolledPort {
    static constexpr bool can_fail = fails;

    std::string log;
    std::uint64_t paused = 0;
    int fails_at = -1, calls = 0; ///< the number of the call of begin() that fails; -1: none
    bool data = false;

    Fault begin(bool is_data) override {
        data = is_data;
        return calls++ == fails_at ? Fault::no_answer : Fault::none;
    }
    Fault write(const std::uint8_t* bytes, std::uint32_t count) override {
        for (std::uint32_t i = 0; i < count; ++i) {
            char text[8];
            std::snprintf(text, sizeof text, "%c%02X ", data ? 'd' : 'c', bytes[i]);
            log += text;
        }
        return Fault::none;
    }
    Fault read(std::uint8_t, std::uint8_t*, std::uint32_t) override { return Fault::unsupported; }
    void end() override {}
    void reset(bool low) override { log += low ? "low " : "high "; }
    void pause(std::uint32_t micros) override { paused += micros; }
};

using Port = PortThat<true>;

template <const Board& board, bool fails = true> struct Plain {
    using Port = PortThat<fails>;
    Port port;
    std::vector<std::uint8_t> frame = std::vector<std::uint8_t>(FrameDisplay<board, Port>::bytes);
    FrameDisplay<board, Port> display{port, frame.data()};
};

void draw(Display& display, int n) {
    const DisplayInfo info = display.info();
    const auto frame = display.acquire();
    ASSERT_TRUE(frame.ok()) << frame.error().rule;
    EXPECT_EQ(frame.value().age, n == 0 ? 0 : 1);
    if (RowExtents* const extents = frame.value().extents)
        for (std::int32_t y = 0; y < info.height; ++y)
            extents->rows[y] = {0, static_cast<std::int16_t>(info.width)};
    for (std::int32_t y = 0; y < info.height; ++y)
        for (std::int32_t i = 0; i < row_bytes(info.format, info.width); ++i)
            frame.value().pixels[y * frame.value().stride + i] =
                static_cast<std::uint8_t>(y * 31 + i * 7 + n);
    ASSERT_TRUE(display.present().ok());
}

template <const Board& board, bool fails = true> void same_as_the_panels_display() {
    Plain<board, fails> own;
    Port port;
    const auto memory = std::make_unique<BusMemoryOf<board>>();
    PolledBus bus(port, bus_caps(board), memory->buffer());
    const auto usual = std::make_unique<BoardDisplay<board>>(bus);
    ASSERT_TRUE(own.display.init().ok());
    ASSERT_TRUE(usual->init().ok());
    for (int n = 0; n < 3; ++n) {
        draw(own.display, n);
        draw(*usual, n);
    }
    EXPECT_EQ(own.port.log, port.log);
    EXPECT_GE(own.port.paused, port.paused);
    const DisplayInfo a = own.display.info(), b = usual->info();
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.format, b.format);
    EXPECT_EQ(a.keeps_buffer, b.keeps_buffer);
    EXPECT_STREQ(a.name, b.name);
}

constexpr Board start_bytes =
    board({.name = "start bytes",
           .display = {.panel = &panels::hx8347_240x320, .orientation = {Rotation::r90}},
           .bus = BusKind::spi_start,
           .write_hz = 12500000});
constexpr Board offsets =
    board({.name = "offsets",
           .display = {.panel = &panels::st7789_135x240, .orientation = {Rotation::r270, true}},
           .write_hz = 40000000});
constexpr Board no_reset = board({.name = "no reset line",
                                  .display = {.panel = &panels::ili9341_240x320, .reset_line = false},
                                  .write_hz = 10000000});
constexpr Board commands_only =
    board({.name = "parameters are commands",
           .display = {.panel = &panels::ssd1331_96x64, .orientation = {Rotation::r180}},
           .write_hz = 6000000});
constexpr Board window_again =
    board({.name = "the window is sent again",
           .display = {.panel = &panels::ssd1327_128x128, .format = PixelFormat::grey4},
           .write_hz = 5000000});

TEST(FrameDisplay, SendsWhatPanelDisplaySendsOfWholeFrames) {
    same_as_the_panels_display<start_bytes>();
    same_as_the_panels_display<offsets>();
    same_as_the_panels_display<no_reset>();
    same_as_the_panels_display<commands_only>();
    same_as_the_panels_display<window_again>();
}

/// For wires that cannot fail, no code that handles faults is compiled.
TEST(FrameDisplay, SendsTheSameWhereNothingCanFail) {
    same_as_the_panels_display<start_bytes, false>();
    same_as_the_panels_display<no_reset, false>();
}

/// After a failed frame the panel's state is unknown, so the next frame begins with a reset.
TEST(FrameDisplay, SetsUpAPanelAnewThatDidNotTakeAFrame) {
    Plain<offsets> own;
    ASSERT_TRUE(own.display.init().ok());
    const std::string opening = own.port.log;
    own.port.fails_at = own.port.calls + 1;
    EXPECT_EQ(own.display.present().error().fault, Fault::no_answer);
    own.port.log.clear();
    EXPECT_TRUE(own.display.present().ok());
    EXPECT_EQ(own.port.log, opening);
    own.port.log.clear();
    EXPECT_TRUE(own.display.present().ok());
    EXPECT_LT(own.port.log.size(), opening.size());
}

} // namespace
