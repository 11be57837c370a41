// The common part of controllers of OLED glass: commands with a fixed number of parameters, a memory of
// cells, and lines of glass that are driven from it. Each family adds the effects of its commands.
#pragma once

#include <span>

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

/// `count` commands from `first` on, each of which takes `parameters` bytes of parameters.
struct OledCommand {
    std::uint8_t first = 0, count = 1, parameters = 0;
};

/// The properties of a controller chip, as data.
struct OledChip {
    const char* name;
    int width, height; ///< size of the memory, in cells
    std::span<const OledCommand> commands{};
    bool parameters_are_data = false; ///< D/C is high for parameters, else low as for commands
    unsigned reset_low_us = 3;
    unsigned reset_to_command_us = 0;
    unsigned serial_write_ns,
        serial_write_got_ns; ///< shortest clock period, ns: as rated, and as modules are known to take
    unsigned parallel_write_ns = 300;
    unsigned i2c_ns = 0; ///< shortest clock period of I2C, ns; 0: the chip has no I2C
};

/// The kind of bus on which bytes arrive.
enum class OledBus : std::uint8_t { serial, parallel, i2c };

class OledController : public Controller {
  public:
    OledController(const OledChip& chip, const GlassMount& glass, OledBus bus);

    void reset(bool low, Time now) final;
    void select(bool chip_select, Time now) final;
    void write(std::uint8_t byte, bool data, Time now, unsigned period_ns) final;

    std::vector<Rgb666> glass(Time now) final;
    std::vector<Rgb666> cells() const final;
    MemorySize memory_size() const final { return {chip_.width, chip_.height}; }
    // These chips do not tell the host which row they scan; a viewer sees the memory at once.
    Time line_time() const final { return 1; }
    Time refresh_time() const final { return 0; }

  protected:
    const OledChip chip_;

    // --- what a family adds
    virtual void power_on() = 0;
    virtual void execute(std::uint8_t command, std::span<const std::uint8_t> parameters, Time now) = 0;
    virtual void data(std::uint8_t byte, Time now) = 0;
    /// Reports data that the stream left unfinished, when the next command begins or the picture is taken.
    virtual void end_data(Time) {}
    /// How a place of the glass is lit.
    struct Lit {
        bool dark = false; ///< no line drives this place
        Rgb666 color;
    };
    virtual Lit lit(int column, int line) const = 0;
    virtual Rgb666 cell(int column, int row) const = 0;

    /// Takes the range of a command, columns, rows or pages below `bound`, and sets the pointer to its start.
    void set_range(int& first, int& last, int& at, std::span<const std::uint8_t> p, int bound, Time now);
    /// Reports only the first violation of a rule until the next command.
    void report_once(Rule rule, const std::string& text, Time at);

  private:
    OledBus bus_;
    bool is_selected_ = false, is_in_reset_ = false, has_written_too_fast_ = false;
    std::uint32_t reported_rules_ = 0; ///< rules already reported, bit 1 << rule each
    Time reset_fell_at_ = 0, ready_at_ = 0;
    std::uint8_t command_ = 0, missing_parameters_ = 0;
    std::vector<std::uint8_t> parameters_;

    void begin(std::uint8_t command, Time now);
    void parameter(std::uint8_t byte, Time now);
    void check_clock(Time now, unsigned period_ns);
};

} // namespace spangle::sim
