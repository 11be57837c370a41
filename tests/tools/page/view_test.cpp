// Tests what the page shows of a board: choices, the viewer who walks around, and the log of the bus.
#include <gtest/gtest.h>

#include <set>

#include <spangle/boards/boards.hpp>

#include "host_sim/page/view.hpp"

namespace spangle {
namespace {

int scene_of(const char* id) {
    return static_cast<int>(scenes::find(id) - scenes::all().begin());
}

int board_named(const char* name) {
    for (int i = 0; i < page::board_count(); ++i)
        if (page::board_of(i).name == std::string(name))
            return i;
    return -1;
}

void show(page::View& view, bool next = true) {
    ASSERT_EQ(view.draw(next), "");
    ASSERT_EQ(view.present(), "");
}

TEST(PageFormats, EachBoardsOwnComesFirstAndAllOpen) {
    for (int i = 0; i < page::board_count(); ++i) {
        const hal::Board& board = page::board_of(i);
        const std::vector<page::Format> formats = page::formats_of(board);
        ASSERT_FALSE(formats.empty()) << board.name;
        EXPECT_EQ(formats[0].surface, board.display.format) << board.name;
        EXPECT_EQ(formats[0].wire.format, board.display.wire.format) << board.name;
        std::set<std::string> names;
        for (int f = 0; f < static_cast<int>(formats.size()); ++f) {
            page::View view;
            ASSERT_EQ(view.open({i, scene_of("S2"), 0, f}), "") << board.name;
            show(view);
            EXPECT_EQ(view.violations(), "")
                << board.name << ": " << formats[static_cast<std::size_t>(f)].name;
            names.insert(formats[static_cast<std::size_t>(f)].name);
        }
        EXPECT_EQ(names.size(), formats.size()) << board.name;
        page::View view;
        EXPECT_NE(view.open({i, 0, 0, static_cast<int>(formats.size())}), "") << board.name;
    }
}

TEST(PageChecks, EachSceneInEachTierAndEachBoardInEachFormat) {
    std::set<std::pair<int, int>> scenes_in_tiers, boards_in_formats;
    for (const page::Choice& choice : page::checked_choices()) {
        if (choice.board == 0 && choice.format == 0)
            scenes_in_tiers.insert({choice.scene, choice.tier});
        boards_in_formats.insert({choice.board, choice.format});
    }
    EXPECT_EQ(scenes_in_tiers.size(), 3u * static_cast<unsigned>(scenes::all().count));
    std::size_t formats = 0;
    for (int i = 0; i < page::board_count(); ++i)
        formats += page::formats_of(page::board_of(i)).size();
    EXPECT_EQ(boards_in_formats.size(), formats);
}

TEST(PageChecks, ADigestNamesGlassMemoryAndBytes) {
    const std::string gears = page::digest_of({0, scene_of("S5"), 0, 0});
    EXPECT_EQ(page::digest_of({0, scene_of("S5"), 0, 0}), gears);
    page::View view;
    ASSERT_EQ(view.open({0, scene_of("S5"), 0, 0}), "");
    for (int frame = 0; frame < page::checked_frames; ++frame)
        show(view);
    EXPECT_EQ(sim::hash(view.glass()) + "-" + sim::hash(view.memory()) + "-" +
                  std::to_string(view.counters().bytes),
              gears);
    show(view);
    EXPECT_NE(view.picture_digest(), gears);
}

TEST(PageViewer, WalksAroundAndComesBackToTheSamePicture) {
    for (const char* id : {"S5", "S9", "CUBE", "BAKED"}) {
        page::View view;
        ASSERT_EQ(view.open({0, scene_of(id), 0, 0}), "");
        ASSERT_TRUE(view.has_camera()) << id;
        show(view);
        const sim::Image front = view.glass();
        view.orbit(40.0f, 20.0f);
        show(view, false);
        const sim::Image aside = view.glass();
        EXPECT_NE(aside, front) << id;
        view.orbit(0.0f, 0.0f);
        show(view, false);
        EXPECT_EQ(view.glass(), front) << id;
        show(view);
        EXPECT_NE(view.glass(), front) << id;
    }
}

// The cube turns about the middle of the picture, and is grey on black.
TEST(PageViewer, WalksAroundTheObject) {
    page::View view;
    ASSERT_EQ(view.open({0, scene_of("CUBE"), 0, 0}), "");
    show(view);
    const sim::Image front = view.glass();
    for (const auto& [yaw, pitch] : {std::pair{90.0f, 0.0f}, {180.0f, 0.0f}, {0.0f, 60.0f}}) {
        view.orbit(yaw, pitch);
        show(view, false);
        EXPECT_GT(view.glass().at(160, 120)[0], 0) << yaw << " " << pitch;
        EXPECT_EQ(view.glass().at(5, 120)[0], 0) << yaw << " " << pitch;
    }
    view.orbit(360.0f, 0.0f);
    show(view, false);
    EXPECT_GT(sim::compare_565(view.glass(), front).identical_percent(), 99.0);
}

TEST(PageViewer, FlatScenesHaveNoCamera) {
    page::View view;
    ASSERT_EQ(view.open({0, scene_of("HUD"), 0, 0}), "");
    EXPECT_FALSE(view.has_camera());
}

TEST(PageBusLog, TellsCommandsAndTheirFirstBytes) {
    page::View view;
    ASSERT_EQ(view.open({board_named("ili9341-spi"), scene_of("S5"), 0, 0}), "");
    show(view);
    const page::BusLog& log = view.log();
    ASSERT_EQ(log.entries().size(), 1u);       // the window is still the whole glass
    EXPECT_EQ(log.entries()[0].command, 0x2C); // RAMWR
    EXPECT_EQ(log.entries()[0].bytes, 320u * 240 * 2);
    EXPECT_EQ(log.commands(), 1u);
    EXPECT_EQ(log.bytes(), 1 + 320u * 240 * 2);
    show(view);
    const std::vector<page::BusLog::Entry>& entries = log.entries();
    ASSERT_EQ(entries.size(), page::BusLog::most_commands); // further commands are only counted
    EXPECT_GT(log.commands(), page::BusLog::most_commands);
    const int commands[] = {0x2A, 0x2B, 0x2C}; // CASET, PASET, RAMWR
    const auto wide = [](const page::BusLog::Entry& e) {
        return 1u + (e.first[2] << 8 | e.first[3]) - (e.first[0] << 8 | e.first[1]);
    };
    for (std::size_t i = 0; i + 2 < entries.size(); i += 3) {
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_EQ(entries[i + j].command, commands[j]);
        EXPECT_EQ(entries[i].bytes, 4u);
        EXPECT_EQ(entries[i + 1].bytes, 4u);
        EXPECT_EQ(entries[i + 2].bytes, 2 * wide(entries[i]) * wide(entries[i + 1])) << i;
    }
}

TEST(PageBusLog, IsOfTheLastFrameOnly) {
    page::View view;
    ASSERT_EQ(view.open({board_named("ssd1306-i2c"), scene_of("CUBE"), 0, 0}), "");
    std::uint64_t before = view.counters().bytes;
    for (int frame = 0; frame < 3; ++frame) {
        show(view);
        EXPECT_EQ(view.log().bytes(), view.counters().bytes - before);
        before = view.counters().bytes;
    }
}

} // namespace
} // namespace spangle
