// Finds the data of a panel from what a person sees. It shows the test card, asks questions, and corrects the
// data until the card looks right.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <spangle/hal/board.hpp>
#include <spangle/hal/panel_display.hpp>

namespace spangle::bringup {

/// The assumed properties of a module: the description of its panel, and how the picture is turned.
struct Guess {
    hal::PanelDesc panel;
    hal::Orientation orientation{};
};

struct WizardResult {
    std::string error; ///< what went wrong; empty: the card looks right with `guess`
    Guess guess;
    int cards = 0; ///< number of cards shown
};

/// The first guess about a controller, before any property of its glass is known.
Guess first_guess(const hal::PanelDesc& like, hal::Extent glass);

/// Shows the card according to this guess. Returns why it cannot, or an empty string.
using Show = std::function<std::string(const Guess&)>;
/// Asks a question, and takes the answer. Returns false when nobody answers any more.
using AskFunction = std::function<bool(const std::string& question, std::string& answer)>;

WizardResult ask_until_right(const Guess& start, const Show& show, const AskFunction& ask);

/// A display of this guess on a bus. It lives as long as this object.
class RealPanel {
  public:
    RealPanel(hal::Bus& bus, const hal::PanelConfig& config);
    ~RealPanel();
    RealPanel(const RealPanel&) = delete;
    RealPanel& operator=(const RealPanel&) = delete;
    hal::PanelDisplay& display();
    const hal::PanelDisplay& display() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Writes the source of a header that describes the board that was found.
std::string board_definition(const Guess& guess, const hal::Board& like);

} // namespace spangle::bringup
