// The timing that controllers of 320x480 pixels have in common.
#pragma once

#include <spangle/hal/panel.hpp>

namespace spangle::hal::panels {

namespace half_vga {

/// 60 Hz and 8 lines of blanking: the registers' reset values or near them.
consteval PanelTiming timing(std::uint16_t serial_write_ns, std::uint16_t practical_serial_mhz,
                             std::uint16_t parallel_write_ns) {
    return {.serial_write_ns = serial_write_ns,
            .parallel_write_ns = parallel_write_ns,
            .practical_serial_mhz = practical_serial_mhz,
            .frame_us = 16667,
            .scan_lines = 488,
            .porch_lines = 8};
}

} // namespace half_vga

} // namespace spangle::hal::panels
