// The display and the memory that a board hands to EGL.
#pragma once

#include <cstddef>

#include <spangle/EGL/egl.h>
#include <spangle/hal/display.hpp>

namespace spangle {

/// A HAL display in the form that eglGetDisplay takes. eglInitialize initialises the panel. The display has
/// one window, which covers all of it: eglCreateWindowSurface(dpy, config, 0, nullptr). `display` must
/// outlive eglTerminate.
inline EGLNativeDisplayType native(hal::Display& display) {
    return &display;
}

/// Hands `bytes` bytes of memory to Spangle for good, before eglInitialize. Contexts, depth buffers,
/// pbuffers, textures and display lists lie in it. Without this call a host uses SPANGLE_HOST_MEMORY_MB
/// mebibytes of its own (64 by default), and on a board EGL functions fail with EGL_BAD_ALLOC.
void memory(void* begin, std::size_t bytes);

/// The use of Spangle's memory.
struct MemoryUse {
    /// The number of bytes that are in use now, the largest number that ever was in use, and the size of the
    /// memory.
    std::size_t used, peak, capacity;
};
/// Returns the memory that all contexts and share groups use now. It may be called at any time.
MemoryUse memory_use();

} // namespace spangle
