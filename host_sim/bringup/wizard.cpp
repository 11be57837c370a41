#include "host_sim/bringup/wizard.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <spangle/panels.hpp>

#include "host_sim/board/bookkeeping.hpp"

namespace spangle::bringup {
namespace {

/// Most cards that are shown: every setting is wrong once at most, and a turn can undo an offset.
constexpr int most_cards = 16;

enum class Verdict { right, changed, over };

/// A thing that can be wrong: the question, the possible answers, and what an answer changes.
struct Question {
    const char* text;
    const char* answers; ///< letters; the first means that all is right
    void (*correct)(Guess& guess, char answer);
};

void exchange_colors(Guess& g, char) {
    g.panel.order = g.panel.order == hal::ColorOrder::rgb ? hal::ColorOrder::bgr : hal::ColorOrder::rgb;
}

void turn(Guess& g, char points) {
    if (points == 'd') { // the top of the F points down: the glass is upside down
        g.panel.mount ^= hal::dcs::MX | hal::dcs::MY;
        return;
    }
    const unsigned quarters = points == 'r' ? 3 : 1;
    const auto now = static_cast<unsigned>(g.orientation.rotation);
    g.orientation.rotation = static_cast<hal::Rotation>((now + quarters) % 4);
}

constexpr Question questions[] = {
    {"Is the background black? y: yes; n: it is white, letters are dark", "yn",
     [](Guess& g, char) { g.panel.inverted = !g.panel.inverted; }},
    {"Which colour is the bar beside the letter R? r: red; b: blue", "rb", exchange_colors},
    {"Does the F read as an F? f: yes; m: as in a mirror", "fm",
     [](Guess& g, char) { g.panel.mount ^= hal::dcs::MX; }},
    {"Where does the top of the F point? u: up; r: right; d: down; l: left", "urdl", turn},
};

Verdict ask_one(const Question& question, Guess& guess, const AskFunction& ask) {
    for (std::string answer; ask(question.text, answer);) {
        const char letter = answer.empty() ? '\0' : answer[0];
        const std::string_view answers = question.answers;
        if (letter == answers[0])
            return Verdict::right;
        if (letter == '\0' || answers.find(letter) == std::string_view::npos)
            continue; // asks the question once more
        question.correct(guess, letter);
        return Verdict::changed;
    }
    return Verdict::over;
}

/// Moves the picture on the glass. The window moves along the picture's axes, but the offset is along those
/// of the memory.
Guess move_guess(Guess guess, int right, int down) {
    const unsigned order = address_order(guess.panel.mount, guess.orientation);
    if ((order & hal::dcs::MV) != 0)
        std::swap(right, down);
    guess.panel.offset.x =
        static_cast<std::int16_t>(guess.panel.offset.x + ((order & hal::dcs::MX) != 0 ? -right : right));
    guess.panel.offset.y =
        static_cast<std::int16_t>(guess.panel.offset.y + ((order & hal::dcs::MY) != 0 ? -down : down));
    return guess;
}

Verdict ask_edges(Guess& guess, const AskFunction& ask) {
    std::string hint;
    for (std::string answer; ask("How many pixels must the picture move to the right, and down, until its "
                                 "white frame lies on the "
                                 "edges of the glass? Two numbers; 0 0: it does" +
                                     hint,
                                 answer);) {
        int right = 0, down = 0;
        if (std::sscanf(answer.c_str(), "%d %d", &right, &down) != 2 || right < -4096 || right > 4096 ||
            down < -4096 || down > 4096)
            continue;
        if (right == 0 && down == 0)
            return Verdict::right;
        const Guess there = move_guess(guess, right, down);
        if (const char* rule = hal::flaw(there.panel)) {
            hint = fmt::format(" (not {} {}: {})", right, down, rule);
            continue;
        }
        guess = there;
        return Verdict::changed;
    }
    return Verdict::over;
}

Verdict ask_all(Guess& guess, const AskFunction& ask) {
    for (const Question& question : questions)
        if (const Verdict v = ask_one(question, guess, ask); v != Verdict::right)
            return v;
    return ask_edges(guess, ask);
}

/// The constant of hal/panels for a panel: "ST7789 240x320" is st7789_240x320. A constant's name consists of
/// controller and size; further words in a panel's name are for people.
std::string constant_of(const hal::PanelDesc& panel) {
    std::string name = panel.name;
    name.resize(std::min(name.size(), name.find(' ', name.find(' ') + 1)));
    for (char& c : name)
        c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

/// The first panel with this controller. It stands for what all panels with the controller have in common.
const hal::PanelDesc& base_of(hal::Controller controller) {
    for (const hal::PanelDesc* panel : hal::panels::all)
        if (panel->controller == controller)
            return *panel;
    return *hal::panels::all[0];
}

const char* name_of(hal::BusKind kind) {
    constexpr const char* names[] = {"spi4", "i8080", "i2c", "spi_start"};
    const auto index = static_cast<unsigned>(kind);
    return index < std::size(names) ? names[index] : names[0];
}

} // namespace

Guess first_guess(const hal::PanelDesc& like, hal::Extent glass) {
    Guess guess{base_of(like.controller)};
    guess.panel.memory = like.memory;
    guess.panel.glass = glass;
    guess.panel.offset = {};
    guess.panel.mount = 0;
    guess.panel.order = hal::ColorOrder::rgb;
    guess.panel.inverted = false;
    return guess;
}

WizardResult ask_until_right(const Guess& start, const Show& show, const AskFunction& ask) {
    WizardResult found{"", start};
    for (found.cards = 1; found.cards <= most_cards; ++found.cards) {
        found.error = show(found.guess);
        if (!found.error.empty())
            return found;
        switch (ask_all(found.guess, ask)) {
        case Verdict::right:
            return found;
        case Verdict::over:
            found.error = "the answers ended before the card looked right";
            return found;
        case Verdict::changed:
            break;
        }
    }
    found.error = "no setting makes these answers true; is the controller the right one?";
    return found;
}

struct RealPanel::Parts {
    struct Panel final : hal::PanelDisplay {
        using hal::PanelDisplay::PanelDisplay;
    };
    sim::Bookkeeping books;
    Panel display;
    Parts(hal::Bus& bus, const hal::PanelConfig& config)
        : books(config), display(bus, config, books.memory()) {}
};

RealPanel::RealPanel(hal::Bus& bus, const hal::PanelConfig& config)
    : parts_(std::make_unique<Parts>(bus, config)) {}
RealPanel::~RealPanel() = default;

hal::PanelDisplay& RealPanel::display() {
    return parts_->display;
}
const hal::PanelDisplay& RealPanel::display() const {
    return parts_->display;
}

/// Designated initialisers for the board's surface and wire, where these are not the usual ones.
std::string pixels_of(const hal::PanelConfig& display) {
    constexpr const char* formats[] = {"rgb565_be", "rgb565_le", "rgb888", "rgba8888", "rgb666",
                                       "rgb444",    "rgb332",    "grey4",  "mono",     "index8"};
    // The names have the order of hal::WireFormat.
    constexpr const char* wires[] = {"rgb565", "rgb666", "rgb444", "rgb332", "grey4", "mono"};
    static_assert(std::size(formats) == pixel_formats);
    std::string text;
    if (display.format != PixelFormat{})
        text += fmt::format(", .format = spangle::PixelFormat::{}",
                            formats[static_cast<unsigned>(display.format)]);
    if (display.wire.converts())
        text += fmt::format(", .wire = spangle::hal::wires::{}",
                            wires[static_cast<unsigned>(display.wire.format)]);
    return text;
}

std::string board_definition(const Guess& guess, const hal::Board& like) {
    const hal::PanelDesc& p = guess.panel;
    return fmt::format(R"(#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

inline constexpr spangle::hal::PanelDesc my_panel = [] {{
    spangle::hal::PanelDesc p = spangle::hal::panels::{};
    p.name = "my panel";
    p.memory = {{{}, {}}};
    p.glass = {{{}, {}}};
    p.offset = {{{}, {}}};
    p.mount = 0x{:02X};
    p.order = spangle::hal::ColorOrder::{};
    p.inverted = {};
    return p;
}}();

inline constexpr spangle::hal::Board my_board = spangle::hal::board({{
    .name = "my-board",
    .display = {{.panel = &my_panel, .orientation = {{spangle::hal::Rotation::r{}{}}}{}}},
    .bus = spangle::hal::BusKind::{},
    .write_hz = {},
    .read_hz = {},
}});
)",
                       constant_of(base_of(p.controller)), p.memory.width, p.memory.height, p.glass.width,
                       p.glass.height, p.offset.x, p.offset.y, p.mount,
                       p.order == hal::ColorOrder::rgb ? "rgb" : "bgr", p.inverted ? "true" : "false",
                       90 * static_cast<unsigned>(guess.orientation.rotation),
                       guess.orientation.mirrored ? ", true" : "", pixels_of(like.display), name_of(like.bus),
                       like.write_hz, like.read_hz);
}

} // namespace spangle::bringup
