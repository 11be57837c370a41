// What the controllers of OLED glass share: command bytes that are followed by so many parameters, a memory
// of cells, and lines of glass that are driven from it. What a command does is each family's own.
#pragma once

#include <span>

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

/// A command, `count` of them from `first` on, and the parameters that follow.
struct OledCommand {
    std::uint8_t first = 0, count = 1, parameters = 0;
};

/// What a chip is, as data.
struct OledChip {
    const char* name;
    int width, height; ///< of the memory, in cells
    std::span<const OledCommand> commands{};
    bool parameters_are_data = false; ///< D/C is high for parameters, else low as for the command
    unsigned reset_low_us = 3;
    unsigned reset_to_command_us = 0;
    unsigned serial_write_ns,
        serial_write_got_ns; ///< shortest clock: rated, and what modules are known to take
    unsigned parallel_write_ns = 300;
    unsigned i2c_ns = 0; ///< 0: has no I2C
};

/// How its bytes arrive.
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
    // These chips tell nobody where they scan; what is seen follows the memory at once.
    Time line_time() const final { return 1; }
    Time refresh_time() const final { return 0; }

  protected:
    const OledChip chip_;

    // What a family adds.
    virtual void power_on() = 0;
    virtual void execute(std::uint8_t command, std::span<const std::uint8_t> parameters, Time now) = 0;
    virtual void data(std::uint8_t byte, Time now) = 0;
    /// The next command, or the end of the look: what the stream of data left unfinished shows now.
    virtual void end_data(Time) {}
    /// The cell that lights this place of the glass; null: none does.
    struct Lit {
        bool dark = false; ///< nothing drives it
        Rgb666 color;
    };
    virtual Lit lit(int column, int line) const = 0;
    virtual Rgb666 cell(int column, int row) const = 0;

    /// A range of columns, rows or pages below `bound`, as commands give it; the pointer goes to its start.
    void set_range(int& first, int& last, int& at, std::span<const std::uint8_t> p, int bound, Time now);
    /// The first of a rule only, until the next command.
    void report_once(Rule rule, const std::string& text, Time at);

  private:
    OledBus bus_;
    bool selected_ = false, in_reset_ = false, write_too_fast_ = false;
    std::uint32_t reported_ = 0; ///< rules, a bit each
    Time reset_fell_at_ = 0, ready_at_ = 0;
    std::uint8_t command_ = 0, missing_ = 0;
    std::vector<std::uint8_t> parameters_;

    void begin(std::uint8_t command, Time now);
    void parameter(std::uint8_t byte, Time now);
    void check_clock(Time now, unsigned period_ns);
};

} // namespace spangle::sim
