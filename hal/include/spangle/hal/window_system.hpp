// A system of windows as EGL sees it: every window and pixmap is a display of its own, opened and closed by
// its handle.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/display.hpp>
#include <spangle/hal/result.hpp>

namespace spangle::hal {

/// What a display that has windows tells EGL. Boards have one display and no window system; hosts name
/// theirs by egl::use_platforms (gl/egl/platforms.hpp).
class WindowSystem {
  public:
    /// Connects. Must succeed before the others are called.
    virtual Result<void> init() = 0;
    /// Whether windows and pixmaps can hold pixels of this format.
    virtual bool shows(PixelFormat format) const = 0;
    /// What EGL_NATIVE_VISUAL_ID tells of such windows (EGL 1.4, 3.4).
    virtual std::int32_t visual_id(PixelFormat format) const = 0;
    /// What EGL_NATIVE_VISUAL_TYPE tells of windows (EGL 1.4, 3.4).
    virtual std::int32_t visual_type() const = 0;
    /// The window or pixmap of that handle. DisplayInfo::width and height may differ from one call of info()
    /// to the next: windows change their size, and one that was destroyed has none. acquire() gives a buffer
    /// of the size that info() told last, and the buffer before it stays until then. present() shows the
    /// buffer at its own size.
    virtual Result<Display*> open(std::uintptr_t handle, bool pixmap, PixelFormat format) = 0;
    /// Closes what open() gave; the display is gone then. The window itself stays.
    virtual void close(Display& window) = 0;

  protected:
    ~WindowSystem() = default;
};

} // namespace spangle::hal
