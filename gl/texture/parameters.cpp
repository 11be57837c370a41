// TexParameter and its queries (GL 1.3, 3.8.4, 6.1.3).
#include <cstddef>
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/tokens.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

namespace {

[[maybe_unused]] bool is_compare_mode(GLenum v) {
    return v == GL_NONE || v == GL_COMPARE_R_TO_TEXTURE;
}
[[maybe_unused]] bool is_depth_mode(GLenum v) {
    return v == GL_LUMINANCE || v == GL_INTENSITY || v == GL_ALPHA;
}

/// Says which values a parameter takes, or how its values are converted.
enum class Rule : std::uint8_t {
    min_filter,
    mag_filter,
    wrap,
    depth_mode,
    compare_mode,
    compare_func,
    level, ///< the value must not be negative
    real,
    clamped, ///< the value is clamped to [0, 1]
    boolean,
};

/// A parameter. TextureParameters holds each one as a word, except BORDER_COLOR, which has four words, and
/// GENERATE_MIPMAP, which is a bool.
struct Row {
    std::uint16_t name;
    std::uint8_t at; ///< offset in TextureParameters, bytes
    Rule rule;
};
#define ROW(NAME, MEMBER, RULE)                                                                              \
    { NAME, offsetof(TextureParameters, MEMBER), Rule::RULE }
constexpr Row rows[] = {
    ROW(GL_TEXTURE_MIN_FILTER, min_filter, min_filter),
    ROW(GL_TEXTURE_MAG_FILTER, mag_filter, mag_filter),
    ROW(GL_TEXTURE_WRAP_S, wrap[0], wrap),
    ROW(GL_TEXTURE_WRAP_T, wrap[1], wrap),
    ROW(GL_TEXTURE_WRAP_R, wrap[2], wrap),
    ROW(GL_TEXTURE_BORDER_COLOR, border_color, clamped),
    ROW(GL_TEXTURE_PRIORITY, priority, clamped),
    ROW(GL_TEXTURE_MIN_LOD, min_lod, real),
    ROW(GL_TEXTURE_MAX_LOD, max_lod, real),
    ROW(GL_TEXTURE_LOD_BIAS, lod_bias, real),
    ROW(GL_TEXTURE_BASE_LEVEL, base_level, level),
    ROW(GL_TEXTURE_MAX_LEVEL, max_level, level),
    ROW(GL_GENERATE_MIPMAP, generate_mipmap, boolean),
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    ROW(GL_DEPTH_TEXTURE_MODE, depth_mode, depth_mode),
    ROW(GL_TEXTURE_COMPARE_MODE, compare_mode, compare_mode),
    ROW(GL_TEXTURE_COMPARE_FUNC, compare_func, compare_func),
#endif
};
#undef ROW

const Row* find_row(GLenum pname) {
    for (const Row& row : rows)
        if (row.name == pname)
            return &row;
    return nullptr;
}

bool is_token(Rule rule, GLenum v) {
    switch (rule) {
    case Rule::min_filter:
        return is_min_filter(v);
    case Rule::mag_filter:
        return is_mag_filter(v);
    case Rule::wrap:
        return is_in(wraps, v);
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    case Rule::depth_mode:
        return is_depth_mode(v);
    case Rule::compare_mode:
        return is_compare_mode(v);
    case Rule::compare_func:
        return is_compare(v);
#endif
    default:
        return true;
    }
}

/// Sets a parameter (GL 1.3, table 3.19). If it returns an error, nothing has changed.
GLenum set_parameter(TextureParameters& p, GLenum pname, const Params& params) {
    const Row* const row = find_row(pname);
    if (row == nullptr || !is_token(row->rule, params.v[0].token()))
        return GL_INVALID_ENUM;
    if (row->rule == Rule::level && params.v[0].integer() < 0)
        return GL_INVALID_VALUE;
    auto* const to = reinterpret_cast<unsigned char*>(&p) + row->at;
    if (row->rule == Rule::boolean) {
        p.generate_mipmap = params.v[0].integer() != 0;
        return GL_NO_ERROR;
    }
    for (std::uint32_t c = 0; c < params.count; ++c) {
        const Param v = params.v[c];
        const std::uint32_t word = row->rule == Rule::clamped ? numeric::clamp01(v.real()).bits : v.word;
        std::memcpy(to + c * sizeof word, &word, sizeof word);
    }
    return GL_NO_ERROR;
}

/// Reads a parameter; returns false if there is no such parameter.
bool get_parameter(const TextureParameters& p, GLenum pname, Params& params) {
    const Row* const row = find_row(pname);
    if (row == nullptr && pname != GL_TEXTURE_RESIDENT)
        return false;
    params.count = pname == GL_TEXTURE_BORDER_COLOR ? 4 : 1;
    if (row == nullptr || row->rule == Rule::boolean) // textures are always resident
        params.v[0] = Param::from_integer(row == nullptr || p.generate_mipmap ? 1 : 0);
    else
        std::memcpy(params.v, reinterpret_cast<const unsigned char*>(&p) + row->at,
                    params.count * sizeof(Param));
    return true;
}

/// Whether `pname` belongs to a system that this build leaves out; if so, raises an error that names the
/// system.
bool left_out(Context& context, GLenum pname) {
    const char* missing = nullptr;
    bool absent = false;
    if (!SPANGLE_FEATURE_DEPTH_TEXTURES &&
        (pname == GL_DEPTH_TEXTURE_MODE || pname == GL_TEXTURE_COMPARE_MODE ||
         pname == GL_TEXTURE_COMPARE_FUNC)) {
        absent = true;
        missing = SPANGLE_TEXT("this build has no SPANGLE_FEATURE_DEPTH_TEXTURES");
    }
    if (!SPANGLE_FEATURE_MIPMAP_GENERATION && pname == GL_GENERATE_MIPMAP) {
        absent = true;
        missing = SPANGLE_TEXT("this build has no SPANGLE_FEATURE_MIPMAP_GENERATION");
    }
    if (absent)
        error(context, GL_INVALID_OPERATION, missing);
    return absent;
}

} // namespace

namespace cmd {

void TexParameter(Context& context, GLenum target, GLenum pname, const Params& params) {
    TextureKind kind;
    if (params.count == 0)
        return error(context, GL_INVALID_ENUM);
    if (!find_texture_target(context, target, kind) || left_out(context, pname))
        return;
    TextureObject& texture = bound_texture(context, kind);
    const GLenum refused = set_parameter(texture.parameters, pname, params);
    if (refused != GL_NO_ERROR)
        return error(context, refused);
    texture_changed(context, texture);
}

void GetTexParameter(Context& context, GLenum target, GLenum pname, Params& params) {
    TextureKind kind;
    params.count = 0;
    if (!find_texture_target(context, target, kind) || left_out(context, pname))
        return;
    if (!get_parameter(bound_texture(context, kind).parameters, pname, params))
        error(context, GL_INVALID_ENUM);
}

} // namespace cmd

} // namespace spangle::gl
