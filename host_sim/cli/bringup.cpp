#include "host_sim/cli/bringup.hpp"

#include <cstdio>
#include <iostream>

#include <fmt/format.h>
#include <spangle/sim/board.hpp>

#include "host_sim/bringup/card.hpp"
#include "host_sim/bringup/probe.hpp"
#include "host_sim/bringup/wizard.hpp"
#include "host_sim/bringup/wrong.hpp"

namespace spangle::cli {
namespace {

constexpr int bad_input = 2;

int refuse(const std::string& why) {
    fmt::print(stderr, "spangle: {}\n", why);
    return bad_input;
}

hal::PanelConfig config_of(const hal::Board& board, const bringup::Guess& guess) {
    hal::PanelConfig config = board.display;
    config.panel = &guess.panel;
    config.orientation = guess.orientation;
    config.buffers = 1;
    config.read_back = config.wait_te = config.poll_line = config.row_hash = config.scan_order = false;
    config.pacing = {};
    return config;
}

/// The card as `guess` has it, on the bus; empty, or why not. With a simulated board also its picture.
std::string show_card(const bringup::Attached& on, const bringup::Guess& guess, const bringup::Wrong& wrong,
                      const std::string& shot) {
    const hal::PanelConfig config = config_of(*on.board, guess);
    bringup::SpoiltBus bus(*on.bus, wrong.line);
    bringup::Stand stand(bus, config);
    if (const auto ready = stand.display().init(); !ready)
        return ready.error().rule;
    const hal::DisplayInfo info = stand.display().info();
    if (const auto sent =
            bringup::show(stand.display(), bringup::card(info.width, info.height), wrong.swapped);
        !sent)
        return sent.error().rule;
    return on.simulated && !shot.empty() ? sim::write_png(on.simulated->glass(), shot) : "";
}

} // namespace

int probe(const BringupOptions& options) {
    const bringup::Attached on = bringup::attach(options.bus);
    if (!on.error.empty())
        return refuse(on.error);
    const bringup::Findings found = bringup::probe(*on.bus, on.reset);
    if (!found.error.empty())
        return refuse(found.error);
    fmt::print("{}", bringup::text_of(found));
    return found.panels.empty() ? 1 : 0;
}

int card(const BringupOptions& options) {
    if (options.list_wrong) {
        for (const bringup::Wrong& wrong : bringup::wrongs())
            fmt::print("{}\t{}\n", wrong.name, wrong.fix);
        return 0;
    }
    const bringup::Wrong* const found = bringup::find_wrong(options.wrong);
    if (found == nullptr && !options.wrong.empty())
        return refuse("no setting '" + options.wrong + "'; `spangle card --list-wrong` lists them");
    const bringup::Attached on = bringup::attach(options.bus);
    if (!on.error.empty())
        return refuse(on.error);
    bringup::Guess guess{*on.board->display.panel, on.board->display.orientation};
    const bringup::Wrong& wrong = found != nullptr ? *found : bringup::nothing_wrong;
    wrong.spoil(guess);
    const std::string problem = show_card(on, guess, wrong, options.shot);
    return problem.empty() ? 0 : refuse(problem);
}

int wizard(const BringupOptions& options) {
    const bringup::Attached on = bringup::attach(options.bus);
    if (!on.error.empty())
        return refuse(on.error);
    hal::Extent glass = on.board->display.panel->glass;
    int width = glass.width, height = glass.height;
    char rest = 0;
    if (!options.glass.empty() &&
        (std::sscanf(options.glass.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 ||
         height < 1 || width > 1024 || height > 1024))
        return refuse("--glass takes WIDTHxHEIGHT, each 1 to 1024, not '" + options.glass + "'");
    glass = {static_cast<std::int16_t>(width), static_cast<std::int16_t>(height)};
    const bringup::Wizardry found = bringup::ask_until_right(
        bringup::first_guess(*on.board->display.panel, glass),
        [&](const bringup::Guess& guess) {
            return show_card(on, guess, bringup::nothing_wrong, options.shot);
        },
        [](const std::string& question, std::string& answer) {
            fmt::print(stderr, "{}: ", question);
            return static_cast<bool>(std::getline(std::cin, answer));
        });
    if (!found.error.empty())
        return refuse(found.error);
    fmt::print("{}", bringup::definition(found.guess, *on.board));
    return 0;
}

} // namespace spangle::cli
