// Tests probe, card and wizard on simulated modules. The wizard's questions are answered by looking at the
// glass.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/bringup/attach.hpp"
#include "host_sim/bringup/card.hpp"
#include "host_sim/bringup/counted_bus.hpp"
#include "host_sim/bringup/probe.hpp"
#include "host_sim/bringup/wizard.hpp"
#include "host_sim/bringup/wrong.hpp"
#include "tests/support/panel_pattern.hpp"

namespace {

using namespace spangle;
using testing::HasSubstr;

TEST(Probe, FindsEveryPanelThatAnswers) {
    int readable = 0;
    for (const hal::Board* board : boards::all) {
        SCOPED_TRACE(board->name);
        sim::SimBoard sim(*board);
        const auto found = bringup::probe(sim.bus(), board->display.reset_line);
        if (board->read_hz == 0) {
            EXPECT_THAT(found.error, HasSubstr("cannot read"));
            continue;
        }
        ++readable;
        EXPECT_EQ(found.error, "");
        EXPECT_THAT(found.panels, testing::Contains(board->display.panel));
        for (const hal::PanelDesc* panel : found.panels)
            EXPECT_EQ(panel->controller, board->display.panel->controller) << panel->name;
        EXPECT_THAT(bringup::text_of(found), HasSubstr(std::string("(board ") + board->name + ")"));
    }
    EXPECT_GT(readable, 3);
}

/// Answers every read with the same byte, or register 04h with an identity.
struct Parrot final : hal::Bus {
    std::uint8_t level = 0;
    std::array<std::uint8_t, 3> id{};
    hal::BusCaps caps() const override {
        hal::BusCaps c;
        c.write_hz = c.read_hz = 1000000;
        return c;
    }
    hal::Result<hal::Buffer> acquire(std::size_t) override { return hal::Buffer{}; }
    hal::Result<hal::Token> submit(const hal::Op* ops, std::size_t count) override {
        for (std::size_t i = 0; i < count; ++i)
            if (ops[i].kind == hal::Op::Kind::read && ops[i].command == 0x04 && id[0] != 0)
                std::copy(id.begin(), id.end(), ops[i].into);
            else if (ops[i].kind == hal::Op::Kind::read)
                std::fill_n(ops[i].into, ops[i].length, level);
        return hal::Token{1};
    }
    bool done(hal::Token) const override { return true; }
    hal::Result<void> wait(hal::Token, std::uint32_t) override { return {}; }
};

TEST(Probe, BitsThatDifferBetweenMakersDoNotCount) {
    Parrot bus;
    bus.id = {0x7C, 0x89, 0xF0}; // an ST7735S; the ST7735R answers 5C
    const auto found = bringup::probe(bus, true);
    EXPECT_THAT(found.panels, testing::Contains(&hal::panels::st7735_128x160));
    EXPECT_THAT(found.panels, testing::Not(testing::Contains(&hal::panels::st7789_240x320)));
}

TEST(Probe, SaysThatNobodyIsThere) {
    Parrot bus;
    for (const std::uint8_t level : {0x00, 0xFF}) {
        bus.level = level;
        const auto found = bringup::probe(bus, true);
        EXPECT_TRUE(found.panels.empty());
        EXPECT_THAT(bringup::text_of(found), HasSubstr("nobody drives the line"));
        EXPECT_THAT(bringup::text_of(found), HasSubstr("no known panel answers so"));
    }
    bus.level = 0x12;
    EXPECT_THAT(bringup::text_of(bringup::probe(bus, true)), HasSubstr("04h: 121212\n"));
}

TEST(Probe, FailuresAreTold) {
    sim::SimBoard sim(boards::ili9341_spi);
    sim.fail_next(hal::Fault::gone);
    EXPECT_NE(bringup::probe(sim.bus(), true).error, "");
    sim.fail_next(hal::Fault::gone);
    EXPECT_NE(bringup::probe(sim.bus(), false).error, "");
}

TEST(Card, ItsFrameIsTheOutermostPixels) {
    const sim::Image card = bringup::card(80, 160);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 80; ++x) {
            const bool edge = x == 0 || y == 0 || x == 79 || y == 159,
                       next = x == 1 || y == 1 || x == 78 || y == 158;
            if (!edge && !next)
                continue;
            EXPECT_EQ(card.at(x, y)[0], edge ? 255 : 0) << x << ", " << y;
        }
}

/// On round glass the frame is a ring. Each of its white pixels is visible and has a neighbour that is not.
/// The rest of the card is visible, too.
TEST(Card, OnRoundGlassNothingOfItIsHidden) {
    const sim::Image card = bringup::card(100, 100, true), square = bringup::card(100, 100);
    int ring = 0, lit = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const bool seen = sim::on_disc(x, y, 100, 100),
                       inner = sim::on_disc(x - 1, y, 100, 100) && sim::on_disc(x + 1, y, 100, 100) &&
                               sim::on_disc(x, y - 1, 100, 100) && sim::on_disc(x, y + 1, 100, 100);
            const bool white = card.at(x, y)[0] == 255 && card.at(x, y)[1] == 255;
            lit += card.at(x, y)[0] + card.at(x, y)[1] + card.at(x, y)[2] != 0;
            ring += seen && !inner;
            EXPECT_TRUE(seen || card.at(x, y)[0] == 0) << x << ", " << y;
            EXPECT_TRUE(white || !seen || inner) << x << ", " << y;
        }
    EXPECT_GT(ring, 250);
    EXPECT_GT(lit, ring + 200) << "letters and bars";
    EXPECT_NE(card, square);
}

TEST(Card, NoTurnAndNoMirrorLooksTheSame) {
    const sim::Image card = bringup::card(60, 60);
    for (const bool mirrored : {false, true})
        for (int quarters = 0; quarters < 4; ++quarters) {
            int differ = 0;
            for (int y = 0; y < 60; ++y)
                for (int x = 0; x < 60; ++x) {
                    int tx = mirrored ? 59 - x : x, ty = y;
                    for (int q = 0; q < quarters; ++q) {
                        const int old = tx;
                        tx = 59 - ty, ty = old;
                    }
                    differ += !std::equal(card.at(x, y), card.at(x, y) + 3, card.at(tx, ty));
                }
            EXPECT_EQ(differ == 0, !mirrored && quarters == 0) << mirrored << quarters;
        }
}

TEST(Card, ShowsItselfOnEveryBoard) {
    for (const hal::Board* board : boards::all) {
        if (board->display.wire.converts())
            continue; // such panels have fewer colours
        SCOPED_TRACE(board->name);
        sim::SimBoard sim(*board);
        ASSERT_TRUE(sim.display().init().ok());
        const hal::DisplayInfo info = sim.display().info();
        const sim::Image card = bringup::card(info.width, info.height, board->display.panel->round);
        ASSERT_TRUE(bringup::show(sim.display(), sim::Image(info.width, info.height)).ok());
        ASSERT_TRUE(bringup::show(sim.display(), card).ok());
        EXPECT_EQ(sim::compare_565(sim.scan_out(), card).identical_percent(), 100.0);
        EXPECT_EQ(sim.violations_text(), "");
        const sim::Image other = bringup::card(info.width + 1, info.height);
        EXPECT_EQ(bringup::show(sim.display(), other).error().fault, hal::Fault::bad_argument);
    }
}

/// A display of 5x4 pixels whose buffer has bytes behind it that nobody may touch.
struct Guarded final : hal::Display {
    explicit Guarded(PixelFormat of) : format(of), stride(5 * format_info(of).bytes_per_pixel) {}
    hal::DisplayInfo info() const override {
        hal::DisplayInfo info;
        info.width = 5;
        info.height = 4;
        info.format = format;
        return info;
    }
    hal::Result<void> init() override { return {}; }
    hal::Result<hal::Frame> acquire() override { return hal::Frame{pixels.data(), stride, 0, &extents}; }
    hal::Result<void> present() override { return {}; }
    const std::uint8_t* at(int x, int y) const {
        return pixels.data() + y * stride + x * format_info(format).bytes_per_pixel;
    }

    PixelFormat format;
    std::int32_t stride;
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(5 * 4 * 4 + 8, 0xA5);
    std::array<RowSpan, 4> rows{};
    RowExtents extents{rows.data(), 4};
};

TEST(Card, StoresWholePixelsOfEveryFormatAndNothingBesideThem) {
    sim::Image picture(5, 4);
    for (int i = 0; i < 20; ++i)
        std::copy_n(std::array<std::uint8_t, 3>{static_cast<std::uint8_t>(13 * i), 0, 255}.data(), 3,
                    picture.at(i % 5, i / 5));
    for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                     PixelFormat::rgba8888, PixelFormat::index8}) {
        Guarded display(format);
        ASSERT_TRUE(bringup::show(display, picture).ok());
        for (int i = 0; i < 20; ++i) {
            const std::uint8_t *const at = display.at(i % 5, i / 5), red = static_cast<std::uint8_t>(13 * i);
            if (format == PixelFormat::index8) {
                EXPECT_EQ(*at, (red & 0xE0) | 3);
            } else if (format == PixelFormat::rgb565_be || format == PixelFormat::rgb565_le) {
                EXPECT_EQ(at[format == PixelFormat::rgb565_be ? 0 : 1], red & 0xF8);
            } else {
                EXPECT_EQ(at[0] | at[2] << 8, red | 255 << 8);
            }
            if (format == PixelFormat::rgba8888) {
                EXPECT_EQ(at[3], 255);
            }
        }
        for (const std::uint8_t* behind = display.at(0, 4);
             behind != display.pixels.data() + display.pixels.size(); ++behind)
            EXPECT_EQ(*behind, 0xA5) << static_cast<int>(format);
    }
}

// --- The wizard

/// How a card lies on a glass: mirrored, then turned clockwise by quarters, then moved.
struct Look {
    bool mirrored = false;
    int quarters = 0, right = 0, down = 0;
};

/// Counts the pixels of the glass that differ from this look; every third pixel is compared.
int misfit(const sim::Image& glass, const sim::Image& card, const Look& look, int enough) {
    int wrong = 0;
    for (int y = 0; y < glass.height && wrong < enough; y += 3)
        for (int x = y % 2; x < glass.width; x += 2) {
            int cx = x - look.right, cy = y - look.down;
            const int w = look.quarters % 2 != 0 ? card.height : card.width,
                      h = look.quarters % 2 != 0 ? card.width : card.height;
            if (cx < 0 || cy < 0 || cx >= w || cy >= h)
                continue;
            const int tx = cx, ty = cy;
            if (look.quarters == 1)
                cx = ty, cy = card.height - 1 - tx;
            if (look.quarters == 2)
                cx = card.width - 1 - tx, cy = card.height - 1 - ty;
            if (look.quarters == 3)
                cx = card.width - 1 - ty, cy = tx;
            if (look.mirrored)
                cx = card.width - 1 - cx;
            const std::uint8_t *a = glass.at(x, y), *b = card.at(cx, cy);
            wrong +=
                (a[1] > 127) != (b[1] > 127) || (a[0] > 127) != (b[0] > 127) || (a[2] > 127) != (b[2] > 127);
        }
    return wrong;
}

Look look_at(const sim::Image& glass, const sim::Image& card, int reach) {
    Look best;
    int least = 1 << 30;
    for (const bool mirrored : {false, true})
        for (int quarters = 0; quarters < 4; ++quarters)
            for (int down = -reach; down <= reach; ++down)
                for (int right = -reach; right <= reach; ++right) {
                    const Look look{mirrored, quarters, right, down};
                    // The glass beyond the card does not count, so of several places that fit the nearest is
                    // taken.
                    const int wrong =
                        misfit(glass, card, look, least) + (std::abs(right) + std::abs(down)) / 4;
                    if (wrong < least)
                        least = wrong, best = look;
                }
    return best;
}

/// A person who looks at the glass and answers.
struct Beholder {
    sim::SimBoard& sim;
    int reach;
    bringup::Guess shown;
    std::unique_ptr<bringup::RealPanel> stand;
    sim::Image glass, card;

    std::string show(const bringup::Guess& guess) {
        shown = guess;
        hal::PanelConfig config;
        config.panel = &shown.panel;
        config.orientation = guess.orientation;
        stand = std::make_unique<bringup::RealPanel>(sim.bus(), config);
        if (const auto ready = stand->display().init(); !ready)
            return ready.error().rule;
        const hal::DisplayInfo info = stand->display().info();
        card = bringup::card(info.width, info.height);
        const auto sent = bringup::show(stand->display(), card);
        glass = sim.glass();
        return sent ? "" : sent.error().rule;
    }
    bool answer(const std::string& question, std::string& to) const {
        const auto count = [&](auto rule) {
            int n = 0;
            for (int y = 0; y < glass.height; ++y)
                for (int x = 0; x < glass.width; ++x)
                    n += rule(glass.at(x, y));
            return n;
        };
        if (question.find("background") != std::string::npos) {
            const int bright = count([](const std::uint8_t* p) { return p[0] + p[1] + p[2] > 382; });
            to = bright * 2 < glass.width * glass.height ? "y" : "n";
        } else if (question.find("colour") != std::string::npos) { // the first bar is the longest
            const int red = count([](const std::uint8_t* p) { return p[0] > 200 && p[1] < 50 && p[2] < 50; });
            const int blue =
                count([](const std::uint8_t* p) { return p[2] > 200 && p[1] < 50 && p[0] < 50; });
            to = red > blue ? "r" : "b";
        } else {
            const Look look = look_at(glass, card, reach);
            if (question.find("read as an F") != std::string::npos)
                to = look.mirrored ? "m" : "f";
            else if (question.find("top of the F") != std::string::npos)
                to = std::string(1, "urdl"[look.quarters]);
            else
                to = std::to_string(-look.right) + " " + std::to_string(-look.down);
        }
        return true;
    }
};

TEST(Wizard, FindsWhatTheModuleIs) {
    const struct {
        const hal::PanelDesc* panel;
        int reach;
    } modules[] = {{&hal::panels::st7735_80x160_26, 27},
                   {&hal::panels::st7735_80x160, 25},
                   {&hal::panels::st7735_128x128_red, 4},
                   {&hal::panels::st7789_240x280, 21}};
    for (const auto& m : modules) {
        SCOPED_TRACE(m.panel->name);
        hal::Board board = boards::st7735_128x160;
        board.display.panel = m.panel;
        board.display.orientation = {};
        sim::SimBoard sim(board);
        Beholder beholder{sim, m.reach, {}, nullptr, {}, {}};
        const auto found = bringup::ask_until_right(
            bringup::first_guess(*m.panel, m.panel->glass), [&](const auto& g) { return beholder.show(g); },
            [&](const std::string& q, std::string& a) { return beholder.answer(q, a); });
        EXPECT_EQ(found.error, "");
        EXPECT_EQ(sim::compare_565(sim.glass(), bringup::card(m.panel->glass.width, m.panel->glass.height))
                      .identical_percent(),
                  100.0);
        EXPECT_EQ(found.guess.panel.offset.x, m.panel->offset.x);
        EXPECT_EQ(found.guess.panel.offset.y, m.panel->offset.y);
        EXPECT_EQ(found.guess.panel.mount, m.panel->mount);
        EXPECT_EQ(found.guess.panel.order, m.panel->order);
        EXPECT_EQ(found.guess.panel.inverted, m.panel->inverted);
    }
}

bringup::WizardResult answered(std::vector<std::string> answers, const bringup::Guess& start) {
    std::size_t next = 0;
    return bringup::ask_until_right(
        start, [](const auto&) { return std::string(); },
        [&](const std::string&, std::string& to) {
            if (next == answers.size())
                return false;
            to = answers[next++];
            return true;
        });
}

TEST(Wizard, AnswersThatAreNone) {
    const auto start = bringup::first_guess(hal::panels::st7789_240x240, {240, 240});
    const auto right = answered({"x", "", "y", "r", "q", "f", "u", "0", "0 0"}, start);
    EXPECT_EQ(right.error, "");
    EXPECT_EQ(right.cards, 1);
    EXPECT_THAT(answered({"y", "r"}, start).error, HasSubstr("ended"));
    const auto kept = answered({"y", "r", "f", "u", "0 -1", "0 80", "y", "r", "f", "u", "0 0"}, start);
    EXPECT_EQ(kept.error, "") << "an offset that cannot be is asked for again";
    EXPECT_EQ(kept.guess.panel.offset.y, 80);
    std::vector<std::string> never(100, "n");
    EXPECT_THAT(answered(never, start).error, HasSubstr("is the controller the right one"));
}

TEST(Wizard, TurnsAndMovesAlongThePicturesAxes) {
    auto start = bringup::first_guess(hal::panels::st7789_240x240, {135, 240});
    const auto turned =
        answered({"y", "r", "f", "r", "y", "r", "f", "u", "-3 5", "y", "r", "f", "u", "0 0"}, start);
    ASSERT_EQ(turned.error, "");
    EXPECT_EQ(turned.guess.orientation.rotation, hal::Rotation::r270);
    EXPECT_EQ(turned.guess.panel.offset.x, 5);
    EXPECT_EQ(turned.guess.panel.offset.y, 3);
    const auto other = answered({"y", "r", "f", "l", "y", "r", "f", "u", "0 0"}, start);
    EXPECT_EQ(other.guess.orientation.rotation, hal::Rotation::r90);
    const auto mirrored = answered({"y", "r", "m", "y", "r", "f", "u", "0 0"}, start);
    EXPECT_EQ(mirrored.guess.panel.mount, 0x40);
    const auto down = answered({"y", "r", "f", "d", "y", "r", "f", "u", "0 0"}, start);
    EXPECT_EQ(down.guess.panel.mount, 0xC0);
}

TEST(Wizard, TheDefinitionSaysAll) {
    bringup::Guess guess{hal::panels::st7735_80x160_26, {hal::Rotation::r90}};
    const std::string text = bringup::board_definition(guess, boards::st7735_128x160);
    for (const char* const part :
         {"panels::st7735_128x160;", "p.memory = {132, 162};", "p.glass = {80, 160};", "p.offset = {26, 1};",
          "p.mount = 0xC0;", "ColorOrder::bgr;", "p.inverted = true;", "Rotation::r90", "BusKind::spi4"})
        EXPECT_THAT(text, HasSubstr(part));
}

/// What the wizard prints is a header that compiles, for every board in any orientation.
TEST(Wizard, TheDefinitionCompiles) {
    const std::string file = testing::TempDir() + "spangle_definitions.cpp";
    {
        std::ofstream out(file);
        int n = 0;
        for (const hal::Board* board : boards::all) {
            const auto rotation = static_cast<hal::Rotation>(n % 4);
            const bool turned =
                board->display.wire.converts() || board->display.wire.format == hal::WireFormat::none;
            std::string text = bringup::board_definition(
                {*board->display.panel, {turned ? rotation : hal::Rotation{}, n % 3 == 0}}, *board);
            text.erase(0, text.find("#include")); // one file holds many definitions
            for (const char* const name : {"my_panel", "my_board"})
                for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += 12)
                    text.insert(at + 8, "_" + std::to_string(100 + n));
            out << text;
            ++n;
        }
        ASSERT_GT(n, 10);
    }
    EXPECT_EQ(std::system((std::string(SPANGLE_COMPILE) + " " + file).c_str()), 0);
    std::ofstream(file, std::ios::app) << "static_assert(my_board_100.write_hz == 1);\n";
    EXPECT_NE(std::system((std::string(SPANGLE_COMPILE) + " " + file + " 2>/dev/null").c_str()), 0)
        << "the compiler looked";
    std::remove(file.c_str());
}

// --- Wrong settings

sim::Image card_with(const bringup::Wrong& wrong) {
    sim::SimBoard sim(*bringup::find_board("st7789-240x280"));
    bringup::Guess guess{*bringup::find_board("st7789-240x280")->display.panel, {}};
    wrong.spoil(guess);
    hal::PanelConfig config;
    config.panel = &guess.panel;
    config.orientation = guess.orientation;
    bringup::SpoiltBus bus(sim.bus(), wrong.line);
    bringup::RealPanel stand(bus, config);
    EXPECT_TRUE(stand.display().init().ok());
    const hal::DisplayInfo info = stand.display().info();
    EXPECT_TRUE(bringup::show(stand.display(), bringup::card(info.width, info.height), wrong.swapped).ok());
    return sim.glass();
}

/// Each wrong setting has a look of its own: no two are the same, and none is right.
TEST(Wrong, EachLooksLikeNoOther) {
    std::vector<sim::Image> seen = {card_with(bringup::nothing_wrong)};
    for (const char* const name : {"order", "inversion", "mirrored", "upside-down", "turned", "offset",
                                   "size", "bytes", "bits", "data-command", "clock"})
        EXPECT_NE(bringup::find_wrong(name), nullptr) << name;
    for (const bringup::Wrong& wrong : bringup::wrongs()) {
        seen.push_back(card_with(wrong));
        for (std::size_t i = 0; i + 1 < seen.size(); ++i)
            EXPECT_FALSE(seen[i] == seen.back()) << wrong.name << " looks like number " << i;
    }
    EXPECT_EQ(bringup::find_wrong("nothing"), nullptr);
}

/// A counted real bus must report what a simulated bus counts at its wires: whole frames, and windows of some
/// columns.
TEST(CountedBus, CountsWhatTheWiresCarry) {
    sim::SimBoard sim(boards::st7735_128x160);
    bringup::CountedBus counted(sim.bus());
    bringup::RealPanel stand(counted, boards::st7735_128x160.display);
    ASSERT_TRUE(stand.display().init().ok());
    EXPECT_EQ(counted.bytes(), sim.counters().bytes);
    EXPECT_EQ(counted.commands(), sim.counters().commands);
    for (const Rect area : {Rect{0, 0, 128, 160}, Rect{5, 7, 20, 30}, Rect{64, 1, 1, 1}}) {
        ASSERT_TRUE(test::draw_pattern(stand.display(), 3, area));
        ASSERT_TRUE(stand.display().present().ok());
        EXPECT_EQ(counted.bytes(), sim.counters().bytes);
        EXPECT_EQ(counted.commands(), sim.counters().commands);
    }
}

} // namespace
