#include "host_sim/dropin/glx_drawables.hpp"

#include <map>
#include <utility>

#include <X11/Xlib-xcb.h>

#include "host_sim/dropin/x_windows.hpp"

using namespace spangle::dropin;
using namespace spangle::dropin::glx;

namespace spangle::dropin::glx {

namespace {

using Targets = std::map<std::pair<Display*, XID>, std::shared_ptr<Target>>;
Targets& drawables() {
    static auto* const all = new Targets;
    return *all;
}

/// Whether EGL lets a context of one configuration draw to surfaces of the other: both have the same planes
/// (EGL 1.4, 2.2).
bool same_planes(const SpangleFbConfig& a, const SpangleFbConfig& b) {
    return a.egl == b.egl;
}

EGLSurface create(Display* display, const Target& drawable, const SpangleFbConfig& config) {
    const EGLDisplay egl = egl_display(display);
    const EGLint window[] = {EGL_RENDER_BUFFER, config.double_buffered ? EGL_BACK_BUFFER : EGL_SINGLE_BUFFER,
                             EGL_ACCUM_SIZE_SPANGLE, config.accum, EGL_NONE};
    const EGLint pbuffer[] = {EGL_WIDTH,
                              drawable.width,
                              EGL_HEIGHT,
                              drawable.height,
                              EGL_LARGEST_PBUFFER,
                              drawable.largest ? EGL_TRUE : EGL_FALSE,
                              EGL_ACCUM_SIZE_SPANGLE,
                              config.accum,
                              EGL_NONE};
    switch (drawable.kind) {
    case Kind::window:
        return eglCreateWindowSurface(egl, config.egl, drawable.native, window);
    case Kind::pixmap:
        return eglCreatePixmapSurface(egl, config.egl, drawable.native, window);
    default:
        return eglCreatePbufferSurface(egl, config.egl, pbuffer);
    }
}

void destroy_surface(Display* display, Target& drawable) {
    if (drawable.surface != EGL_NO_SURFACE)
        eglDestroySurface(egl_display(display), drawable.surface);
    drawable.surface = EGL_NO_SURFACE;
}

/// Drops plain windows that were destroyed, with their surfaces. X does not tell GLX when they are, so this
/// looks when another drawable is made.
void forget_gone_windows(Display* display) {
    XWindows* const windows = XWindows::of(display);
    Targets& all = drawables();
    for (auto at = all.begin(); at != all.end();) {
        Target& d = *at->second;
        if (at->first.first == display && d.kind == Kind::window && !d.made && windows->is_gone(d.native)) {
            destroy_surface(display, d);
            at = all.erase(at);
        } else {
            ++at;
        }
    }
}

XID keep(Display* display, Target drawable) {
    const XID id = xcb_generate_id(XGetXCBConnection(display));
    drawable.made = true;
    drawables()[{display, id}] = std::make_shared<Target>(drawable);
    return id;
}

void destroy(Display* display, XID id, Kind kind, Problem problem, Request request) {
    const std::lock_guard<std::recursive_mutex> guard(lock());
    const auto at = drawables().find({display, id});
    if (at == drawables().end() || at->second->kind != kind)
        return report(display, problem, request, id);
    // A window of GLX ends with its window of X (GLX 1.4, 3.3.4), so its name is an error from then on.
    const bool gone = kind == Kind::window && XWindows::of(display)->is_gone(at->second->native);
    destroy_surface(display, *at->second);
    drawables().erase(at);
    if (gone)
        report(display, problem, request, id);
}

} // namespace

std::recursive_mutex& lock() {
    static std::recursive_mutex mutex;
    return mutex;
}

std::shared_ptr<Target> made_drawable(Display* display, GLXDrawable id) {
    const std::lock_guard<std::recursive_mutex> guard(lock());
    const auto at = drawables().find({display, id});
    return at == drawables().end() ? nullptr : at->second;
}

std::shared_ptr<Target> drawable_of(Display* display, GLXDrawable id) {
    const std::lock_guard<std::recursive_mutex> guard(lock());
    if (std::shared_ptr<Target> known = made_drawable(display, id))
        return known;
    forget_gone_windows(display);
    auto fresh = std::make_shared<Target>();
    fresh->native = id;
    drawables()[{display, id}] = fresh;
    return fresh;
}

EGLSurface surface_of(Display* display, Target& drawable, GLXFBConfig config) {
    const std::lock_guard<std::recursive_mutex> guard(lock());
    if (drawable.surface != EGL_NO_SURFACE && same_planes(*drawable.config, *config))
        return drawable.surface;
    if (drawable.made && !same_planes(*drawable.config, *config))
        return EGL_NO_SURFACE;
    destroy_surface(display, drawable); // a plain window takes the planes of the context that draws to it
    if (!drawable.made)
        drawable.config = config;
    drawable.surface = create(display, drawable, *drawable.config);
    return drawable.surface;
}

void forget_drawables(Display* display) {
    const std::lock_guard<std::recursive_mutex> guard(lock());
    std::erase_if(drawables(), [display](const auto& known) { return known.first.first == display; });
}

} // namespace spangle::dropin::glx

extern "C" {

GLXWindow glXCreateWindow(Display* display, GLXFBConfig config, Window window, const int*) {
    const GLXFBConfig found = checked(display, config);
    if (found == nullptr) {
        report(display, Problem::fb_config, Request::create_window, 0);
        return 0;
    }
    if (XWindows::of(display)->is_gone(window)) {
        report_core(display, BadWindow, Request::create_window, window);
        return 0;
    }
    const std::lock_guard<std::recursive_mutex> guard(lock());
    Target drawable;
    drawable.native = window;
    drawable.config = found;
    return keep(display, drawable);
}

void glXDestroyWindow(Display* display, GLXWindow window) {
    destroy(display, window, Kind::window, Problem::window, Request::destroy_window);
}

GLXPixmap glXCreatePixmap(Display* display, GLXFBConfig config, Pixmap pixmap, const int*) {
    const GLXFBConfig found = checked(display, config);
    if (found == nullptr) {
        report(display, Problem::fb_config, Request::create_pixmap, 0);
        return 0;
    }
    if (XWindows::of(display)->is_gone(pixmap)) {
        report_core(display, BadPixmap, Request::create_pixmap, pixmap);
        return 0;
    }
    const std::lock_guard<std::recursive_mutex> guard(lock());
    Target drawable;
    drawable.kind = Kind::pixmap;
    drawable.native = pixmap;
    drawable.config = found;
    return keep(display, drawable);
}

void glXDestroyPixmap(Display* display, GLXPixmap pixmap) {
    destroy(display, pixmap, Kind::pixmap, Problem::pixmap, Request::create_pixmap);
}

GLXPixmap glXCreateGLXPixmap(Display* display, XVisualInfo* visual, Pixmap pixmap) {
    const GLXFBConfig config =
        visual == nullptr ? nullptr : of_visual(display, visual->screen, visual->visualid);
    if (config == nullptr) {
        report_core(display, BadValue, Request::create_pixmap, 0);
        return 0;
    }
    return glXCreatePixmap(display, config, pixmap, nullptr);
}

GLXPixmap glXCreateGLXPixmapWithConfigSGIX(Display* display, GLXFBConfig config, Pixmap pixmap) {
    return glXCreatePixmap(display, config, pixmap, nullptr);
}

void glXDestroyGLXPixmap(Display* display, GLXPixmap pixmap) {
    glXDestroyPixmap(display, pixmap);
}

GLXPbuffer glXCreatePbuffer(Display* display, GLXFBConfig config, const int* list) {
    const GLXFBConfig found = checked(display, config);
    if (found == nullptr) {
        report(display, Problem::fb_config, Request::create_pbuffer, 0);
        return 0;
    }
    Target drawable;
    drawable.kind = Kind::pbuffer;
    drawable.config = found;
    for (; list != nullptr && *list != 0; list += 2) {
        if (list[0] == PBUFFER_WIDTH)
            drawable.width = list[1];
        else if (list[0] == PBUFFER_HEIGHT)
            drawable.height = list[1];
        else if (list[0] == LARGEST_PBUFFER)
            drawable.largest = list[1] != 0;
    }
    const std::lock_guard<std::recursive_mutex> guard(lock());
    if (surface_of(display, drawable, found) == EGL_NO_SURFACE) {
        report_core(display, eglGetError() == EGL_BAD_PARAMETER ? BadValue : BadAlloc,
                    Request::create_pbuffer, 0);
        return 0;
    }
    return keep(display, drawable);
}

void glXDestroyPbuffer(Display* display, GLXPbuffer pbuffer) {
    destroy(display, pbuffer, Kind::pbuffer, Problem::pbuffer, Request::create_pbuffer);
}

void glXQueryDrawable(Display* display, GLXDrawable id, int name, unsigned int* value) {
    const std::shared_ptr<Target> drawable = made_drawable(display, id);
    if (drawable == nullptr)
        return report(display, Problem::drawable, Request::get_drawable_attributes, id);
    EGLint found = 0;
    if (drawable->surface == EGL_NO_SURFACE)
        surface_of(display, *drawable, drawable->config);
    switch (name) {
    case WIDTH:
    case HEIGHT:
        eglQuerySurface(egl_display(display), drawable->surface, name == WIDTH ? EGL_WIDTH : EGL_HEIGHT,
                        &found);
        break;
    case PRESERVED_CONTENTS:
        found = True;
        break;
    case LARGEST_PBUFFER:
        found = drawable->largest ? True : False;
        break;
    case FBCONFIG_ID:
        found = drawable->config->id;
        break;
    case EVENT_MASK:
        found = static_cast<EGLint>(drawable->events);
        break;
    case SWAP_INTERVAL:
    case MAX_SWAP_INTERVAL:
        found = name == MAX_SWAP_INTERVAL ? 1 : 0;
        break;
    default:
        break;
    }
    if (value != nullptr)
        *value = static_cast<unsigned>(found);
}

/// A pbuffer of Spangle is never clobbered: the mask is kept, but the event never comes.
void glXSelectEvent(Display* display, GLXDrawable id, unsigned long mask) {
    if (const std::shared_ptr<Target> drawable = made_drawable(display, id))
        drawable->events = mask;
    else
        report(display, Problem::drawable, Request::get_drawable_attributes, id);
}

void glXGetSelectedEvent(Display* display, GLXDrawable id, unsigned long* mask) {
    if (const std::shared_ptr<Target> drawable = made_drawable(display, id))
        *mask = drawable->events;
    else
        report(display, Problem::drawable, Request::get_drawable_attributes, id);
}
}
