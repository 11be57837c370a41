// Contexts: how they are created, destroyed and made current (EGL 1.4, 3.7).
#include "gl/api/names.hpp"
#include "gl/context/error.hpp"
#include "gl/egl/configs.hpp"
#include "gl/egl/objects.hpp"
#include "gl/egl/platforms.hpp"
#include "gl/vertex/engine.hpp"

#include <new>

namespace spangle::egl {

namespace {

/// True if a surface and a context agree in colour format, depth format and multisampling, as they must (EGL
/// 1.4, 2.2).
bool are_compatible(const Config& a, const Config& b) {
    return a.format == b.format && a.depth == b.depth && a.multisampled == b.multisampled;
}

/// True if the surface is current on another thread.
bool is_current_elsewhere(const Surface* surface) {
    return surface->bindings != 0 && thread().draw != surface && thread().read != surface;
}

/// True if GL_FRONT names the surface's buffer. A pbuffer's only buffer is a back buffer (EGL 1.4, 3.5.6),
/// and serves programs that draw to the front, too. A window of a window system keeps its picture after a
/// swap, so that drawing to its front adds to what is seen.
bool names_front(const Surface& surface) {
#if SPANGLE_HAS_PLATFORMS
    if (surface.system != nullptr)
        return true;
#endif
    return !surface.window || !surface.back_buffered;
}

/// True if the native window still exists, or if no window system has it. A destroyed window has width 0.
bool exists([[maybe_unused]] const Surface& surface) {
#if SPANGLE_HAS_PLATFORMS
    if (surface.system != nullptr && surface.native->info().width == 0)
        return fail(EGL_BAD_NATIVE_WINDOW, SPANGLE_TEXT("the window is destroyed")) != EGL_FALSE;
#endif
    return true;
}

/// True if the surface has a buffer. If its display has given none so far, the display is asked again.
bool has_pixels(Display& display, Surface& surface) {
    return exists(surface) && (surface.has_pixels() || next_frame(display, surface));
}

/// Checks the arguments of eglMakeCurrent. On success, it marks the objects as current at once, so that no
/// other thread takes them meanwhile.
EGLBoolean bind_current(Display& display, Context& context, Surface& draw, Surface& read) {
    if (!are_compatible(context.config, draw.config) || !are_compatible(context.config, read.config))
        return fail(EGL_BAD_MATCH, SPANGLE_TEXT("the context's config has another colour format, "
                                                "depth buffer or multisample buffer than the surface's"));
    // Records are replayed by the fixed policy only.
    const bool records = SPANGLE_HAS_RECORDS && (draw.band.record != nullptr || read.band.record != nullptr);
    if (records &&
        (&draw != &read || precision_of(context.config.precision).engine != &spangle::gl::fixed_engine))
        return fail(EGL_BAD_MATCH, SPANGLE_TEXT("a window with a record is drawn to and read "
                                                "at once, and not by a reference"));
    if (context.current && thread().context != &context)
        return fail(EGL_BAD_ACCESS, SPANGLE_TEXT("the context is current on another thread"));
    if (is_current_elsewhere(&draw) || is_current_elsewhere(&read))
        return fail(EGL_BAD_ACCESS, SPANGLE_TEXT("a surface is current on another thread"));
    if (!has_pixels(display, draw) || !has_pixels(display, read))
        return EGL_FALSE;
    ++draw.bindings;
    ++read.bindings;
    context.current = true;
    return EGL_TRUE;
}

} // namespace

#if !SPANGLE_HAS_PLATFORMS

/// Checks the attributes of eglCreateContext. OpenGL contexts have none in EGL 1.4.
EGLint context_problem(const EGLint* list) {
    return list == nullptr || *list == EGL_NONE ? EGL_SUCCESS : EGL_BAD_ATTRIBUTE;
}

#endif

void show_pixels() {
    const Thread& t = thread();
    gl::Drawable& drawable = t.context->gl->drawable;
    set_pixels(*t.draw, drawable.surface);
    drawable.double_buffered = t.draw->back_buffered;
    drawable.front_buffered = names_front(*t.draw);
    set_pixels(*t.read, drawable.read);
    drawable.read_double_buffered = t.read->back_buffered;
    drawable.read_front_buffered = names_front(*t.read);
#if SPANGLE_MESSAGES
    drawable.show = [](bool finish) {
        begin_call(finish ? "glFinish" : "glFlush");
        show_window(finish);
    };
#else
    drawable.show = show_window;
#endif
#if SPANGLE_HAS_PLATFORMS
    drawable.follow = t.draw->system != nullptr ? follow_current_window : nullptr;
#endif
    gl::make_current(*t.context->gl);
}

#if SPANGLE_HAS_PLATFORMS

void follow_current_window() {
    begin_call(SPANGLE_TEXT("glViewport"));
    const Thread& t = thread();
    const EGLint before = t.error;
    const gl::LockGuard held(t.display->native_lock);
    const std::uint8_t* const pixels = t.draw->frame.pixels;
    const std::int32_t width = t.draw->width, height = t.draw->height;
    if (t.draw->cut_off)
        return;
    (void)follow_window(*t.display, *t.draw);
    if (t.draw->width != width || t.draw->height != height || t.draw->frame.pixels != pixels)
        show_pixels();
    thread().error = before;
}

#endif

void release_current(const Context* next) {
    Thread& t = thread();
    if (t.context == nullptr)
        return;
    show_window(false); // changing the context flushes the old one (EGL 1.4, 3.7.3)
    const Registry registry;
    Display& display = *t.display;
    Context* const context = t.context;
    Surface* const surfaces[2] = {t.draw, t.read};
    detach_record(*t.draw);
    gl::set_current_context(nullptr);
    t.display = nullptr;
    t.context = nullptr;
    t.draw = t.read = nullptr;
    context->current = context == next;
    for (Surface* s : surfaces)
        --s->bindings;
    if (display.free_unused_objects != nullptr)
        display.free_unused_objects(display);
}

} // namespace spangle::egl

using namespace spangle::egl;

extern "C" {

EGLContext eglCreateContext(EGLDisplay dpy, EGLConfig config, EGLContext share_context,
                            const EGLint* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreateContext"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_NO_CONTEXT;
    const Config found = made_of(find_config(*display, config));
    if (found.id == 0) {
        fail(EGL_BAD_CONFIG, SPANGLE_TEXT("config is not one of this display"));
        return EGL_NO_CONTEXT;
    }
    Context* const share = share_context == EGL_NO_CONTEXT ? nullptr : find_context(*display, share_context);
    if (share_context != EGL_NO_CONTEXT && share == nullptr)
        return EGL_NO_CONTEXT;
    const EGLint problem = context_problem(attrib_list);
    if (problem != EGL_SUCCESS) {
        fail(problem, SPANGLE_TEXT("attrib_list asks for a context that there is not"));
        return EGL_NO_CONTEXT;
    }
    const Precision precision = precision_of(found.precision);
    void* const memory = arena().allocate(sizeof(Context));
    spangle::gl::Context* const gl =
        memory == nullptr ? nullptr
                          : spangle::gl::create_context(arena(), {precision.tier, precision.engine},
                                                        share == nullptr ? nullptr : share->gl);
    if (gl == nullptr) {
        arena().free(memory);
        fail(EGL_BAD_ALLOC, SPANGLE_TEXT("not enough memory; see spangle::memory"));
        return EGL_NO_CONTEXT;
    }
    auto* const context = new (memory) Context();
    context->config = found;
    context->gl = gl;
    context->next = display->contexts;
    display->contexts = context;
#if SPANGLE_HAS_PLATFORMS
    if (platforms().created != nullptr)
        platforms().created(*gl);
#endif
    end_call();
    return context;
}

EGLBoolean eglDestroyContext(EGLDisplay dpy, EGLContext handle) {
    begin_call(SPANGLE_TEXT("eglDestroyContext"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    Context* const context = find_context(*display, handle);
    if (context == nullptr)
        return EGL_FALSE;
    context->destroyed = true;
    free_destroyed(*display);
    return end_call();
}

/// Makes a context current. Between glBegin and glEnd this is refused, because GL defines no primitive whose
/// drawable changes. The drawable, and everything derived from its size and formats, stays until the
/// primitive ends.
EGLBoolean eglMakeCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext ctx) {
    Display* display = nullptr;
    Context* context = nullptr;
    Surface *draw_surface = nullptr, *read_surface = nullptr;
    {
        const Registry registry;
        begin_call(SPANGLE_TEXT("eglMakeCurrent"));
        if (ctx == EGL_NO_CONTEXT) { // EGL 1.4, 3.7.3 allows this on an uninitialised display
            if (find_entry(dpy) == nullptr)
                return EGL_FALSE;
            if (draw != EGL_NO_SURFACE || read != EGL_NO_SURFACE)
                return fail(EGL_BAD_MATCH, SPANGLE_TEXT("surfaces are given, but no context"));
        } else {
            display = find_display(dpy);
            if (display == nullptr)
                return EGL_FALSE;
            context = find_context(*display, ctx);
            if (context == nullptr)
                return EGL_FALSE;
            if (draw == EGL_NO_SURFACE || read == EGL_NO_SURFACE)
                return fail(EGL_BAD_MATCH, SPANGLE_TEXT("a context is given, but not both surfaces"));
            draw_surface = find_surface(*display, draw);
            read_surface = find_surface(*display, read);
            if (draw_surface == nullptr || read_surface == nullptr)
                return EGL_FALSE;
        }
        if (in_primitive())
            return fail_in_primitive();
        if (context != nullptr && bind_current(*display, *context, *draw_surface, *read_surface) == EGL_FALSE)
            return EGL_FALSE;
    }
    release_current(context);
    if (context == nullptr)
        return end_call();
    const Registry registry;
    thread().display = display;
    thread().context = context;
    thread().draw = draw_surface;
    thread().read = read_surface;
    show_pixels();
    attach_record(*draw_surface);
    return end_call();
}

EGLContext eglGetCurrentContext() {
    return thread().context;
}

EGLSurface eglGetCurrentSurface(EGLint readdraw) {
    begin_call(SPANGLE_TEXT("eglGetCurrentSurface"));
    if (readdraw == EGL_DRAW)
        return thread().draw;
    if (readdraw == EGL_READ)
        return thread().read;
    fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("readdraw is neither EGL_DRAW nor EGL_READ"));
    return EGL_NO_SURFACE;
}

EGLDisplay eglGetCurrentDisplay() {
    return thread().display;
}

EGLBoolean eglQueryContext(EGLDisplay dpy, EGLContext ctx, EGLint attribute, EGLint* value) {
    begin_call(SPANGLE_TEXT("eglQueryContext"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    const Context* const context = find_context(*display, ctx);
    if (context == nullptr)
        return EGL_FALSE;
    if (value == nullptr)
        return fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("value is a null pointer"));
    switch (attribute) {
    case EGL_CONFIG_ID:
        *value = context->config.id;
        break;
    case EGL_CONTEXT_CLIENT_TYPE:
        *value = EGL_OPENGL_API;
        break;
    case EGL_CONTEXT_CLIENT_VERSION:
        *value = 1;
        break;
    case EGL_RENDER_BUFFER:
        *value = thread().context != context || thread().draw == nullptr ? EGL_NONE
                 : thread().draw->back_buffered                          ? EGL_BACK_BUFFER
                                                                         : EGL_SINGLE_BUFFER;
        break;
    default:
        return fail(EGL_BAD_ATTRIBUTE, SPANGLE_TEXT("attribute is not one of contexts"));
    }
    return end_call();
}
}
