// Plays whole scenes through every transport. The glass must show, to the bit, what the simulated board
// shows.
#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "tests/support/scene_player.hpp"
#include "tests/unit/hal_linux/rig.hpp"

namespace {

using namespace linux_test;

using spangle::test::play;

hal::Board board_of(Transport transport, bool small) {
    hal::Board board = small ? boards::st7735_128x160 : boards::ili9341_spi;
    if (is_parallel(transport))
        board = boards::ili9341_8080;
    board.display.orientation = {hal::Rotation::r90};
    return board;
}

void expect_scene(Transport transport, const char* id, bool small, bool asynchronous) {
    const scenes::Scene* const scene = scenes::find(id);
    ASSERT_NE(scene, nullptr);
    hal::Board board = board_of(transport, small);
    sim::SimBoard sim(board);
    ASSERT_TRUE(play(sim.display(), *scene, 3));
    RigOptions options;
    options.panel = board.display.panel;
    options.orientation = board.display.orientation;
    options.buffers = asynchronous ? 2 : 1;
    options.asynchronous = asynchronous;
    options.read_back = can_read(transport);
    options.spi_hz = 2000000; // so slow that a slow test machine keeps deadlines
    Rig rig(transport, options);
    const auto opened = rig.open();
    ASSERT_TRUE(opened.ok()) << opened.error().rule;
    ASSERT_TRUE(play(*rig.display, *scene, 3));
    ASSERT_TRUE(rig.display->finish().ok());
    EXPECT_EQ(sim::hash(rig.module.glass(options.orientation)), sim::hash(sim.glass()));
    EXPECT_EQ(rig.module.violations_text(), "");
}

TEST(Scenes, EachOverSpidev) {
    for (const scenes::Scene& scene : scenes::all()) {
        SCOPED_TRACE(scene.id);
        expect_scene(Transport::spi, scene.id, false, true);
    }
}

class SceneOver : public testing::TestWithParam<Transport> {};

TEST_P(SceneOver, GlassEqualsTheSimulatedBoards) {
    // These transports take 16 calls a byte.
    const bool bits = !is_spidev(GetParam()) && !is_parallel(GetParam());
    for (const char* const id : {"S6", "HUD"}) {
        SCOPED_TRACE(id);
        expect_scene(GetParam(), id, bits, false);
    }
}

INSTANTIATE_TEST_SUITE_P(, SceneOver, testing::ValuesIn(every_transport),
                         [](const auto& test) { return std::string(name_of(test.param)); });

} // namespace
