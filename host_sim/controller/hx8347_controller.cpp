#include "host_sim/controller/hx8347_controller.hpp"

#include <utility>

namespace spangle::sim {
namespace {

constexpr Time us = 1000, ms = 1000 * us;
constexpr unsigned serial_ns = 50, parallel_ns = 66, read_ns = 450;
constexpr std::uint8_t id = 0x47;

enum : std::uint8_t {
    ID = 0x00,
    WINDOW = 0x02,
    MEMORY_ACCESS = 0x16,
    PIXELS = 0x17,
    GRAM = 0x22,
    DISPLAY = 0x28
};
enum : std::uint8_t { MY = 0x80, MX = 0x40, MV = 0x20, BGR = 0x08 };

} // namespace

Hx8347Controller::Hx8347Controller(const GlassMount& glass, RegisterBus bus)
    : Controller("HX8347", glass), bus_(bus), memory_(static_cast<std::size_t>(width * height)) {
    PowerOnNoise noise;
    for (Rgb666& p : memory_) {
        const std::uint32_t n = noise.next();
        p = {static_cast<std::uint8_t>(n >> 26), static_cast<std::uint8_t>(n >> 20 & 63),
             static_cast<std::uint8_t>(n >> 14 & 63)};
    }
    power_on();
}

void Hx8347Controller::power_on() {
    registers_ = {};
    registers_[ID] = id;
    registers_[5] = width - 1;
    registers_[8] = (height - 1) >> 8;
    registers_[9] = (height - 1) & 0xFF;
    registers_[PIXELS] = 0x06;
    index_ = 0;
    value_count_ = 1; // no register waits for its value
    pixel_byte_count_ = 0;
    stream_pixels_ = 0;
    is_answering_ = false;
}

void Hx8347Controller::reset(bool low, Time now) {
    if (low == is_in_reset_)
        return;
    is_in_reset_ = low;
    if (low) {
        reset_fell_at_ = now;
        return;
    }
    if (now - reset_fell_at_ < 10 * us)
        report(Rule::reset_pulse, "reset was low for less than 10 us", now);
    power_on();
    ready_at_ = now + 5 * ms;
}

/// On a serial bus a start byte follows each falling CS. The index of the register is kept. A pixel that was
/// cut off is lost.
void Hx8347Controller::select(bool chip_select, Time now) {
    is_selected_ = chip_select;
    has_start_byte_ = false;
    is_answering_ = false;
    if (pixel_byte_count_ != 0 && bus_ == RegisterBus::start_byte)
        report(Rule::half_pixel, "CS rose inside a pixel", now);
    if (bus_ == RegisterBus::start_byte)
        pixel_byte_count_ = 0;
}

void Hx8347Controller::write(std::uint8_t byte, bool data, Time now, unsigned period_ns) {
    if (!is_selected_ || is_in_reset_)
        return;
    const unsigned shortest = bus_ == RegisterBus::parallel ? parallel_ns : serial_ns;
    if (period_ns < shortest && !is_too_fast_)
        report(Rule::write_clock,
               "a write cycle of " + std::to_string(period_ns) + " ns; this controller takes " +
                   std::to_string(shortest) + " ns",
               now);
    is_too_fast_ = period_ns < shortest;
    if (bus_ == RegisterBus::start_byte && !has_start_byte_)
        return start(byte, now);
    const bool is_index = bus_ == RegisterBus::start_byte ? index_follows_ : !data;
    if (is_index)
        choose(byte, now);
    else
        store(byte, now);
}

/// Takes the start byte 0111 0 ID RS RW. RS = 1 announces a value, RS = 0 an index; RW = 1 announces a read.
void Hx8347Controller::start(std::uint8_t byte, Time now) {
    has_start_byte_ = true;
    index_follows_ = (byte & 0x02) == 0;
    if ((byte & 0xFD) != 0x70)
        report(Rule::control_byte, hex_text(byte) + " is no start byte of a write", now);
}

void Hx8347Controller::choose(std::uint8_t index, Time now) {
    if (now < ready_at_)
        report(Rule::too_early, "index " + hex_text(index) + " before the reset is over", now);
    end_register(now);
    index_ = index;
    value_count_ = 0;
    answer_bit_ = 0;
    is_answering_ = bus_ == RegisterBus::parallel && index != GRAM;
    if (index != GRAM)
        return;
    check_window(now);
    column_ = word(WINDOW);
    row_ = word(WINDOW + 4);
    stream_pixels_ = 0;
    pixel_byte_count_ = 0;
}

void Hx8347Controller::end_register(Time now) {
    if (index_ != GRAM) {
        if (value_count_ != 1 && answer_bit_ == 0)
            report(Rule::parameter_count,
                   "register " + hex_text(index_) + " got " + std::to_string(value_count_) +
                       " values instead of one",
                   now);
        return;
    }
    if (pixel_byte_count_ != 0)
        report(Rule::half_pixel, "the pixel stream ended inside a pixel: one byte slipped", now);
    if (value_count_ != 0 && stream_pixels_ != window())
        report(Rule::pixel_count,
               std::to_string(stream_pixels_) + " pixels were sent to a window of " +
                   std::to_string(window()),
               now);
    pixel_byte_count_ = 0;
}

void Hx8347Controller::store(std::uint8_t value, Time now) {
    ++value_count_;
    is_answering_ = false;
    if (index_ == GRAM)
        return pixel_byte(value, now);
    if (index_ == ID)
        return;
    registers_[index_] = value;
    if (index_ == PIXELS && (value & 7) != 5 && (value & 7) != 6)
        report(Rule::color_format, "register 17h " + hex_text(value) + " names no format of this controller",
               now);
}

std::uint64_t Hx8347Controller::window() const {
    const int columns = word(WINDOW + 2) - word(WINDOW) + 1, rows = word(WINDOW + 6) - word(WINDOW + 4) + 1;
    return columns <= 0 || rows <= 0 ? 1
                                     : static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
}

void Hx8347Controller::check_window(Time now) {
    const int columns = order(MV) ? height : width, rows = order(MV) ? width : height;
    if (word(WINDOW) > word(WINDOW + 2) || word(WINDOW + 2) >= columns ||
        word(WINDOW + 4) > word(WINDOW + 6) || word(WINDOW + 6) >= rows)
        report(Rule::window,
               "columns " + std::to_string(word(WINDOW)) + ".." + std::to_string(word(WINDOW + 2)) + " of " +
                   std::to_string(columns) + ", rows " + std::to_string(word(WINDOW + 4)) + ".." +
                   std::to_string(word(WINDOW + 6)) + " of " + std::to_string(rows),
               now);
}

void Hx8347Controller::pixel_byte(std::uint8_t byte, Time now) {
    pixel_bytes_[static_cast<std::size_t>(pixel_byte_count_++)] = byte;
    if (pixel_byte_count_ < pixel_bytes())
        return;
    pixel_byte_count_ = 0;
    const auto six = [](int v) { return static_cast<std::uint8_t>(v & 63); };
    const int word = pixel_bytes_[0] << 8 | pixel_bytes_[1];
    put(pixel_bytes() == 3
            ? Rgb666{six(pixel_bytes_[0] >> 2), six(pixel_bytes_[1] >> 2), six(pixel_bytes_[2] >> 2)}
            : Rgb666{six(word >> 11 << 1), six(word >> 5), six((word & 31) << 1)},
        now);
}

void Hx8347Controller::put(Rgb666 color, Time now) {
    if (stream_pixels_++ == window())
        report(Rule::pixel_count, "more pixels than the window's " + std::to_string(window()), now);
    const int c = order(MV) ? row_ : column_, r = order(MV) ? column_ : row_;
    const int column = order(MX) ? width - 1 - c : c, row = order(MY) ? height - 1 - r : r;
    if (column >= 0 && column < width && row >= 0 && row < height)
        memory_[static_cast<std::size_t>(row * width + column)] = color;
    if (++column_ <= word(WINDOW + 2))
        return;
    column_ = word(WINDOW);
    if (++row_ > word(WINDOW + 6))
        row_ = word(WINDOW + 4);
}

/// A register is read as it was written, without a dummy cycle before the answer.
bool Hx8347Controller::drive_bit() {
    return is_answering_ && (registers_[index_] >> (7 - answer_bit_++ % 8) & 1) != 0;
}

void Hx8347Controller::read_clock(Time now, unsigned period_ns) {
    if (period_ns < read_ns && answer_bit_ == 1)
        report(Rule::read,
               "read with a cycle of " + std::to_string(period_ns) + " ns; this controller answers in " +
                   std::to_string(read_ns) + " ns",
               now);
}

/// The glass is lit while GON, DTE and both D bits of register 28h are set.
std::vector<Rgb666> Hx8347Controller::glass(Time) {
    std::vector<Rgb666> picture;
    const bool on = (registers_[DISPLAY] & 0x3C) == 0x3C;
    for (int y = 0; y < glass_.height; ++y)
        for (int x = 0; x < glass_.width; ++x) {
            const int column = glass_.x + (glass_.mirror_columns ? glass_.width - 1 - x : x);
            const int row = glass_.y + (glass_.mirror_rows ? glass_.height - 1 - y : y);
            Rgb666 p = on ? memory_[static_cast<std::size_t>(row * width + column)] : Rgb666{};
            if (order(BGR) != glass_.bgr_filter)
                std::swap(p.r, p.b);
            picture.push_back(p);
        }
    return picture;
}

} // namespace spangle::sim
