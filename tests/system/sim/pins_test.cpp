// Tests the controller at its pins. Drivers that move pins bit by bit give the memory, glass and answers that
// a bus of bytes gives. Rule 4, which only pins can break, is broken here.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include <spangle/boards/boards.hpp>
#include <spangle/hal/panel_display.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/bus/sim_bus.hpp"
#include "host_sim/controller/dcs_controller.hpp"
#include "tests/system/sim/pin_bus.hpp"

namespace {

using namespace spangle;
using namespace sim_test;
using sim::DcsController;
using sim::Rule;

DcsController controller_of(const hal::Board& board) {
    const hal::PanelDesc& panel = *board.display.panel;
    const sim::GlassMount mount{
        .x = panel.offset.x, .y = panel.offset.y, .width = panel.glass.width, .height = panel.glass.height};
    const sim::Chip& chip = sim::chips[static_cast<unsigned>(panel.controller)];
    return {sim::with_memory_size(chip, {panel.memory.width, panel.memory.height}), mount,
            board.bus == hal::BusKind::i8080};
}

std::unique_ptr<PinBus> pins_of(const hal::Board& board, sim::Controller& controller) {
    if (board.bus == hal::BusKind::i8080)
        return std::make_unique<ParallelPinBus>(controller, hal::bus_caps(board));
    return std::make_unique<SerialPinBus>(controller, hal::bus_caps(board));
}

/// Shows a picture whose neighbouring pixels all differ, on a panel that was just set up.
void show_noise(hal::PanelDisplay& display) {
    const hal::DisplayInfo info = display.info();
    ASSERT_TRUE(display.init().ok());
    const auto frame = display.acquire();
    ASSERT_TRUE(frame.ok());
    for (int y = 0; y < info.height; ++y) {
        for (int i = 0; i < info.width * 2; ++i)
            frame.value().pixels[y * frame.value().stride + i] =
                static_cast<std::uint8_t>(static_cast<unsigned>(y * 977 + i) * 2654435761u >> 24);
        frame.value().extents->rows[y] = {0, static_cast<std::int16_t>(info.width)};
    }
    ASSERT_TRUE(display.present().ok());
    ASSERT_TRUE(display.finish().ok());
}

std::string text_of(const sim::Violations& violations) {
    std::string text;
    for (const sim::Violation& v : violations)
        text += std::to_string(int(v.rule)) + ": " + v.text + "\n";
    return text;
}

bool reported(const sim::Controller& controller, Rule rule) {
    return std::any_of(controller.violations().begin(), controller.violations().end(),
                       [rule](const sim::Violation& v) { return v.rule == rule; });
}

TEST(Pins, EveryBoardShowsWhatABusOfBytesShows) {
    for (const hal::Board* board : boards::all) {
        if (board->bus != hal::BusKind::spi4 && board->bus != hal::BusKind::i8080)
            continue; // messages of this bus are not delimited by a pin
        const auto one = sim::make_controller(*board->display.panel, board->bus),
                   other = sim::make_controller(*board->display.panel, board->bus);
        sim::Controller &by_pin = *one, &by_byte = *other;
        const std::unique_ptr<PinBus> pins = pins_of(*board, by_pin);
        sim::SimBus bytes(by_byte, hal::bus_caps(*board));
        static hal::PanelStorage<hal::PanelSizes{.height = 320, .buffers = 2}> storage[2];
        hal::PanelDisplay pin_display(*pins, board->display, storage[0].memory());
        hal::PanelDisplay byte_display(bytes, board->display, storage[1].memory());
        show_noise(pin_display);
        show_noise(byte_display);
        EXPECT_EQ(text_of(by_pin.violations()), "") << board->name;
        EXPECT_EQ(by_pin.cells(), by_byte.cells()) << board->name;
        EXPECT_EQ(by_pin.glass(pins->now + 50'000'000), by_byte.glass(bytes.now() + 50'000'000))
            << board->name;
        if (pins->caps().read_hz == 0 || !board->display.panel->commands->status_registers)
            continue;
        const auto status = pin_display.status(), expected = byte_display.status();
        ASSERT_TRUE(status.ok() && expected.ok());
        EXPECT_EQ(status.value().status, expected.value().status) << board->name;
        EXPECT_EQ(status.value().power_mode, 0x9C) << board->name;
        std::uint8_t rgb[2][5 * 3 * 3];
        ASSERT_TRUE(pin_display.read_back({7, 9, 5, 3}, rgb[0]).ok());
        ASSERT_TRUE(byte_display.read_back({7, 9, 5, 3}, rgb[1]).ok());
        EXPECT_TRUE(std::equal(rgb[0], rgb[0] + sizeof rgb[0], rgb[1])) << board->name;
        EXPECT_EQ(text_of(by_pin.violations()), "") << board->name;
    }
}

TEST(Pins, SpiMode3IsTakenToo) {
    DcsController controller = controller_of(boards::st7789_240), other = controller_of(boards::st7789_240);
    SerialPinBus mode3(controller, hal::bus_caps(boards::st7789_240)),
        mode0(other, hal::bus_caps(boards::st7789_240));
    mode3.rest_high();
    static hal::PanelStorage<hal::PanelSizes{.height = 240, .buffers = 2}> storage[2];
    hal::PanelDisplay three(mode3, boards::st7789_240.display, storage[0].memory());
    hal::PanelDisplay zero(mode0, boards::st7789_240.display, storage[1].memory());
    show_noise(three);
    show_noise(zero);
    EXPECT_EQ(text_of(controller.violations()), "");
    EXPECT_EQ(controller.memory(), other.memory());
}

/// A VCD file holds what the wires do: replayed edge by edge it fills another controller with the same
/// picture.
template <class Pins> void replay(std::istream& file, Pins& pins) {
    using Pin = typename Pins::Pin;
    Time now = 0;
    unsigned value = 0;
    std::string line;
    while (std::getline(file, line) && line != "$enddefinitions $end") {
    }
    while (std::getline(file, line)) {
        if (line[0] == '#')
            now = std::stoull(line.substr(1));
        else if (line[1] >= 'A' && line[1] <= 'H') { // D0 to D7
            const unsigned bit = 1u << (line[1] - 'A');
            value = line[0] == '1' ? value | bit : value & ~bit;
            if constexpr (requires { Pin::write; })
                pins.drive(value);
        } else {
            const bool high = line[0] == '1';
            switch (line[1]) {
            case 'c':
                pins.set(Pin::select, high, now);
                break;
            case 'd':
                pins.set(Pin::data, high, now);
                break;
            case 'r':
                pins.set(Pin::reset, high, now);
                break;
            default:
                if constexpr (requires { Pin::write; })
                    pins.set(Pin::write, high, now);
                else
                    pins.set(line[1] == 'k' ? Pin::clock : Pin::mosi, high, now);
            }
        }
    }
}

TEST(Pins, ARecordedTraceReplays) {
    const std::string path = testing::TempDir() + "replay-" + std::to_string(getpid()) + ".vcd";
    for (const hal::Board* board : {&boards::st7735_128x160, &boards::ili9341_8080, &boards::hx8347_spi,
                                    &boards::ssd1351_spi, &boards::ssd1306_spi}) {
        const auto sent = sim::make_controller(*board->display.panel, board->bus),
                   again = sim::make_controller(*board->display.panel, board->bus);
        sim::Controller &live = *sent, &replayed = *again;
        const auto noise = replayed.cells();
        hal::BusCaps caps = hal::bus_caps(*board);
        hal::PanelConfig config = board->display;
        config.read_back = false; // answers are not recorded
        sim::SimBus bus(live, caps);
        {
            sim::VcdFile vcd(path, board->bus);
            bus.listen(&vcd);
            static hal::PanelStorage<hal::PanelSizes{.height = 240, .buffers = 2}> storage;
            hal::PanelDisplay display(bus, config, storage.memory());
            show_noise(display);
            EXPECT_EQ(vcd.commit(), "");
        }
        std::ifstream file(path);
        if (board->bus == hal::BusKind::i8080) {
            sim::ParallelPins pins(replayed);
            replay(file, pins);
        } else {
            sim::SerialPins pins(replayed);
            replay(file, pins);
        }
        EXPECT_EQ(text_of(replayed.violations()), "") << board->name;
        EXPECT_EQ(replayed.cells(), live.cells()) << board->name;
        EXPECT_NE(replayed.cells(), noise) << board->name;
    }
    std::remove(path.c_str());
}

TEST(Pins, ChipSelectDropsAPartialByteOnly) {
    DcsController controller = controller_of(boards::ili9341_spi);
    sim::SerialPins pins(controller);
    using Pin = sim::SerialPins::Pin;
    Time now = 200'000'000;
    const auto bits = [&](unsigned value, int count) {
        for (int i = count - 1; i >= 0; --i) {
            pins.set(Pin::mosi, (value >> i & 1) != 0, now);
            pins.set(Pin::clock, true, now += 50);
            pins.set(Pin::clock, false, now += 50);
        }
    };
    const auto pulse = [&] {
        pins.set(Pin::select, true, now);
        pins.set(Pin::select, false, now += 1000);
    };
    pulse();
    bits(0x15, 5); // bits of a byte that is given up
    pulse();
    bits(0x36, 8);
    pulse(); // between bytes nothing is cancelled
    pins.set(Pin::data, true, now);
    bits(0xE8, 8);
    EXPECT_EQ(controller.madctl(), 0xE8);
    pulse();
    pins.set(Pin::data, false, now);
    bits(0x00, 8);
    EXPECT_EQ(text_of(controller.violations()), "");
    pins.set(Pin::select, true, now);
    bits(0x01, 8); // for another chip: this one is not selected
    EXPECT_EQ(controller.madctl(), 0xE8);
}

/// Wrong buses, serial and parallel, break rule 4 on purpose.
TEST(Rules, DataPinInsideAByte) {
    for (const hal::Board* board : {&boards::st7789_240, &boards::ili9341_8080}) {
        DcsController controller = controller_of(*board);
        const std::unique_ptr<PinBus> pins = pins_of(*board, controller);
        const std::uint8_t order = 0x60;
        hal::Op op;
        op.kind = hal::Op::Kind::command;
        op.command = 0x36;
        op.data = &order;
        op.length = 1;
        pins->now = 200'000'000;
        ASSERT_TRUE(pins->submit(&op, 1).ok());
        EXPECT_EQ(text_of(controller.violations()), "") << board->name;
        EXPECT_EQ(controller.madctl(), 0x60) << board->name;
        pins->data_pin_early = true;
        ASSERT_TRUE(pins->submit(&op, 1).ok());
        EXPECT_TRUE(reported(controller, Rule::dc_in_byte)) << board->name;
    }
}

/// A serial rule is about each clock of a byte: the shortest one counts, not their mean.
TEST(Rules, OneShortClockOfAByte) {
    DcsController controller = controller_of(boards::ili9341_spi);
    sim::SerialPins pins(controller);
    using Pin = sim::SerialPins::Pin;
    Time now = 200'000'000;
    pins.set(Pin::select, false, now);
    for (int i = 0; i < 16; ++i) {
        const Time half = i == 11 ? 5 : 100;
        pins.set(Pin::clock, true, now += half);
        pins.set(Pin::clock, false, now += half == 5 ? 100 : 5);
        EXPECT_EQ(reported(controller, Rule::write_clock), i == 15) << i;
    }
}

} // namespace
