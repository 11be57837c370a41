// board() and PanelDisplay::init() refuse the same descriptions, with the same words.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/boards/boards.hpp>
#include <spangle/hal.hpp>

using namespace hal_test;

namespace {

using Change = std::function<void(Board&)>;

/// Changes that break one rule or more on some boards, and none on others.
std::vector<Change> changes() {
    std::vector<Change> all = {
        [](Board&) {},
        [](Board& b) { b.display.buffers = 0; },
        [](Board& b) { b.display.buffers = 2; },
        [](Board& b) { b.display.buffers = 3; },
        [](Board& b) { b.display.wire = {}; },
        [](Board& b) { b.display.wire = wires::rgb444, b.display.buffers = 1; },
        [](Board& b) { b.display.wire = wires::mono, b.display.buffers = 1; },
        [](Board& b) { b.display.read_back = true; },
        [](Board& b) { b.display.read_back = false, b.read_hz = 0; },
        [](Board& b) { b.read_hz = 0; },
        [](Board& b) { b.read_hz = 60000000; },
        [](Board& b) { b.display.poll_line = true; },
        [](Board& b) { b.display.poll_line = true, b.display.read_back = false; },
        [](Board& b) { b.display.wait_te = true; },
        [](Board& b) { b.display.wait_te = b.has_te = true; },
        [](Board& b) { b.display.scan_order = true; },
        [](Board& b) { b.display.scan_order = true, b.display.buffers = 2, b.display.wire = {}; },
        [](Board& b) { b.display.row_hash = true; },
        [](Board& b) { b.display.band = 48; },
        [](Board& b) { b.display.band = 7; },
        [](Board& b) { b.display.band = -8; },
        [](Board& b) { b.display.band = 16, b.display.pacing = Pacing::drop; },
        [](Board& b) { b.write_hz = 0; },
        [](Board& b) { b.write_hz = b.write_hz + b.write_hz / 8; },
        [](Board& b) { b.write_hz = 1000001; },
        [](Board& b) { b.write_hz = 2000000000; },
    };
    for (const BusKind bus : {BusKind::spi4, BusKind::spi_start, BusKind::i8080, BusKind::i2c})
        all.push_back([bus](Board& b) { b.bus = bus; });
    for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgba8888,
                                     PixelFormat::rgb444, PixelFormat::grey4, PixelFormat::mono})
        all.push_back([format](Board& b) { b.display.format = format; });
    for (const Rotation rotation : {Rotation::r90, Rotation::r180})
        all.push_back([rotation](Board& b) { b.display.orientation.rotation = rotation; });
    return all;
}

/// Describes the board's display to a bus that does what the board says, and returns why it is refused.
std::string refusal_when_it_runs(const Board& board) {
    using Storage = PanelStorage<PanelSizes{.height = 512,
                                            .buffers = 2,
                                            .hashed_width = 512,
                                            .turned = true,
                                            .held = true,
                                            .content = 512,
                                            .indexed = true}>;
    static const auto storage = std::make_unique<Storage>();
    FakePanelBus bus(*board.display.panel, bus_caps(board));
    PanelDisplay display(bus, board.display, storage->memory());
    const Error error = display.init().error();
    const bool refused = error.fault == Fault::bad_argument || error.fault == Fault::unsupported;
    EXPECT_EQ(bus.submits != 0, !refused) << "what is refused sends nothing: " << error.rule;
    return refused ? error.rule : "";
}

/// Applies every pair of changes to a board of each kind, 40 x 40 x 8 descriptions.
TEST(PanelRules, AreTheSameForABoardAndForAPanelDisplay) {
    const std::vector<Change> all = changes();
    int wrong = 0, right = 0;
    for (const Board* kind :
         {&boards::ili9341_spi, &boards::ili9341_8080, &boards::st7789_240x320, &boards::ssd1306_i2c,
          &boards::ssd1306_spi, &boards::ssd1327_spi, &boards::hx8347_spi, &boards::st7735_128x160})
        for (const Change& first : all)
            for (const Change& second : all) {
                Board board = *kind;
                first(board), second(board);
                if (!is_drawable(board.display.format))
                    continue; // only a build knows which surfaces it has
                const char* const rule = flaw(board);
                ASSERT_EQ(rule != nullptr ? rule : "", refusal_when_it_runs(board))
                    << board.name << ", changes " << &first - all.data() << " and " << &second - all.data();
                ++(rule != nullptr ? wrong : right);
            }
    EXPECT_GT(wrong, 1000);
    EXPECT_GT(right, 1000);
}

} // namespace
