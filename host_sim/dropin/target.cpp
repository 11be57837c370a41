#include "host_sim/dropin/target.hpp"

#include <csignal>

#include <pthread.h>

namespace spangle::dropin {

namespace {

/// Blocks signals while it lives, so that threads made meanwhile take none: signals are meant for the
/// program.
class SignalBlock {
  public:
    SignalBlock() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalBlock() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalBlock(const SignalBlock&) = delete;
    SignalBlock& operator=(const SignalBlock&) = delete;

  private:
    sigset_t before_;
};

} // namespace

std::string Target::open(const bringup::BusOptions& bus, const hal::Board& board) {
    const SignalBlock quiet;
    attachment_ = bringup::attach(bus, board);
    if (!attachment_.error.empty())
        return attachment_.error;
    hal::Display* display = attachment_.display.get();
    if (attachment_.simulated != nullptr) {
        display = &attachment_.simulated->display();
    } else if (display == nullptr) {
        attachment_.board.display.reset_line = attachment_.reset;
        counted_bus_.emplace(*attachment_.bus);
        real_panel_.emplace(*counted_bus_, attachment_.board.display);
        display = &real_panel_->display();
    }
    if (const auto up = display->init(); !up.ok())
        return up.error().rule;
    display_ = display;
    before_ = counters();
    started_ = Clock::now();
    return "";
}

void Target::close() {
    if (attachment_.simulated != nullptr)
        return;
    display_ = nullptr;
    real_panel_.reset();
    counted_bus_.reset();
    attachment_ = {};
}

sim::BoardCounters Target::counters() const {
    if (attachment_.simulated != nullptr)
        return attachment_.simulated->counters();
    sim::BoardCounters out;
    if (counted_bus_) {
        out.bytes = counted_bus_->bytes();
        out.commands = counted_bus_->commands();
        out.pixel_bytes = counted_bus_->pixel_bytes();
    }
    return out;
}

std::string Target::figures() const {
    std::string text;
    const auto number = [&text](const char* name, auto value) {
        text += std::string(name) + ' ' + std::to_string(value) + '\n';
    };
    const sim::BoardCounters now = counters();
    number("bus_bytes", now.bytes - before_.bytes);
    number("bus_pixel_bytes", now.pixel_bytes - before_.pixel_bytes);
    number("bus_commands", now.commands - before_.commands);
    number("busy_ns", now.busy_ns - before_.busy_ns);
    const hal::DisplayInfo info = display_->info();
    if (attachment_.display != nullptr) {
        text += "board GUD display " + std::to_string(info.width) + 'x' + std::to_string(info.height) + '\n';
        number("wire_bits", 8 * format_info(info.format).bytes_per_pixel);
    } else {
        text += std::string("board ") + attachment_.board.name + '\n';
        number("wire_bits", hal::wire_info(hal::wire_format(attachment_.board.display)).bits);
    }
    if (attachment_.simulated == nullptr) {
        text += "where " + attachment_.where + '\n';
        number("shown_ns",
               std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - started_).count());
    } else if (const std::string broken = attachment_.simulated->violations_text(); !broken.empty()) {
        text += "violations\n" + broken;
    }
    return text;
}

} // namespace spangle::dropin
