// What the demo reports: report_silent.cpp is linked for hardware, report_semihosting.cpp for an emulator.
#pragma once

#include "boards/demo/demo.hpp"

namespace spangle::demo {

/// The watcher that looks on while the display shows scenes.
Watcher& watcher();

/// The number of frames of a scene, each time that the scene is shown.
int frames_to_show();
void begin(const scenes::Scene& scene);
/// Reports the end of a scene. `problem` is null, or the text that play() returned.
void end(const char* problem);
/// Whether the program shows all scenes once more. Called after the last scene.
bool again();

} // namespace spangle::demo
