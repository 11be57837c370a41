// Displays, the program's memory, EGL's strings, and the error of each thread (EGL 1.4, 3.1 to 3.3, 3.11).
#include <spangle/message.hpp>
#include <spangle/native.hpp>

#include "gl/api/names.hpp"
#include "gl/context/error.hpp"
#include "gl/context/sentence.hpp"
#include "gl/egl/objects.hpp"
#include "gl/egl/platforms.hpp"

namespace spangle {

namespace egl {

namespace {

constinit Display displays[gl::most_displays] = {};
constinit gl::Arena memory_arena;
constinit SPANGLE_THREAD_LOCAL Thread this_thread = {};

#ifndef SPANGLE_FIRMWARE
/// Memory of a PC program that gives none. Its pages stay untouched unless the program needs them.
alignas(16) unsigned char host_memory[gl::host_memory_bytes];
#endif

template <class T> T* on_list(T* first, const void* handle) {
    for (T* object = first; object != nullptr; object = object->next)
        if (object == handle && !object->destroyed)
            return object;
    return nullptr;
}

void free_object(Surface* surface) {
    free_surface(surface);
}

void free_object(Context* context) {
    gl::destroy_context(context->gl);
    arena().free(context);
}

bool is_held(const Surface& surface) {
    return surface.bindings != 0 || surface.frames != 0;
}

bool is_held(const Context& context) {
    return context.current;
}

template <class T> void sweep_list(T** link) {
    while (T* const object = *link) {
        if (object->destroyed && !is_held(*object)) {
            *link = object->next;
            free_object(object);
        } else {
            link = &object->next;
        }
    }
}

void free_unused_objects(Display& display) {
    sweep_list(&display.surfaces);
    sweep_list(&display.contexts);
}

#if SPANGLE_MESSAGES
constinit SPANGLE_THREAD_LOCAL const char* entered = nullptr; // name of the command that this thread runs
#endif

} // namespace

#if SPANGLE_MESSAGES
void begin_call(const char* command) {
    entered = command;
}
#endif

#if SPANGLE_THREADS
constinit gl::Lock registry_lock;
#endif

Thread& thread() {
    return this_thread;
}

EGLBoolean fail(EGLint error, [[maybe_unused]] const char* rule) {
    this_thread.error = error;
#if SPANGLE_MESSAGES
    if (rule != nullptr && entered != nullptr) {
        gl::Sentence out;
        out << entered << ": " << rule;
        message(static_cast<unsigned>(error), out.text());
    }
#endif
    return EGL_FALSE;
}

EGLBoolean end_call() {
    this_thread.error = EGL_SUCCESS;
    return EGL_TRUE;
}

bool in_primitive() {
    const Context* const context = this_thread.context;
    return context != nullptr && context->gl->inside_begin_end();
}

EGLBoolean fail_in_primitive() {
    return fail(EGL_BAD_ACCESS, SPANGLE_TEXT("between glBegin and glEnd surfaces stay current and nothing "
                                             "is shown; call glEnd first"));
}

Display* find_entry(EGLDisplay handle) {
    for (Display& display : displays)
        if (display.used && &display == handle)
            return &display;
    fail(EGL_BAD_DISPLAY, SPANGLE_TEXT("dpy is not a display of eglGetDisplay"));
    return nullptr;
}

Display* find_display(EGLDisplay handle) {
    Display* const display = find_entry(handle);
    if (display == nullptr || display->initialized)
        return display;
    fail(EGL_NOT_INITIALIZED, SPANGLE_TEXT("dpy has not been initialized, eglInitialize comes first"));
    return nullptr;
}

Surface* find_surface(Display& display, EGLSurface handle) {
    Surface* const surface = on_list(display.surfaces, handle);
    if (surface == nullptr)
        fail(EGL_BAD_SURFACE, SPANGLE_TEXT("the surface is not one of this display, or was destroyed"));
    return surface;
}

Context* find_context(Display& display, EGLContext handle) {
    Context* const context = on_list(display.contexts, handle);
    if (context == nullptr)
        fail(EGL_BAD_CONTEXT, SPANGLE_TEXT("the context is not one of this display, or was destroyed"));
    return context;
}

gl::Arena& arena() {
#ifndef SPANGLE_FIRMWARE
    memory_arena.give_first(host_memory, sizeof host_memory);
#endif
    return memory_arena;
}

void free_destroyed(Display& display) {
    display.free_unused_objects = free_unused_objects;
    free_unused_objects(display);
}

namespace {

/// Returns an entry for another display: an unused one, or one of a terminated display that has no objects
/// left. An object that is still current keeps its display's entry.
Display* free_entry() {
    for (Display& display : displays)
        if (!display.used)
            return &display;
    for (Display& display : displays)
        if (display.terminated && display.surfaces == nullptr && display.contexts == nullptr)
            return &display;
    return nullptr;
}

bool is_current(const Surface& surface) {
    return this_thread.draw == &surface || this_thread.read == &surface;
}

/// True if a window from before eglTerminate is still current on another thread, which draws into the
/// display's memory.
bool is_drawn_elsewhere(const Display& display) {
    for (const Surface* s = display.surfaces; s != nullptr; s = s->next)
        if (s->window && !is_current(*s))
            return true;
    return false;
}

/// Takes the pixels, which belong to the display, from all of its windows. GL is told about windows that are
/// current on this thread.
void cut_off_windows(Display& display) {
    {
        const gl::LockGuard held(display.native_lock);
        for (Surface* s = display.surfaces; s != nullptr; s = s->next)
            s->cut_off = s->window;
    }
    if (this_thread.display == &display)
        show_pixels();
}

} // namespace

EGLDisplay display_of(hal::Display* native, [[maybe_unused]] hal::WindowSystem* system) {
    const Registry registry;
    const auto is_it = [&](const Display& display) {
#if SPANGLE_HAS_PLATFORMS
        if (display.system != system)
            return false;
#endif
        return display.native == native;
    };
    for (Display& display : displays)
        if (display.used && is_it(display)) {
            display.terminated = false; // the caller uses this entry now, so it must not be reused
            return &display;
        }
    Display* const display = free_entry();
    if (display == nullptr)
        return EGL_NO_DISPLAY; // EGL defines no error for this (EGL 1.4, 3.2)
    display->used = true;
    display->terminated = false;
    display->native = native;
#if SPANGLE_HAS_PLATFORMS
    display->system = system;
#endif
    return display;
}

} // namespace egl

void memory(void* begin, std::size_t bytes) {
    egl::memory_arena.give(begin, bytes);
}

MemoryUse memory_use() {
    const gl::Arena& a = egl::arena();
    return {a.used(), a.peak(), a.capacity()};
}

} // namespace spangle

using namespace spangle::egl;

extern "C" {

EGLint eglGetError() {
    const EGLint error = thread().error;
    thread().error = EGL_SUCCESS;
    return error;
}

EGLDisplay eglGetDisplay(EGLNativeDisplayType display_id) {
#if SPANGLE_HAS_PLATFORMS
    if (platforms().find != nullptr)
        return platform_display(EGL_NONE, display_id);
#endif
    return display_of(static_cast<spangle::hal::Display*>(display_id), nullptr);
}

EGLBoolean eglInitialize(EGLDisplay dpy, EGLint* major, EGLint* minor) {
    begin_call(SPANGLE_TEXT("eglInitialize"));
    const Registry registry;
    Display* const display = find_entry(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    if (!display->initialized && display->native != nullptr) {
        if (is_drawn_elsewhere(*display))
            return fail(EGL_NOT_INITIALIZED, SPANGLE_TEXT("a window from before eglTerminate is "
                                                          "still current on another thread"));
        const spangle::gl::LockGuard held(display->native_lock);
        const spangle::hal::Result<void> up = display->native->init();
        if (!up.ok())
            return fail(EGL_NOT_INITIALIZED, up.error().rule);
    }
#if SPANGLE_HAS_PLATFORMS
    if (!display->initialized && display->system != nullptr) {
        const spangle::hal::Result<void> up = display->system->init();
        if (!up.ok())
            return fail(EGL_NOT_INITIALIZED, up.error().rule);
    }
#endif
    display->initialized = true;
    display->terminated = false;
    if (major != nullptr)
        *major = 1;
    if (minor != nullptr)
        *minor = 4;
    return end_call();
}

/// Terminates a display. The handle stays valid, and may be terminated or initialized again (EGL 1.4, 3.2),
/// until eglGetDisplay needs the entry for another display.
EGLBoolean eglTerminate(EGLDisplay dpy) {
    begin_call(SPANGLE_TEXT("eglTerminate"));
    const Registry registry;
    Display* const display = find_entry(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    if (thread().display == display && in_primitive())
        return fail_in_primitive();
    // Objects that are current stay alive until they are released (EGL 1.4, 3.2).
    for (Surface* s = display->surfaces; s != nullptr; s = s->next)
        s->destroyed = true;
    for (Context* c = display->contexts; c != nullptr; c = c->next)
        c->destroyed = true;
    cut_off_windows(*display);
    free_destroyed(*display);
    display->initialized = false;
    display->terminated = true;
    return end_call();
}

const char* eglQueryString(EGLDisplay dpy, EGLint name) {
    begin_call(SPANGLE_TEXT("eglQueryString"));
#if SPANGLE_HAS_PLATFORMS
    if (dpy == EGL_NO_DISPLAY && name == EGL_EXTENSIONS)
        return client_extensions();
#endif
    const Registry registry;
    if (find_display(dpy) == nullptr)
        return nullptr;
    end_call();
    switch (name) {
    case EGL_VENDOR:
        return "Spangle";
    case EGL_VERSION:
        return "1.4 Spangle";
    case EGL_CLIENT_APIS:
        return "OpenGL";
    case EGL_EXTENSIONS:
        return "EGL_EXT_buffer_age EGL_SPANGLE_precision"
#if SPANGLE_HAS_PLATFORMS
               " EGL_KHR_create_context EGL_KHR_get_all_proc_addresses"
#endif
#if SPANGLE_FEATURE_ACCUM
               " EGL_SPANGLE_accum"
#endif
#if SPANGLE_FEATURE_BANDS
               " EGL_SPANGLE_bands"
#endif
#if SPANGLE_FEATURE_COLOR_INDEX
               " EGL_SPANGLE_color_index"
#endif
            ;
    default:
        fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("name is not a string of a display"));
        return nullptr;
    }
}

EGLBoolean eglBindAPI(EGLenum api) {
    begin_call(SPANGLE_TEXT("eglBindAPI"));
    return api == EGL_OPENGL_API
               ? end_call()
               : fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("api is not EGL_OPENGL_API, the one there is"));
}

/// Returns OpenGL even before eglBindAPI. EGL 1.4, 3.7 begins with NONE if there is no OpenGL ES, but then
/// every program would have to bind the only API that exists.
EGLenum eglQueryAPI() {
    return EGL_OPENGL_API;
}

EGLBoolean eglReleaseThread() {
    begin_call(SPANGLE_TEXT("eglReleaseThread"));
    if (in_primitive())
        return fail_in_primitive();
    release_current();
    return end_call();
}

EGLBoolean eglWaitGL() {
    return eglWaitClient();
}

// eglWaitClient does what glFinish does (EGL 1.4, 3.8).
EGLBoolean eglWaitClient() {
    begin_call(SPANGLE_TEXT("eglWaitClient"));
    if (in_primitive())
        return fail_in_primitive();
    show_window(true);
    return end_call();
}

EGLBoolean eglWaitNative(EGLint engine) {
    begin_call(SPANGLE_TEXT("eglWaitNative"));
    return engine == EGL_CORE_NATIVE_ENGINE
               ? end_call()
               : fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("engine is not EGL_CORE_NATIVE_ENGINE"));
}
}
