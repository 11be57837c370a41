// What the demo tells of itself: report_silent.cpp on hardware, report_semihosting.cpp in an emulator.
#pragma once

#include "boards/demo/demo.hpp"

namespace spangle::demo {

/// Who looks on while the display shows scenes.
Watcher& watcher();

/// Of a scene each time it is shown.
int frames_to_show();
void begin(const scenes::Scene& scene);
/// `problem`: null, or what play() said.
void end(const char* problem);
/// All scenes were shown: once more?
bool again();

} // namespace spangle::demo
