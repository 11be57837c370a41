#include "host_sim/dropin/target.hpp"

#include <csignal>

#include <pthread.h>

namespace spangle::dropin {

namespace {

/// Blocks signals while it lives, so that threads made meanwhile take none: signals are meant for the
/// program.
class WithoutSignals {
  public:
    WithoutSignals() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    WithoutSignals(const WithoutSignals&) = delete;
    WithoutSignals& operator=(const WithoutSignals&) = delete;

  private:
    sigset_t before_;
};

} // namespace

std::string Target::open(const bringup::BusOptions& bus, const hal::Board& board) {
    const WithoutSignals quiet;
    attached_ = bringup::attach(bus, board);
    if (!attached_.error.empty())
        return attached_.error;
    hal::Display* display = attached_.display.get();
    if (attached_.simulated != nullptr) {
        display = &attached_.simulated->display();
    } else if (display == nullptr) {
        attached_.board.display.reset_line = attached_.reset;
        counted_.emplace(*attached_.bus);
        stand_.emplace(*counted_, attached_.board.display);
        display = &stand_->display();
    }
    if (const auto up = display->init(); !up.ok())
        return up.error().rule;
    display_ = display;
    before_ = counters();
    started_ = Clock::now();
    return "";
}

void Target::close() {
    if (attached_.simulated != nullptr)
        return;
    display_ = nullptr;
    stand_.reset();
    counted_.reset();
    attached_ = {};
}

sim::BoardCounters Target::counters() const {
    if (attached_.simulated != nullptr)
        return attached_.simulated->counters();
    sim::BoardCounters out;
    if (counted_) {
        out.bytes = counted_->bytes();
        out.commands = counted_->commands();
        out.pixel_bytes = counted_->pixel_bytes();
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
    if (attached_.display != nullptr) {
        text += "board GUD display " + std::to_string(info.width) + 'x' + std::to_string(info.height) + '\n';
        number("wire_bits", 8 * format_info(info.format).bytes_per_pixel);
    } else {
        text += std::string("board ") + attached_.board.name + '\n';
        number("wire_bits", hal::wire_info(hal::wire_format(attached_.board.display)).bits);
    }
    if (attached_.simulated == nullptr) {
        text += "where " + attached_.where + '\n';
        number("shown_ns",
               std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - started_).count());
    } else if (const std::string broken = attached_.simulated->violations_text(); !broken.empty()) {
        text += "violations\n" + broken;
    }
    return text;
}

} // namespace spangle::dropin
