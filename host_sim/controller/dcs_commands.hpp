// Commands of the MIPI display command set as controllers receive them, and bits of their parameters. The
// drivers of hal/ have names of their own (spangle/hal/dcs.hpp): models and drivers share no definition, so
// that one cannot hide a fault of the other.
#pragma once

#include <cstdint>

namespace spangle::sim::dcs {

enum : std::uint8_t {
    nop = 0x00,
    soft_reset = 0x01,
    read_id = 0x04,
    read_status = 0x09,
    read_power_mode = 0x0A,
    read_address_mode = 0x0B,
    read_pixel_format = 0x0C,
    read_image_mode = 0x0D,
    read_signal_mode = 0x0E,
    read_self_diagnosis = 0x0F,
    sleep_in = 0x10,
    sleep_out = 0x11,
    partial_mode_on = 0x12,
    normal_mode_on = 0x13,
    inversion_off = 0x20,
    inversion_on = 0x21,
    gamma_set = 0x26,
    display_off = 0x28,
    display_on = 0x29,
    column_address_set = 0x2A,
    row_address_set = 0x2B,
    memory_write = 0x2C,
    memory_read = 0x2E,
    partial_area = 0x30,
    scroll_area = 0x33,
    tearing_line_off = 0x34,
    tearing_line_on = 0x35,
    address_mode = 0x36,
    scroll_start = 0x37,
    idle_mode_off = 0x38,
    idle_mode_on = 0x39,
    pixel_format = 0x3A,
    memory_write_on = 0x3C, ///< writes pixels from where the last write ended
    memory_read_on = 0x3E,
    tearing_scanline = 0x44,
    read_scanline = 0x45,
    brightness = 0x51,
    control_display = 0x53,
    adaptive_brightness = 0x55,
    first_vendor_command = 0x60, ///< numbers from here on are commands of the maker's own
    read_id_1 = 0xDA,
    read_id_2 = 0xDB,
    read_id_3 = 0xDC,
};

/// Bits of the address mode (MADCTL).
enum : std::uint8_t {
    rows_mirrored = 0x80,
    columns_mirrored = 0x40,
    rows_and_columns_exchanged = 0x20,
    refresh_upwards = 0x10,
    blue_first = 0x08,
    refresh_leftwards = 0x04,
};

/// The pixel format at reset: 18 bits on either interface.
inline constexpr std::uint8_t pixel_format_18_bits = 0x66;

} // namespace spangle::sim::dcs
