// Windows and pixmaps of an X server as displays of EGL. Requests go over the program's own connection, so
// that they come after the requests that made the window. They are made by XCB, so that an error about a
// window that is gone does not end the program.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <xcb/xcb.h>

#include <spangle/hal/window_system.hpp>

struct _XDisplay;

namespace spangle::dropin {

class XWindow;

/// The place of red, green and blue in a pixel of X.
struct XPixels {
    std::uint32_t red = 0, green = 0, blue = 0; ///< masks of bits in the pixel
    int bytes = 0;    ///< bytes of a pixel; 0: drawables of this depth cannot be drawn to
    int row_unit = 4; ///< bytes of which a row is a multiple
    bool big_endian = false;
};

class XWindows final : public hal::WindowSystem {
  public:
    /// The windows of a connection, the same object each time. Null stands for the display that DISPLAY
    /// names. Returns null if there is no such display.
    static XWindows* of(_XDisplay* display);

    /// Sets a function that is called for each connection about to be closed, while requests can still be
    /// sent over it.
    static void on_close(void (*closing)(_XDisplay* display));

    hal::Result<void> init() override;
    bool shows(PixelFormat format) const override;
    std::int32_t visual_id(PixelFormat format) const override;
    std::int32_t visual_type() const override;
    hal::Result<hal::Display*> open(std::uintptr_t handle, bool pixmap, PixelFormat format) override;
    void close(hal::Display& window) override;

    xcb_connection_t* connection() const { return connection_; }
    XPixels pixels_of_depth(int depth) const;
    bool has_shared_memory() const { return has_shared_memory_; }
    /// Whether the server no longer has the window with this handle.
    bool is_gone(std::uintptr_t handle);

  private:
    explicit XWindows(_XDisplay* display);
    void watch_connection();

    _XDisplay* display_;
    bool is_watched_ = false; ///< Xlib will tell when this connection is closed
    xcb_connection_t* connection_;
    bool has_shared_memory_ = false;
    std::uint32_t visual_ = 0;
};

} // namespace spangle::dropin
