// Versatile Express A9: the panel on the motherboard's PL111, two frames in memory.
#pragma once

#include <spangle/hal/mapped_display.hpp>

namespace spangle::boards {

inline constexpr hal::MappedConfig vexpress_a9 = {.name = "vexpress_a9", .width = 320, .height = 240};

} // namespace spangle::boards
