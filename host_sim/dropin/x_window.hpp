// A window or pixmap of X as a display: a buffer of the size that the server says, and an image that is sent
// to it.
#pragma once

#include <cstdint>
#include <vector>

#include <xcb/shm.h>
#include <xcb/xcb.h>

#include <spangle/hal/display.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/dropin/x_windows.hpp"

namespace spangle::dropin {

/// An image in memory that the server shares, where it can; otherwise the image is sent.
class XImage {
  public:
    explicit XImage(const XWindows& windows);
    ~XImage();
    XImage(const XImage&) = delete;
    XImage& operator=(const XImage&) = delete;

    /// Makes room for rows of so many bytes in all. Before that, the server must have taken the image that
    /// was put last.
    std::uint8_t* resize(std::size_t bytes);
    void put(xcb_drawable_t to, xcb_gcontext_t gc, int width, int height, int depth, int row_bytes);

  private:
    void free_shared();
    xcb_connection_t* connection() const { return windows_.connection(); }

    const XWindows& windows_;
    bool is_shared_;
    xcb_shm_seg_t segment_ = 0;
    std::uint8_t* segment_memory_ = nullptr;
    std::size_t segment_bytes_ = 0;
    std::vector<std::uint8_t> private_memory_;
};

class XWindow final : public hal::Display {
  public:
    XWindow(XWindows& windows, xcb_drawable_t drawable, bool pixmap, PixelFormat format);
    ~XWindow();
    XWindow(const XWindow&) = delete;
    XWindow& operator=(const XWindow&) = delete;

    /// Whether the server knows the drawable, and pixels of its depth can be made.
    bool usable() const { return pixels_.bytes != 0; }

    /// Asks the server for the size. A window that is gone has the size 0.
    hal::DisplayInfo info() const override;
    hal::Result<void> init() override { return {}; }
    hal::Result<hal::Frame> acquire() override;
    hal::Result<void> present() override;

  private:
    bool ask_size() const;
    void wish_size() const;
    /// Shows rows of R G B A bytes, the uppermost first.
    void put(const std::uint8_t* rgba, int width, int height);

    XWindows& windows_;
    xcb_drawable_t drawable_;
    bool is_pixmap_;
    PixelFormat format_;
    int depth_ = 0;
    XPixels pixels_;
    xcb_gcontext_t gc_ = 0;
    mutable std::int32_t width_ = 1, height_ = 1; ///< pixels, as the server told last
    std::int32_t buffer_width_ = 0, buffer_height_ = 0;
    std::vector<std::uint8_t> buffer_;
    bool is_presented_ = false;
    XImage image_;
};

} // namespace spangle::dropin
