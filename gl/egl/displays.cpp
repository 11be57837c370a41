// Displays, memory, strings, errors of this thread (EGL 1.4, 3.1 to 3.3, 3.11).
#include <spangle/message.hpp>
#include <spangle/native.hpp>

#include "gl/api/names.hpp"
#include "gl/context/error.hpp"
#include "gl/egl/objects.hpp"

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
        if (object == handle && object->destroyed == nullptr)
            return object;
    return nullptr;
}

template <class T> void unlink(T*& first, T* object) {
    T** link = &first;
    while (*link != object)
        link = &(*link)->next;
    *link = object->next;
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

void release(Display& display, Surface* surface) {
    if (surface->destroyed != nullptr && surface->bindings == 0)
        surface->destroyed(display, surface);
}

void release(Display& display, Context* context) {
    if (context->destroyed != nullptr && !context->current)
        context->destroyed(display, context);
}

void destroy(Display& display, Surface* surface) {
    surface->destroyed = [](Display& from, Surface* object) {
        unlink(from.surfaces, object);
        free_surface(object);
    };
    release(display, surface);
}

void destroy(Display& display, Context* context) {
    context->destroyed = [](Display& from, Context* object) {
        unlink(from.contexts, object);
        gl::destroy_context(object->gl);
        arena().free(object);
    };
    release(display, context);
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
    auto* const native = static_cast<spangle::hal::Display*>(display_id);
    for (Display& display : displays)
        if (display.used && display.native == native)
            return &display;
    for (Display& display : displays)
        if (!display.used) {
            display.used = true;
            display.native = native;
            return &display;
        }
    return EGL_NO_DISPLAY; // no error exists for this (EGL 1.4, 3.2)
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
        for (Surface* s = display.surfaces; s != nullptr;) {
            Surface* const next = s->next;
            destroy(display, s);
            s = next;
        }
        for (Context* c = display.contexts; c != nullptr;) {
            Context* const next = c->next;
            destroy(display, c);
            c = next;
        }
        display.initialized = false;
        // With nothing left alive the entry can serve another display.
        if (display.surfaces == nullptr && display.contexts == nullptr)
            display.used = false;
        return succeed();
    }
    return fail(EGL_BAD_DISPLAY);
}

const char* eglQueryString(EGLDisplay dpy, EGLint name) {
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
