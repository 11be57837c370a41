// Plays scenes on a display: the same on a board and on its simulated twin.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>

#include "boards/scenes/scene.hpp"

namespace spangle::demo {

/// Rows of a picture in memory, top row first.
struct Rows {
    const std::uint8_t* pixels = nullptr;
    std::int32_t stride = 0, row_bytes = 0, count = 0;
};

/// Who looks on: counts, compares, or does nothing. A frame that memory does not hold is drawn and presented
/// band by band, from the top down.
class Watcher {
  public:
    virtual void begin_frame() {}
    virtual void draws() {}            ///< a frame, or its next band
    virtual void drawn(const Rows&) {} ///< that, and it is not yet presented
    virtual void presented() {}        ///< all of the frame

  protected:
    ~Watcher() = default;
};

/// Opens the display, draws frames 0, 1, ... of the scene in the display's own format, with 16-bit depth
/// where the build has it, and lets go of all memory. Null, or the call that failed.
const char* play(hal::Display& display, const scenes::Scene& scene, int frames, Watcher& watcher);

/// A name for a picture: FNV-1a over its rows, so that those of its bands, one after the other, are it.
class PictureHash {
  public:
    void add(const Rows& rows);
    std::uint32_t value() const { return value_; }

  private:
    std::uint32_t value_ = 2166136261u;
};

} // namespace spangle::demo
