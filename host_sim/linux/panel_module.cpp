#include "host_sim/linux/panel_module.hpp"

#include "host_sim/board/module.hpp"

namespace spangle::sim {
namespace {

bool high(std::uint64_t levels, unsigned line) {
    return (levels >> line & 1) != 0;
}

bool wired(unsigned line) {
    return line != ModuleWiring::open;
}

} // namespace

PanelModule::PanelModule(const hal::PanelDesc& panel, const ModuleWiring& wiring, PinHeader& header,
                         Kernel& kernel)
    : panel_(panel), wiring_(wiring), kernel_(kernel) {
    power_cycle();
    header.on_change = [this](std::uint64_t levels, Time now) { lines_changed(levels, now); };
    header.input = [this](unsigned line, Time now) { return input(line, now); };
    if (wired(wiring_.backlight))
        header.pulled_down |= std::uint64_t{1} << wiring_.backlight; // a backlight that nobody sets is off
}

void PanelModule::power_cycle() {
    controller_ = make_controller(panel_, is_parallel() ? hal::BusKind::i8080 : panel_.serial_bus);
    serial_pins_.emplace(*controller_, wiring_.bus == ModuleWiring::Bus::spi3);
    parallel_pins_.emplace(*controller_, wiring_.bus == ModuleWiring::Bus::parallel16 ? 16u : 8u);
    if (!wired(wiring_.select) && is_parallel())
        parallel_pins_->set(ParallelPins::Pin::select, false, kernel_.now());
    if (!wired(wiring_.select) && !is_parallel() && wired(wiring_.clock))
        serial_pins_->set(SerialPins::Pin::select, false, kernel_.now());
}

/// Passes changed lines on to the pins, data lines before clocks. By changing both in one system call the
/// host promises that their order does not matter.
void PanelModule::lines_changed(std::uint64_t levels, Time now) {
    if (wired(wiring_.backlight))
        has_backlight_ = high(levels, wiring_.backlight);
    if (is_parallel())
        parallel_changed(levels, now);
    else
        serial_changed(levels, now);
}

void PanelModule::serial_changed(std::uint64_t levels, Time now) {
    using Pin = SerialPins::Pin;
    const auto set = [&](Pin pin, unsigned line) {
        if (wired(line))
            serial_pins_->set(pin, high(levels, line), now);
    };
    set(Pin::reset, wiring_.reset);
    set(Pin::select, wiring_.select);
    set(Pin::data, wiring_.data_command);
    if (!wired(wiring_.clock))
        return;
    set(Pin::mosi, wiring_.data[0]);
    set(Pin::clock, wiring_.clock);
}

void PanelModule::parallel_changed(std::uint64_t levels, Time now) {
    using Pin = ParallelPins::Pin;
    const auto set = [&](Pin pin, unsigned line) {
        if (wired(line))
            parallel_pins_->set(pin, high(levels, line), now);
    };
    set(Pin::reset, wiring_.reset);
    set(Pin::select, wiring_.select);
    set(Pin::data, wiring_.data_command);
    unsigned value = 0;
    const unsigned lines = wiring_.bus == ModuleWiring::Bus::parallel16 ? 16 : 8;
    for (unsigned i = 0; i < lines; ++i)
        value |= (high(levels, wiring_.data[i]) ? 1u : 0u) << i;
    parallel_pins_->drive(value);
    set(Pin::write, wiring_.clock);
    set(Pin::read, wiring_.answer);
}

bool PanelModule::input(unsigned line, Time now) {
    if (line == wiring_.te)
        return !is_te_cut_ && controller_->te(now);
    if (!is_parallel())
        return serial_pins_->miso();
    for (unsigned i = 0; i < wiring_.data.size(); ++i)
        if (line == wiring_.data[i])
            return (parallel_pins_->answer() >> i & 1) != 0;
    return true;
}

Image PanelModule::glass(hal::Orientation orientation) {
    Controller& c = *controller_;
    kernel_.advance(2 * c.refresh_time());
    return upright(picture_of_glass(c, kernel_.now()), orientation);
}

std::string PanelModule::violations_text() const {
    return controller_->violations_text();
}

} // namespace spangle::sim
