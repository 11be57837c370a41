// Watches the contexts of a program from elsewhere: what was covered of each surface, and what a finished
// picture holds. Nothing here calls GL or EGL, so that it may be called from inside of them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "host_sim/capture/drawn_frame.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::trade {

class FrameWatch : public raster::Observer {
  public:
    FrameWatch();

    /// Returns the picture, and what was drawn to it since the last call for this surface. Depths have 16
    /// bits.
    DrawnFrame take(const raster::Surface& surface);
    /// The number of pixels whose coverage differed from that of brute force.
    std::uint64_t mismatches() const;

  private:
    struct WatchedSurface {
        std::unique_ptr<Coverage> coverage;
        int width = 0, height = 0;
    };
    mutable std::mutex mutex_; ///< guards the members below: threads draw to surfaces of their own
    std::map<const std::uint8_t*, WatchedSurface> surfaces_;
    std::uint64_t earlier_mismatches_ = 0; ///< mismatches counted before surfaces changed their size

    Coverage& of(const raster::Surface& surface);
    Coverage& current();
};

} // namespace spangle::trade
