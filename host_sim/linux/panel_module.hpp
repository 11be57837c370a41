// A display module wired to a machine: tells which of its pins hangs on which line of a GPIO chip or adapter.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <spangle/hal/board.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/bus/pin_header.hpp"
#include "host_sim/bus/pins.hpp"
#include "host_sim/controller/dcs_controller.hpp"
#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

/// The line of each pin; `open` means that nothing is soldered there.
struct ModuleWiring {
    static constexpr unsigned open = ~0u;

    enum class Bus { spi4, spi3, parallel8, parallel16 };
    Bus bus = Bus::spi4;
    unsigned reset = open, backlight = open, te = open;
    unsigned select = open; ///< if open, always selected unless an SPI controller drives it
    unsigned data_command = open;
    unsigned clock = open;              ///< SCK, or WRX on a parallel bus
    unsigned answer = open;             ///< SDO, or RDX on a parallel bus
    std::array<unsigned, 16> data = {}; ///< D0 and up; on a serial bus the first is SDA
};

class PanelModule {
  public:
    /// Connects the lines of `header` with this module's pins.
    PanelModule(const hal::PanelDesc& panel, const ModuleWiring& wiring, PinHeader& header, Kernel& kernel);
    PanelModule(const PanelModule&) = delete;
    PanelModule& operator=(const PanelModule&) = delete;

    Controller& controller() { return *controller_; }
    /// The controller of a DCS panel, which tells more than others.
    DcsController& dcs() { return dynamic_cast<DcsController&>(*controller_); }
    /// The serial pins, for an SPI controller that drives clock, select and data itself.
    SerialPins& serial() { return *serial_pins_; }
    bool is_backlight_on() const { return has_backlight_; }

    /// Turns the power off and on: all state is lost, and the memory holds noise.
    void power_cycle();
    /// Breaks the TE line, or mends it.
    void cut_te(bool cut) { is_te_cut_ = cut; }
    /// Returns the picture that a viewer sees two refreshes from now, upright.
    Image glass(hal::Orientation orientation);
    std::string violations_text() const;

  private:
    const hal::PanelDesc& panel_;
    ModuleWiring wiring_;
    Kernel& kernel_;
    std::unique_ptr<Controller> controller_;
    std::optional<SerialPins> serial_pins_;
    std::optional<ParallelPins> parallel_pins_;
    bool has_backlight_ = false, is_te_cut_ = false;

    bool is_parallel() const {
        return wiring_.bus == ModuleWiring::Bus::parallel8 || wiring_.bus == ModuleWiring::Bus::parallel16;
    }
    void lines_changed(std::uint64_t levels, Time now);
    void serial_changed(std::uint64_t levels, Time now);
    void parallel_changed(std::uint64_t levels, Time now);
    bool input(unsigned line, Time now);
};

} // namespace spangle::sim
