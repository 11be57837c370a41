// Decodes register writes of an emulated board, and sends them to the model of its panel.
#include <cstdio>
#include <sstream>

#include <gtest/gtest.h>

#include <spangle/boards/boards.hpp>

#include "host_sim/boards/wires.hpp"

namespace {

using namespace spangle;
using namespace spangle::sim;
using Kind = WireEvent::Kind;

Wiring wired(std::initializer_list<const char*> words) {
    Wiring wiring;
    for (const char* word : words)
        EXPECT_TRUE(parse_wiring(word, wiring)) << word;
    return wiring;
}

std::string write(unsigned address, unsigned value) {
    char line[128];
    std::snprintf(line, sizeof line,
                  "memory_region_ops_write cpu 0 mr 0x55d0 addr 0x%x value 0x%x size 4 name 'x'\n", address,
                  value);
    return line;
}

/// Returns one character for each event.
std::string events(const std::string& trace, const Wiring& wiring) {
    std::istringstream in(trace);
    std::string text;
    for (const WireEvent& e : read_trace(in, wiring))
        text += "bSRdcLHp"[static_cast<unsigned>(e.kind)];
    return text;
}

TEST(Wiring, WordsThatAreNoneAreRefused) {
    Wiring wiring;
    for (const char* word :
         {"spi", "select=0x40", "select=0x40:1:reset_set", "colour=1", "pause=0x10", "pause=0x10:0"})
        EXPECT_FALSE(parse_wiring(word, wiring)) << word;
}

TEST(Wiring, LevelsOfPinsAreBitsOfRegisters) {
    const Wiring wiring = wired({"spi=0x8", "select=0x4c:0", "data=0x50:7", "reset=0x4c:3"});
    const std::string trace = write(0x4c, 0x9) + write(0x4c, 0x8) + write(0x4c, 0x8) + write(0x8, 0x2C) +
                              write(0x50, 0x80) + write(0x50, 0xFF) + write(0x8, 1) + write(0x50, 0x7F) +
                              write(0x4c, 0x9) + write(0x4c, 0x1) + write(0x99, 0xFF) + "no trace at all\n";
    EXPECT_EQ(events(trace, wiring), "RH"
                                     "S"
                                     "b"
                                     "d"
                                     "b"
                                     "c"
                                     "R"
                                     "L");
}

TEST(Wiring, SetResetRegistersKeepWhatIsNotNamed) {
    const Wiring wiring = wired({"spi=0x8", "select=0x18:1:set_reset"});
    const std::string trace = write(0x18, 1u << 17) + write(0x18, 1u << 16) + write(0x18, 1u << 0) +
                              write(0x18, 1u << 1) + write(0x18, 2) + write(0x18, 1u << 0);
    EXPECT_EQ(events(trace, wiring), "SR");
}

TEST(Wiring, SelectMayBeHigh) {
    const Wiring wiring = wired({"spi=0x8", "select=0x4:0", "select_high=1"});
    EXPECT_EQ(events(write(4, 1) + write(4, 0), wiring), "SR");
}

TEST(Wiring, PausesAreTicksOfAClock) {
    const Wiring wiring = wired({"spi=0x8", "pause=0xe000e014:25000000"});
    std::istringstream in(write(0xe000e014, 250) + write(0xe000e014, 0xFFFFFF));
    const std::vector<WireEvent> seen = read_trace(in, wiring);
    ASSERT_EQ(seen.size(), 1u) << "the counter of instructions is none";
    EXPECT_EQ(seen[0].kind, Kind::pause);
    EXPECT_EQ(seen[0].value, 10000u);
}

/// An HX8347 with start bytes: select, start byte, values, release.
struct Hx8347 {
    std::vector<WireEvent> events{{Kind::release, 0},
                                  {Kind::reset_low, 0},
                                  {Kind::pause, 1000000},
                                  {Kind::reset_high, 0},
                                  {Kind::pause, 200000000}};
    void message(std::initializer_list<std::uint32_t> bytes) {
        events.push_back({Kind::select, 0});
        for (const std::uint32_t b : bytes)
            events.push_back({Kind::byte, b});
        events.push_back({Kind::release, 0});
    }
    void value(std::uint32_t index, std::uint32_t v) {
        message({0x70, index});
        message({0x72, v});
    }
};

TEST(WiredPanel, TakesWhatIsSentWhileItIsSelected) {
    Hx8347 bus;
    bus.value(0x17, 0x05);
    bus.events.push_back({Kind::byte, 0x72}); // no chip is selected
    bus.events.push_back({Kind::byte, 0x00});
    bus.value(0x02, 0x00);
    WiredPanel panel(boards::hx8347_spi, wired({"spi=0x8", "pause=0x4:1000"}), bus.events);
    EXPECT_TRUE(panel.advance(2)) << "start bytes do not count";
    EXPECT_FALSE(panel.at_end());
    EXPECT_TRUE(panel.advance(4));
    EXPECT_TRUE(panel.at_end()) << "what releases the panel belongs to what was sent";
    EXPECT_FALSE(panel.advance(5));
    EXPECT_EQ(panel.violations(), "");
}

TEST(WiredPanel, TimesAreHeldWherePausesAreSeen) {
    Hx8347 bus;
    bus.events.resize(4); // no wait follows the reset
    bus.value(0x17, 0x05);
    for (const bool pauses : {true, false}) {
        Wiring wiring = wired({"spi=0x8"});
        wiring.pause_register = pauses ? 4 : 0;
        WiredPanel panel(boards::hx8347_spi, wiring, bus.events);
        EXPECT_TRUE(panel.advance(2));
        EXPECT_EQ(panel.violations().empty(), !pauses);
    }
}

TEST(WiredPanel, ShowsThePictureUpright) {
    Hx8347 bus;
    for (const auto& [index, v] : std::initializer_list<std::pair<std::uint32_t, std::uint32_t>>{{0x1F, 0x88},
                                                                                                 {0x1F, 0x80},
                                                                                                 {0x1F, 0x90},
                                                                                                 {0x1F, 0xD0},
                                                                                                 {0x17, 0x05},
                                                                                                 {0x28, 0x3C},
                                                                                                 {0x16, 0x08},
                                                                                                 {0x02, 0},
                                                                                                 {0x03, 0},
                                                                                                 {0x04, 0},
                                                                                                 {0x05, 0},
                                                                                                 {0x06, 0},
                                                                                                 {0x07, 0},
                                                                                                 {0x08, 0},
                                                                                                 {0x09, 0}})
        bus.value(index, v);
    bus.message({0x70, 0x22});
    bus.message({0x72, 0xF8, 0x00});
    WiredPanel panel(boards::hx8347_spi, wired({"spi=0x8"}), bus.events);
    ASSERT_TRUE(panel.advance(33));
    const Image glass = panel.glass();
    EXPECT_EQ(glass.width, 320);
    EXPECT_EQ(glass.height, 240);
    // The memory's first cell is in this corner of the glass: the module mirrors rows and columns, and the
    // picture is turned by a quarter.
    const std::uint8_t* const cell = glass.at(319, 0);
    EXPECT_GE(cell[0], 248);
    EXPECT_EQ(cell[1], 0);
    EXPECT_EQ(cell[2], 0);
}

} // namespace
