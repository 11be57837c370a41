#include "host_sim/controller/dcs_controller.hpp"

#include <algorithm>
#include <cstdio>

namespace spangle::sim {

namespace {

constexpr Time us = 1000, ms = 1000 * us;

/// Parameters of the commands of the standard; -1: not checked (pixels, reads, makers' own).
int expected_parameters(std::uint8_t command) {
    switch (command) {
    case 0x00:
    case 0x01:
    case 0x10:
    case 0x11:
    case 0x12:
    case 0x13:
    case 0x20:
    case 0x21:
    case 0x28:
    case 0x29:
    case 0x34:
    case 0x38:
    case 0x39:
        return 0;
    case 0x26:
    case 0x35:
    case 0x36:
    case 0x3A:
    case 0x51:
    case 0x53:
    case 0x55:
        return 1;
    case 0x37:
    case 0x44:
        return 2;
    case 0x2A:
    case 0x2B:
    case 0x30:
        return 4;
    case 0x33:
        return 6;
    default:
        return -1;
    }
}

std::string hex(unsigned v) {
    char text[8];
    std::snprintf(text, sizeof text, "%02Xh", v);
    return text;
}

bool is_write(std::uint8_t command) {
    return command == 0x2C || command == 0x3C;
}

} // namespace

DcsController::DcsController(const Chip& chip, const GlassMount& glass, bool parallel)
    : chip_(chip), glass_(glass), parallel_(parallel),
      memory_(static_cast<std::size_t>(chip.width * chip.height)), shown_(memory_.size()) {
    // What memory holds at power-on is anybody's guess; noise makes a forgotten clear visible.
    std::uint32_t noise = 12345;
    for (Rgb666& p : memory_) {
        noise = noise * 1664525u + 1013904223u;
        p = {static_cast<std::uint8_t>(noise >> 26), static_cast<std::uint8_t>(noise >> 20 & 63),
             static_cast<std::uint8_t>(noise >> 14 & 63)};
    }
    power_on_registers();
}

void DcsController::power_on_registers() {
    awake_ = on_ = inverted_ = idle_ = partial_ = scrolling_ = te_on_ = te_with_hblank_ = false;
    madctl_ = 0;
    colmod_ = 0x66;
    te_line_ = 0;
    xs_ = ys_ = 0;
    xe_ = chip_.width - 1;
    ye_ = chip_.height - 1;
    partial_start_ = 0;
    partial_end_ = chip_.height - 1;
    scroll_top_ = scroll_start_ = 0;
    scroll_height_ = chip_.height;
    makers_.clear();
    keys_turned_ = 0;
    has_command_ = false;
    pixel_fill_ = 0;
    forget_read();
}

void DcsController::report(Rule rule, const std::string& text, Time at) {
    violations_.push_back({rule, std::string(chip_.name) + ": " + text, at});
}

// --- pins

void DcsController::reset(bool low, Time now) {
    if (low == in_reset_)
        return;
    scan_until(now);
    in_reset_ = low;
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

/// Between bytes a raised CS ends no command (a fact of these controllers): parameters and pixels may go on.
/// It does end an answer: the line is let go.
void DcsController::select(bool chip_select, Time now) {
    selected_ = chip_select;
    if (chip_select)
        return;
    end_read(now);
    forget_read();
}

void DcsController::write(std::uint8_t byte, bool data, Time now, unsigned period_ns) {
    if (!selected_ || in_reset_)
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
    if (is_write(command_))
        pixel_byte(byte, now);
    else
        parameter(byte, now);
}

/// Once a command: a frame at the wrong clock is one mistake.
void DcsController::check_write_clock(Time now, unsigned period_ns) {
    const unsigned shortest = parallel_ ? chip_.parallel_write_ns : chip_.serial_write_got_ns;
    if (period_ns >= shortest || write_too_fast_)
        return;
    write_too_fast_ = true;
    report(Rule::write_clock,
           "a write cycle of " + std::to_string(period_ns) + " ns; this controller takes " +
               std::to_string(shortest) + " ns",
           now);
}

// --- commands

void DcsController::begin_command(std::uint8_t command, Time now) {
    if (now < ready_at_)
        report(Rule::too_early,
               "command " + hex(command) + " before the reset or sleep change before it is over", now);
    has_command_ = true;
    command_ = command;
    parameters_.clear();
    parameter_count_ = 0;
    stream_pixels_ = stream_bytes_ = 0;
    pixel_fill_ = 0;
    stream_tore_ = write_too_fast_ = false;
    if (is_write(command))
        begin_write(command == 0x2C, now);
    else if (expected_parameters(command) == 0)
        execute(now);
    prepare_read(now);
}

/// The next command ends the one before: what it left unfinished shows now.
void DcsController::end_command(Time now) {
    if (!has_command_)
        return;
    const int expected = expected_parameters(command_);
    if (expected >= 0 && parameter_count_ != static_cast<std::size_t>(expected))
        report(Rule::parameter_count,
               "command " + hex(command_) + " got " + std::to_string(parameter_count_) +
                   " parameters instead of " + std::to_string(expected),
               now);
    end_read(now);
    end_write(now);
    end_maker_register(now);
    turn_key();
}

/// Keys count in their order; one that is turned again changes nothing.
void DcsController::turn_key() {
    bool wrong = false;
    for (int i = 0; i < chip_.key_count; ++i) {
        const Key& key = chip_.keys[static_cast<std::size_t>(i)];
        if (command_ != key.command)
            continue;
        if (std::equal(parameters_.begin(), parameters_.end(), key.parameters.begin(),
                       key.parameters.begin() + key.count)) {
            keys_turned_ = std::max(keys_turned_, i <= keys_turned_ ? i + 1 : 0);
            return;
        }
        wrong = true;
    }
    if (wrong)
        keys_turned_ = 0;
}

/// From 60h on commands are the maker's; behind a lock they are lost.
void DcsController::end_maker_register(Time now) {
    if (command_ < 0x60 || parameters_.empty())
        return;
    for (int i = 0; i < chip_.key_count; ++i)
        if (command_ == chip_.keys[static_cast<std::size_t>(i)].command)
            return;
    if (keys_turned_ == chip_.key_count)
        makers_[command_] = parameters_;
    else
        report(Rule::locked_register, "register " + hex(command_) + " was written without its key", now);
}

std::vector<std::uint8_t> DcsController::maker_register(std::uint8_t command) const {
    const auto found = makers_.find(command);
    return found == makers_.end() ? std::vector<std::uint8_t>{} : found->second;
}

/// Exactly the dummy clocks are missing: the host took the first of them for data. (More clocks than an
/// answer has are no fault: some hosts read whole bytes and shift.)
void DcsController::end_read(Time now) {
    if (!answering_ || read_dummies_ == 0 || read_clocks_ == 0)
        return;
    const std::uint64_t pixel = reads_565() ? 16 : 24;
    const bool slipped = reads_memory()
                             ? read_clocks_ % pixel == 0 && (read_clocks_ - read_dummies_) % pixel != 0
                             : read_clocks_ + read_dummies_ == read_bits_.size();
    if (slipped)
        report(Rule::read, "command " + hex(command_) + " was read without its dummy clocks", now);
}

void DcsController::end_write(Time now) {
    if (!is_write(command_) || stream_bytes_ == 0)
        return;
    const std::uint64_t window = window_pixels();
    for (const unsigned other : {2u, 3u})
        if (bytes_of(window) != window * other && stream_bytes_ == window * other) {
            report(Rule::color_format,
                   "the window was filled with " + std::to_string(other) + " bytes a pixel, COLMOD is " +
                       hex(colmod_),
                   now);
            return;
        }
    // Two bytes of 12-bit pixels are one pixel and the latched half of a pair: the end of an odd count.
    const bool half = format() == Format::rgb444 ? pixel_fill_ == 1 : pixel_fill_ != 0;
    if (half)
        report(Rule::half_pixel, "the pixel stream ended inside a pixel: one byte slipped", now);
    if (stream_pixels_ % window != 0 || stream_pixels_ > window)
        report(Rule::pixel_count,
               std::to_string(stream_pixels_) + " pixels were sent to a window of " + std::to_string(window),
               now);
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
    case 0x01: // SWRESET: registers only; the memory stays
        if (!awake_)
            sleep_out_allowed_at_ = std::max(sleep_out_allowed_at_, now + 5 * ms);
        else
            sleep_out_allowed_at_ = now + 120 * ms;
        power_on_registers();
        has_command_ = true;
        ready_at_ = now + 5 * ms;
        break;
    case 0x10:
        if (now < sleep_in_allowed_at_)
            report(Rule::too_early, "SLPIN less than 120 ms after SLPOUT", now);
        awake_ = false;
        ready_at_ = now + 5 * ms;
        sleep_out_allowed_at_ = now + 120 * ms;
        break;
    case 0x11:
        if (now < sleep_out_allowed_at_)
            report(Rule::too_early, "SLPOUT less than 120 ms after SLPIN or reset", now);
        awake_ = true;
        ready_at_ = now + 5 * ms;
        sleep_in_allowed_at_ = now + 120 * ms;
        break;
    case 0x12:
        partial_ = true;
        break;
    case 0x13:
        partial_ = scrolling_ = false;
        break;
    case 0x20:
        inverted_ = false;
        break;
    case 0x21:
        inverted_ = true;
        break;
    case 0x28:
        on_ = false;
        break;
    case 0x29:
        on_ = true;
        break;
    case 0x2A:
        set_window(true, now);
        break;
    case 0x2B:
        set_window(false, now);
        break;
    case 0x30:
        partial_start_ = word(0);
        partial_end_ = word(2);
        break;
    case 0x33:
        if (word(0) + word(2) + word(4) != chip_.height) {
            report(Rule::window, "VSCRDEF: the three areas must add up to the memory's height", now);
            break;
        }
        scroll_top_ = word(0);
        scroll_height_ = word(2);
        break;
    case 0x34:
        te_on_ = false;
        break;
    case 0x35:
        te_on_ = true;
        te_with_hblank_ = (p[0] & 1) != 0;
        break;
    case 0x36:
        madctl_ = p[0];
        break;
    case 0x37:
        scroll_start_ = word(0);
        scrolling_ = true;
        break;
    case 0x38:
        idle_ = false;
        break;
    case 0x39:
        idle_ = true;
        break;
    case 0x3A:
        colmod_ = p[0];
        pixel_fill_ = 0;
        if (static_cast<unsigned>(format()) != (colmod_ & 7u))
            report(Rule::color_format, "COLMOD " + hex(colmod_) + " names no format of this controller", now);
        break;
    case 0x44:
        te_line_ = word(0);
        break;
    default:
        break;
    }
}

void DcsController::set_window(bool columns, Time now) {
    const int start = parameters_[0] << 8 | parameters_[1];
    int end = parameters_[2] << 8 | parameters_[3];
    const bool exchanged = (madctl_ & 0x20) != 0;
    const int bound = columns != exchanged ? chip_.width : chip_.height;
    if (start > end || end >= bound)
        report(Rule::window,
               std::string(columns ? "CASET " : "RASET ") + std::to_string(start) + ".." +
                   std::to_string(end) + " of " + std::to_string(bound),
               now);
    if (end >= bound && chip_.out_of_range_clamps)
        end = bound - 1;
    (columns ? xs_ : ys_) = start;
    (columns ? xe_ : ye_) = end;
}

// --- pixels

/// COLMOD values that name no format have been reported; the model goes on with 16 bits, or with 18 where
/// this bus has no other.
DcsController::Format DcsController::format() const {
    const unsigned takes = parallel_ ? chip_.parallel_depths : chip_.serial_depths, asked = colmod_ & 7u;
    if ((takes >> asked & 1u) != 0)
        return static_cast<Format>(asked);
    return (takes & depths({5})) != 0 ? Format::rgb565 : Format::rgb666;
}

std::uint64_t DcsController::bytes_of(std::uint64_t pixels) const {
    switch (format()) {
    case Format::rgb444:
        return (pixels * 3 + 1) / 2;
    case Format::rgb565:
        return pixels * 2;
    default:
        return pixels * 3;
    }
}

std::uint64_t DcsController::window_pixels() const {
    return xs_ > xe_ || ys_ > ye_
               ? 1
               : static_cast<std::uint64_t>(xe_ - xs_ + 1) * static_cast<std::uint64_t>(ye_ - ys_ + 1);
}

/// Host address to memory cell (ST7735R datasheet 9.11; the others alike).
bool DcsController::locate(int x, int y, int& column, int& row) const {
    const int c = (madctl_ & 0x20) != 0 ? y : x, r = (madctl_ & 0x20) != 0 ? x : y;
    column = (madctl_ & 0x40) != 0 ? chip_.width - 1 - c : c;
    row = (madctl_ & 0x80) != 0 ? chip_.height - 1 - r : r;
    return column >= 0 && column < chip_.width && row >= 0 && row < chip_.height;
}

void DcsController::begin_write(bool restart, Time now) {
    scan_until(now);
    if (!awake_)
        report(Rule::write_in_sleep, "RAMWR while asleep", now);
    if (restart) {
        x_ = xs_;
        y_ = ys_;
    }
    int c0, r0, c1, r1;
    const bool inside = locate(xs_, ys_, c0, r0) && locate(xe_, ye_, c1, r1);
    if (!inside)
        return; // CASET or RASET has been reported
    const auto [left, right] = std::minmax(c0, c1);
    const auto [top, bottom] = std::minmax(r0, r1);
    if (left < glass_.x || right >= glass_.x + glass_.width || top < glass_.y ||
        bottom >= glass_.y + glass_.height)
        report(Rule::window,
               "the window reaches memory that no glass shows: columns " + std::to_string(left) + ".." +
                   std::to_string(right) + ", rows " + std::to_string(top) + ".." + std::to_string(bottom),
               now);
}

void DcsController::pixel_byte(std::uint8_t byte, Time now) {
    ++stream_bytes_;
    pixel_bytes_[static_cast<std::size_t>(pixel_fill_++)] = byte;
    const Format f = format();
    const int whole = f == Format::rgb565 ? 2 : 3;
    if (f == Format::rgb444 && pixel_fill_ == 2) // RRRRGGGG BBBBRRRR GGGGBBBB
        put_pixel(decode(0), now);
    if (pixel_fill_ < whole)
        return;
    pixel_fill_ = 0;
    put_pixel(decode(3), now);
}

/// `nibble`: where the red of a 12-bit pixel stands.
Rgb666 DcsController::decode(int nibble) const {
    const auto six = [](int v) { return static_cast<std::uint8_t>(v & 63); };
    if (format() == Format::rgb666)
        return {six(pixel_bytes_[0] >> 2), six(pixel_bytes_[1] >> 2), six(pixel_bytes_[2] >> 2)};
    if (format() == Format::rgb444) {
        const auto four = [this, six](int n) {
            const int v = pixel_bytes_[static_cast<std::size_t>(n / 2)] >> (n % 2 == 0 ? 4 : 0) & 15;
            return six(v << 2 | v >> 2);
        };
        return {four(nibble), four(nibble + 1), four(nibble + 2)};
    }
    const int word = pixel_bytes_[0] << 8 | pixel_bytes_[1];
    const int green = word >> 5 & 63, low = chip_.low_bit_from_green ? green & 1 : 0;
    return {six(word >> 11 << 1 | low), six(green), six((word & 31) << 1 | low)};
}

void DcsController::put_pixel(Rgb666 color, Time now) {
    int column, row;
    if (locate(x_, y_, column, row)) {
        if (te_on_ && !stream_tore_ && on_ && stream_pixels_ != 0) {
            // The beam stands in this row: above it is new, below it old.
            const int line = scan_line(now);
            if (line == row && line > 0 && x_ == xs_) {
                stream_tore_ = true;
                report(Rule::tear,
                       "the write crossed the scan line at row " + std::to_string(row) + ", frame " +
                           std::to_string(frames_scanned(now)),
                       now);
            }
        }
        if (stream_pixels_ % 64 == 0)
            scan_until(now);
        memory_[static_cast<std::size_t>(row * chip_.width + column)] = color;
        ++pixels_written_;
    }
    ++stream_pixels_;
    if (++x_ <= xe_)
        return;
    x_ = xs_;
    if (++y_ > ye_)
        y_ = ys_;
}

// --- reading

void DcsController::push_read(std::initializer_list<std::uint8_t> bytes, int dummy_bits) {
    // On a parallel bus one dummy byte, on a serial one as many clocks as the chip takes to turn the line
    // round.
    const int dummies = parallel_ ? 8 : dummy_bits;
    answering_ = true;
    read_dummies_ = static_cast<std::size_t>(dummies);
    read_bits_.assign(read_dummies_, false);
    push_bytes(bytes.begin(), bytes.size());
    read_at_ = 0;
}

void DcsController::push_bytes(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        for (int bit = 7; bit >= 0; --bit)
            read_bits_.push_back((bytes[i] >> bit & 1) != 0);
}

void DcsController::forget_read() {
    read_bits_.clear();
    read_at_ = read_dummies_ = 0;
    read_clocks_ = 0;
    answering_ = read_too_fast_ = false;
}

void DcsController::prepare_read(Time now) {
    forget_read();
    const auto bit = [](bool on, int position) { return static_cast<unsigned>(on ? 1 : 0) << position; };
    const auto byte = [](unsigned v) { return static_cast<std::uint8_t>(v); };
    switch (command_) {
    case 0x04:
        push_read({chip_.id[0], chip_.id[1], chip_.id[2]}, chip_.register_dummy_bits);
        break;
    case 0x09: {
        const unsigned format = (colmod_ & 7u) << 20;
        const unsigned s = bit(awake_, 31) | bit(madctl_ & 0x80, 30) | bit(madctl_ & 0x40, 29) |
                           bit(madctl_ & 0x20, 28) | bit(madctl_ & 0x10, 27) | bit(madctl_ & 8, 26) |
                           bit(madctl_ & 4, 25) | format | bit(idle_, 19) | bit(partial_, 18) |
                           bit(awake_, 17) | bit(!partial_, 16) | bit(scrolling_, 15) | bit(inverted_, 13) |
                           bit(on_, 10) | bit(te_on_, 9) | bit(te_with_hblank_, 5);
        push_read({byte(s >> 24), byte(s >> 16), byte(s >> 8), byte(s)}, chip_.register_dummy_bits);
        break;
    }
    case 0x0A:
        push_read({byte(bit(awake_, 7) | bit(idle_, 6) | bit(partial_, 5) | bit(awake_, 4) |
                        bit(!partial_, 3) | bit(on_, 2))},
                  0);
        break;
    case 0x0B:
        push_read({madctl_}, 0);
        break;
    case 0x0C:
        push_read({byte(colmod_ & 0x77u)}, 0);
        break;
    case 0x0D:
        push_read({byte(bit(scrolling_, 7) | bit(inverted_, 5))}, 0);
        break;
    case 0x0E:
        push_read({byte(bit(te_on_, 7) | bit(te_with_hblank_, 6))}, 0);
        break;
    case 0x0F:
        push_read({byte(awake_ ? 0xC0 : 0x00)}, 0);
        break;
    case 0x45: {
        const int line = scan_line(now);
        push_read({byte(static_cast<unsigned>(line) >> 8), byte(static_cast<unsigned>(line))},
                  chip_.register_dummy_bits);
        break;
    }
    case 0x2E:
        read_x_ = xs_;
        read_y_ = ys_;
        [[fallthrough]];
    case 0x3E:
        push_read({}, chip_.pixel_dummy_bits);
        break;
    case 0xDA:
    case 0xDB:
    case 0xDC:
        push_read({chip_.id[command_ - 0xDAu]}, 0);
        break;
    default:
        if (const MakerId& own = chip_.maker_id; own.command != 0 && command_ == own.command) {
            push_read({}, own.dummy_bits);
            push_bytes(own.bytes.data(), own.count);
        }
        break;
    }
}

/// Three bytes a pixel, six bits left aligned, whatever COLMOD says; some answer as they were written.
void DcsController::push_pixels() {
    int column, row;
    Rgb666 p;
    if (locate(read_x_, read_y_, column, row))
        p = memory_[static_cast<std::size_t>(row * chip_.width + column)];
    const int word = p.r >> 1 << 11 | p.g << 5 | p.b >> 1;
    const std::array<int, 3> six_each{p.r << 2, p.g << 2, p.b << 2}, as_written{word >> 8, word & 255, 0};
    std::array<std::uint8_t, 3> bytes{};
    for (std::size_t i = 0; i < 3; ++i)
        bytes[i] = static_cast<std::uint8_t>(reads_565() ? as_written[i] : six_each[i]);
    push_bytes(bytes.data(), reads_565() ? 2 : 3);
    if (++read_x_ <= xe_)
        return;
    read_x_ = xs_;
    if (++read_y_ > ye_)
        read_y_ = ys_;
}

bool DcsController::drive_bit() {
    if (!answers())
        return false;
    if (read_at_ >= read_bits_.size()) {
        read_bits_.clear();
        read_at_ = 0;
        push_pixels();
    }
    return read_bits_[read_at_++];
}

void DcsController::read_clock(Time now, unsigned period_ns) {
    ++read_clocks_;
    const unsigned shortest = parallel_ ? chip_.parallel_read_ns : chip_.serial_read_ns;
    if (period_ns >= shortest || read_too_fast_)
        return;
    read_too_fast_ = true;
    report(Rule::read,
           "read with a cycle of " + std::to_string(period_ns) + " ns; this controller answers in " +
               std::to_string(shortest) + " ns",
           now);
}

bool DcsController::read_bit(Time now, unsigned period_ns) {
    const bool bit = drive_bit();
    read_clock(now, period_ns);
    return bit;
}

std::uint8_t DcsController::read_byte(Time now, unsigned period_ns) {
    unsigned byte = 0;
    for (int i = 0; i < 8; ++i)
        byte = byte << 1 | (read_bit(now, period_ns) ? 1u : 0u);
    return static_cast<std::uint8_t>(byte);
}

// --- scan-out

/// The native row being scanned; rows from chip height on are blanking.
int DcsController::scan_line(Time now) const {
    return static_cast<int>(now % frame_ns() / chip_.line_ns);
}

std::uint64_t DcsController::frames_scanned(Time now) const {
    return now / frame_ns();
}

bool DcsController::te(Time now) {
    scan_until(now);
    if (!te_on_ || !awake_)
        return false;
    const int line = scan_line(now);
    if (te_line_ != 0)
        return line == te_line_;
    const bool hblank = te_with_hblank_ && now % chip_.line_ns > chip_.line_ns * 9 / 10;
    return line >= chip_.height || hblank;
}

void DcsController::scan_row(int row) {
    if (row == 0)
        modes_ = {awake_ && on_, partial_, scrolling_, idle_, partial_start_, partial_end_, scroll_start_};
    const auto cell = [this](int r) { return &memory_[static_cast<std::size_t>(r * chip_.width)]; };
    Rgb666* const out = &shown_[static_cast<std::size_t>(row * chip_.width)];
    const bool outside_wraps = modes_.partial_start > modes_.partial_end;
    const bool in_partial = outside_wraps ? row >= modes_.partial_start || row <= modes_.partial_end
                                          : row >= modes_.partial_start && row <= modes_.partial_end;
    if (!modes_.visible || (modes_.partial && !in_partial)) {
        std::fill(out, out + chip_.width, Rgb666{});
        return;
    }
    int source = row;
    if (modes_.scrolling && row >= scroll_top_ && row < scroll_top_ + scroll_height_ && scroll_height_ > 0) {
        const int moved = (row - scroll_top_ + modes_.scroll_start - scroll_top_) % scroll_height_;
        source = scroll_top_ + (moved < 0 ? moved + scroll_height_ : moved);
    }
    std::copy(cell(source), cell(source) + chip_.width, out);
    if (modes_.idle)
        for (int c = 0; c < chip_.width; ++c) {
            const auto one = [](int v) { return static_cast<std::uint8_t>(v >= 32 ? 63 : 0); };
            out[c] = {one(out[c].r), one(out[c].g), one(out[c].b)};
        }
}

void DcsController::scan_until(Time now) {
    if (now <= scanned_to_)
        return;
    const Time line = chip_.line_ns;
    Time at = scanned_to_ / line, end = now / line;
    const Time lines = frame_ns() / line;
    if (end - at > 2 * lines)
        at = end - 2 * lines; // older frames have been overwritten
    for (; at < end; ++at)
        if (const auto row = static_cast<int>((at + 1) % lines); row < chip_.height)
            scan_row(row);
    scanned_to_ = now;
}

std::vector<Rgb666> DcsController::glass(Time now) {
    scan_until(now);
    std::vector<Rgb666> picture;
    picture.reserve(static_cast<std::size_t>(glass_.width * glass_.height));
    const bool complement = inverted_ != glass_.normally_inverted;
    const bool exchange = ((madctl_ & 0x08) != 0) != glass_.bgr_filter;
    for (int y = 0; y < glass_.height; ++y)
        for (int x = 0; x < glass_.width; ++x) {
            const int column = glass_.x + (glass_.mirror_columns ? glass_.width - 1 - x : x);
            const int row = glass_.y + (glass_.mirror_rows ? glass_.height - 1 - y : y);
            Rgb666 p = shown_[static_cast<std::size_t>(row * chip_.width + column)];
            if (modes_.visible && complement)
                p = {static_cast<std::uint8_t>(63 - p.r), static_cast<std::uint8_t>(63 - p.g),
                     static_cast<std::uint8_t>(63 - p.b)};
            if (exchange)
                std::swap(p.r, p.b);
            picture.push_back(p);
        }
    return picture;
}

} // namespace spangle::sim
