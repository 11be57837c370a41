// The answers of a DCS controller to read commands.
#include "host_sim/controller/dcs_controller.hpp"

namespace spangle::sim {

void DcsController::push_read(std::initializer_list<std::uint8_t> bytes, int dummy_bits) {
    // A parallel bus has one dummy byte. A serial bus has as many clocks as the chip takes to turn the data
    // line round.
    const int dummies = is_parallel_ ? 8 : dummy_bits;
    is_answering_ = true;
    read_dummy_bits_ = static_cast<std::size_t>(dummies);
    read_bits_.assign(read_dummy_bits_, false);
    push_bytes(bytes.begin(), bytes.size());
    read_position_ = 0;
}

void DcsController::push_bytes(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        for (int bit = 7; bit >= 0; --bit)
            read_bits_.push_back((bytes[i] >> bit & 1) != 0);
}

void DcsController::forget_read() {
    read_bits_.clear();
    read_position_ = read_dummy_bits_ = 0;
    read_clocks_ = 0;
    is_answering_ = has_read_too_fast_ = false;
}

void DcsController::prepare_read(Time now) {
    forget_read();
    const auto bit = [](bool on, int position) { return static_cast<unsigned>(on ? 1 : 0) << position; };
    const auto byte = [](unsigned v) { return static_cast<std::uint8_t>(v); };
    switch (command_) {
    case dcs::read_id:
        push_read({chip_.id[0], chip_.id[1], chip_.id[2]}, chip_.register_dummy_bits);
        break;
    case dcs::read_status: {
        const unsigned format = (colmod_ & 7u) << 20;
        const unsigned s =
            bit(is_awake_, 31) | bit(madctl_ & dcs::rows_mirrored, 30) |
            bit(madctl_ & dcs::columns_mirrored, 29) | bit(madctl_ & dcs::rows_and_columns_exchanged, 28) |
            bit(madctl_ & dcs::refresh_upwards, 27) | bit(madctl_ & dcs::blue_first, 26) |
            bit(madctl_ & dcs::refresh_leftwards, 25) | format | bit(is_idle_, 19) | bit(is_partial_, 18) |
            bit(is_awake_, 17) | bit(!is_partial_, 16) | bit(is_scrolling_, 15) | bit(is_inverted_, 13) |
            bit(is_display_on_, 10) | bit(has_te_, 9) | bit(te_with_hblank_, 5);
        push_read({byte(s >> 24), byte(s >> 16), byte(s >> 8), byte(s)}, chip_.register_dummy_bits);
        break;
    }
    case dcs::read_power_mode:
        push_read({byte(bit(is_awake_, 7) | bit(is_idle_, 6) | bit(is_partial_, 5) | bit(is_awake_, 4) |
                        bit(!is_partial_, 3) | bit(is_display_on_, 2))},
                  0);
        break;
    case dcs::read_address_mode:
        push_read({madctl_}, 0);
        break;
    case dcs::read_pixel_format:
        push_read({byte(colmod_ & 0x77u)}, 0);
        break;
    case dcs::read_image_mode:
        push_read({byte(bit(is_scrolling_, 7) | bit(is_inverted_, 5))}, 0);
        break;
    case dcs::read_signal_mode:
        push_read({byte(bit(has_te_, 7) | bit(te_with_hblank_, 6))}, 0);
        break;
    case dcs::read_self_diagnosis:
        push_read({byte(is_awake_ ? 0xC0 : 0x00)}, 0);
        break;
    case dcs::read_scanline: {
        const int line = scan_line(now);
        push_read({byte(static_cast<unsigned>(line) >> 8), byte(static_cast<unsigned>(line))},
                  chip_.register_dummy_bits);
        break;
    }
    case dcs::memory_read:
        read_column_ = column_start_;
        read_page_ = page_start_;
        [[fallthrough]];
    case dcs::memory_read_on:
        push_read({}, chip_.pixel_dummy_bits);
        break;
    case dcs::read_id_1:
    case dcs::read_id_2:
    case dcs::read_id_3:
        push_read({chip_.id[command_ - unsigned{dcs::read_id_1}]}, 0);
        break;
    default:
        if (const MakerId& own = chip_.maker_id; own.command != 0 && command_ == own.command) {
            push_read({}, own.dummy_bits);
            push_bytes(own.bytes.data(), own.count);
        }
        break;
    }
}

/// Appends the next pixel of the window to the answer. Most chips answer three bytes a pixel, six bits
/// left-aligned, whatever COLMOD says; some answer in the format that pixels are written in.
void DcsController::push_pixels() {
    int column, row;
    Rgb666 p;
    if (locate_cell(read_column_, read_page_, column, row))
        p = memory_[static_cast<std::size_t>(row * chip_.width + column)];
    const int word = p.r >> 1 << 11 | p.g << 5 | p.b >> 1;
    const std::array<int, 3> six_each{p.r << 2, p.g << 2, p.b << 2}, as_written{word >> 8, word & 255, 0};
    std::array<std::uint8_t, 3> bytes{};
    for (std::size_t i = 0; i < 3; ++i)
        bytes[i] = static_cast<std::uint8_t>(reads_565() ? as_written[i] : six_each[i]);
    push_bytes(bytes.data(), reads_565() ? 2 : 3);
    if (++read_column_ <= column_end_)
        return;
    read_column_ = column_start_;
    if (++read_page_ > page_end_)
        read_page_ = page_start_;
}

bool DcsController::drive_bit() {
    if (!answers())
        return false;
    if (read_position_ >= read_bits_.size()) {
        read_bits_.clear();
        read_position_ = 0;
        push_pixels();
    }
    return read_bits_[read_position_++];
}

void DcsController::read_clock(Time now, unsigned period_ns) {
    ++read_clocks_;
    const unsigned shortest = is_parallel_ ? chip_.parallel_read_ns : chip_.serial_read_ns;
    if (period_ns >= shortest || has_read_too_fast_)
        return;
    has_read_too_fast_ = true;
    report(Rule::read,
           "read with a cycle of " + std::to_string(period_ns) + " ns; this controller answers in " +
               std::to_string(shortest) + " ns",
           now);
}

/// Reports an answer of which exactly the dummy clocks are missing: the host took the first of them for data.
/// More clocks than an answer has are no fault, because some hosts read whole bytes and shift.
void DcsController::end_read(Time now) {
    if (!is_answering_ || read_dummy_bits_ == 0 || read_clocks_ == 0)
        return;
    const std::uint64_t pixel = reads_565() ? 16 : 24;
    const bool slipped = reads_memory()
                             ? read_clocks_ % pixel == 0 && (read_clocks_ - read_dummy_bits_) % pixel != 0
                             : read_clocks_ + read_dummy_bits_ == read_bits_.size();
    if (slipped)
        report(Rule::read, "command " + hex_text(command_) + " was read without its dummy clocks", now);
}

} // namespace spangle::sim
