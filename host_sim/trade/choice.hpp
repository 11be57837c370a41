// What can be chosen: tiers and formats, by name.
#pragma once

#include <string_view>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>

namespace spangle::trade {

struct Tier {
    const char* name;
    EGLint precision, shadow;
};
inline constexpr Tier tiers[] = {
    {"exact", EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_SHADOW_SPANGLE},
    {"balanced", EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_SHADOW_BALANCED_SPANGLE},
    {"fast", EGL_PRECISION_FAST_SPANGLE, EGL_PRECISION_SHADOW_FAST_SPANGLE}};

struct Format {
    const char* name;
    PixelFormat format;
};
inline constexpr Format formats[] = {{"565", PixelFormat::rgb565_be}, {"888", PixelFormat::rgb888},
                                     {"8888", PixelFormat::rgba8888}, {"666", PixelFormat::rgb666},
                                     {"444", PixelFormat::rgb444},    {"332", PixelFormat::rgb332},
                                     {"grey4", PixelFormat::grey4},   {"mono", PixelFormat::mono}};

/// The one of that name, or null.
template <class Named, unsigned Count> const Named* find(const Named (&all)[Count], std::string_view name) {
    for (const Named& one : all)
        if (name == one.name)
            return &one;
    return nullptr;
}

} // namespace spangle::trade
