// Orientation changes no pixel. Every scene is drawn through EGL on a board whose panel is mounted in each of
// the eight ways, and looks the same to a person who turns the head with it.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "tests/support/scene_player.hpp"

namespace {

using namespace spangle;

struct Seen {
    sim::Image glass, memory;
    std::string violations;
};

/// Draws two frames, so that the second one is sent as damage.
Seen draw(const scenes::Scene& scene, const hal::Board& board) {
    sim::SimBoard sim(board);
    EXPECT_TRUE(test::play(sim.display(), scene, 2));
    return {sim.glass(), sim.memory(), sim.violations_text()};
}

class Orientations : public testing::TestWithParam<const scenes::Scene*> {};

/// Compares each mount with the first one of the same size: all eight of square glass, four and four of other
/// glass.
TEST_P(Orientations, ChangeNoPixel) {
    int moved = 0;
    for (const hal::Board* board : {&boards::st7789_240, &boards::st7735_128x160}) {
        Seen first[2]; // upright, and on its side
        for (const hal::Orientation o : hal::orientations) {
            hal::Board turned = *board;
            turned.display.orientation = o;
            const Seen seen = draw(*GetParam(), turned);
            EXPECT_EQ(seen.violations, "");
            Seen& reference = first[seen.glass.width >= seen.glass.height ? 0 : 1];
            const std::string where = std::string(board->name) + " turned " +
                                      std::to_string(90 * int(o.rotation)) + " degrees" +
                                      (o.mirrored ? ", mirrored" : "");
            if (reference.glass.width == 0) {
                reference = seen;
                continue;
            }
            EXPECT_EQ(seen.glass, reference.glass) << where;
            moved += seen.memory == reference.memory ? 0 : 1;
        }
    }
    // A dithered clear equals its own transpose; no other picture equals its turned picture.
    EXPECT_GE(moved, 11) << "of 13 mounts: were they turned at all?";
}

std::vector<const scenes::Scene*> every_scene() {
    std::vector<const scenes::Scene*> all;
    for (const scenes::Scene& scene : scenes::all())
        all.push_back(&scene);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Orientations, testing::ValuesIn(every_scene()),
                         [](const auto& info) { return std::string(info.param->id); });

} // namespace
