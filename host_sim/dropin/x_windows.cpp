#include "host_sim/dropin/x_windows.hpp"

// The rasterizer's headers come before Xlib, which defines None as a macro.
#include "host_sim/dropin/stage.hpp"

#include <cstdlib>
#include <map>
#include <mutex>

#include <X11/Xlib-xcb.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <xcb/shm.h>

#include "host_sim/dropin/x_window.hpp"

// Xlib declares this function for extensions (Xlib, appendix C) in Xlibint.h, which defines min and max as
// macros and is not included.
extern "C" int (*XESetCloseDisplay(Display*, int, int (*)(Display*, XExtCodes*)))(Display*, XExtCodes*);

namespace spangle::dropin {

namespace {

template <class T> struct FreeDeleter {
    void operator()(T* reply) const { std::free(reply); }
};
template <class T> using Reply = std::unique_ptr<T, FreeDeleter<T>>;

const xcb_screen_t* screen_of(xcb_connection_t* connection) {
    return xcb_setup_roots_iterator(xcb_get_setup(connection)).data;
}

const xcb_visualtype_t* true_color(const xcb_screen_t& screen, int depth) {
    for (auto d = xcb_screen_allowed_depths_iterator(&screen); d.rem != 0; xcb_depth_next(&d)) {
        if (d.data->depth != depth)
            continue;
        for (auto v = xcb_depth_visuals_iterator(d.data); v.rem != 0; xcb_visualtype_next(&v))
            if (v.data->_class == XCB_VISUAL_CLASS_TRUE_COLOR)
                return v.data;
    }
    return nullptr;
}

/// Whether the server offers the extension for shared memory.
bool shares_memory(xcb_connection_t* connection) {
    const xcb_query_extension_reply_t* const there = xcb_get_extension_data(connection, &xcb_shm_id);
    if (there == nullptr || there->present == 0)
        return false;
    const Reply<xcb_shm_query_version_reply_t> version(
        xcb_shm_query_version_reply(connection, xcb_shm_query_version(connection), nullptr));
    return version != nullptr;
}

/// The windows of each connection, by its address. A connection that is opened later may have the address of
/// a closed one.
std::map<_XDisplay*, XWindows*>& known_windows() {
    static auto* const all = new std::map<_XDisplay*, XWindows*>;
    return *all;
}

std::mutex known_mutex;
void (*closing_listener)(_XDisplay*) = nullptr;

/// A connection on which XCB neither sends nor answers anything. No server has the name it is made with.
xcb_connection_t* closed_connection() {
    static xcb_connection_t* const none = xcb_connect("none", nullptr);
    return none;
}

} // namespace

void XWindows::on_close(void (*closing)(_XDisplay* display)) {
    closing_listener = closing;
}

/// Arranges to be called before the connection is closed, as Xlib does for its extensions (Xlib, appendix C).
void XWindows::watch_connection() {
    XExtCodes* const codes = XAddExtension(display_);
    if (codes == nullptr)
        return;
    is_watched_ = true;
    XESetCloseDisplay(display_, codes->extension, [](_XDisplay* closed, XExtCodes*) {
        if (closing_listener != nullptr)
            closing_listener(closed);
        const std::lock_guard<std::mutex> lock(known_mutex);
        XWindows& windows = *known_windows()[closed];
        windows.is_watched_ = false;
        // Windows that are current to other threads stay open. Their requests get no answers from here on.
        windows.connection_ = closed_connection();
        return 0;
    });
}

XWindows* XWindows::of(_XDisplay* display) {
    static _XDisplay* usual = nullptr;
    const std::lock_guard<std::mutex> lock(known_mutex);
    if (display == nullptr && usual == nullptr)
        usual = XOpenDisplay(nullptr);
    if (display == nullptr)
        display = usual;
    if (display == nullptr)
        return nullptr;
    XWindows*& windows = known_windows()[display];
    if (windows == nullptr)
        windows = new XWindows(display);
    windows->connection_ = XGetXCBConnection(display); // a new connection may have a closed one's address
    if (!windows->is_watched_)
        windows->watch_connection();
    return windows;
}

XWindows::XWindows(_XDisplay* display) : display_(display), connection_(XGetXCBConnection(display)) {}

hal::Result<void> XWindows::init() {
    if (xcb_connection_has_error(connection_) != 0)
        return hal::Error{hal::Fault::gone, "X: the connection is broken"};
    has_shared_memory_ = shares_memory(connection_) && std::getenv("SPANGLE_NO_SHM") == nullptr;
    const xcb_screen_t* const screen = screen_of(connection_);
    const xcb_visualtype_t* const visual = true_color(*screen, screen->root_depth);
    visual_ = visual != nullptr ? visual->visual_id : screen->root_visual;
    return {};
}

bool XWindows::shows(PixelFormat format) const {
    return format == Stage::get().format();
}

std::int32_t XWindows::visual_id(PixelFormat) const {
    return static_cast<std::int32_t>(visual_);
}

std::int32_t XWindows::visual_type() const {
    return XCB_VISUAL_CLASS_TRUE_COLOR;
}

XPixels XWindows::pixels_of_depth(int depth) const {
    const xcb_setup_t* const setup = xcb_get_setup(connection_);
    const xcb_visualtype_t* const visual = true_color(*screen_of(connection_), depth);
    XPixels out;
    if (visual == nullptr)
        return out;
    for (auto f = xcb_setup_pixmap_formats_iterator(setup); f.rem != 0; xcb_format_next(&f))
        if (f.data->depth == depth && f.data->bits_per_pixel % 8 == 0) {
            out.bytes = f.data->bits_per_pixel / 8;
            out.row_unit = f.data->scanline_pad / 8;
        }
    out.red = visual->red_mask;
    out.green = visual->green_mask;
    out.blue = visual->blue_mask;
    out.big_endian = setup->image_byte_order == XCB_IMAGE_ORDER_MSB_FIRST;
    return out;
}

bool XWindows::is_gone(std::uintptr_t handle) {
    xcb_generic_error_t* problem = nullptr;
    const Reply<xcb_get_geometry_reply_t> reply(xcb_get_geometry_reply(
        connection_, xcb_get_geometry(connection_, static_cast<xcb_drawable_t>(handle)), &problem));
    std::free(problem);
    return reply == nullptr;
}

hal::Result<hal::Display*> XWindows::open(std::uintptr_t handle, bool pixmap, PixelFormat format) {
    auto window = std::make_unique<XWindow>(*this, static_cast<xcb_drawable_t>(handle), pixmap, format);
    if (!window->usable())
        return hal::Error{hal::Fault::gone, "X: no such window or pixmap of true colours"};
    return window.release();
}

void XWindows::close(hal::Display& window) {
    delete static_cast<XWindow*>(&window);
}

} // namespace spangle::dropin
