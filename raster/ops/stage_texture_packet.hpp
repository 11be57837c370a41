// The texture function of one unit in the chain, a packet at a time. The modes are looked at once per packet,
// and texels are combined in lanes.
#pragma once

#include "raster/ops/stage_texture_lanes.hpp"
#include "raster/ops/texel_packet.hpp"
#include "raster/ops/texture_combine_packet.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The texture function for packets of number system N. It makes the same bytes as Texture2D.
template <class N> class PacketTexture {
    using SingleLane = OneLane<N>;
    using L = typename N::L;
    using Color = typename N::Color;
    static constexpr int lanes = N::lanes;

  public:
    template <int Unit> static void run(PlacesOf<N>& places, const Span<typename N::Policy>& span) {
        apply(static_cast<Packet<N>&>(places), span, Unit, false);
    }
    /// Samples unit 0 and applies MODULATE with texels in steps, N::in_steps().
    static void run_steps(PlacesOf<N>& places, const Span<typename N::Policy>& span) {
        apply(static_cast<Packet<N>&>(places), span, 0, true);
    }
    /// Samples and combines all units that are on. It is used where at least one unit combines.
    static void combined(PlacesOf<N>& places, const Span<typename N::Policy>& span) {
        auto& k = static_cast<Packet<N>&>(places);
        const FragmentState& state = span.state->fragment;
        Color texels[max_texture_units][Packet<N>::groups];
        for (int u = 0; u < max_texture_units; ++u)
            if (state.unit[u].texture != nullptr)
                sample(k, span, u, texels[u]);
        if constexpr (lanes > 1 || has_shortcuts) {
            PacketCombine<N>::units(state, texels, (k.n + lanes - 1) / lanes, k.color);
        } else {
            for (std::int32_t i = 0; i < k.n; ++i) {
                Color texel[max_texture_units];
                for (int u = 0; u < max_texture_units; ++u)
                    texel[u] = state.unit[u].texture != nullptr ? texels[u][i] : Color{};
                TextureCombine<N>::units(state, texel, k.color[i]);
            }
        }
    }

  private:
    Packet<N>& packet_;
    const TextureUnit& unit_;
    const Texture& texture_;
    const TextureFunction<SingleLane> function_;
    const int unit_number_;

    PacketTexture(Packet<N>& k, const TextureUnit& unit, int which)
        : packet_(k), unit_(unit), texture_(*unit.texture), function_(unit), unit_number_(which) {
        static_assert(lanes == 1);
    }
    /// Fragments of the packet that follow each other.
    struct Stretch {
        std::int32_t first, count;
    };

    using Span = raster::Span<typename N::Policy>;

    [[gnu::noinline]] static void apply(Packet<N>& k, const Span& span, int which, bool steps) {
        const TextureUnit& unit = span.state->fragment.unit[which];
        Color texels[Packet<N>::groups];
        sample(k, span, which, texels);
        if constexpr (is_balanced<N>)
            for (std::int32_t g = 0; steps && g * lanes < k.n; ++g)
                texels[g] = N::in_steps(texels[g]);
        const Color constant = env_color<N>(unit);
        for (std::int32_t g = 0; g * lanes < k.n; ++g)
            apply_env<N>(unit.env, unit.texture->base, k.color[g], texels[g], constant);
    }
    [[gnu::noinline]] static void sample(Packet<N>& k, const Span& span, int which, Color* texels) {
        if constexpr (lanes > 1)
            LaneTexture<N>::sample(k, span, which, texels);
        else
            sample_one(k, span, which, texels);
    }
    static void sample_one(Packet<N>& k, const Span& span, int which, Color* texels) {
        const TextureUnit& unit = span.state->fragment.unit[which];
        if constexpr (has_third_coordinates)
            if (wants_r(*unit.texture))
                return in_volume(k, span, which, texels);
        const PacketTexture stage(k, unit, which);
        if (has_shortcuts)
            stage.sample_stretches(texels);
        else
            stage.one_by_one({0, k.n}, texels);
    }

    [[gnu::noinline]] static void in_volume(Packet<N>& k, const Span& span, int which, Color* texels) {
        const VolumeCoords coords(span, which);
        const VolumeFunction<SingleLane> function(span.state->fragment.unit[which]);
        for (std::int32_t i = 0; i < k.n; ++i)
            set_lane(texels[i / lanes], i % lanes, function.sample(coords.at(k.x + i)));
    }

    /// Samples together what follows each other and takes the same levels and filter.
    void sample_stretches(Color* texels) const {
        if (!function_.wants_lod)
            return sample_stretch({0, packet_.n}, {0, texture_.mag, 0}, nullptr, texels);
        std::uint32_t next[packet_length]; // weights of the level behind
        const std::int32_t* const lod = packet_.lod[unit_number_];
        auto how = function_.choose_sampling(lod[0]);
        for (Stretch of{0, 1};; ++of.count) {
            const std::int32_t i = of.first + of.count;
            next[i - 1] = how.next;
            const bool ends = i == packet_.n;
            const auto other = ends ? how : function_.choose_sampling(lod[i]);
            if (ends || !other.alike(how)) {
                sample_stretch(of, how, next, texels);
                of = {i, 0};
            }
            if (ends)
                return;
            how = other;
        }
    }
    /// Where some fragments see the border colour, all are sampled one by one.
    void sample_stretch(const Stretch& of, const typename TextureFunction<SingleLane>::Sampling& how,
                        const std::uint32_t* next, Color* texels) const {
        if (!filtered(of, how.level, how.filter, texels))
            return one_by_one(of, texels);
        if (how.next == 0)
            return;
        Color behind[Packet<N>::groups];
        if (!filtered(of, how.level + 1, how.filter, behind))
            return one_by_one(of, texels);
        for (std::int32_t i = of.first; i < of.first + of.count; ++i)
            texels[i] = between_levels<N>(texels[i], behind[i], next[i]);
    }
    [[gnu::noinline]] void one_by_one(const Stretch& of, Color* texels) const {
        for (std::int32_t i = of.first; i < of.first + of.count; ++i) {
            const auto& coord = packet_.coord[unit_number_][i];
            texels[i] = function_.sample(coord.s[0], coord.t[0],
                                         function_.wants_lod ? packet_.lod[unit_number_][i] : 0);
        }
    }

    /// False: some fragments see the border colour, or texels do not come as words.
    [[gnu::noinline]] bool filtered(const Stretch& of, int level, Filter filter, Color* to) const {
        const TextureLevel& image = texture_.level[level];
        const TexelWords words = words_of(texture_);
        if (words == TexelWords::none)
            return false;
        const auto& coord = packet_.coord[unit_number_][of.first];
        constexpr std::int32_t group = sizeof coord / sizeof coord.s[0];
        const bool linear = filter == Filter::linear, border = texture_.border_texels != 0;
        // In indirect formats a texel is found by its column and row, not by an address in bytes.
        const bool indirect = is_indirect(texture_.format);
        const std::int32_t bytes = indirect ? 1 : texel_bytes(sampled(texture_.format)),
                           stride = indirect ? 1 : static_cast<std::int32_t>(image.stride);
        TexelOffsets s, t;
        const bool stored = find_texels<lanes>(s, linear, {texture_.wrap_s, image.width, bytes, border},
                                               coord.s, group, of.count) &&
                            find_texels<lanes>(t, linear, {texture_.wrap_t, image.height, stride, border},
                                               coord.t, group, of.count);
        if (!stored)
            return false;
        if (words == TexelWords::rgb565)
            combine<std::uint16_t>(image, linear, s, t, of.count, to + of.first);
        else
            combine<std::uint32_t>(image, linear, s, t, of.count, to + of.first);
        return true;
    }

    /// Combines n texels of type Word.
    template <class Word>
    void combine(const TextureLevel& image, bool linear, const TexelOffsets& s, const TexelOffsets& t,
                 std::int32_t n, Color* to) const {
        using Texels = TexelColors<N, sizeof(Word) == 2, true>;
        Word texel[4][packet_length];
        const auto fetch = [&](const std::int32_t* across, const std::int32_t* up, Word* words) {
            fetch_texels(texture_, image, across, up, n, words);
        };
        fetch(s.at, t.at, texel[0]);
        if (!linear) {
            for (std::int32_t i = 0; i < n; ++i)
                to[i] = Texels::unpack(texel[0][i]);
            return;
        }
        fetch(s.next, t.at, texel[1]);
        fetch(s.at, t.next, texel[2]);
        fetch(s.next, t.next, texel[3]);
        for (std::int32_t i = 0; i < n; ++i)
            to[i] = Texels::mix(typename Texels::Weights(t.weight[i]), std::uint32_t{texel[0][i]},
                                std::uint32_t{texel[1][i]}, std::uint32_t{texel[2][i]},
                                std::uint32_t{texel[3][i]}, std::uint32_t{s.weight[i]});
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
