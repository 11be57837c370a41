#include "host_sim/profile/emit.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include <fmt/format.h>

#include <spangle/GL/gl.h>

#include "host_sim/profile/key_words.hpp"

namespace spangle::profile {

using namespace raster;
using namespace key_names;

namespace {

/// The part of a key that lists of fused spans can express; everything else has its default value.
Key expressible_key(const Key& key) {
    Key k;
    k.number = key.number;
    k.kind = key.kind;
    k.depth = key.depth;
    k.depth_write = key.depth_write;
    k.depth_format = key.depth != Compare::always || key.depth_write ? DepthFormat::z16 : DepthFormat::none;
    // Fused spans load texels as words of 16 and 32 bits. Texels of other formats are left to the chain.
    const TexelFormat format = key.unit[0].texels;
    const bool loads =
        format == TexelFormat::rgb565 || format == TexelFormat::rgb888 || format == TexelFormat::rgba8888;
    const bool plain = key.unit[0].env == TexEnv::replace || key.unit[0].env == TexEnv::modulate;
    if (key.unit[0].on && !key.unit[0].general && loads && plain)
        k.unit[0] = key.unit[0];
    k.color = key.color;
    k.color_alpha = key.color_alpha;
    if (key.fog && key.fog_mode == FogMode::linear) {
        k.fog = true;
        k.fog_mode = FogMode::linear;
    }
    if (key.blend && !key.blend_general && key.blending == blend_over) {
        k.blend = true;
        k.blending = blend_over;
    }
    k.cubic = key.cubic;
    k.coarse = key.coarse;
    k.dither = key.dither;
    return k;
}

} // namespace

RangeText text_of(gl::Range range) {
    constexpr RangeText all[gl::range_count] = {
#define RANGE(name, counted) {#name, counted},
#include "gl/context/ranges.inc"
#undef RANGE
    };
    return all[static_cast<unsigned>(range)];
}

bool is_fusible(const Key& key) {
    // The exact tier has no fused span that filters between four texels whose coordinates every fragment
    // divides.
    if (key.number == Number::exact && divides(key.kind, key.fog) && key.unit[0].on &&
        key.unit[0].filter == Filter::linear)
        return false;
    return key.number != Number::reference && key == expressible_key(key);
}

namespace {

/// Text to which words and numbers are appended.
struct Words {
    std::string text;
    Words& operator<<(const char* more) {
        text += more;
        return *this;
    }
    Words& operator<<(unsigned number) {
        text += std::to_string(number);
        return *this;
    }
};

} // namespace

std::string words(const Key& key) {
    Words out;
    say(out, key);
    return out.text;
}

namespace {

/// Optional systems whose primitives are cut (gl/vertex/clipper.hpp).
constexpr const char* cutting[] = {"CLIP_PLANES", "POLYGON_MODE", "SELECTION", "FEEDBACK", "ANTIALIASING"};

// The names of options that are lists must stand for the bits that the code knows.
namespace agree {
namespace color {
using enum PixelFormat;
constexpr PixelFormat rgb565 = rgb565_be;
} // namespace color
#define BIT_COLOR_FORMATS(name, token) static_cast<unsigned>(color::name)
#define BIT_DEPTH_FORMATS(name, token) static_cast<unsigned>(DepthFormat::name)
#define BIT_TEXTURE_FORMATS(name, token) static_cast<unsigned>(TexelFormat::name)
#define BIT_TIER_SET(name, token) static_cast<unsigned>(Tier::name)
#define BIT_ARRAY_TYPES(name, token) (GL_##token - GL_BYTE)
// Primitives and kinds of lighting are bits in gl/context/limits.hpp; tests/tools/profiles/options.py
// compares them.
#define BIT_PRIMITIVES(name, token) bit_of(#name, {"points", "lines", "polygons"})
#define BIT_LIGHT_KINDS(name, token) bit_of(#name, {"specular", "local", "two_sided", "color_material"})
constexpr unsigned bit_of(std::string_view name, std::initializer_list<std::string_view> names) {
    unsigned bit = 0;
    for (const std::string_view one : names) {
        if (one == name)
            return bit;
        ++bit;
    }
    return 32;
}
#define NAME(list, name, token, bit)                                                                         \
    static_assert(BIT_##list(name, token) == (bit), "cmake/Limits.cmake: " #list " " #name);
#include "option_names.inc"
#undef NAME
} // namespace agree

struct OptionName {
    std::string_view list, name;
    unsigned bit;
};
constexpr OptionName option_names[] = {
#define NAME(list, name, token, bit) {#list, #name, bit},
#include "option_names.inc"
#undef NAME
};

/// Returns the names of the bits of a set, as the option `list` takes them.
std::string names_of(std::string_view list, unsigned set) {
    std::string out;
    for (const OptionName& one : option_names)
        if (one.list == list && (set >> one.bit & 1) != 0)
            out.append(out.empty() ? "" : " ").append(one.name);
    return out.empty() ? "none" : out;
}

} // namespace

Profile make(const Record& record, const Choice& choice) {
    Profile out;
    const auto has = [&](const char* feature) { return record.features.count(feature) != 0; };
    // Entry points of fixed-point numbers that nobody calls are not linked. Which of them a program calls is
    // not recorded.
    out.features.assign(record.features.begin(), record.features.end());
    if (!has("FIXED_POINT"))
        out.features.emplace_back("FIXED_POINT");
    if ((record.color_formats & narrow_formats) != 0)
        out.features.emplace_back("NARROW_SURFACES");
    if ((record.color_formats & index_formats) != 0 && !has("COLOR_INDEX"))
        out.features.emplace_back("COLOR_INDEX");

    // The chain is left out if every key that a draw may need can have a fused span. Otherwise only keys with
    // many pixels get one.
    out.chain =
        record.keys.empty() || std::any_of(record.keys.begin(), record.keys.end(), [](const KeyUse& use) {
            return (use.needed || use.pixels != 0) && !is_fusible(use.key);
        });
    const double all = static_cast<double>(record.pixels());
    for (const KeyUse& use : record.keys)
        if (is_fusible(use.key) && (out.chain ? use.pixels != 0 && static_cast<double>(use.pixels) * 100.0 >=
                                                                       choice.least_share * all
                                              : use.needed || use.pixels != 0))
            out.fused.push_back(use.key);

    const auto set = [&](const char* limit, auto value) {
        out.limits.emplace_back(limit, fmt::format("{}", value));
    };
    const auto name_all = [&](const char* limit, unsigned bits) {
        out.limits.emplace_back(limit, names_of(limit, bits));
    };
    // Clipping makes vertices with a w of their own, so a build that clips keeps perspective.
    const bool cuts =
        record.reach(gl::Range::CUTS) != 0 || std::any_of(std::begin(cutting), std::end(cutting), has);
    if (choice.unclipped && !cuts) {
        set("CLIPPING", 0);
        if (record.reach(gl::Range::PERSPECTIVE) == 0)
            set("PERSPECTIVE", 0);
    }
    set("TEXTURE_UNITS", std::min(record.texture_units, 2));
    set("TEXTURE_LEVELS", record.texture_levels);
    set("LIGHTS", record.lights);
    name_all("LIGHT_KINDS", has("LIGHTING") ? record.light_kinds : 0u);
    set("FULL_LIGHTING", record.full_lighting ? 1 : 0);
    set("MODELVIEW_STACK", record.modelview_stack);
    set("PROJECTION_STACK", record.projection_stack);
    set("TEXTURE_STACK", record.texture_stack);
    if (!has("SELECTION"))
        set("NAME_STACK", 1);
    set("LIST_NESTING", record.list_nesting);
    constexpr unsigned floats = 1u << 6;
    name_all("ARRAY_TYPES", record.array_types != 0 ? record.array_types : floats);
    name_all("PRIMITIVES", record.primitives);
    name_all("TIER_SET", record.tiers);
    name_all("COLOR_FORMATS", record.color_formats);
    name_all("DEPTH_FORMATS", record.depth_formats);
    constexpr unsigned rgb565 = 1u << static_cast<unsigned>(TexelFormat::rgb565);
    name_all("TEXTURE_FORMATS", record.texture_formats != 0 ? record.texture_formats : rgb565);
    set("DISPLAYS", 1);
    if (!out.chain)
        set("CHAIN", 0);
    if (out.fused.empty())
        set("FUSED_SPANS", 0);
    if (choice.small) {
        set("OPTIMIZE", "size");
        set("VERTEX_CACHE", 1);
    }
    return out;
}

std::string settings(const Profile& profile, const Record& record, const Choice& choice) {
    std::string out = fmt::format(
        "# What {} asks for, written by `spangle profile`. Use: cmake -DSPANGLE_PROFILE=THIS_FILE\n",
        choice.title);
    out += fmt::format(
        "# Of the arena it took at most {} bytes on the host that recorded it, where pointers have 8.\n",
        record.arena_peak);
    out += "set(SPANGLE_PROFILE_FEATURES";
    for (const std::string& feature : profile.features)
        out += " " + feature;
    out += ")\n";
    if (!profile.fused.empty())
        out += fmt::format("set(SPANGLE_FUSED {})\n", choice.list);
    for (const auto& [limit, value] : profile.limits)
        out += fmt::format("set(SPANGLE_{} {})\n", limit, value);
    out += "# How far it went. Debug builds stop a program that goes farther, and say in "
           "what.\nset(SPANGLE_RANGES";
    for (unsigned i = 0; i < gl::range_count; ++i)
        out +=
            fmt::format(" {}={}", text_of(gl::Range{static_cast<std::uint8_t>(i)}).name, record.reached[i]);
    return out + ")\n";
}

std::string fused_lines(const Profile& profile) {
    std::string out;
    for (const Key& key : profile.fused) {
        const Key usual;
        out += fmt::format("// {}\n[] {{\n    Key k;\n    k.number = Number::{};\n    k.kind = Kind::{};\n",
                           words(key), name(numbers, key.number), name(kinds, key.kind));
        if (key.depth_format != DepthFormat::none)
            out += fmt::format("    k.depth_format = DepthFormat::z16;\n    k.depth = Compare::{};\n    "
                               "k.depth_write = {};\n",
                               name(compares, key.depth), key.depth_write);
        if (key.unit[0].on)
            out += fmt::format(
                "    k.unit[0] = {{true, false, TexelFormat::{}, BaseFormat::{}, Filter::{}, TexEnv::{}}};\n",
                name(texels, key.unit[0].texels), name(bases, key.unit[0].base),
                name(filters, key.unit[0].filter), name(environments, key.unit[0].env));
        if (key.fog)
            out += "    k.fog = true;\n    k.fog_mode = FogMode::linear;\n";
        if (key.blend)
            out += "    k.blend = true;\n    k.blending = blend_over;\n";
        const auto flag = [&](const char* member, bool value, bool before) {
            if (value != before)
                out += fmt::format("    k.{} = {};\n", member, value);
        };
        flag("color", key.color, usual.color);
        flag("color_alpha", key.color_alpha, usual.color_alpha);
        flag("cubic", key.cubic, usual.cubic);
        flag("coarse", key.coarse, usual.coarse);
        flag("dither", key.dither, usual.dither);
        out += "    return k;\n}(),\n";
    }
    return out;
}

} // namespace spangle::profile
