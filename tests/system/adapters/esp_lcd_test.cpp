// Tests the esp_lcd adapter: Spangle's display drives a simulated panel through stubs of Espressif's panel
// IO.
#include <memory>
#include <vector>

#include <esp_lcd_panel_io.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spangle/adapters/esp_lcd.hpp>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "tests/support/panel_pattern.hpp"

using namespace spangle;

/// A panel IO whose other end is a simulated panel. Pixels stay queued until a call has to wait for them.
struct esp_lcd_panel_io_t {
    sim::SimBoard* board = nullptr;
    esp_lcd_panel_io_callbacks_t callbacks{};
    void* user = nullptr;
    int colors = 0, parameters = 0, queued = 0;
    esp_err_t answer = ESP_OK;
    std::vector<std::uint8_t> sent; ///< bytes that were sent as colours

    void transmit(int command, const void* data, std::size_t bytes, bool color) {
        std::vector<hal::Op> ops;
        hal::Op op;
        op.kind = hal::Op::Kind::command;
        op.command = static_cast<std::uint8_t>(command);
        if (!color) {
            op.data = static_cast<const std::uint8_t*>(data);
            op.length = static_cast<std::uint32_t>(bytes);
        }
        if (command >= 0)
            ops.push_back(op);
        op = {};
        op.kind = hal::Op::Kind::pixels;
        op.data = static_cast<const std::uint8_t*>(data);
        op.length = static_cast<std::uint32_t>(bytes);
        op.stride = static_cast<std::int32_t>(bytes);
        if (color)
            ops.push_back(op);
        const auto token = board->bus().submit(ops.data(), ops.size());
        EXPECT_TRUE(token.ok() && board->bus().wait(token.value(), 1000000).ok());
    }
    void finish() {
        for (; queued != 0; --queued)
            callbacks.on_color_trans_done(this, nullptr, user);
    }
};

esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t io,
                                                    const esp_lcd_panel_io_callbacks_t* callbacks,
                                                    void* user) {
    io->callbacks = *callbacks;
    io->user = user;
    return io->answer;
}
esp_err_t esp_lcd_panel_io_tx_param(esp_lcd_panel_io_handle_t io, int command, const void* parameters,
                                    std::size_t bytes) {
    io->finish();
    if (io->answer == ESP_OK && command >= 0)
        io->transmit(command, parameters, bytes, false), ++io->parameters;
    return io->answer;
}
esp_err_t esp_lcd_panel_io_tx_color(esp_lcd_panel_io_handle_t io, int command, const void* color,
                                    std::size_t bytes) {
    const auto* const bytes_of = static_cast<const std::uint8_t*>(color);
    io->sent.insert(io->sent.end(), bytes_of, bytes_of + bytes);
    if (io->answer == ESP_OK)
        io->transmit(command, color, bytes, true), ++io->colors, ++io->queued;
    return io->answer;
}

namespace {

esp_lcd_panel_io_t* current = nullptr;
std::vector<std::unique_ptr<std::uint8_t[]>> memory;

adapters::EspLcdConfig config_of(esp_lcd_panel_io_t& io, const hal::Board& board) {
    current = &io;
    adapters::EspLcdConfig config;
    config.io = &io;
    config.write_hz = board.write_hz;
    config.delay_us = [](std::uint32_t micros) {
        current->board->pass(sim::Time{micros} * 1000);
        current->finish();
    };
    config.set_reset = [](bool high) {
        hal::Op op;
        op.kind = hal::Op::Kind::reset;
        op.micros = 10;
        if (!high)
            return; // this port's reset pulse is one operation, which ends by itself
        const auto token = current->board->bus().submit(&op, 1);
        EXPECT_TRUE(token.ok() && current->board->bus().wait(token.value(), 1000).ok());
    };
    config.allocate = [](std::size_t bytes) -> void* {
        memory.push_back(std::make_unique<std::uint8_t[]>(bytes));
        return memory.back().get();
    };
    return config;
}

TEST(EspLcd, APanelThroughIt) {
    for (const hal::Board* board : {&boards::st7789_240, &boards::ili9341_spi, &boards::st7735_128x160}) {
        SCOPED_TRACE(board->name);
        sim::SimBoard sim(*board);
        esp_lcd_panel_io_t io;
        io.board = &sim;
        adapters::EspLcdBus bus(config_of(io, *board));
        hal::PanelConfig panel = board->display;
        panel.read_back = false;
        hal::PanelStorage<hal::PanelSizes{.height = 320}> storage;
        test::OwnedDisplay display(bus, panel, storage.memory());
        const auto ready = display.init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
        ASSERT_TRUE(test::draw_pattern(display, 7));
        ASSERT_TRUE(display.present().ok());
        ASSERT_TRUE(test::draw_pattern(display, 8, {3, 4, 20, 10}));
        ASSERT_TRUE(display.present().ok());
        EXPECT_EQ(test::glass_difference(display, sim.glass()), "");
        EXPECT_EQ(sim.violations_text(), "");
        EXPECT_GT(io.colors, 3);
    }
}

TEST(EspLcd, AListIsDoneWithItsLastColour) {
    sim::SimBoard sim(boards::st7789_240);
    esp_lcd_panel_io_t io;
    io.board = &sim;
    adapters::EspLcdBus bus(config_of(io, boards::st7789_240));
    const std::uint8_t pixel[2] = {0x12, 0x34};
    hal::Op ops[2];
    ops[0].kind = hal::Op::Kind::command;
    ops[0].command = 0x2C;
    ops[1].kind = hal::Op::Kind::repeat;
    ops[1].data = pixel;
    ops[1].length = 2;
    ops[1].rows = 300;
    const auto token = bus.submit(ops, 2);
    ASSERT_TRUE(token.ok());
    EXPECT_EQ(io.parameters, 0) << "the command goes with the first colours";
    EXPECT_EQ(io.colors, 3) << "600 bytes in blocks of 240";
    ASSERT_EQ(io.sent.size(), 600u);
    for (std::size_t i = 0; i < io.sent.size(); ++i)
        EXPECT_EQ(io.sent[i], pixel[i % 2]);
    EXPECT_FALSE(bus.done(token.value()));
    EXPECT_EQ(bus.submit(ops, 2).error().fault, hal::Fault::busy);
    EXPECT_EQ(bus.wait(token.value(), 0).error().fault, hal::Fault::timeout);
    EXPECT_TRUE(bus.wait(token.value(), 1000).ok());
    EXPECT_TRUE(bus.done(token.value()));
}

TEST(EspLcd, RowsWithGapsAndWithout) {
    sim::SimBoard sim(boards::st7789_240);
    esp_lcd_panel_io_t io;
    io.board = &sim;
    adapters::EspLcdBus bus(config_of(io, boards::st7789_240));
    const std::uint8_t bytes[] = {1, 2, 3, 4, 5, 6, 7, 8};
    hal::Op op;
    op.kind = hal::Op::Kind::pixels;
    op.data = bytes;
    op.length = 2;
    op.rows = 2;
    op.stride = 2;
    ASSERT_TRUE(bus.submit(&op, 1).ok());
    EXPECT_EQ(io.colors, 1);
    io.finish();
    op.stride = 6;
    ASSERT_TRUE(bus.submit(&op, 1).ok());
    EXPECT_EQ(io.colors, 3);
    EXPECT_EQ(io.sent, (std::vector<std::uint8_t>{1, 2, 3, 4, 1, 2, 7, 8}));
}

TEST(EspLcd, RefusalsAndFailures) {
    sim::SimBoard sim(boards::st7789_240);
    esp_lcd_panel_io_t io;
    io.board = &sim;
    adapters::EspLcdConfig config = config_of(io, boards::st7789_240);
    config.set_reset = nullptr;
    config.allocate = [](std::size_t) -> void* { return nullptr; };
    adapters::EspLcdBus bus(config);
    EXPECT_FALSE(bus.acquire(10).ok());
    hal::Op op;
    for (const auto kind :
         {hal::Op::Kind::read, hal::Op::Kind::wait_te, hal::Op::Kind::reset, hal::Op::Kind::repeat}) {
        op.kind = kind;
        EXPECT_EQ(bus.submit(&op, 1).error().fault, hal::Fault::unsupported);
    }
    op.kind = hal::Op::Kind::command;
    for (const auto& [code, fault] :
         {std::pair{ESP_FAIL, hal::Fault::no_answer}, {ESP_ERR_TIMEOUT, hal::Fault::timeout}}) {
        io.answer = code;
        const auto token = bus.submit(&op, 1);
        ASSERT_TRUE(token.ok());
        EXPECT_EQ(bus.wait(token.value(), 100).error().fault, fault);
    }
    const std::uint8_t pixel[2] = {};
    op.kind = hal::Op::Kind::pixels;
    op.data = pixel;
    op.length = 2;
    const auto token = bus.submit(&op, 1);
    EXPECT_TRUE(bus.done(token.value())) << "what was refused is not waited for";
    EXPECT_FALSE(bus.wait(token.value(), 100).ok());
    adapters::EspLcdBus unregistered(config);
    EXPECT_FALSE(unregistered.submit(&op, 1).ok());
}

TEST(EspLcd, NamesWhatTheConfigurationLacks) {
    sim::SimBoard sim(boards::st7789_240);
    esp_lcd_panel_io_t io;
    io.board = &sim;
    adapters::EspLcdConfig config = config_of(io, boards::st7789_240);
    config.allocate = nullptr;
    config.delay_us = nullptr;
    adapters::EspLcdBus bus(config);
    const auto buffer = bus.acquire(10);
    ASSERT_FALSE(buffer.ok());
    EXPECT_EQ(buffer.error().fault, hal::Fault::bad_argument);
    EXPECT_THAT(buffer.error().rule, testing::HasSubstr("allocate"));
    hal::Op op;
    op.kind = hal::Op::Kind::delay;
    op.micros = 1;
    const auto token = bus.submit(&op, 1);
    ASSERT_FALSE(token.ok());
    EXPECT_EQ(token.error().fault, hal::Fault::bad_argument);
    EXPECT_THAT(token.error().rule, testing::HasSubstr("delay_us"));
}

TEST(EspLcd, ParametersThatAreCommands) {
    sim::SimBoard sim(boards::st7789_240);
    esp_lcd_panel_io_t io;
    io.board = &sim;
    adapters::EspLcdBus bus(config_of(io, boards::st7789_240));
    const std::uint8_t parameters[2] = {0x00, 0x00}; // the controller takes 00h as NOP
    hal::Op op;
    op.kind = hal::Op::Kind::command;
    op.data = parameters;
    op.length = 2;
    op.parameters_are_commands = true;
    ASSERT_TRUE(bus.submit(&op, 1).ok());
    EXPECT_EQ(io.parameters, 3);
}

} // namespace
