// The state key says which stages and modes a draw needs. It is canonical: two states that draw the same
// bytes by the same stages have one key. Fused spans are found by their key.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>

#include "raster/span/kind.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {

/// The number system of a list of stages (number.hpp).
enum class Number : std::uint8_t { raw565, balanced, exact, reference };

/// The key of one texture unit. `general`: modes are read from the state while drawing, and the later fields
/// are 0.
struct UnitKey {
    bool on = false, general = false;
    TexelFormat texels{};
    BaseFormat base{};
    Filter filter{};
    TexEnv env{};
    friend constexpr bool operator==(const UnitKey&, const UnitKey&) = default;
};

constexpr bool is_565(PixelFormat format) {
    return format == PixelFormat::rgb565_be || format == PixelFormat::rgb565_le;
}

struct Key {
    Number number{};
    Kind kind{};
    PixelFormat format{};
    DepthFormat depth_format{}; ///< none unless depth or stencil is used
    UnitKey unit[max_texture_units];
    bool combine = false;     ///< some unit combines: all units are sampled first
    bool pixels = false;      ///< the primary colour is that of an image, and some stage reads it
    bool color = true;        ///< the primary colour is that of vertices, and some stage reads it
    bool color_alpha = false; ///< some stage reads the alpha of this colour, too
    bool color_sum = false;
    bool fog = false;
    FogMode fog_mode{};
    Compare alpha = Compare::always;
    bool stencil = false;
    Compare depth = Compare::always;
    bool depth_write = false;
    bool blend = false;
    bool cubic =
        false; ///< texture coordinates are those of the exact tier; set only where `number` does not say so
    bool coarse = false; ///< blended in steps of the target, with alpha in 32nds
    bool blend_general =
        false; ///< blend modes are read from the state while drawing; `blending` is its default then
    Blending blending;
    bool dither = false;
    bool masked = false; ///< some colour channel is not written
    bool logic = false;
    bool count = false;
    bool coverage = false;
    bool polygon_stipple = false;
    bool depth_offset = false;
    bool samples = false; ///< alpha or a given value decides which samples are covered
#if SPANGLE_MIXES_RUNS
    /// Texture coordinates have the runs of another tier than the one that has this number system.
    bool other_runs = false;
#endif
    friend constexpr bool operator==(const Key&, const Key&) = default;

    constexpr bool second_unit() const {
        if constexpr (max_texture_units > 1)
            return unit[1].on;
        else
            return false;
    }
};

/// True where depths are tested or written.
constexpr bool needs_depth(const Key& key) {
    return key.depth != Compare::always || key.depth_write;
}

/// True where something other than texture coordinates varies over 1/w, so that every fragment divides. In
/// the exact tier texture coordinates, too, are divided then.
constexpr bool divides(Kind kind, bool fog) {
    return kind == Kind::full || (kind == Kind::textured && fog);
}

/// True where light is multiplied by the fog factor before it meets the texel. MODULATE and fog's factor are
/// products, in any order; where light is gray, light times factor is one product for all components.
constexpr bool fogs_light(const Key& key) {
    return key.number == Number::balanced && key.fog && key.fog_mode == FogMode::linear && key.unit[0].on &&
           !key.unit[0].general && key.unit[0].env == TexEnv::modulate && !key.second_unit() &&
           !key.color_sum;
}

/// True where texels and the fog's colour are counted in steps of the target, so that a threshold is one more
/// summand. This holds where colours are dithered and nothing but sums follows MODULATE.
constexpr bool counts_steps(const Key& key) {
    return fogs_light(key) && key.dither && key.unit[0].base != BaseFormat::alpha && !key.blend &&
           !key.masked && !key.logic;
}

} // namespace spangle::raster
