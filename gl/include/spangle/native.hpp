// What a board hands to EGL: its display, and memory.
#pragma once

#include <cstddef>

#include <spangle/EGL/egl.h>
#include <spangle/hal/display.hpp>

namespace spangle {

/// A HAL display as eglGetDisplay takes it. eglInitialize initialises the panel; its one window covers the
/// whole display: eglCreateWindowSurface(dpy, config, 0, nullptr). The display outlives eglTerminate.
inline EGLNativeDisplayType native(hal::Display& display) {
    return &display;
}

/// Hands memory to Spangle for good: contexts, depth buffers, pbuffers, textures and display lists lie in it.
/// Call it before eglInitialize. Without it a host uses SPANGLE_HOST_MEMORY_MB of its own (64 unless the
/// build says otherwise), and a board has none: EGL_BAD_ALLOC.
void memory(void* begin, std::size_t bytes);

/// Bytes of that memory in use, and the most that ever were.
struct MemoryUse {
    std::size_t used, peak, capacity;
};
MemoryUse memory_use();

} // namespace spangle
