// RV32 virt: a linear frame buffer; the display's own memory holds two frames.
#pragma once

#include <spangle/hal/mapped_display.hpp>

namespace spangle::boards {

inline constexpr hal::MappedConfig rv32_virt = {.name = "rv32_virt", .width = 320, .height = 240};

} // namespace spangle::boards
