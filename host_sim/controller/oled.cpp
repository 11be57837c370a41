#include "host_sim/controller/oled.hpp"

namespace spangle::sim {

OledController::OledController(const OledChip& chip, const GlassMount& glass, OledBus bus)
    : Controller(chip.name, glass), chip_(chip), bus_(bus) {}

void OledController::reset(bool low, Time now) {
    if (low == is_in_reset_)
        return;
    is_in_reset_ = low;
    if (low) {
        reset_fell_at_ = now;
        return;
    }
    if (now - reset_fell_at_ < Time{chip_.reset_low_us} * 1000)
        report(Rule::reset_pulse, "reset was low for less than " + std::to_string(chip_.reset_low_us) + " us",
               now);
    missing_parameters_ = 0;
    ready_at_ = now + Time{chip_.reset_to_command_us} * 1000;
    power_on();
}

/// Raising CS between bytes ends no command: parameters and data may go on afterwards.
void OledController::select(bool chip_select, Time) {
    is_selected_ = chip_select;
}

void OledController::write(std::uint8_t byte, bool data_byte, Time now, unsigned period_ns) {
    if (!is_selected_ || is_in_reset_)
        return;
    const bool is_parameter = missing_parameters_ != 0 && data_byte == chip_.parameters_are_data;
    if (missing_parameters_ != 0 && !is_parameter) {
        report(Rule::parameter_count,
               "command " + hex_text(command_) + " still waits for " + std::to_string(missing_parameters_) +
                   " parameters",
               now);
        missing_parameters_ = 0;
    }
    if (!is_parameter && !data_byte)
        begin(byte, now);
    check_clock(now, period_ns);
    if (is_parameter)
        parameter(byte, now);
    else if (data_byte)
        data(byte, now);
}

void OledController::begin(std::uint8_t command, Time now) {
    end_data(now);
    if (now < ready_at_)
        report(Rule::too_early, "command " + hex_text(command) + " before the reset is over", now);
    command_ = command;
    parameters_.clear();
    reported_rules_ = 0;
    has_written_too_fast_ = false;
    for (const OledCommand& known : chip_.commands)
        if (command >= known.first && command - known.first < known.count) {
            missing_parameters_ = known.parameters;
            if (missing_parameters_ == 0)
                execute(command, {}, now);
            return;
        }
    report(Rule::parameter_count,
           hex_text(command) + " is no command of this controller: is a byte missing, or one too many?", now);
}

void OledController::parameter(std::uint8_t byte, Time now) {
    parameters_.push_back(byte);
    if (--missing_parameters_ == 0)
        execute(command_, parameters_, now);
}

/// Reports a clock that is too fast once per command: a frame at the wrong clock is one mistake.
void OledController::check_clock(Time now, unsigned period_ns) {
    const unsigned shortest = bus_ == OledBus::serial     ? chip_.serial_write_got_ns
                              : bus_ == OledBus::parallel ? chip_.parallel_write_ns
                                                          : chip_.i2c_ns;
    if (period_ns >= shortest || has_written_too_fast_)
        return;
    has_written_too_fast_ = true;
    report(Rule::write_clock,
           "a write cycle of " + std::to_string(period_ns) + " ns; this controller takes " +
               std::to_string(shortest) + " ns",
           now);
}

void OledController::report_once(Rule rule, const std::string& text, Time at) {
    const std::uint32_t bit = 1u << static_cast<unsigned>(rule);
    if ((reported_rules_ & bit) == 0)
        report(rule, text, at);
    reported_rules_ |= bit;
}

void OledController::set_range(int& first, int& last, int& at, std::span<const std::uint8_t> p, int bound,
                               Time now) {
    if (p[0] > p[1] || p[1] >= bound) {
        report(Rule::window,
               "range " + std::to_string(p[0]) + ".." + std::to_string(p[1]) + " of " + std::to_string(bound),
               now);
        return;
    }
    first = at = p[0];
    last = p[1];
}

std::vector<Rgb666> OledController::cells() const {
    std::vector<Rgb666> out;
    for (int row = 0; row < chip_.height; ++row)
        for (int column = 0; column < chip_.width; ++column)
            out.push_back(cell(column, row));
    return out;
}

std::vector<Rgb666> OledController::glass(Time) {
    std::vector<Rgb666> picture;
    for (int y = 0; y < glass_.height; ++y)
        for (int x = 0; x < glass_.width; ++x) {
            const Lit place = lit(glass_.x + (glass_.mirror_columns ? glass_.width - 1 - x : x),
                                  glass_.y + (glass_.mirror_rows ? glass_.height - 1 - y : y));
            Rgb666 p = place.dark ? Rgb666{} : place.color;
            if (glass_.bgr_filter)
                std::swap(p.r, p.b);
            picture.push_back(p);
        }
    return picture;
}

} // namespace spangle::sim
