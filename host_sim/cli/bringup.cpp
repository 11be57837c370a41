#include "host_sim/cli/bringup.hpp"

#include <cstdio>
#include <iostream>

#include <fmt/format.h>
#include <spangle/sim/board.hpp>
#include <unistd.h>

#include "host_sim/bringup/card.hpp"
#include "host_sim/bringup/probe.hpp"
#include "host_sim/bringup/wizard.hpp"
#include "host_sim/bringup/wrong.hpp"
#include "host_sim/cli/say.hpp"

namespace spangle::cli {
namespace {

hal::PanelConfig config_of(const bringup::Attachment& on, const bringup::Guess& guess) {
    hal::PanelConfig config = on.board.display;
    config.panel = &guess.panel;
    config.orientation = guess.orientation;
    config.buffers = 1;
    config.reset_line = on.reset;
    config.read_back = config.wait_te = config.poll_line = config.row_hash = config.scan_order = false;
    config.pacing = {};
    return config;
}

/// Sets up a display and shows the card on it, with the setting that `wrong` spoils. Returns what failed, or
/// an empty string.
std::string show_on(hal::Display& display, bool round, const bringup::Wrong& wrong) {
    if (const auto ready = display.init(); !ready)
        return ready.error().rule;
    const hal::DisplayInfo info = display.info();
    const auto sent = bringup::show(display, bringup::card(info.width, info.height, round), wrong.swapped);
    const auto shown = sent ? display.finish() : sent;
    return shown ? "" : shown.error().rule;
}

/// Shows the card on a display with the settings of `guess`. Returns what failed, or an empty string.
std::string show_card(const bringup::Attachment& on, const bringup::Guess& guess,
                      const bringup::Wrong& wrong) {
    if (on.display != nullptr)
        return show_on(*on.display, false, wrong);
    bringup::SpoiltBus bus(*on.bus, wrong.line);
    bringup::RealPanel stand(bus, config_of(on, guess));
    return show_on(stand.display(), guess.panel.round, wrong);
}

/// Why --shot cannot be used: only simulated glass has a picture.
const char* shot_flaw(const BringupOptions& options) {
    return !options.shot.empty() && options.bus.real()
               ? "--shot writes the simulated glass; a real one is for your eyes"
               : nullptr;
}

/// Waits, because a display on USB goes dark when the program ends that shows something on it.
void wait_for_enter(const char* what) {
    if (isatty(STDIN_FILENO) == 0)
        return;
    tell(std::string(what) + "; the Enter key ends it: ");
    std::string line;
    std::getline(std::cin, line);
}

/// Prints what a display on USB reports about itself.
int probe_gud(const bringup::Attachment& on) {
    if (const auto ready = on.display->init(); !ready)
        return refuse(ready.error().rule);
    const hal::DisplayInfo info = on.display->info();
    print("{} at {}: {}x{}\n", info.name, on.where, info.width, info.height);
    print("it describes itself: spangle card --gud, spangle run SCENE --gud\n");
    return 0;
}

/// Asks the I2C addresses of displays. Controllers on I2C are not read. Only their acknowledge shows that
/// they are present.
int probe_i2c(const BringupOptions& options) {
    bool heard = false;
    for (const unsigned address : {0x3Cu, 0x3Du}) {
        const bringup::I2cAnswer answer = bringup::ask_i2c(options.bus, address);
        if (!answer.error.empty())
            return refuse(answer.error);
        print("{:02X}h: {}\n", address, answer.heard ? "a controller acknowledges" : "nobody");
        heard = heard || answer.heard;
    }
    print_text(bringup::i2c_candidates());
    return heard ? 0 : not_done;
}

/// Shows the card on a display on USB, which has no settings to find, and prints what a program needs.
int wizard_gud(const bringup::Attachment& on) {
    if (const std::string problem = show_card(on, {}, bringup::nothing_wrong); !problem.empty())
        return refuse(problem);
    wait_for_enter("the test card is on the display; if it looks wrong, its firmware is what to change");
    print("#include <spangle/usb/gud_display.hpp>\n\nspangle::hal::GudDisplay display; // {}x{}, as its "
          "firmware says\n",
          on.display->info().width, on.display->info().height);
    return 0;
}

} // namespace

int probe(const BringupOptions& options) {
    if (!options.bus.i2c.empty())
        return probe_i2c(options);
    const bringup::Attachment on = bringup::attach(options.bus);
    if (!on.error.empty())
        return refuse(on.error);
    if (on.display != nullptr)
        return probe_gud(on);
    const bringup::Findings found = bringup::probe(*on.bus, on.reset);
    if (!found.error.empty())
        return refuse(found.error);
    print_text(bringup::text_of(found));
    return found.panels.empty() ? not_done : 0;
}

int card(const BringupOptions& options) {
    if (options.list_wrong) {
        for (const bringup::Wrong& wrong : bringup::wrongs())
            print("{}\t{}\n", wrong.name, wrong.fix);
        return 0;
    }
    const bringup::Wrong* const found = bringup::find_wrong(options.wrong);
    if (found == nullptr && !options.wrong.empty())
        return refuse("no setting '" + options.wrong + "'; `spangle card --list-wrong` lists them");
    if (found != nullptr && options.bus.gud)
        return refuse("--wrong spoils a panel's description, and a GUD display has none");
    if (const char* const rule = shot_flaw(options); rule != nullptr)
        return refuse(rule);
    sim::Output shot;
    if (const std::string problem = open(shot, "--shot", options.shot); !problem.empty())
        return refuse(problem);
    const bringup::Attachment on = bringup::attach(options.bus);
    if (!on.error.empty())
        return refuse(on.error);
    bringup::Guess guess{*on.board.display.panel, on.board.display.orientation};
    const bringup::Wrong& wrong = found != nullptr ? *found : bringup::nothing_wrong;
    wrong.spoil(guess);
    if (const std::string problem = show_card(on, guess, wrong); !problem.empty())
        return refuse(problem);
    if (on.display != nullptr)
        wait_for_enter("the test card is on the display");
    const std::string unwritten = shot.is_open() ? finish(shot, on.simulated->glass()) : "";
    return unwritten.empty() ? 0 : refuse(unwritten, not_done);
}

int wizard(const BringupOptions& options) {
    if (const char* const rule = shot_flaw(options); rule != nullptr)
        return refuse(rule);
    if (!options.shot.empty() && sim::is_standard_output(options.shot))
        return refuse("the definition is printed on standard output; --shot needs a file");
    const bringup::Attachment on = bringup::attach(options.bus);
    if (!on.error.empty())
        return refuse(on.error);
    if (on.display != nullptr)
        return wizard_gud(on);
    hal::Extent glass = on.board.display.panel->glass;
    int width = glass.width, height = glass.height;
    char rest = 0;
    if (!options.glass.empty() &&
        (std::sscanf(options.glass.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 ||
         height < 1 || width > 1024 || height > 1024))
        return refuse("--glass takes WIDTHxHEIGHT, each 1 to 1024, not '" + options.glass + "'");
    glass = {static_cast<std::int16_t>(width), static_cast<std::int16_t>(height)};
    const bringup::WizardResult found = bringup::ask_until_right(
        bringup::first_guess(*on.board.display.panel, glass),
        [&](const bringup::Guess& guess) {
            const std::string problem = show_card(on, guess, bringup::nothing_wrong);
            return problem.empty() && !options.shot.empty()
                       ? sim::write_png(on.simulated->glass(), options.shot)
                       : problem;
        },
        [](const std::string& question, std::string& answer) {
            tell(question + ": ");
            return static_cast<bool>(std::getline(std::cin, answer));
        });
    if (!found.error.empty())
        return refuse(found.error);
    print_text(bringup::board_definition(found.guess, on.board));
    return 0;
}

} // namespace spangle::cli
