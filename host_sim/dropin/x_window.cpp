#include "host_sim/dropin/x_window.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>

#include <sys/ipc.h>
#include <sys/shm.h>

#include "gl/context/limits.hpp"
#include "host_sim/dropin/pictures.hpp"
#include "host_sim/dropin/stage.hpp"

namespace spangle::dropin {

namespace {

constexpr std::size_t longest_request = 1u << 16; ///< bytes of an image that any server takes in one request

/// Drops the errors of a request, so that nobody sees them.
void forget(xcb_connection_t* connection, xcb_void_cookie_t cookie) {
    xcb_discard_reply(connection, cookie.sequence);
}

/// Waits until the server has done all requests before this one.
void wait_for_server(xcb_connection_t* connection) {
    std::free(xcb_get_input_focus_reply(connection, xcb_get_input_focus(connection), nullptr));
}

/// A component of eight bits, moved and sized to the bits of the mask.
std::uint32_t component(std::uint32_t mask, std::uint32_t eight_bits) {
    if (mask == 0)
        return 0;
    const int low = std::countr_zero(mask), bits = std::popcount(mask);
    return (bits >= 8 ? eight_bits << (bits - 8) : eight_bits >> (8 - bits)) << low;
}

void store(std::uint32_t value, const XPixels& pixels, std::uint8_t* to) {
    for (int i = 0; i < pixels.bytes; ++i)
        to[pixels.big_endian ? pixels.bytes - 1 - i : i] = static_cast<std::uint8_t>(value >> (8 * i));
}

} // namespace

XImage::XImage(const XWindows& windows) : windows_(windows), is_shared_(windows.has_shared_memory()) {}

XImage::~XImage() {
    free_shared();
}

void XImage::free_shared() {
    if (segment_memory_ == nullptr)
        return;
    forget(connection(), xcb_shm_detach_checked(connection(), segment_));
    xcb_flush(connection());
    shmdt(segment_memory_);
    segment_memory_ = nullptr;
    segment_bytes_ = 0;
}

std::uint8_t* XImage::resize(std::size_t bytes) {
    if (is_shared_ && segment_memory_ != nullptr)
        wait_for_server(connection());
    if (is_shared_ && bytes > segment_bytes_) {
        free_shared();
        const int id = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
        void* const memory = id < 0 ? nullptr : shmat(id, nullptr, 0);
        if (memory != nullptr && memory != reinterpret_cast<void*>(-1)) {
            segment_ = xcb_generate_id(connection());
            xcb_generic_error_t* const problem =
                xcb_request_check(connection(), xcb_shm_attach_checked(connection(), segment_,
                                                                       static_cast<std::uint32_t>(id), 0));
            is_shared_ = problem == nullptr; // a server on another machine cannot share memory
            std::free(problem);
            if (is_shared_) {
                segment_memory_ = static_cast<std::uint8_t*>(memory);
                segment_bytes_ = bytes;
            } else {
                shmdt(memory);
            }
        } else {
            is_shared_ = false;
        }
        if (id >= 0)
            shmctl(id, IPC_RMID, nullptr); // the memory is freed when the last process detaches it
    }
    if (is_shared_)
        return segment_memory_;
    private_memory_.resize(bytes);
    return private_memory_.data();
}

void XImage::put(xcb_drawable_t to, xcb_gcontext_t gc, int width, int height, int depth, int row_bytes) {
    const auto w = static_cast<std::uint16_t>(width), h = static_cast<std::uint16_t>(height);
    const auto d = static_cast<std::uint8_t>(depth);
    if (is_shared_) {
        forget(connection(), xcb_shm_put_image_checked(connection(), to, gc, w, h, 0, 0, w, h, 0, 0, d,
                                                       XCB_IMAGE_FORMAT_Z_PIXMAP, 0, segment_, 0));
    } else {
        const int rows = std::max(1, static_cast<int>(longest_request) / row_bytes);
        for (int y = 0; y < height; y += rows) {
            const int n = std::min(rows, height - y);
            forget(connection(),
                   xcb_put_image_checked(
                       connection(), XCB_IMAGE_FORMAT_Z_PIXMAP, to, gc, w, static_cast<std::uint16_t>(n), 0,
                       static_cast<std::int16_t>(y), 0, d, static_cast<std::uint32_t>(n * row_bytes),
                       private_memory_.data() + static_cast<std::ptrdiff_t>(y) * row_bytes));
        }
    }
    xcb_flush(connection());
}

XWindow::XWindow(XWindows& windows, xcb_drawable_t drawable, bool pixmap, PixelFormat format)
    : windows_(windows), drawable_(drawable), is_pixmap_(pixmap), format_(format), image_(windows) {
    xcb_connection_t* const c = windows_.connection();
    xcb_generic_error_t* problem = nullptr;
    xcb_get_geometry_reply_t* const reply =
        xcb_get_geometry_reply(c, xcb_get_geometry(c, drawable_), &problem);
    std::free(problem);
    if (reply == nullptr)
        return;
    depth_ = reply->depth;
    std::free(reply);
    pixels_ = windows_.pixels_of_depth(depth_);
    if (!usable())
        return;
    gc_ = xcb_generate_id(c);
    const std::uint32_t no_events[] = {0};
    forget(c, xcb_create_gc_checked(c, gc_, drawable_, XCB_GC_GRAPHICS_EXPOSURES, no_events));
    if (!is_pixmap_)
        wish_size();
    ask_size();
}

XWindow::~XWindow() {
    xcb_connection_t* const c = windows_.connection();
    if (gc_ != 0)
        forget(c, xcb_free_gc_checked(c, gc_));
    xcb_flush(c);
}

/// Resizes the window to the size of the panel, which cannot change. The program learns of it as when a user
/// resizes the window.
void XWindow::wish_size() const {
    const Stage::Size wish = Stage::get().window_size();
    if (wish.width == 0)
        return;
    xcb_connection_t* const c = windows_.connection();
    const std::uint32_t size[] = {static_cast<std::uint32_t>(wish.width),
                                  static_cast<std::uint32_t>(wish.height)};
    forget(c, xcb_configure_window_checked(c, drawable_, XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT,
                                           size));
    xcb_flush(c);
}

/// Asks the server for the size of the drawable. Returns false when the drawable is gone, and keeps the last
/// size.
bool XWindow::ask_size() const {
    xcb_connection_t* const c = windows_.connection();
    xcb_generic_error_t* problem = nullptr;
    const std::unique_ptr<xcb_get_geometry_reply_t, void (*)(void*)> reply(
        xcb_get_geometry_reply(c, xcb_get_geometry(c, drawable_), &problem), std::free);
    std::free(problem);
    if (reply == nullptr)
        return false;
    constexpr std::int32_t largest = gl::max_viewport_dim;
    width_ = std::clamp<std::int32_t>(reply->width, 1, largest);
    height_ = std::clamp<std::int32_t>(reply->height, 1, largest);
    return true;
}

hal::DisplayInfo XWindow::info() const {
    const bool lives = ask_size() || is_pixmap_; // pixmaps live as long as anybody uses them
    hal::DisplayInfo out;
    out.name = is_pixmap_ ? "X pixmap" : "X window";
    out.width = lives ? width_ : 0;
    out.height = lives ? height_ : 0;
    out.format = format_;
    out.keeps_buffer = true;
    return out;
}

hal::Result<hal::Frame> XWindow::acquire() {
    const std::int32_t stride = row_bytes(format_, width_);
    if (buffer_width_ != width_ || buffer_height_ != height_) {
        buffer_width_ = width_;
        buffer_height_ = height_;
        buffer_.assign(
            static_cast<std::size_t>(stride) * static_cast<std::size_t>(stored_rows(format_, height_)), 0);
        is_presented_ = false;
    }
    hal::Frame frame;
    frame.pixels = buffer_.data();
    frame.stride = stride;
    frame.age = is_presented_ ? 1 : 0;
    return frame;
}

hal::Result<void> XWindow::present() {
    hal::DisplayInfo shown;
    shown.width = buffer_width_;
    shown.height = buffer_height_;
    shown.format = format_;
    hal::Frame frame;
    frame.pixels = buffer_.data();
    frame.stride = row_bytes(format_, buffer_width_);
    if (!is_pixmap_)
        Stage::get().show(frame, shown);
    if (!is_pixmap_ && Stage::get().has_board()) {
        const sim::Image glass = Stage::get().picture();
        put(glass.rgba.data(), glass.width, glass.height);
    } else if (format_ == PixelFormat::rgba8888) {
        put(buffer_.data(), buffer_width_, buffer_height_);
    } else {
        put(picture_of(frame, shown).rgba.data(), buffer_width_, buffer_height_);
    }
    is_presented_ = true;
    return {};
}

void XWindow::put(const std::uint8_t* rgba, int width, int height) {
    const int row = (width * pixels_.bytes + pixels_.row_unit - 1) / pixels_.row_unit * pixels_.row_unit;
    std::uint8_t* const to = image_.resize(static_cast<std::size_t>(row) * static_cast<std::size_t>(height));
    const bool usual = pixels_.bytes == 4 && !pixels_.big_endian && pixels_.red == 0xFF0000 &&
                       pixels_.green == 0xFF00 && pixels_.blue == 0xFF;
    const std::uint8_t* from = rgba;
    for (int y = 0; y < height; ++y) {
        std::uint8_t* pixel = to + static_cast<std::ptrdiff_t>(y) * row;
        for (int x = 0; x < width; ++x, from += 4, pixel += pixels_.bytes) {
            if (usual) {
                pixel[0] = from[2];
                pixel[1] = from[1];
                pixel[2] = from[0];
                pixel[3] = 255;
            } else {
                store(component(pixels_.red, from[0]) | component(pixels_.green, from[1]) |
                          component(pixels_.blue, from[2]),
                      pixels_, pixel);
            }
        }
    }
    image_.put(drawable_, gc_, width, height, depth_, row);
}

} // namespace spangle::dropin
