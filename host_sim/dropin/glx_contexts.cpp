// The contexts of GLX, which of them is current, and swapping of buffers (GLX 1.4, 3.3.7 to 3.3.10).
#include <set>

#include <spangle/GL/gl.h>

#include "gl/context/context.hpp"
#include "host_sim/dropin/glx_drawables.hpp"

using namespace spangle::dropin::glx;

struct SpangleGlxContext {
    Display* display = nullptr;
    GLXFBConfig config = nullptr;
    EGLDisplay egl_display = EGL_NO_DISPLAY; ///< kept when the connection is closed
    EGLContext egl = EGL_NO_CONTEXT;
    GLXContextID id = 0;
    bool destroyed = false; ///< the context is freed once no thread has it current
    int users = 0;          ///< number of threads to which the context is current: 0 or 1
};

namespace {

/// The context that is current on this thread, and its drawables.
struct Current {
    GLXContext context = nullptr;
    Display* display = nullptr;
    GLXDrawable draw = 0, read = 0;
    std::shared_ptr<Target> draw_to, read_from;
};
thread_local Current current;

std::set<GLXContext>& contexts() {
    static auto* const all = new std::set<GLXContext>;
    return *all;
}

bool exists(GLXContext context) {
    const std::lock_guard<std::recursive_mutex> guard(lock());
    return contexts().count(context) != 0 && !context->destroyed;
}

void free_if_unused(GLXContext context) {
    if (!context->destroyed || context->users != 0)
        return;
    eglDestroyContext(context->egl_display, context->egl);
    contexts().erase(context);
    delete context;
}

/// Reports the last error of EGL as the error that GLX has for it.
void report_refusal(Display* display, Request request, GLXDrawable drawable) {
    switch (eglGetError()) {
    case EGL_BAD_ACCESS:
        return spangle::gl::current_context() != nullptr && spangle::gl::current_context()->inside_begin_end()
                   ? report(display, Problem::context_state, request, 0)
                   : report_core(display, BadAccess, request, 0);
    case EGL_BAD_ALLOC:
        return report_core(display, BadAlloc, request, 0);
    case EGL_BAD_MATCH:
        return report_core(display, BadMatch, request, drawable);
    default:
        return report(display, Problem::drawable, request, drawable);
    }
}

/// The attributes with which glXCreateContextAttribsARB is called.
struct ContextAttributes {
    int major = 1, minor = 0, flags = 0;
    int error = Success;        ///< X's error with which the list is refused
    bool profile_error = false; ///< the list of attributes is refused with GLXBadProfileARB
};

bool is_defined_version(int major, int minor) {
    constexpr int last_minor[] = {-1, 5, 1, 3, 6}; // last minor versions of OpenGL 1, 2, 3 and 4
    return major >= 1 && major <= 4 && minor >= 0 && minor <= last_minor[major];
}

/// Whether the mask names exactly one profile. Profiles exist from OpenGL 3.2 on, but a mask that names none
/// or several is refused for every version.
bool is_profile(int mask) {
    return mask == CONTEXT_CORE_PROFILE_BIT || mask == CONTEXT_COMPATIBILITY_PROFILE_BIT;
}

/// Reads and checks the attributes. A value that no version knows is BadValue. A version that does not exist,
/// or that lacks what is asked for with it, is BadMatch (GLX_ARB_create_context,
/// GLX_ARB_create_context_profile).
ContextAttributes context_wish(const int* list) {
    ContextAttributes wish;
    bool color_index = false;
    for (; list != nullptr && *list != 0; list += 2) {
        const int value = list[1];
        bool known = true;
        switch (list[0]) {
        case CONTEXT_MAJOR_VERSION:
            wish.major = value;
            break;
        case CONTEXT_MINOR_VERSION:
            wish.minor = value;
            break;
        case CONTEXT_FLAGS:
            wish.flags = value;
            known = (value & ~(CONTEXT_DEBUG_BIT | CONTEXT_FORWARD_COMPATIBLE_BIT)) == 0;
            break;
        case CONTEXT_PROFILE_MASK:
            wish.profile_error = wish.profile_error || !is_profile(value);
            break;
        case RENDER_TYPE:
            color_index = value == COLOR_INDEX_TYPE;
            known = color_index || value == RGBA_TYPE;
            break;
        default:
            known = false;
        }
        if (!known) {
            wish.error = BadValue;
            return wish;
        }
    }
    const bool forward = (wish.flags & CONTEXT_FORWARD_COMPATIBLE_BIT) != 0 && wish.major < 3;
    if (!is_defined_version(wish.major, wish.minor) || forward || color_index)
        wish.error = BadMatch;
    return wish;
}

GLXContext create(Display* display, GLXFBConfig config, GLXContext share, const EGLint* attributes,
                  Request request, Problem refusal) {
    if (share != nullptr && !exists(share)) {
        report(display, Problem::context, request, 0);
        return nullptr;
    }
    const std::lock_guard<std::recursive_mutex> guard(lock());
    const EGLDisplay on = egl_display(display);
    const EGLContext egl =
        eglCreateContext(on, config->egl, share == nullptr ? EGL_NO_CONTEXT : share->egl, attributes);
    if (egl == EGL_NO_CONTEXT) {
        if (eglGetError() == EGL_BAD_ALLOC)
            report_core(display, BadAlloc, request, 0);
        else
            report(display, refusal, request, 0);
        return nullptr;
    }
    static GLXContextID last = 0;
    auto* const context = new SpangleGlxContext;
    context->display = display;
    context->config = config;
    context->egl_display = on;
    context->egl = egl;
    context->id = ++last;
    contexts().insert(context);
    return context;
}

Bool release() {
    const std::lock_guard<std::recursive_mutex> guard(lock());
    if (current.context == nullptr)
        return True;
    // This call names no display, because the connection may be closed.
    if (eglReleaseThread() == EGL_FALSE) {
        report_refusal(current.display, Request::make_current, 0);
        return False;
    }
    const GLXContext old = current.context;
    --old->users;
    current = {};
    free_if_unused(old);
    return True;
}

Bool make_current(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext context, Request request) {
    if (context == nullptr && draw == 0 && read == 0)
        return release();
    if (context == nullptr || draw == 0 || read == 0) {
        report_core(display, BadMatch, request, draw);
        return False;
    }
    if (!exists(context)) {
        report(display, Problem::context, request, 0);
        return False;
    }
    const std::lock_guard<std::recursive_mutex> guard(lock());
    const std::shared_ptr<Target> draw_to = drawable_of(display, draw),
                                  read_from = read == draw ? draw_to : drawable_of(display, read);
    const EGLSurface draw_surface = surface_of(display, *draw_to, context->config);
    const EGLSurface read_surface =
        draw_surface == EGL_NO_SURFACE ? EGL_NO_SURFACE : surface_of(display, *read_from, context->config);
    if (read_surface == EGL_NO_SURFACE) {
        const GLXDrawable wrong = draw_surface == EGL_NO_SURFACE ? draw : read;
        const Target& without = draw_surface == EGL_NO_SURFACE ? *draw_to : *read_from;
        if (without.made && without.config->egl != context->config->egl)
            report_core(display, BadMatch, request, wrong);
        else
            report_refusal(display, request, wrong);
        return False;
    }
    if (eglMakeCurrent(egl_display(display), draw_surface, read_surface, context->egl) == EGL_FALSE) {
        report_refusal(display, request, draw);
        return False;
    }
    const GLXContext old = current.context;
    ++context->users;
    current = {context, display, draw, read, draw_to, read_from};
    if (old != nullptr) {
        --old->users;
        free_if_unused(old);
    }
    return True;
}

} // namespace

/// Releases what belongs to a connection before it is closed. Programs may do so with a primitive begun and a
/// context current. GL and EGL do not release a context inside a primitive (EGL 1.4, 3.7.3), so the primitive
/// is ended first.
void spangle::dropin::glx::forget_connection(Display* display) {
    const EGLDisplay egl = eglGetPlatformDisplayEXT(EGL_PLATFORM_X11_KHR, display, nullptr);
    if (egl == EGL_NO_DISPLAY)
        return;
    if (eglGetCurrentDisplay() == egl) {
        const spangle::gl::Context* const context = spangle::gl::current_context();
        if (context != nullptr && context->inside_begin_end())
            glEnd();
        release();
        eglReleaseThread(); // releases a context that EGL itself made current
    }
    eglTerminate(egl); // contexts current to other threads stay until released
    const std::lock_guard<std::recursive_mutex> guard(lock());
    for (auto at = contexts().begin(); at != contexts().end();) {
        const GLXContext context = *at++;
        if (context->display != display)
            continue;
        context->destroyed = true;
        free_if_unused(context);
    }
    forget_drawables(display);
    forget_configs(display);
}

extern "C" {

GLXContext glXCreateNewContext(Display* display, GLXFBConfig config, int render_type, GLXContext share,
                               Bool) {
    const GLXFBConfig found = checked(display, config);
    if (found == nullptr) {
        report(display, Problem::fb_config, Request::create_new_context, 0);
        return nullptr;
    }
    if (render_type != RGBA_TYPE) {
        report_core(display, BadValue, Request::create_new_context, 0);
        return nullptr;
    }
    return create(display, found, share, nullptr, Request::create_new_context, Problem::fb_config);
}

GLXContext glXCreateContext(Display* display, XVisualInfo* visual, GLXContext share, Bool) {
    const GLXFBConfig config =
        visual == nullptr ? nullptr : of_visual(display, visual->screen, visual->visualid);
    if (config == nullptr) {
        report_core(display, BadValue, Request::create_context, 0);
        return nullptr;
    }
    return create(display, config, share, nullptr, Request::create_context, Problem::fb_config);
}

GLXContext glXCreateContextWithConfigSGIX(Display* display, GLXFBConfig config, int render_type,
                                          GLXContext share, Bool direct) {
    return glXCreateNewContext(display, config, render_type, share, direct);
}

GLXContext glXCreateContextAttribsARB(Display* display, GLXFBConfig config, GLXContext share, Bool,
                                      const int* list) {
    const GLXFBConfig found = checked(display, config);
    if (found == nullptr) {
        report(display, Problem::fb_config, Request::create_context_attribs, 0);
        return nullptr;
    }
    const ContextAttributes wish = context_wish(list);
    if (wish.profile_error) {
        report(display, Problem::profile, Request::create_context_attribs, 0);
        return nullptr;
    }
    if (wish.error != Success) {
        report_core(display, wish.error, Request::create_context_attribs, 0);
        return nullptr;
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                 wish.major,
                                 EGL_CONTEXT_MINOR_VERSION_KHR,
                                 wish.minor,
                                 EGL_CONTEXT_FLAGS_KHR,
                                 wish.flags,
                                 EGL_NONE};
    return create(display, found, share, attributes, Request::create_context_attribs, Problem::fb_config);
}

void glXDestroyContext(Display* display, GLXContext context) {
    if (context == nullptr)
        return;
    if (!exists(context))
        return report(display, Problem::context, Request::create_context, 0);
    const std::lock_guard<std::recursive_mutex> guard(lock());
    context->destroyed = true;
    free_if_unused(context);
}

Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context) {
    return make_current(display, drawable, drawable, context, Request::make_current);
}

Bool glXMakeContextCurrent(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
    return make_current(display, draw, read, context, Request::make_context_current);
}

Bool glXMakeCurrentReadSGI(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
    return glXMakeContextCurrent(display, draw, read, context);
}

/// EGL has no way to copy state from one context to another, and neither has Spangle.
void glXCopyContext(Display* display, GLXContext, GLXContext, unsigned long) {
    report_core(display, BadImplementation, Request::copy_context, 0);
}

Bool glXIsDirect(Display* display, GLXContext context) {
    if (exists(context))
        return True;
    report(display, Problem::context, Request::create_context, 0);
    return False;
}

int glXQueryContext(Display* display, GLXContext context, int name, int* value) {
    if (!exists(context)) {
        report(display, Problem::context, Request::create_context, 0);
        return BAD_CONTEXT;
    }
    switch (name) {
    case FBCONFIG_ID:
        *value = context->config->id;
        return Success;
    case RENDER_TYPE:
        *value = RGBA_TYPE;
        return Success;
    case SCREEN:
        *value = context->config->screen;
        return Success;
    default:
        return BAD_ATTRIBUTE;
    }
}

GLXContext glXGetCurrentContext() {
    return current.context;
}

GLXDrawable glXGetCurrentDrawable() {
    return current.draw;
}

GLXDrawable glXGetCurrentReadDrawable() {
    return current.read;
}

GLXDrawable glXGetCurrentReadDrawableSGI() {
    return current.read;
}

Display* glXGetCurrentDisplay() {
    return current.display;
}

void glXSwapBuffers(Display* display, GLXDrawable id) {
    if (current.context != nullptr && current.display == display && current.draw == id) {
        if (eglSwapBuffers(egl_display(display), current.draw_to->surface) == EGL_FALSE)
            report(display, Problem::current_window, Request::swap_buffers, id);
        return;
    }
    // A drawable that is not current has nothing new to show, so that only its name can be wrong.
    if (made_drawable(display, id) == nullptr)
        report(display, Problem::drawable, Request::swap_buffers, id);
}

void glXWaitGL() {
    if (current.context != nullptr)
        eglWaitClient();
}

void glXWaitX() {
    if (current.context != nullptr)
        XSync(current.display, False);
}

void glXSwapIntervalEXT(Display* display, GLXDrawable, int interval) {
    if (current.context == nullptr)
        return;
    if (interval < 0)
        return report_core(display, BadValue, Request::swap_buffers, 0);
    eglSwapInterval(current.context->egl_display, interval);
}

int glXSwapIntervalSGI(int interval) {
    if (interval <= 0)
        return BAD_VALUE;
    if (current.context == nullptr)
        return BAD_CONTEXT;
    eglSwapInterval(current.context->egl_display, interval);
    return 0;
}
}

namespace {
thread_local unsigned mesa_interval = 0;
}

extern "C" {

int glXSwapIntervalMESA(unsigned int interval) {
    if (current.context == nullptr)
        return BAD_CONTEXT;
    mesa_interval = interval;
    eglSwapInterval(current.context->egl_display, static_cast<EGLint>(interval != 0));
    return 0;
}

int glXGetSwapIntervalMESA() {
    return static_cast<int>(mesa_interval);
}
}
