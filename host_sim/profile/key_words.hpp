// State keys in words, for reports, and for images of firmware that count what each key costs. Both use these
// words, so that they can be matched.
#pragma once

#include "raster/span/key.hpp"

namespace spangle::profile {

namespace key_names {

inline constexpr const char *numbers[] = {"raw565", "balanced", "exact", "reference"},
                            *kinds[] = {"flat", "affine", "textured", "full"},
                            *compares[] = {"never",   "less",     "equal",  "lequal",
                                           "greater", "notequal", "gequal", "always"},
                            *texels[] = {"a8",     "l8",       "i8",       "la88",     "rgb565",
                                         "rgb888", "rgba8888", "rgba4444", "rgba5551", "rgb332",
                                         "z16",    "z24",      "p4",       "p8",       "etc1"},
                            *bases[] = {"alpha", "luminance", "luminance_alpha", "intensity", "rgb", "rgba"},
                            *filters[] = {"nearest", "linear"},
                            *environments[] = {"replace", "modulate", "decal", "blend", "add", "combine"},
                            *fogs[] = {"exp", "exp2", "linear"};
template <class E> const char* name(const char* const* of, E value) {
    return of[static_cast<unsigned>(value)];
}

} // namespace key_names

/// Writes what is on in a key: "balanced full depth(less) texture(rgb565 rgb nearest modulate)". `out` takes
/// texts and numbers by <<.
template <class Out> void say(Out& out, const raster::Key& key) {
    using namespace key_names;
    out << name(numbers, key.number) << " " << name(kinds, key.kind);
    if (needs_depth(key))
        out << " depth(" << name(compares, key.depth) << (key.depth_write ? ")" : ", not written)");
    const auto word = [&](bool is, const char* text) {
        if (is)
            out << " " << text;
    };
    word(key.depth_format == DepthFormat::z24s8, "24 bits");
    for (const raster::UnitKey& unit : key.unit) {
        word(unit.on && unit.general, "texture(any)");
        if (unit.on && !unit.general)
            out << " texture(" << name(texels, unit.texels) << " " << name(bases, unit.base) << " "
                << name(filters, unit.filter) << " " << name(environments, unit.env) << ")";
    }
    word(key.combine, "combine");
    word(key.pixels, "pixels");
    word(key.color_alpha, "alpha");
    word(key.color_sum, "sum");
    if (key.fog)
        out << " fog(" << name(fogs, key.fog_mode) << ")";
    if (key.alpha != raster::Compare::always)
        out << " alpha_test(" << name(compares, key.alpha) << ")";
    word(key.stencil, "stencil");
    word(key.blend && key.blend_general, "blend(any)");
    word(key.blend && !key.blend_general && key.blending == raster::blend_over, "blend(over)");
    if (key.blend && !key.blend_general && !(key.blending == raster::blend_over))
        out << " blend(" << static_cast<unsigned>(key.blending.src) << ", "
            << static_cast<unsigned>(key.blending.dst) << ")";
    word(key.dither, "dither");
    word(key.masked, "masked");
    word(key.logic, "logic");
    word(key.count, "count");
    word(key.coverage, "coverage");
    word(key.polygon_stipple, "stipple");
    word(key.depth_offset, "offset");
    word(key.samples, "samples");
}

} // namespace spangle::profile
