// The configurations of a display: formats x depth buffers x precisions, with samples and without.
#pragma once

#include "gl/egl/objects.hpp"

namespace spangle::gl {
struct Engine;
}

namespace spangle::egl {

/// The configuration behind a handle; id 0 when there is none.
Config find_config(const Display& display, EGLConfig handle);

/// The configuration that pbuffers and contexts of `config` really get: `config` itself unless
/// Platforms::drawn overrides it.
#if SPANGLE_HAS_PLATFORMS
Config made_of(Config config);
#else
inline const Config& made_of(const Config& config) {
    return config;
}
#endif

/// Swap intervals: 1 waits until the display has taken the last frame, 0 does not wait (EGL 1.4, 3.9.3).
inline constexpr EGLint least_swap_interval = 0, most_swap_interval = 1;

/// Whether a window of this display may have the configuration: a panel takes its own format only.
bool fits_window(const Display& display, const Config& config);

/// The engine and tier of a precision; engine null when this program has none.
struct Precision {
    const gl::Engine* engine;
    raster::Tier tier;
};
Precision precision_of(EGLint precision);

/// Registers the engine of a reference policy, DOUBLE or SHADOW; SHADOW's engine serves all three tiers. Host
/// tools call this before they create contexts.
void register_engine(EGLint precision, const gl::Engine* engine);

} // namespace spangle::egl
