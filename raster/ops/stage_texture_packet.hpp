// The texture function of one unit in the chain, a packet at a time. The modes are looked at once per packet,
// and texels are combined in lanes.
#pragma once

#include "raster/ops/sample_packet.hpp"
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
    using Sampling = typename TextureFunction<SingleLane>::Sampling;
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
        combine_units<N>(state, texels, k.n, k.color);
    }

    /// Samples all fragments one by one.
    void sample_one_by_one(Color* texels) const { one_by_one({0, packet_.n}, texels); }
    /// Samples together what follows each other and takes the same levels, filter and face.
    void sample_stretches(Color* texels) const {
        const bool wants_lod = function_.wants_lod;
        Sampling how = {0, texture_.mag, 0};
        if (!wants_lod && thirds_ == nullptr)
            return sample_stretch({0, packet_.n}, how, nullptr, texels);
        std::uint32_t next[packet_length]; // weights of the level behind
        const std::int32_t* const lod = packet_.lod[unit_number_];
        if (wants_lod)
            how = function_.choose_sampling(lod[0]);
        for (Stretch of{0, 1};; ++of.count) {
            const std::int32_t i = of.first + of.count;
            next[i - 1] = how.next;
            const bool ends = i == packet_.n;
            const Sampling other =
                ends || !wants_lod || lod[i] == lod[i - 1] ? how : function_.choose_sampling(lod[i]);
            if (ends || !other.alike(how) || face(i) != face(i - 1)) {
                sample_stretch(of, how, next, texels);
                of = {i, 0};
            }
            if (ends)
                return;
            how = other;
        }
    }

  private:
    Packet<N>& packet_;
    const TextureUnit& unit_;
    const Texture& texture_;
    const TextureFunction<SingleLane> function_;
    const int unit_number_;
    /// What textures with three coordinates need besides the packet's s and t.
    struct Thirds {
        std::uint32_t r[packet_length];
        std::uint8_t face[packet_length];
    };
    const Thirds* const thirds_; ///< null for other textures

    PacketTexture(Packet<N>& k, const TextureUnit& unit, int which, const Thirds* thirds)
        : packet_(k), unit_(unit), texture_(*unit.texture), function_(unit), unit_number_(which),
          thirds_(thirds) {
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
        const PacketTexture stage(k, unit, which, nullptr);
        sample_packet(stage, true, texels);
    }

    /// Finds the places of textures with three coordinates, and samples there. Where depths are compared,
    /// fragments are sampled one by one.
    [[gnu::noinline]] static void in_volume(Packet<N>& k, const Span& span, int which, Color* texels) {
        const TextureUnit& unit = span.state->fragment.unit[which];
        const VolumeCoords coords(span, which);
        Thirds thirds;
        for (std::int32_t i = 0; i < k.n; ++i) {
            const VolumePlace place = coords.at(k.x + i);
            k.coord[which][i].s[0] = place.s;
            k.coord[which][i].t[0] = place.t;
            k.lod[which][i] = place.lod;
            thirds.r[i] = place.r;
            thirds.face[i] = static_cast<std::uint8_t>(place.face);
        }
        const PacketTexture stage(k, unit, which, &thirds);
        sample_packet(stage, !unit.texture->compares, texels);
    }

    unsigned face(std::int32_t i) const { return thirds_ != nullptr ? thirds_->face[i] : 0; }
    /// Where some fragments see the border colour, all are sampled one by one.
    void sample_stretch(const Stretch& of, const Sampling& how, const std::uint32_t* next,
                        Color* texels) const {
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
            const std::int32_t lod = function_.wants_lod ? packet_.lod[unit_number_][i] : 0;
            if constexpr (has_third_coordinates) {
                if (thirds_ != nullptr) {
                    texels[i] = VolumeFunction<SingleLane>(unit_).sample(
                        {coord.s[0], coord.t[0], thirds_->r[i], thirds_->face[i], lod});
                    continue;
                }
            }
            texels[i] = function_.sample(coord.s[0], coord.t[0], lod);
        }
    }

    /// False: some fragments see the border colour, or texels do not come as words.
    [[gnu::noinline]] bool filtered(const Stretch& of, int level, Filter filter, Color* to) const {
        TextureLevel image = texture_.level[level];
        if constexpr (has_cube_maps)
            if (texture_.shape == TextureShape::cube)
                image.texels = texture_.faces->texels[face(of.first)][level];
        // In indirect formats a texel is found by its column and row, not by an address in bytes.
        const bool indirect = is_indirect(texture_.format),
                   volume = has_volumes && texture_.shape == TextureShape::volume;
        if (words_of(texture_) == TexelWords::none || (volume && indirect))
            return false;
        const auto& coord = packet_.coord[unit_number_][of.first];
        constexpr std::int32_t apart = sizeof coord / sizeof coord.s[0];
        const bool linear = filter == Filter::linear, border = texture_.border_texels != 0;
        const std::int32_t bytes = indirect ? 1 : texel_bytes(sampled(texture_.format)),
                           stride = indirect ? 1 : static_cast<std::int32_t>(image.stride);
        TexelOffsets s, t;
        if (!find_texels(s, linear, {texture_.wrap_s, image.width, bytes, border}, coord.s, apart,
                         of.count) ||
            !find_texels(t, linear, {texture_.wrap_t, image.height, stride, border}, coord.t, apart,
                         of.count))
            return false;
        if constexpr (has_volumes)
            if (volume)
                return in_slices(image, level, linear, s, t, of, to + of.first);
        combine(image, linear, s, t, of.count, to + of.first);
        return true;
    }
    /// Samples one slice of a volume for each fragment, or mixes two slices (LINEAR). Returns false where a
    /// slice belongs to a border that is only a colour.
    [[gnu::noinline]] bool in_slices(const TextureLevel& image, int level, bool linear, const TexelOffsets& s,
                                     TexelOffsets& t, const Stretch& of, Color* to) const {
        const std::int32_t deep = texture_.depth >> level,
                           bytes = static_cast<std::int32_t>(image.stride) *
                                   (image.height + 2 * texture_.border_texels);
        TexelOffsets r;
        if (!find_texels(r, linear,
                         {texture_.wrap_r, deep > 1 ? deep : 1, bytes, texture_.border_texels != 0},
                         thirds_->r + of.first, 1, of.count))
            return false;
        for (std::int32_t i = 0; i < of.count; ++i)
            t.at[i] += r.at[i];
        for (std::int32_t i = 0; linear && i < of.count; ++i)
            t.next[i] += r.at[i];
        combine(image, linear, s, t, of.count, to);
        if (!linear)
            return true;
        for (std::int32_t i = 0; i < of.count; ++i) {
            t.at[i] += r.next[i] - r.at[i];
            t.next[i] += r.next[i] - r.at[i];
        }
        Color behind[Packet<N>::groups];
        combine(image, linear, s, t, of.count, behind);
        for (std::int32_t i = 0; i < of.count; ++i)
            if (r.weight[i] != 0)
                to[i] = between_levels<N>(to[i], behind[i], r.weight[i] << 8);
        return true;
    }

    void combine(const TextureLevel& image, bool linear, const TexelOffsets& s, const TexelOffsets& t,
                 std::int32_t n, Color* to) const {
        const TexelWords form = words_of(texture_);
        if (has_other_texels && form == TexelWords::colors)
            combine_colors(image, linear, s, t, n, to);
        else if (form == TexelWords::rgb565)
            combine_words<std::uint16_t>(image, linear, s, t, n, to);
        else
            combine_words<std::uint32_t>(image, linear, s, t, n, to);
    }
    /// Combines the texels of n fragments, which become colours before they are mixed.
    [[gnu::noinline]] void combine_colors(const TextureLevel& image, bool linear, const TexelOffsets& s,
                                          const TexelOffsets& t, std::int32_t n, Color* to) const {
        const TexelFormat format = word_format(texture_);
        std::uint16_t texels[packet_length][4];
        fetch_texels(texture_, image, s, t, linear, n, texels);
        for (std::int32_t i = 0; i < n; ++i) {
            Color c[4];
            for (int k = 0; k < (linear ? 4 : 1); ++k)
                c[k] = texel_as_color<N>(format, texels[i][k]);
            to[i] = linear ? mixed_colors<N>(c[0], c[1], c[2], c[3], s.weight[i], t.weight[i]) : c[0];
        }
    }
    /// Combines the texels of n fragments, which are words of type Word.
    template <class Word>
    [[gnu::noinline]] void combine_words(const TextureLevel& image, bool linear, const TexelOffsets& s,
                                         const TexelOffsets& t, std::int32_t n, Color* to) const {
        using Texels = TexelColors<N, sizeof(Word) == 2, true>;
        Word texels[packet_length][4];
        fetch_texels(texture_, image, s, t, linear, n, texels);
        for (std::int32_t i = 0; !linear && i < n; ++i)
            to[i] = Texels::unpack(texels[i][0]);
        for (std::int32_t i = 0; linear && i < n; ++i) {
            const Word(&of)[4] = texels[i];
            to[i] =
                Texels::mix(typename Texels::Weights(t.weight[i]), std::uint32_t{of[0]}, std::uint32_t{of[1]},
                            std::uint32_t{of[2]}, std::uint32_t{of[3]}, s.weight[i]);
        }
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
