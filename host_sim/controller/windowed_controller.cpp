#include "host_sim/controller/windowed_controller.hpp"

#include <algorithm>

namespace spangle::sim {
namespace {

constexpr OledCommand ssd1327_commands[] = {
    {0x15, 1, 2}, {0x75, 1, 2},                // set the window's columns and rows
    {0x2E, 2, 0}, {0x81, 1, 1},  {0xA0, 3, 1}, // scrolling off, on; set contrast; remap, start line, offset
    {0xA4, 4, 0}, {0xA8, 1, 1},  {0xAB, 1, 1}, // set normal, all on, all off, inverse; multiplex; regulator
    {0xAE, 2, 0}, {0xB1, 1, 1},  {0xB3, 1, 1}, // switch display off, on; set phases, clock
    {0xB6, 1, 1}, {0xB8, 1, 15}, {0xB9, 1, 0}, // set second precharge, a grey table, the linear table
    {0xBC, 1, 1}, {0xBE, 1, 1},  {0xD5, 1, 1}, {0xFD, 1, 1},
};
constexpr OledCommand ssd0323_commands[] = {
    {0x15, 1, 2}, {0x75, 1, 2}, {0x81, 1, 1}, {0x84, 3, 0}, // set current ranges (84h to 86h)
    {0xA0, 3, 1}, {0xA4, 4, 0}, {0xA8, 1, 1}, {0xAD, 1, 1}, //
    {0xAE, 2, 0}, {0xB0, 4, 1}, {0xB8, 1, 8}, {0xBC, 1, 1}, //
    {0xBE, 2, 1}, {0xE3, 1, 0}, {0xF0, 1, 1},
};
constexpr OledCommand ssd1351_commands[] = {
    {0x15, 1, 2}, {0x75, 1, 2}, {0x5C, 1, 0},  {0x96, 1, 5}, // set columns, rows; write pixels; set scrolling
    {0x9E, 2, 0}, {0xA0, 3, 1}, {0xA4, 4, 0},  {0xAB, 1, 1}, //
    {0xAE, 2, 0}, {0xB1, 1, 1}, {0xB2, 1, 3},  {0xB3, 1, 1}, //
    {0xB4, 1, 3}, {0xB5, 2, 1}, {0xB8, 1, 63}, {0xB9, 1, 0}, //
    {0xBB, 1, 1}, {0xBE, 1, 1}, {0xC1, 1, 3},  {0xC7, 1, 1}, //
    {0xCA, 1, 1}, {0xFD, 1, 1},
};
constexpr OledCommand ssd1331_commands[] = {
    {0x15, 1, 2}, {0x75, 1, 2}, {0x21, 1, 7},  {0x22, 1, 10}, {0x23, 1, 6}, // set columns, rows; draw; copy
    {0x24, 2, 4}, {0x26, 1, 1}, {0x27, 1, 5},  {0x2E, 2, 0}, // dim, clear a box; switch filling, scrolling
    {0x81, 3, 1}, {0x87, 1, 1}, {0x8A, 3, 1},  {0xA0, 3, 1}, //
    {0xA4, 4, 0}, {0xA8, 1, 1}, {0xAB, 1, 5},  {0xAC, 1, 0}, // ABh sets and ACh enters dim mode
    {0xAD, 1, 1}, {0xAE, 2, 0}, {0xB0, 1, 1},                // set supply; switch off, on, power save
    {0xB1, 1, 1}, {0xB3, 1, 1}, {0xB8, 1, 32}, {0xB9, 1, 0}, //
    {0xBB, 1, 1}, {0xBE, 1, 1}, {0xE3, 1, 0},  {0xFD, 1, 1},
};
constexpr std::uint8_t ssd1351_locked[] = {0xA2, 0xB1, 0xB3, 0xBB, 0xBE, 0xC1};

} // namespace

const WindowedChip ssd1327 = {.chip = {.name = "SSD1327",
                                       .width = 128,
                                       .height = 128,
                                       .commands = ssd1327_commands,
                                       .serial_write_ns = 100,
                                       .serial_write_got_ns = 100,
                                       .i2c_ns = 2500},
                              .remap = {.vertical = 0x04,
                                        .columns = 0x01,
                                        .nibbles = 0x02,
                                        .order = 0,
                                        .com_reversed = 0x10,
                                        .com_split = 0x40},
                              .grey = true};
const WindowedChip ssd0323 = {.chip = {.name = "SSD0323",
                                       .width = 128,
                                       .height = 80,
                                       .commands = ssd0323_commands,
                                       .serial_write_ns = 250,
                                       .serial_write_got_ns = 250,
                                       .i2c_ns = 2500},
                              .remap = {.vertical = 0x04,
                                        .columns = 0x01,
                                        .nibbles = 0x02,
                                        .order = 0,
                                        .com_reversed = 0x10,
                                        .com_split = 0x40},
                              .grey = true,
                              .first_com = 4};
const WindowedChip ssd1351 = {
    .chip = {.name = "SSD1351",
             .width = 128,
             .height = 128,
             .commands = ssd1351_commands,
             .parameters_are_data = true,
             .serial_write_ns = 50,
             .serial_write_got_ns = 50},
    .remap = {.vertical = 0x01,
              .columns = 0x02,
              .nibbles = 0,
              .order = 0x04,
              .com_reversed = 0x10,
              .com_split = 0x20},
    .order_set_is_rgb = true,
    .stream_command = 0x5C,
    .multiplex_command = 0xCA,
    .shown = {DisplayMode::all_off, DisplayMode::all_on, DisplayMode::memory, DisplayMode::inverse},
    .offset_at_reset = 0x60,
    .lock_command = 0xFD,
    .unlock_all = 0xB1,
    .locked = ssd1351_locked};
const WindowedChip ssd1331 = {.chip = {.name = "SSD1331",
                                       .width = 96,
                                       .height = 64,
                                       .commands = ssd1331_commands,
                                       .serial_write_ns = 150,
                                       .serial_write_got_ns = 150},
                              .remap = {.vertical = 0x01,
                                        .columns = 0x02,
                                        .nibbles = 0,
                                        .order = 0x04,
                                        .com_reversed = 0x10,
                                        .com_split = 0x20},
                              .clear_command = 0x25};

WindowedController::WindowedController(const WindowedChip& chip, const GlassMount& glass, OledBus bus)
    : OledController(chip.chip, glass, bus), windowed_chip_(chip),
      memory_(static_cast<std::size_t>(chip.chip.width * chip.chip.height)) {
    PowerOnNoise noise;
    for (std::uint16_t& cell : memory_)
        cell = static_cast<std::uint16_t>(noise.next() >> (chip.grey ? 28 : 16));
    power_on();
}

void WindowedController::power_on() {
    remap_bits_ = windowed_chip_.grey ? 0 : 0x40;
    first_column_ = first_row_ = column_ = row_ = start_line_ = 0;
    last_column_ = address_count() - 1;
    last_row_ = chip_.height - 1;
    display_offset_ = windowed_chip_.offset_at_reset;
    multiplex_ratio_ = chip_.height;
    display_mode_ = DisplayMode::memory;
    is_display_on_ = is_streaming_ = is_scrolling_ = is_unlocked_ = false;
    pixel_byte_count_ = 0;
    stream_pixels_ = 0;
}

bool WindowedController::is_locked_out(std::uint8_t command) const {
    return std::find(windowed_chip_.locked.begin(), windowed_chip_.locked.end(), command) !=
           windowed_chip_.locked.end();
}

void WindowedController::execute(std::uint8_t command, std::span<const std::uint8_t> p, Time now) {
    if (now < busy_until_)
        report(Rule::busy, "command " + hex_text(command) + " while the controller draws", now);
    is_streaming_ = command == windowed_chip_.stream_command && command != 0;
    if (is_locked_out(command) && !is_unlocked_) {
        report(Rule::locked_register,
               "register " + hex_text(command) + " was written without the key that opens it", now);
        return;
    }
    if (command == windowed_chip_.lock_command && command != 0)
        is_unlocked_ = p[0] == windowed_chip_.unlock_all;
    if (command == windowed_chip_.multiplex_command)
        multiplex_ratio_ = std::min((p[0] & 127) + 1, chip_.height);
    if (command == windowed_chip_.clear_command && command != 0)
        clear(p, now);
    switch (command) {
    case 0x15:
        set_range(first_column_, last_column_, column_, p, address_count(), now);
        break;
    case 0x75:
        set_range(first_row_, last_row_, row_, p, chip_.height, now);
        break;
    case 0x2E:
    case 0x2F:
    case 0x9E:
    case 0x9F:
        is_scrolling_ = (command & 1) != 0;
        break;
    case 0xA0:
        remap_bits_ = p[0];
        if (!windowed_chip_.grey && (remap_bits_ & 0x80) != 0)
            report(Rule::color_format,
                   "A0h " + hex_text(remap_bits_) + ": three bytes a pixel are not modelled", now);
        break;
    case 0xA1:
        start_line_ = p[0] % chip_.height;
        break;
    case 0xA2:
        display_offset_ = p[0] % chip_.height;
        break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
        display_mode_ = windowed_chip_.shown[command - 0xA4u];
        break;
    case 0xAE:
    case 0xAF:
        is_display_on_ = command == 0xAF;
        break;
    default:
        break;
    }
}

std::uint64_t WindowedController::window() const {
    return static_cast<std::uint64_t>(last_column_ - first_column_ + 1) *
           static_cast<std::uint64_t>(last_row_ - first_row_ + 1);
}

void WindowedController::clear(std::span<const std::uint8_t> p, Time now) {
    constexpr Time engine_ns = 1'000'000; // what drivers wait; the datasheet names no time
    busy_until_ = now + engine_ns;
    for (int row = p[1]; row <= p[3] && row < chip_.height; ++row)
        for (int column = p[0]; column <= p[2] && column < chip_.width; ++column)
            memory_[index(column, row)] = 0;
}

void WindowedController::data(std::uint8_t byte, Time now) {
    if (windowed_chip_.stream_command != 0 && !is_streaming_) {
        report_once(Rule::parameter_count,
                    "data " + hex_text(byte) + " without the command that takes pixels", now);
        return;
    }
    if (is_scrolling_ || now < busy_until_)
        report_once(Rule::busy, "the memory is written while the controller moves or draws in it", now);
    if (!two_bytes())
        return put(byte, now);
    pixel_bytes_[static_cast<std::size_t>(pixel_byte_count_++)] = byte;
    if (pixel_byte_count_ < 2)
        return;
    pixel_byte_count_ = 0;
    put(static_cast<unsigned>(pixel_bytes_[0] << 8 | pixel_bytes_[1]), now);
}

/// Writes the value of one column address: two greys, or one colour.
void WindowedController::put(unsigned value, Time now) {
    if (++stream_pixels_ > window())
        report_once(Rule::pixel_count,
                    "more data than the window's " + std::to_string(window()) + " addresses hold", now);
    const int address = bit(windowed_chip_.remap.columns) ? address_count() - 1 - column_ : column_;
    const int left = windowed_chip_.grey ? 2 * address : address;
    if (left < glass_.x || left >= glass_.x + glass_.width || row_ < glass_.y ||
        row_ >= glass_.y + glass_.height)
        report_once(Rule::window,
                    "no glass at column " + std::to_string(left) + " of row " + std::to_string(row_), now);
    if (windowed_chip_.grey) {
        const bool swapped = bit(
            windowed_chip_.remap.nibbles); // if the bit is clear, the low nibble belongs to the lower segment
        memory_[index(left, row_)] = static_cast<std::uint16_t>(swapped ? value >> 4 : value & 15);
        memory_[index(left + 1, row_)] = static_cast<std::uint16_t>(swapped ? value & 15 : value >> 4);
    } else {
        // A pixel RRRGGGBB gives the upper bits of a component; its upper bits are repeated in the lower
        // ones.
        const unsigned r = value >> 5 & 7, g = value >> 2 & 7, b = value & 3;
        const unsigned wide = (r << 2 | r >> 1) << 11 | (g << 3 | g) << 5 | (b << 3 | b << 1 | b >> 1);
        memory_[index(left, row_)] = static_cast<std::uint16_t>(two_bytes() ? value : wide);
    }
    advance();
}

void WindowedController::advance() {
    const auto step = [](int& at, int first, int last) {
        at = at == last ? first : at + 1;
        return at == first;
    };
    if (bit(windowed_chip_.remap.vertical)) {
        if (step(row_, first_row_, last_row_))
            step(column_, first_column_, last_column_);
    } else if (step(column_, first_column_, last_column_)) {
        step(row_, first_row_, last_row_);
    }
}

/// Reports a stream that filled only a part of its window, or of a pixel. It leaves the pointer in the
/// middle, so a byte was lost.
void WindowedController::end_data(Time now) {
    if (pixel_byte_count_ != 0)
        report(Rule::half_pixel, "the pixel stream ended inside a pixel: one byte slipped", now);
    if (stream_pixels_ != 0 && stream_pixels_ % window() != 0)
        report_once(Rule::pixel_count,
                    std::to_string(stream_pixels_) + " addresses were written of a window of " +
                        std::to_string(window()),
                    now);
    pixel_byte_count_ = 0;
    stream_pixels_ = 0;
}

Rgb666 WindowedController::cell(int column, int row) const {
    const unsigned v = value(column, row);
    const auto six = [](unsigned bits) { return static_cast<std::uint8_t>(bits); };
    if (windowed_chip_.grey) {
        const std::uint8_t grey = six(v << 2 | v >> 2);
        return {grey, grey, grey};
    }
    return {six(v >> 11 << 1 | v >> 15), six(v >> 5 & 63), six((v & 31) << 1 | (v >> 4 & 1))};
}

/// The state of a pixel of the glass, whose even lines are on the COM pins of one side, and odd lines on
/// those of the other side.
OledController::Lit WindowedController::lit(int column, int line) const {
    if (!bit(windowed_chip_.remap.com_split))
        line = line / 2 + line % 2 * (glass_.height / 2);
    if (!is_display_on_ || line >= multiplex_ratio_)
        return {true, {}};
    const int driven = bit(windowed_chip_.remap.com_reversed) ? multiplex_ratio_ - 1 - line : line;
    Rgb666 p =
        cell(column, (driven + display_offset_ + start_line_ + windowed_chip_.first_com) % chip_.height);
    if (display_mode_ == DisplayMode::all_on || display_mode_ == DisplayMode::all_off) {
        const auto all = static_cast<std::uint8_t>(display_mode_ == DisplayMode::all_on ? 63 : 0);
        p = {all, all, all};
    }
    if (display_mode_ == DisplayMode::inverse)
        p = {static_cast<std::uint8_t>(63 - p.r), static_cast<std::uint8_t>(63 - p.g),
             static_cast<std::uint8_t>(63 - p.b)};
    if (!windowed_chip_.grey && bit(windowed_chip_.remap.order) != windowed_chip_.order_set_is_rgb)
        std::swap(p.r, p.b);
    return {false, p};
}

} // namespace spangle::sim
