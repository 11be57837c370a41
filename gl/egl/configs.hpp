// The configs of a display: each combination of a format, a depth buffer and a precision, with samples and
// without.
#pragma once

#include "gl/egl/objects.hpp"

namespace spangle::gl {
struct Engine;
}

namespace spangle::egl {

/// Returns the config of a handle, or a config of id 0 if there is none.
Config find_config(const Display& display, EGLConfig handle);

/// Returns the config that pbuffers and contexts of `config` get: `config` itself, unless Platforms::drawn
/// overrides it.
#if SPANGLE_HAS_PLATFORMS
Config made_of(Config config);
#else
inline const Config& made_of(const Config& config) {
    return config;
}
#endif

/// Swap intervals: 1 waits until the display has taken the last frame, 0 does not wait (EGL 1.4, 3.9.3).
inline constexpr EGLint least_swap_interval = 0, most_swap_interval = 1;

/// True if a window of this display may have the config. A panel accepts its own format only.
bool fits_window(const Display& display, const Config& config);

/// The engine and tier of a precision. `engine` is null if this program has none.
struct Precision {
    const gl::Engine* engine;
    raster::Tier tier;
};
Precision precision_of(EGLint precision);

/// Registers the engine of a reference policy, DOUBLE or SHADOW. The engine of SHADOW serves all three tiers.
/// Host tools call this before they create contexts.
void register_engine(EGLint precision, const gl::Engine* engine);

} // namespace spangle::egl
