// Windows and pixmaps of an X server as displays of EGL. Requests go over the program's own connection, so
// that they come after those that made the window, and by XCB, so that an error of a window that is gone ends
// no program.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <xcb/xcb.h>

#include <spangle/hal/window_system.hpp>

struct _XDisplay;

namespace spangle::dropin {

class XWindow;

/// Where red, green and blue lie in a pixel of X.
struct XPixels {
    std::uint32_t red = 0, green = 0, blue = 0; ///< masks
    int bytes = 0;                              ///< of a pixel; 0: drawables of this depth cannot be drawn to
    int row_unit = 4;                           ///< rows are multiples of so many bytes
    bool big_endian = false;
};

class XWindows final : public hal::WindowSystem {
  public:
    /// That of a connection, the same each time; of null: of the display that DISPLAY names. Null: there is
    /// none.
    static XWindows* of(_XDisplay* display);

    /// The function is told of each connection that is closed, while requests can still be sent over it.
    static void on_close(void (*closing)(_XDisplay* display));

    hal::Result<void> init() override;
    bool shows(PixelFormat format) const override;
    std::int32_t visual_id(PixelFormat format) const override;
    std::int32_t visual_type() const override;
    hal::Result<hal::Display*> open(std::uintptr_t handle, bool pixmap, PixelFormat format) override;
    void close(hal::Display& window) override;

    xcb_connection_t* connection() const { return connection_; }
    XPixels pixels_of_depth(int depth) const;
    bool has_shared_memory() const { return shared_memory_; }
    /// The window's surface of that handle is of one that the server does not have any more.
    bool is_gone(std::uintptr_t handle);

  private:
    explicit XWindows(_XDisplay* display);
    void watch_connection();

    _XDisplay* display_;
    bool is_watched_ = false; ///< Xlib tells when this connection is closed
    xcb_connection_t* connection_;
    bool shared_memory_ = false;
    std::uint32_t visual_ = 0;
};

} // namespace spangle::dropin
