// The state key says which stages and modes a draw needs. It is canonical: states that draw the same bytes by
// the same stages have the same key. Fused spans are looked up by their key.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>

#include "raster/span/kind.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {

/// The number system of a list of stages (number.hpp).
enum class Number : std::uint8_t { raw565, balanced, exact, reference };

/// The key of one texture unit. `general` says that modes are read from the state while drawing; the members
/// after it are 0 then.
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
    DepthFormat depth_format{}; ///< `none` unless depth or stencil is used
    UnitKey unit[max_texture_units];
    bool combine = false;     ///< at least one unit combines, so all units are sampled first
    bool pixels = false;      ///< the primary colour comes from an image, and a stage reads it
    bool color = true;        ///< the primary colour comes from vertices, and a stage reads it
    bool color_alpha = false; ///< a stage reads the alpha of this colour
    bool color_sum = false;
    bool fog = false;
    FogMode fog_mode{};
    Compare alpha = Compare::always;
    bool stencil = false;
    Compare depth = Compare::always;
    bool depth_write = false;
    bool blend = false;
    /// Texture coordinates are those of the exact tier. Set only where `number` does not imply it.
    bool cubic = false;
    bool coarse = false; ///< blends in steps of the stored components, with alpha in 32nds
    /// Blend modes are read from the state while drawing. `blending` has its default value then.
    bool blend_general = false;
    Blending blending;
    bool dither = false;
    bool masked = false; ///< at least one colour channel is not written
    bool logic = false;
    bool count = false;
    bool coverage = false;
    bool polygon_stipple = false;
    bool depth_offset = false;
    bool samples = false; ///< alpha or a given value decides which samples are covered
#if SPANGLE_MIXES_RUNS
    /// Texture coordinates have the runs of another tier than that of this number system.
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

/// True where attributes other than texture coordinates vary over 1/w, so that every fragment divides. The
/// exact tier then divides texture coordinates at every fragment, too.
constexpr bool divides(Kind kind, bool fog) {
    return kind == Kind::full || (kind == Kind::textured && fog);
}

/// True where light is multiplied by the fog factor before it is multiplied by the texel. MODULATE and fog
/// are products, whose order does not matter. Where light is gray, one product of light and factor serves all
/// components.
constexpr bool fogs_light(const Key& key) {
    return key.number == Number::balanced && key.fog && key.fog_mode == FogMode::linear && key.unit[0].on &&
           !key.unit[0].general && key.unit[0].env == TexEnv::modulate && !key.second_unit() &&
           !key.color_sum;
}

/// True where texels and the fog's colour are counted in steps of the target. A dither threshold is then one
/// more summand. This needs dithering, and a state in which only sums follow MODULATE.
constexpr bool counts_steps(const Key& key) {
    return fogs_light(key) && key.dither && key.unit[0].base != BaseFormat::alpha && !key.blend &&
           !key.masked && !key.logic;
}

} // namespace spangle::raster
