// The configurations of a display: formats x depth buffers x precisions, with samples and without.
#pragma once

#include "gl/egl/objects.hpp"

namespace spangle::gl {
struct Engine;
}

namespace spangle::egl {

/// The configuration behind a handle; id 0 when there is none.
Config find_config(const Display& display, EGLConfig handle);

/// What a pbuffer or a context of a configuration has: the same, unless Platforms::drawn says otherwise.
#if SPANGLE_HAS_PLATFORMS
Config made_of(Config config);
#else
inline const Config& made_of(const Config& config) {
    return config;
}
#endif

/// A window waits for the last frame to be taken, or it does not (EGL 1.4, 3.9.3).
inline constexpr EGLint least_swap_interval = 0, most_swap_interval = 1;

/// Whether a window of this display may have the configuration: only in the panel's own format.
bool fits_window(const Display& display, const Config& config);

/// The engine and tier of a precision; engine null when this program has none.
struct Precision {
    const gl::Engine* engine;
    raster::Tier tier;
};
Precision precision_of(EGLint precision);

/// Host tools link the reference policies and name them here, before contexts are made: DOUBLE, and SHADOW
/// for its three tiers.
void register_engine(EGLint precision, const gl::Engine* engine);

} // namespace spangle::egl
