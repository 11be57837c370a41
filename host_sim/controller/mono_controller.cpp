#include "host_sim/controller/mono_controller.hpp"

namespace spangle::sim {
namespace {

constexpr OledCommand ssd1306_commands[] = {
    {0x00, 32, 0},                                           // set the column in page mode by nibbles
    {0x20, 1, 1},  {0x21, 1, 2}, {0x22, 1, 2},               // set addressing mode, column and page range
    {0x26, 2, 6},  {0x29, 2, 5}, {0x2E, 2, 0},               // set, stop and start scrolling
    {0x40, 64, 0}, {0x81, 1, 1}, {0x8D, 1, 1},               // set start line, contrast, charge pump
    {0xA0, 2, 0},  {0xA3, 1, 2}, {0xA4, 4, 0}, {0xA8, 1, 1}, // set remap, scroll area, all on, inverse, ratio
    {0xAE, 2, 0},  {0xB0, 8, 0}, {0xC0, 1, 0}, {0xC8, 1, 0}, // switch off, on; set page, COM direction
    {0xD3, 1, 1},  {0xD5, 1, 1}, {0xD9, 1, 1}, {0xDA, 2, 1}, // set offset, clock, precharge, pins, VCOMH
    {0xE3, 1, 0},                                            // no operation
};
constexpr OledCommand sh1106_commands[] = {
    {0x00, 32, 0}, {0x30, 4, 0}, {0x40, 64, 0}, {0x81, 1, 1}, // set column, charge pump, start line, contrast
    {0xA0, 2, 0},  {0xA4, 4, 0}, {0xA8, 1, 1},  {0xAD, 1, 1}, // set remap, all on, inverse, multiplex, DC-DC
    {0xAE, 2, 0},  {0xB0, 8, 0}, {0xC0, 1, 0},  {0xC8, 1, 0}, //
    {0xD3, 1, 1},  {0xD5, 1, 1}, {0xD9, 1, 1},  {0xDA, 2, 1}, //
    {0xE0, 1, 0},  {0xE3, 1, 0}, {0xEE, 1, 0},                // read-modify-write, no operation, end of E0h
};
/// The commands that QEMU's model of the SSD0303 knows, and those of its family.
constexpr OledCommand ssd0303_commands[] = {
    {0x00, 32, 0}, {0x40, 64, 0}, {0x81, 1, 1}, {0xA0, 2, 0}, //
    {0xA4, 4, 0},  {0xA8, 1, 1},  {0xAD, 1, 1}, {0xAE, 2, 0}, //
    {0xB0, 8, 0},  {0xC0, 1, 0},  {0xC8, 1, 0}, {0xD3, 1, 1}, //
    {0xD5, 1, 1},  {0xD8, 1, 1},  {0xD9, 1, 1}, {0xDA, 2, 1}, //
    {0xE3, 1, 0},                                             //
};

} // namespace

const MonoChip ssd1306 = {.chip = {.name = "SSD1306",
                                   .width = 128,
                                   .height = 64,
                                   .commands = ssd1306_commands,
                                   .serial_write_ns = 100,
                                   .serial_write_got_ns = 50,
                                   .i2c_ns = 1000},
                          .pump_command = 0x8D,
                          .pump_bit = 0x04};
/// The converter of the SH1106 comes on with the panel; AD 8A turns it off.
const MonoChip sh1106 = {.chip = {.name = "SH1106",
                                  .width = 132,
                                  .height = 64,
                                  .commands = sh1106_commands,
                                  .serial_write_ns = 250,
                                  .serial_write_got_ns = 125,
                                  .i2c_ns = 2500},
                         .page_mode_only = true,
                         .pump_command = 0xAD,
                         .pump_bit = 0x01,
                         .pump_at_reset = true};
const MonoChip ssd0303 = {.chip = {.name = "SSD0303",
                                   .width = 132,
                                   .height = 64,
                                   .commands = ssd0303_commands,
                                   .serial_write_ns = 250,
                                   .serial_write_got_ns = 250,
                                   .i2c_ns = 2500},
                          .page_mode_only = true,
                          .pump_command = 0xAD,
                          .pump_bit = 0x01,
                          .pump_at_reset = true};

MonoController::MonoController(const MonoChip& chip, const GlassMount& glass, OledBus bus)
    : OledController(chip.chip, glass, bus), mono_(chip),
      memory_(static_cast<std::size_t>(chip.chip.width * chip.chip.height / 8)) {
    PowerOnNoise noise;
    for (std::uint8_t& byte : memory_)
        byte = static_cast<std::uint8_t>(noise.next() >> 24);
    power_on();
}

void MonoController::power_on() {
    mode_ = Mode::page;
    column_ = page_ = first_column_ = first_page_ = start_line_ = display_offset_ = 0;
    last_column_ = chip_.width - 1;
    last_page_ = pages() - 1;
    multiplex_ratio_ = chip_.height;
    is_segment_remapped_ = is_com_reversed_ = is_entirely_on_ = is_inverted_ = is_display_on_ =
        is_scrolling_ = is_read_modify_write_ = false;
    is_com_alternating_ = true;
    has_charge_pump_ = mono_.pump_at_reset;
    stream_bytes_ = 0;
}

void MonoController::execute(std::uint8_t command, std::span<const std::uint8_t> parameters, Time now) {
    if (!parameters.empty())
        return execute_with(command, parameters, now);
    const int low = command & 15;
    switch (command >> 4) {
    case 0x0:
    case 0x1:
        if (mode_ != Mode::page)
            report(Rule::window, "column " + hex_text(command) + " is heeded in page mode only", now);
        else
            column_ = command < 0x10 ? (column_ & 0xF0) | low : low << 4 | (column_ & 15);
        if (column_ >= chip_.width && command >= 0x10)
            report(Rule::window, "column " + std::to_string(column_) + " of " + std::to_string(chip_.width),
                   now);
        return;
    case 0x4:
    case 0x5:
    case 0x6:
    case 0x7:
        start_line_ = command & 63;
        return;
    case 0xB:
        if (mode_ != Mode::page)
            report(Rule::window, "page " + hex_text(command) + " is heeded in page mode only", now);
        else
            page_ = low;
        if (page_ >= pages())
            report(Rule::window, "page " + std::to_string(page_) + " of " + std::to_string(pages()), now);
        return;
    default:
        break;
    }
    switch (command) {
    case 0x2E:
    case 0x2F:
        is_scrolling_ = command == 0x2F;
        break;
    case 0xA0:
    case 0xA1:
        is_segment_remapped_ = command == 0xA1;
        break;
    case 0xA4:
    case 0xA5:
        is_entirely_on_ = command == 0xA5;
        break;
    case 0xA6:
    case 0xA7:
        is_inverted_ = command == 0xA7;
        break;
    case 0xAE:
    case 0xAF:
        is_display_on_ = command == 0xAF;
        break;
    case 0xC0:
    case 0xC8:
        is_com_reversed_ = command == 0xC8;
        break;
    case 0xE0:
        is_read_modify_write_ = true;
        read_modify_write_column_ = column_;
        break;
    case 0xEE:
        if (is_read_modify_write_)
            column_ = read_modify_write_column_;
        is_read_modify_write_ = false;
        break;
    default:
        break;
    }
}

void MonoController::execute_with(std::uint8_t command, std::span<const std::uint8_t> p, Time now) {
    if (command == mono_.pump_command)
        has_charge_pump_ = (p[0] & mono_.pump_bit) != 0;
    switch (command) {
    case 0x20:
        mode_ = static_cast<Mode>((p[0] & 3) < 3 ? p[0] & 3 : 2);
        break;
    case 0x21:
        set_range(first_column_, last_column_, column_, p, chip_.width, now);
        break;
    case 0x22:
        set_range(first_page_, last_page_, page_, p, pages(), now);
        break;
    case 0xA8:
        multiplex_ratio_ = (p[0] & 63) + 1;
        if (multiplex_ratio_ < 16)
            report(Rule::window, "a multiplex ratio of " + std::to_string(multiplex_ratio_) + " is below 16",
                   now);
        break;
    case 0xD3:
        display_offset_ = p[0] & 63;
        break;
    case 0xDA:
        is_com_alternating_ = (p[0] & 0x10) != 0;
        break;
    default:
        break;
    }
}

/// The number of bytes until the memory pointer is back where it began.
std::uint64_t MonoController::window() const {
    if (mode_ == Mode::page)
        return static_cast<std::uint64_t>(chip_.width);
    return static_cast<std::uint64_t>(last_column_ - first_column_ + 1) *
           static_cast<std::uint64_t>(last_page_ - first_page_ + 1);
}

/// Writes a byte of eight pixels. The remap of A1h changes where later bytes go, and moves nothing in memory.
void MonoController::data(std::uint8_t byte, Time now) {
    if (is_scrolling_)
        report_once(Rule::busy, "the memory is written while it scrolls", now);
    ++stream_bytes_;
    if (stream_bytes_ > window() || (mode_ == Mode::page && column_ >= chip_.width)) {
        report_once(Rule::pixel_count,
                    "more bytes than fit from the pointer on; the window has " + std::to_string(window()),
                    now);
    }
    column_ %= chip_.width;
    const int segment = is_segment_remapped_ ? chip_.width - 1 - column_ : column_;
    if (segment < glass_.x || segment >= glass_.x + glass_.width || page_ * 8 >= glass_.y + glass_.height)
        report_once(Rule::window,
                    "no glass at column " + std::to_string(segment) + " of page " + std::to_string(page_),
                    now);
    if (page_ < pages())
        memory_[static_cast<std::size_t>(page_ * chip_.width + segment)] = byte;
    advance();
}

void MonoController::advance() {
    switch (mode_) {
    case Mode::page:
        ++column_; // a column beyond the last is reported when another byte comes
        return;
    case Mode::horizontal:
        if (++column_ <= last_column_)
            return;
        column_ = first_column_;
        page_ = page_ >= last_page_ ? first_page_ : page_ + 1;
        return;
    case Mode::vertical:
        if (++page_ <= last_page_)
            return;
        page_ = first_page_;
        column_ = column_ >= last_column_ ? first_column_ : column_ + 1;
        return;
    }
}

/// Reports a stream that filled only a part of its window. It leaves the pointer in the middle of the window,
/// so a byte was lost.
void MonoController::end_data(Time now) {
    if (mode_ != Mode::page && stream_bytes_ != 0 && (column_ != first_column_ || page_ != first_page_))
        report_once(Rule::pixel_count,
                    std::to_string(stream_bytes_) + " bytes were sent to a window of " +
                        std::to_string(window()),
                    now);
    stream_bytes_ = 0;
}

bool MonoController::bit(int column, int row) const {
    return (memory_[static_cast<std::size_t>(row / 8 * chip_.width + column)] >> (row % 8) & 1) != 0;
}

Rgb666 MonoController::cell(int column, int row) const {
    return bit(column, row) ? Rgb666{63, 63, 63} : Rgb666{};
}

/// The state of a pixel of the glass. Glass of more than 32 rows has its even rows on the lower half of the
/// COM pins and its odd rows on the upper half. If DAh bit 4 sets another order of the pins, the rows appear
/// shuffled.
OledController::Lit MonoController::lit(int column, int line) const {
    const bool alternating = glass_.height > 32;
    if (is_com_alternating_ != alternating)
        line = is_com_alternating_ ? line % (chip_.height / 2) * 2 + line / (chip_.height / 2)
                                   : line / 2 + line % 2 * (chip_.height / 2);
    if (!is_display_on_ || (mono_.pump_command != 0 && !has_charge_pump_) || line >= multiplex_ratio_)
        return {true, {}};
    const int driven = is_com_reversed_ ? multiplex_ratio_ - 1 - line : line;
    const bool set = is_entirely_on_ ||
                     bit(column, (driven + display_offset_ + start_line_) % chip_.height) != is_inverted_;
    return {false, set ? Rgb666{63, 63, 63} : Rgb666{}};
}

} // namespace spangle::sim
