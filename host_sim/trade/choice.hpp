// The tiers and formats that can be chosen, by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>
#include <spangle/raster/tier.hpp>

namespace spangle::trade {

struct Tier {
    std::string name;
    EGLint precision, shadow;
    std::optional<raster::Knobs> knobs = {}; ///< knobs of a tier that the user composed
    std::string words = {};                  ///< text from which the knobs were read
};
/// The knobs of a tier that the user composed; null for the three tiers of the library.
inline const raster::Knobs* own_knobs(const Tier& tier) {
    return tier.knobs ? &*tier.knobs : nullptr;
}
inline const Tier tiers[] = {
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

/// The entry of that name, or null.
template <class Named, unsigned Count> const Named* find(const Named (&all)[Count], std::string_view name) {
    for (const Named& one : all)
        if (name == one.name)
            return &one;
    return nullptr;
}

} // namespace spangle::trade
