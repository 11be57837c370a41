// Plays scenes on a display: the same on a board and on its simulated twin.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>

#include "boards/scenes/scene.hpp"

namespace spangle::demo {

/// Who looks on: counts, compares, or does nothing.
class Watcher {
  public:
    virtual void begin_frame() {}
    virtual void drawn() {} ///< and not yet presented
    virtual void presented() {}

  protected:
    ~Watcher() = default;
};

/// Opens the display, draws frames 0, 1, ... of the scene in the display's own format with 16-bit depth, and
/// lets go of all memory. Null, or the call that failed.
const char* play(hal::Display& display, const scenes::Scene& scene, int frames, Watcher& watcher);

/// A name for what is drawn in the frame that the display waits for: FNV-1a over its rows, top row first.
std::uint32_t frame_hash(hal::Display& display);

} // namespace spangle::demo
