// Plays scenes on a display. A board and its simulated twin run this same code.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>

#include "boards/scenes/scene.hpp"

namespace spangle::demo {

/// Rows of a picture in memory; the top row is first.
struct Rows {
    const std::uint8_t* pixels = nullptr;
    std::int32_t stride = 0, row_bytes = 0, count = 0;
};

/// A watcher looks on while scenes are shown: it counts, compares, or does nothing. A frame that is too large
/// for memory is drawn and presented in bands, from the top down.
class Watcher {
  public:
    virtual void begin_frame() {}
    virtual void draws() {}            ///< called before a frame or its next band is drawn
    virtual void drawn(const Rows&) {} ///< called when a frame or band is drawn and not yet presented
    virtual void presented() {}        ///< called when all of the frame is presented

  protected:
    ~Watcher() = default;
};

/// Opens the display, draws frames 0, 1, ... of the scene, and frees all memory. GL draws in the display's
/// own format, with 16-bit depth where the build has it. Returns null, or the name of the call that failed.
const char* play(hal::Display& display, const scenes::Scene& scene, int frames, Watcher& watcher);

/// The FNV-1a hash of a picture's rows. Adding the bands of a picture from the top down gives the hash of the
/// whole picture.
class PictureHash {
  public:
    void add(const Rows& rows);
    std::uint32_t value() const { return value_; }

  private:
    std::uint32_t value_ = 2166136261u;
};

} // namespace spangle::demo
