// The texture function of one unit: it fetches texels, filters them and applies the environment.
#pragma once

#include <cstddef>

#include "raster/ops/filter_texels.hpp"
#include "raster/ops/number_packed.hpp"
#include "raster/ops/stage.hpp"
#include "raster/ops/texel_color.hpp"
#include "raster/ops/texel_other.hpp"
#include "raster/ops/texel_packet.hpp"
#include "raster/ops/texture_env.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Mixes two levels. The second level has the weight `next` / 2^16, which is not 0.
template <class N>
SPANGLE_INLINE typename N::Color between_levels(const typename N::Color& a, const typename N::Color& b,
                                                typename N::L::U16 next) {
    const typename N::L::U16 none = N::L::splat(0), rest = N::L::splat(65535) - next + N::L::splat(1);
    const auto mix = [&](typename N::T v, typename N::T w) {
        if constexpr (is_exact<N> && N::lanes > 1)
            return N::weighted(v, rest, w, next);
        else
            return N::weighted(v, rest, w, next, none, none, none, none);
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
}

/// Whether the texture needs a level of detail: it has mipmaps, or its filters differ.
inline bool wants_lod(const Texture& texture) {
    return texture.mip != MipFilter::none || texture.mag != texture.min;
}

/// How a texture is sampled: the level and the filter that lambda selects (GL 1.3, 3.8.8).
struct Sampling {
    int level;
    Filter filter;
    std::uint32_t next; ///< weight of the next level, in 2^-16; 0 where only `level` is sampled
    bool alike(const Sampling& other) const {
        return level == other.level && filter == other.filter && (next == 0) == (other.next == 0);
    }
};

/// Selects how a texture is sampled.
struct LevelChoice {
    const Texture& texture;
    std::int32_t lod_bias;
    bool wants_lod;

    explicit LevelChoice(const TextureUnit& unit)
        : texture(*unit.texture), lod_bias(unit.lod_bias), wants_lod(raster::wants_lod(texture)) {}

    /// Lambda with the bias added, limited to the texture's range.
    SPANGLE_INLINE std::int32_t with_lod_bias(std::int32_t lod) const {
        lod += lod_bias;
        lod = lod < texture.min_lod ? texture.min_lod : lod;
        return lod > texture.max_lod ? texture.max_lod : lod;
    }
    /// The weight of the next level, in 2^-16, where mipmaps are mixed.
    SPANGLE_INLINE static std::uint32_t weight_behind(std::int32_t biased_lod) {
        return (static_cast<std::uint32_t>(biased_lod) & 255) << 8;
    }
    [[gnu::noinline]] Sampling choose_sampling(std::int32_t lod) const {
        lod = with_lod_bias(lod);
        const bool late =
            texture.mag == Filter::linear && texture.min == Filter::nearest && texture.mip != MipFilter::none;
        const bool magnified = lod <= (late ? 128 : 0);
        Sampling how = {0, magnified ? texture.mag : texture.min, 0};
        if (magnified || texture.mip == MipFilter::none)
            return how;
        how.level = texture.mip == MipFilter::linear ? lod >> 8
                    : lod <= 128                     ? 0
                                 : (lod + 127) >> 8; // ceil(lambda + 1/2) - 1 (GL 1.3, 3.8.8)
        how.next = texture.mip == MipFilter::linear ? weight_behind(lod) : 0;
        const int last = texture.level_count - 1;
        if (how.level >= last)
            how.level = last, how.next = 0;
        return how;
    }
};

/// Samples a texture whose modes are all known only at run time. sample() is not inline, because the chain
/// calls it for two units.
template <class N> struct TextureFunction : LevelChoice {
    using Color = typename N::Color;
    using Sampling = raster::Sampling;
    Color border;

    explicit TextureFunction(const TextureUnit& unit) : LevelChoice(unit) {
        const std::uint8_t* const b = texture.border_color;
        border = {N::from8(b[0]), N::from8(b[1]), N::from8(b[2]), N::from8(b[3])};
    }

    /// The colour of the texture at s and t.
    [[gnu::noinline]] Color sample(std::uint32_t s, std::uint32_t t, std::int32_t lod) const {
        return wants_lod ? sample_minified(lod, s, t) : filtered(0, texture.mag, s, t);
    }

    // Textures with three coordinates use the following functions, too (stage_texture_volume.hpp).
    [[gnu::noinline]] Color sample_minified(std::int32_t lod, std::uint32_t s, std::uint32_t t) const {
        const Sampling how = choose_sampling(lod);
        const Color a = filtered(how.level, how.filter, s, t);
        return how.next == 0 ? a : between_levels<N>(a, filtered(how.level + 1, how.filter, s, t), how.next);
    }

    [[gnu::noinline]] Color filtered(int level, Filter filter, std::uint32_t s, std::uint32_t t) const {
        const TextureLevel& image = texture.level[level];
        const int w = log2_of(image.width), h = log2_of(image.height);
        if (filter == Filter::nearest)
            return texel(image, wrapped_nearest(texture.wrap_s, s, w, image.width),
                         wrapped_nearest(texture.wrap_t, t, h, image.height));
        return filtered(image, wrapped_linear(texture.wrap_s, s, w, image.width),
                        wrapped_linear(texture.wrap_t, t, h, image.height));
    }

    Color filtered(const TextureLevel& image, const TexelIndex& i, const TexelIndex& j) const {
        const std::int32_t i0 = wrap_texel(texture.wrap_s, i.i, image.width),
                           i1 = wrap_texel(texture.wrap_s, i.i + 1, image.width),
                           j0 = wrap_texel(texture.wrap_t, j.i, image.height),
                           j1 = wrap_texel(texture.wrap_t, j.i + 1, image.height);
        return filter_texels<N>(*this, image, {i0, i1, j0, j1, i.weight, j.weight});
    }

    /// The colour of texel k among four.
    SPANGLE_INLINE Color texel(const TextureLevel& image, const FilteredTexels& of, int k) const {
        return texel(image, (k & 1) != 0 ? of.i1 : of.i0, (k & 2) != 0 ? of.j1 : of.j0);
    }
    /// Mixes the colours of four texels.
    SPANGLE_INLINE Color mixed(const Color (&c)[4], const FilteredTexels& of) const {
        const Color &c00 = c[0], &c10 = c[1], &c01 = c[2], &c11 = c[3];
        if constexpr (is_balanced<N>) {
            if (words_of(texture) == TexelWords::bytes) {
                const Filter8<1> filter(of.b);
                const auto mix = [&](auto c) {
                    return filter.component(c00.*c >> 8, c10.*c >> 8, c01.*c >> 8, c11.*c >> 8, of.a);
                };
                return {mix(&Color::r), mix(&Color::g), mix(&Color::b), mix(&Color::a)};
            }
        }
        return bilinear<N>(c00, c10, c01, c11, of.a, of.b);
    }

    /// Mixes four texels of bytes, which are fetched as words.
    Color filtered_bytes(const TextureLevel& image, std::int32_t i0, std::int32_t i1, std::int32_t j0,
                         std::int32_t j1, std::uint32_t a, std::uint32_t b) const {
        using Texels = TexelColors<N, false, true>;
        const bool indirect = is_indirect(texture.format);
        const std::int32_t bytes = indirect ? 1 : texel_bytes(sampled(texture.format)),
                           stride = indirect ? 1 : static_cast<std::int32_t>(image.stride);
        TexelOffsets s, t;
        s.at[0] = i0 * bytes;
        s.next[0] = i1 * bytes;
        t.at[0] = j0 * stride;
        t.next[0] = j1 * stride;
        std::uint32_t word[1][4];
        fetch_texels(texture, image, s, t, true, 1, word);
        return Texels::mix(typename Texels::Weights(b), word[0][0], word[0][1], word[0][2], word[0][3], a);
    }
    /// Whether all four texels lie in the image or in its stored border.
    bool stored(const TextureLevel& image, const FilteredTexels& of) const {
        return stored(image, of.i0, of.j0) && stored(image, of.i1, of.j1);
    }
    bool stored(const TextureLevel& image, std::int32_t i, std::int32_t j) const {
        return texture.border_texels != 0 || (i >= 0 && j >= 0 && i < image.width && j < image.height);
    }
    const std::uint8_t* address(const TextureLevel& image, std::int32_t i, std::int32_t j) const {
        return image.texels + static_cast<std::ptrdiff_t>(j) * static_cast<std::ptrdiff_t>(image.stride) +
               i * texel_bytes(sampled(texture.format));
    }
    /// A texel of the image or of its border, or the border colour where neither is stored.
    Color texel(const TextureLevel& image, std::int32_t i, std::int32_t j) const {
        if (!stored(image, i, j))
            return border;
        if constexpr (has_indirect_texels)
            if (is_indirect(texture.format))
                return read_indirect<N>(texture, image, i, j);
        return read_texel<N>(texture.format, address(image, i, j));
    }
};

/// A texture of one image with wrap mode REPEAT, one filter and packed rows, all of whose modes are known to
/// the compiler. It makes the same bytes as Texture2D. Steps: MODULATE takes texels in steps, N::in_steps().
template <class N, int Unit, TexelFormat Texels, BaseFormat Base, Filter F, TexEnv Env, bool Steps = false>
struct TextureFixed : StageBase {
    static constexpr unsigned in = field_color | field_coord << Unit, out = field_color;
    using System = N;
    using Color = typename N::Color;
    static constexpr TexelFormat texel_format = Texels;
    static constexpr std::uint32_t bytes = texel_bytes(Texels);
    const std::uint8_t* texels;
    int log2_width, log2_height;
    [[no_unique_address]] std::conditional_t<Env == TexEnv::blend, Color, StageBase> constant;

    template <class S>
    SPANGLE_INLINE TextureFixed(const S& s, std::int32_t)
        : texels(s.state->fragment.unit[Unit].texture->level[0].texels),
          log2_width(s.state->log2_width[Unit]), log2_height(s.state->log2_height[Unit]) {
        if constexpr (Env == TexEnv::blend) {
            const std::uint32_t* const c = s.state->fragment.unit[Unit].env_color;
            constant = {N::from_units(c[0]), N::from_units(c[1]), N::from_units(c[2]), N::from_units(c[3])};
        }
    }

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        static_assert(F == Filter::nearest && N::lanes == 1);
        const typename N::Coord& c = p.coord[Unit];
        return combine(p, [&](std::uint32_t) {
            return texel(row_of(static_cast<std::uint32_t>(repeat_nearest(c.t[0], log2_height))),
                         static_cast<std::uint32_t>(repeat_nearest(c.s[0], log2_width)));
        });
    }

    /// Combines each lane k with the texel at address(k).
    template <class Address> SPANGLE_INLINE bool combine(Px<N>& p, Address address) const {
        if constexpr (requires { p.color.texel; }) {
            p.color.texel = word_at(address(0));
            return true;
        } else if constexpr (is_raw<N>) {
            static_assert(N::lanes == 1 && Env == TexEnv::replace);
            p.color.word = raw_texel(address(0));
            return true;
        } else if constexpr (is_packed<N>) {
            static_assert(Texels == TexelFormat::rgba8888 && Env == TexEnv::replace);
            p.color = N::from_word(word_at(address(0)));
            return true;
        } else if constexpr (N::lanes == 1 && by_fractions) {
            return modulate(p, address(0));
        } else if constexpr (N::lanes == 1) {
            return apply_texture_function(p, read_texel<N, Texels>(address(0)));
        } else {
            return apply_texture_function(p, Colors::unpack(words(address)));
        }
    }
    /// True where combine_words() can take the texels of all lanes as words.
    static constexpr bool loads_words = Texels == TexelFormat::rgba8888 && N::lanes > 1;
    template <class Words> SPANGLE_INLINE bool combine_words(Px<N>& p, const Words& words) const {
        return apply_texture_function(p, Colors::unpack(words));
    }
    /// True where fragments do little with a texel except storing it, as for sprites, text and floors.
    static constexpr bool stores_texels = Env == TexEnv::replace || Texels == TexelFormat::rgba8888;

  protected:
    static constexpr bool has_alpha =
        Texels != TexelFormat::rgb565 && Texels != TexelFormat::rgb888 && Texels != TexelFormat::l8;
    using Colors = TexelColors<N, Texels == TexelFormat::rgb565, has_alpha>;
    SPANGLE_INLINE const std::uint8_t* row_of(std::uint32_t j) const {
        return texels + (j << log2_width) * bytes;
    }
    SPANGLE_INLINE static const std::uint8_t* texel(const std::uint8_t* row, std::uint32_t i) {
        return row + std::size_t{i} * bytes;
    }
    /// Texels as they lie in memory, one per lane. Loads are scalar, and all arithmetic is done in lanes.
    using Word = std::conditional_t<Texels == TexelFormat::rgb565, std::uint16_t, std::uint32_t>;
    SPANGLE_INLINE static Word word_at(const std::uint8_t* texel) {
        if constexpr (Texels == TexelFormat::rgb565)
            return static_cast<Word>(Lanes<1>::load(texel));
        else if constexpr (Texels == TexelFormat::rgba8888) // TextureLevel says that these texels are aligned
            return texel_word<Texels>(static_cast<const std::uint8_t*>(__builtin_assume_aligned(texel, 4)));
        else
            return texel_word<Texels>(texel);
    }
    template <class Address> SPANGLE_INLINE static auto words(Address address) {
        return N::L::generate([&](std::uint32_t k)
                                  __attribute__((always_inline)) { return word_at(address(k)); });
    }
    static constexpr bool by_fractions =
        Env == TexEnv::modulate && Base == BaseFormat::rgb && Texels == TexelFormat::rgb565;
    /// MODULATE with factors from tables. They are the factors that apply_texture_function() would compute
    /// from the texel.
    SPANGLE_INLINE static bool modulate(Px<N>& p, const std::uint8_t* texel) {
        const std::uint32_t word = Lanes<1>::load(texel);
        p.color.r = N::scaled(p.color.r, texel_factor<5, N, Steps>(word >> 11));
        p.color.g = N::scaled(p.color.g, texel_factor<6, N, Steps>((word >> 5) & 63));
        p.color.b = N::scaled(p.color.b, texel_factor<5, N, Steps>(word & 31));
        return true;
    }
    SPANGLE_INLINE bool apply_texture_function(Px<N>& p, const Color& s) const {
        if constexpr (is_raw<N> || (Env == TexEnv::replace && Base == BaseFormat::rgba))
            p.color = s; // systems that only combine colours with stored ones come here, too
        else if constexpr (Env == TexEnv::blend)
            apply_env<N>(Env, Base, p.color, s, constant);
        else if constexpr (Steps)
            apply_env<N>(Env, Base, p.color, N::in_steps(s), Color{});
        else
            apply_env<N>(Env, Base, p.color, s, Color{});
        return true;
    }
    /// A texel as the word R5 G6 B5.
    SPANGLE_INLINE static std::uint32_t raw_texel(const std::uint8_t* texel) {
        if constexpr (Texels == TexelFormat::rgb565)
            return Lanes<1>::load(texel);
        else
            return (texel[0] & 0xF8u) << 8 | (texel[1] & 0xFCu) << 3 | texel[2] >> 3;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
