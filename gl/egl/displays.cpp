// Displays, memory, strings, errors of this thread (EGL 1.4, 3.1 to 3.3, 3.11).
#include <spangle/message.hpp>
#include <spangle/native.hpp>

#include "gl/api/names.hpp"
#include "gl/context/error.hpp"
#include "gl/egl/objects.hpp"
#include "gl/egl/platforms.hpp"

namespace spangle {

namespace egl {

namespace {

constinit Display displays[gl::most_displays] = {};
constinit gl::Arena memory_arena;
constinit SPANGLE_THREAD_LOCAL Thread this_thread = {};

#ifndef SPANGLE_FIRMWARE
/// What a PC program gets that hands over nothing: never touched unless it is used.
alignas(16) unsigned char host_memory[64u << 20];
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
    return surface.bindings != 0;
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

void sweep(Display& display) {
    sweep_list(&display.surfaces);
    sweep_list(&display.contexts);
}

} // namespace

Thread& thread() {
    return this_thread;
}

EGLBoolean fail(EGLint error, const char* text) {
    this_thread.error = error;
    if (text != nullptr)
        message(static_cast<unsigned>(error), text);
    return EGL_FALSE;
}

EGLBoolean succeed() {
    this_thread.error = EGL_SUCCESS;
    return EGL_TRUE;
}

Display* find_display(EGLDisplay handle) {
    for (Display& display : displays) {
        if (!display.used || &display != handle)
            continue;
        if (display.initialized)
            return &display;
        fail(EGL_NOT_INITIALIZED);
        return nullptr;
    }
    fail(EGL_BAD_DISPLAY);
    return nullptr;
}

Surface* find_surface(Display& display, EGLSurface handle) {
    Surface* const surface = on_list(display.surfaces, handle);
    if (surface == nullptr)
        fail(EGL_BAD_SURFACE);
    return surface;
}

Context* find_context(Display& display, EGLContext handle) {
    Context* const context = on_list(display.contexts, handle);
    if (context == nullptr)
        fail(EGL_BAD_CONTEXT);
    return context;
}

gl::Arena& arena() {
#ifndef SPANGLE_FIRMWARE
    if (memory_arena.capacity() == 0)
        memory_arena.give(host_memory, sizeof host_memory);
#endif
    return memory_arena;
}

void free_destroyed(Display& display) {
    display.sweep = sweep;
    sweep(display);
}

EGLDisplay display_of(hal::Display* native, [[maybe_unused]] hal::WindowSystem* system) {
    const auto is_it = [&](const Display& display) {
#if SPANGLE_HAS_PLATFORMS
        if (display.system != system)
            return false;
#endif
        return display.native == native;
    };
    for (Display& display : displays)
        if (display.used && is_it(display))
            return &display;
    for (Display& display : displays)
        if (!display.used) {
            display.used = true;
            display.native = native;
#if SPANGLE_HAS_PLATFORMS
            display.system = system;
#endif
            return &display;
        }
    return EGL_NO_DISPLAY; // no error exists for this (EGL 1.4, 3.2)
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
    for (Display& display : displays) {
        if (!display.used || &display != dpy)
            continue;
        if (!display.initialized && display.native != nullptr) {
            const spangle::hal::Result<void> up = display.native->init();
            if (!up.ok())
                return fail(EGL_NOT_INITIALIZED, up.error().rule);
        }
#if SPANGLE_HAS_PLATFORMS
        if (!display.initialized && display.system != nullptr) {
            const spangle::hal::Result<void> up = display.system->init();
            if (!up.ok())
                return fail(EGL_NOT_INITIALIZED, up.error().rule);
        }
#endif
        display.initialized = true;
        if (major != nullptr)
            *major = 1;
        if (minor != nullptr)
            *minor = 4;
        return succeed();
    }
    return fail(EGL_BAD_DISPLAY);
}

EGLBoolean eglTerminate(EGLDisplay dpy) {
    for (Display& display : displays) {
        if (!display.used || &display != dpy)
            continue;
        // What is current stays alive until it is released (EGL 1.4, 3.2).
        for (Surface* s = display.surfaces; s != nullptr; s = s->next)
            s->destroyed = true;
        for (Context* c = display.contexts; c != nullptr; c = c->next)
            c->destroyed = true;
        free_destroyed(display);
        display.initialized = false;
        // With nothing left alive the entry can serve another display.
        if (display.surfaces == nullptr && display.contexts == nullptr)
            display.used = false;
        return succeed();
    }
    return fail(EGL_BAD_DISPLAY);
}

const char* eglQueryString(EGLDisplay dpy, EGLint name) {
#if SPANGLE_HAS_PLATFORMS
    if (dpy == EGL_NO_DISPLAY && name == EGL_EXTENSIONS)
        return client_extensions();
#endif
    if (find_display(dpy) == nullptr)
        return nullptr;
    succeed();
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
#if SPANGLE_FEATURE_BANDS
               " EGL_SPANGLE_bands"
#endif
#if SPANGLE_FEATURE_COLOR_INDEX
               " EGL_SPANGLE_color_index"
#endif
            ;
    default:
        fail(EGL_BAD_PARAMETER);
        return nullptr;
    }
}

EGLBoolean eglBindAPI(EGLenum api) {
    return api == EGL_OPENGL_API ? succeed() : fail(EGL_BAD_PARAMETER);
}

/// OpenGL from the start: EGL 1.4, 3.7 begins with NONE where there is no OpenGL ES, which would only ask
/// programs of the one API there is to bind it.
EGLenum eglQueryAPI() {
    return EGL_OPENGL_API;
}

EGLBoolean eglReleaseThread() {
    release_current();
    return succeed();
}

EGLBoolean eglWaitGL() {
    return eglWaitClient();
}

EGLBoolean eglWaitClient() { // as Finish (EGL 1.4, 3.8)
    show_window(true);
    return succeed();
}

EGLBoolean eglWaitNative(EGLint engine) {
    return engine == EGL_CORE_NATIVE_ENGINE ? succeed() : fail(EGL_BAD_PARAMETER);
}
}
