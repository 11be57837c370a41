// The decoder of commands of a DCS controller, which reports the rules that they break.
#include "host_sim/controller/dcs_controller.hpp"

#include <algorithm>

namespace spangle::sim {

namespace {

constexpr Time us = 1000, ms = 1000 * us;

/// The number of parameters of a standard command. -1 stands for commands that are not checked: pixels, reads
/// and the maker's own.
int expected_parameters(std::uint8_t command) {
    switch (command) {
    case dcs::nop:
    case dcs::soft_reset:
    case dcs::sleep_in:
    case dcs::sleep_out:
    case dcs::partial_mode_on:
    case dcs::normal_mode_on:
    case dcs::inversion_off:
    case dcs::inversion_on:
    case dcs::display_off:
    case dcs::display_on:
    case dcs::tearing_line_off:
    case dcs::idle_mode_off:
    case dcs::idle_mode_on:
        return 0;
    case dcs::gamma_set:
    case dcs::tearing_line_on:
    case dcs::address_mode:
    case dcs::pixel_format:
    case dcs::brightness:
    case dcs::control_display:
    case dcs::adaptive_brightness:
        return 1;
    case dcs::scroll_start:
    case dcs::tearing_scanline:
        return 2;
    case dcs::column_address_set:
    case dcs::row_address_set:
    case dcs::partial_area:
        return 4;
    case dcs::scroll_area:
        return 6;
    default:
        return -1;
    }
}

} // namespace

DcsController::DcsController(const Chip& chip, const GlassMount& glass, bool parallel)
    : Controller(chip.name, glass), chip_(chip), is_parallel_(parallel),
      memory_(static_cast<std::size_t>(chip.width * chip.height)), scanned_memory_(memory_.size()) {
    PowerOnNoise noise;
    for (Rgb666& p : memory_) {
        const std::uint32_t n = noise.next();
        p = {static_cast<std::uint8_t>(n >> 26), static_cast<std::uint8_t>(n >> 20 & 63),
             static_cast<std::uint8_t>(n >> 14 & 63)};
    }
    power_on_registers();
}

void DcsController::power_on_registers() {
    is_awake_ = is_display_on_ = is_inverted_ = is_idle_ = is_partial_ = is_scrolling_ = has_te_ =
        te_with_hblank_ = false;
    madctl_ = 0;
    colmod_ = dcs::pixel_format_18_bits;
    te_line_ = 0;
    column_start_ = page_start_ = 0;
    column_end_ = chip_.width - 1;
    page_end_ = chip_.height - 1;
    partial_start_ = 0;
    partial_end_ = chip_.height - 1;
    scroll_top_ = scroll_start_ = 0;
    scroll_height_ = chip_.height;
    maker_registers_.clear();
    unlocked_keys_ = 0;
    has_command_ = false;
    pixel_byte_count_ = 0;
    forget_read();
}

// --- pins of the controller

void DcsController::reset(bool low, Time now) {
    if (low == is_in_reset_)
        return;
    scan_until(now);
    is_in_reset_ = low;
    if (low) {
        reset_fell_at_ = now;
        return;
    }
    if (now - reset_fell_at_ < 10 * us)
        report(Rule::reset_pulse, "reset was low for less than 10 us", now);
    power_on_registers();
    ready_at_ = now + chip_.reset_to_command_ms * ms;
    sleep_out_allowed_at_ = now + 120 * ms;
}

/// Raising CS between bytes ends no command, which is a fact of these controllers: parameters and pixels may
/// go on afterwards. It ends an answer, because the controller releases the data line.
void DcsController::select(bool chip_select, Time now) {
    is_selected_ = chip_select;
    if (chip_select)
        return;
    end_read(now);
    forget_read();
}

void DcsController::write(std::uint8_t byte, bool data, Time now, unsigned period_ns) {
    if (!is_selected_ || is_in_reset_)
        return;
    if (!data) {
        end_command(now);
        begin_command(byte, now);
    }
    check_write_clock(now, period_ns);
    if (!data)
        return;
    if (!has_command_)
        return;
    if (writes_memory())
        pixel_byte(byte, now);
    else
        parameter(byte, now);
}

/// Reports a clock that is too fast once per command: a frame at the wrong clock is one mistake.
void DcsController::check_write_clock(Time now, unsigned period_ns) {
    const unsigned shortest = is_parallel_ ? chip_.parallel_write_ns : chip_.serial_write_got_ns;
    if (period_ns >= shortest || has_written_too_fast_)
        return;
    has_written_too_fast_ = true;
    report(Rule::write_clock,
           "a write cycle of " + std::to_string(period_ns) + " ns; this controller takes " +
               std::to_string(shortest) + " ns",
           now);
}

// --- decoder of commands

void DcsController::begin_command(std::uint8_t command, Time now) {
    if (now < ready_at_)
        report(Rule::too_early,
               "command " + hex_text(command) + " before the reset or sleep change before it is over", now);
    has_command_ = true;
    command_ = command;
    parameters_.clear();
    parameter_count_ = 0;
    stream_pixels_ = stream_bytes_ = 0;
    pixel_byte_count_ = 0;
    has_torn_ = has_written_too_fast_ = false;
    if (writes_memory())
        begin_write(command == dcs::memory_write, now);
    else if (expected_parameters(command) == 0)
        execute(now);
    prepare_read(now);
}

/// Checks the previous command when the next one begins, because only then it is known what was left
/// unfinished.
void DcsController::end_command(Time now) {
    if (!has_command_)
        return;
    const int expected = expected_parameters(command_);
    if (expected >= 0 && parameter_count_ != static_cast<std::size_t>(expected))
        report(Rule::parameter_count,
               "command " + hex_text(command_) + " got " + std::to_string(parameter_count_) +
                   " parameters instead of " + std::to_string(expected),
               now);
    end_read(now);
    end_write(now);
    end_maker_register(now);
    turn_key();
}

/// Notes a key of the maker's registers. Keys count only in their order; turning a key again changes nothing.
void DcsController::turn_key() {
    bool wrong = false;
    for (int i = 0; i < chip_.key_count; ++i) {
        const Key& key = chip_.keys[static_cast<std::size_t>(i)];
        if (command_ != key.command)
            continue;
        if (std::equal(parameters_.begin(), parameters_.end(), key.parameters.begin(),
                       key.parameters.begin() + key.count)) {
            unlocked_keys_ = std::max(unlocked_keys_, i <= unlocked_keys_ ? i + 1 : 0);
            return;
        }
        wrong = true;
    }
    if (wrong)
        unlocked_keys_ = 0;
}

/// Keeps the parameters of a command from 60h on in the maker's register, or reports that the register is
/// locked.
void DcsController::end_maker_register(Time now) {
    if (command_ < dcs::first_vendor_command || parameters_.empty())
        return;
    for (int i = 0; i < chip_.key_count; ++i)
        if (command_ == chip_.keys[static_cast<std::size_t>(i)].command)
            return;
    if (unlocked_keys_ == chip_.key_count)
        maker_registers_[command_] = parameters_;
    else
        report(Rule::locked_register, "register " + hex_text(command_) + " was written without its key", now);
}

std::vector<std::uint8_t> DcsController::maker_register(std::uint8_t command) const {
    const auto found = maker_registers_.find(command);
    return found == maker_registers_.end() ? std::vector<std::uint8_t>{} : found->second;
}

void DcsController::parameter(std::uint8_t byte, Time now) {
    ++parameter_count_;
    if (parameters_.size() < 64)
        parameters_.push_back(byte);
    if (static_cast<int>(parameter_count_) == expected_parameters(command_))
        execute(now);
}

void DcsController::execute(Time now) {
    scan_until(now);
    const auto& p = parameters_;
    const auto word = [&p](std::size_t i) { return p[i] << 8 | p[i + 1]; };
    switch (command_) {
    case dcs::soft_reset: // SWRESET resets registers only; the memory stays
        if (!is_awake_)
            sleep_out_allowed_at_ = std::max(sleep_out_allowed_at_, now + 5 * ms);
        else
            sleep_out_allowed_at_ = now + 120 * ms;
        power_on_registers();
        has_command_ = true;
        ready_at_ = now + 5 * ms;
        break;
    case dcs::sleep_in:
        if (now < sleep_in_allowed_at_)
            report(Rule::too_early, "SLPIN less than 120 ms after SLPOUT", now);
        is_awake_ = false;
        ready_at_ = now + 5 * ms;
        sleep_out_allowed_at_ = now + 120 * ms;
        break;
    case dcs::sleep_out:
        if (now < sleep_out_allowed_at_)
            report(Rule::too_early, "SLPOUT less than 120 ms after SLPIN or reset", now);
        is_awake_ = true;
        ready_at_ = now + 5 * ms;
        sleep_in_allowed_at_ = now + 120 * ms;
        break;
    case dcs::partial_mode_on:
        is_partial_ = true;
        break;
    case dcs::normal_mode_on:
        is_partial_ = is_scrolling_ = false;
        break;
    case dcs::inversion_off:
        is_inverted_ = false;
        break;
    case dcs::inversion_on:
        is_inverted_ = true;
        break;
    case dcs::display_off:
        is_display_on_ = false;
        break;
    case dcs::display_on:
        is_display_on_ = true;
        break;
    case dcs::column_address_set:
        set_window(true, now);
        break;
    case dcs::row_address_set:
        set_window(false, now);
        break;
    case dcs::partial_area:
        partial_start_ = word(0);
        partial_end_ = word(2);
        break;
    case dcs::scroll_area:
        if (word(0) + word(2) + word(4) != chip_.height) {
            report(Rule::window, "VSCRDEF: the three areas must add up to the memory's height", now);
            break;
        }
        scroll_top_ = word(0);
        scroll_height_ = word(2);
        break;
    case dcs::tearing_line_off:
        has_te_ = false;
        break;
    case dcs::tearing_line_on:
        has_te_ = true;
        te_with_hblank_ = (p[0] & 1) != 0;
        break;
    case dcs::address_mode:
        madctl_ = p[0];
        break;
    case dcs::scroll_start:
        scroll_start_ = word(0);
        is_scrolling_ = true;
        break;
    case dcs::idle_mode_off:
        is_idle_ = false;
        break;
    case dcs::idle_mode_on:
        is_idle_ = true;
        break;
    case dcs::pixel_format:
        colmod_ = p[0];
        pixel_byte_count_ = 0;
        if (static_cast<unsigned>(format()) != (colmod_ & 7u))
            report(Rule::color_format, "COLMOD " + hex_text(colmod_) + " names no format of this controller",
                   now);
        break;
    case dcs::tearing_scanline:
        te_line_ = word(0);
        break;
    default:
        break;
    }
}

void DcsController::set_window(bool columns, Time now) {
    const int start = parameters_[0] << 8 | parameters_[1];
    int end = parameters_[2] << 8 | parameters_[3];
    const bool exchanged = (madctl_ & dcs::rows_and_columns_exchanged) != 0;
    const int bound = columns != exchanged ? chip_.width : chip_.height;
    if (start > end || end >= bound)
        report(Rule::window,
               std::string(columns ? "CASET " : "RASET ") + std::to_string(start) + ".." +
                   std::to_string(end) + " of " + std::to_string(bound),
               now);
    if (end >= bound && chip_.out_of_range_clamps)
        end = bound - 1;
    (columns ? column_start_ : page_start_) = start;
    (columns ? column_end_ : page_end_) = end;
}

} // namespace spangle::sim
