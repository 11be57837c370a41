// A display module wired to a machine: which of its pins hangs on which line of a GPIO chip or an adapter.
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

/// Lines by pin; `open`: nothing is soldered there.
struct ModuleWiring {
    static constexpr unsigned open = ~0u;

    enum class Bus { spi4, spi3, parallel8, parallel16 };
    Bus bus = Bus::spi4;
    unsigned reset = open, backlight = open, te = open;
    unsigned select = open; ///< open: always selected, unless an SPI controller drives it
    unsigned data_command = open;
    unsigned clock = open;              ///< SCK, or WRX
    unsigned answer = open;             ///< SDO, or RDX
    std::array<unsigned, 16> data = {}; ///< D0 and up; serial: SDA in the first
};

class PanelModule {
  public:
    /// The lines of `header` end at this module's pins.
    PanelModule(const hal::PanelDesc& panel, const ModuleWiring& wiring, PinHeader& header, Kernel& kernel);
    PanelModule(const PanelModule&) = delete;
    PanelModule& operator=(const PanelModule&) = delete;

    Controller& controller() { return *controller_; }
    /// A DCS panel's, which tells more.
    DcsController& dcs() { return dynamic_cast<DcsController&>(*controller_); }
    /// For an SPI controller that drives clock, select and data itself.
    SerialPins& serial() { return *serial_; }
    bool backlit() const { return backlit_; }

    /// Everything forgotten, noise in the memory.
    void power_cycle();
    /// The TE line is broken, or whole again.
    void cut_te(bool cut) { te_cut_ = cut; }
    /// What is seen, upright, two refreshes from now.
    Image glass(hal::Orientation orientation);
    std::string violations_text() const;

  private:
    const hal::PanelDesc& panel_;
    ModuleWiring wiring_;
    Kernel& kernel_;
    std::unique_ptr<Controller> controller_;
    std::optional<SerialPins> serial_;
    std::optional<ParallelPins> parallel_;
    bool backlit_ = false, te_cut_ = false;

    bool is_parallel() const {
        return wiring_.bus == ModuleWiring::Bus::parallel8 || wiring_.bus == ModuleWiring::Bus::parallel16;
    }
    void lines_changed(std::uint64_t levels, Time now);
    void serial_changed(std::uint64_t levels, Time now);
    void parallel_changed(std::uint64_t levels, Time now);
    bool input(unsigned line, Time now);
};

} // namespace spangle::sim
