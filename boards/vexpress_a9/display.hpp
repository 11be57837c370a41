// Versatile Express A9: the panel on the PL111 of the CoreTile; the board's memory holds two frames.
#pragma once

#include <spangle/hal/mapped_display.hpp>

namespace spangle::boards {

inline constexpr hal::MappedConfig vexpress_a9 = {.name = "vexpress_a9", .width = 320, .height = 240};

} // namespace spangle::boards
