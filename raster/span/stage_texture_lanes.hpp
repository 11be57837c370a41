// The texels of one unit in the chain of hosts: a packet at a time, in lanes from the coordinates to the
// filtered colours. The bytes of TextureFunction and VolumeFunction, which fragments that need one of them
// alone get.
#pragma once

#include "raster/span/filter_exact.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/stage_texture_one.hpp"
#include "raster/span/texel_fetch.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// N: of the packet, eight lanes.
template <class N> class LaneTexture {
    using One = OneLane<N>;
    using L = typename N::L;
    using U16 = typename L::U16;
    using Color = typename N::Color;
    using Sampling = typename TextureFunction<One>::Sampling;
    using Span = raster::Span<typename N::Policy>;
    static constexpr int lanes = N::lanes;
    static_assert(lanes == 8 && packet_length <= 32);

  public:
    static void sample(Packet<N>& k, const Span& span, int which, Color* texels) {
        const TextureUnit& unit = span.state->fragment.unit[which];
        if constexpr (has_third_coordinates)
            if (wants_r(*unit.texture))
                return in_volume(k, span, which, texels);
        auto& coord = k.coord[which];
        fill_last_group(coord, k.n);
        constexpr std::int32_t group = sizeof coord[0] / sizeof coord[0].s[0];
        const LaneTexture stage(unit, {coord[0].s, coord[0].t, group, k.lod[which], nullptr, nullptr}, k.n);
        if (stage.together(texels))
            return;
        for (std::int32_t i = 0; i < k.n; ++i)
            set_lane(texels[i / lanes], i % lanes,
                     stage.function_.sample(coord[i / lanes].s[i % lanes], coord[i / lanes].t[i % lanes],
                                            stage.function_.wants_lod ? k.lod[which][i] : 0));
    }

  private:
    /// Where the fragments look.
    struct Places {
        const std::uint32_t *s, *t;
        std::int32_t group; ///< words from eight of them to the next eight
        const std::int32_t* lod;
        const std::uint32_t* r; ///< of a volume
        const unsigned* face;   ///< of a cube
    };
    const Texture& texture_;
    const TextureFunction<One> function_;
    const Places places_;
    const std::int32_t n_, groups_;

    LaneTexture(const TextureUnit& unit, const Places& places, std::int32_t n)
        : texture_(*unit.texture), function_(unit), places_(places), n_(n), groups_((n + lanes - 1) / lanes) {
    }

    /// Lanes beyond the last fragment look where that one does. Nothing that they find is stored, but stages
    /// of one lane leave them as they were, and a border colour there would send all fragments one by one.
    /// Their colours are whatever arithmetic makes of what was in memory: masks (Packet::live) keep them from
    /// every decision and from the planes.
    template <class Coord> SPANGLE_INLINE static void fill_last_group(Coord& coord, std::int32_t n) {
        const std::int32_t end = n % lanes;
        if (end == 0)
            return;
        auto& at = coord[n / lanes];
        for (std::int32_t lane = end; lane < lanes; ++lane) {
            at.s[lane] = at.s[end - 1];
            at.t[lane] = at.t[end - 1];
        }
    }

    [[gnu::noinline]] static void in_volume(Packet<N>& k, const Span& span, int which, Color* texels) {
        const VolumeCoords coords(span, which);
        const TextureUnit& unit = span.state->fragment.unit[which];
        VolumePlace places[packet_length];
        std::uint32_t s[packet_length], t[packet_length], r[packet_length];
        unsigned face[packet_length];
        const std::int32_t whole = (k.n + lanes - 1) & -lanes;
        for (std::int32_t i = 0; i < whole; ++i) {
            places[i] = i < k.n ? coords.at(k.x + i) : places[i - 1];
            s[i] = places[i].s;
            t[i] = places[i].t;
            r[i] = places[i].r;
            face[i] = places[i].face;
            k.lod[which][i] = places[i].lod;
        }
        if (LaneTexture(unit, {s, t, lanes, k.lod[which], r, face}, k.n).together(texels))
            return;
        const VolumeFunction<One> function(unit);
        for (std::int32_t i = 0; i < k.n; ++i)
            set_lane(texels[i / lanes], i % lanes, function.sample(places[i]));
    }

    /// False: fragments take too many levels or filters, or some see the border colour.
    [[gnu::noinline]] bool together(Color* texels) const {
        if (!function_.wants_lod)
            return filtered(0, texture_.mag, texels);
        Sampling how[packet_length];
        alignas(16) std::uint16_t next[packet_length] = {};
        bool alike = true;
        for (std::int32_t i = 0; i < n_; ++i) {
            how[i] = function_.sampling(places_.lod[i]);
            next[i] = static_cast<std::uint16_t>(how[i].next);
            alike = alike && how[i].alike(how[0]);
        }
        return alike ? sampled_by(how[0], next, texels) : in_kinds(how, next, texels);
    }
    /// All fragments by one level and filter, or by one pair of levels.
    bool sampled_by(const Sampling& how, const std::uint16_t* next, Color* texels) const {
        if (!filtered(how.level, how.filter, texels))
            return false;
        if (how.next == 0)
            return true;
        Color behind[texel_groups];
        if (!filtered(how.level + 1, how.filter, behind))
            return false;
        for (std::int32_t g = 0; g < groups_; ++g)
            texels[g] = between_levels<N>(texels[g], behind[g], L::gather(next + g * lanes));
        return true;
    }
    /// All fragments by each level and filter that some of them take.
    [[gnu::noinline]] bool in_kinds(const Sampling* how, const std::uint16_t* next, Color* texels) const {
        constexpr int most = 4; // more take longer than one by one
        std::uint32_t left = ~0u >> (32 - n_);
        for (int kind = 0; left != 0; ++kind) {
            if (kind == most)
                return false;
            const Sampling& one = how[std::countr_zero(left)];
            alignas(16) std::uint16_t chosen[packet_length] = {};
            for (std::int32_t i = 0; i < n_; ++i)
                if (how[i].alike(one)) {
                    chosen[i] = 0xFFFF;
                    left &= ~(1u << i);
                }
            Color found[texel_groups];
            if (!sampled_by(one, next, found))
                return false;
            for (std::int32_t g = 0; g < groups_; ++g)
                texels[g] =
                    kind == 0 ? found[g] : chosen_of(L::gather(chosen + g * lanes), found[g], texels[g]);
        }
        return true;
    }
    SPANGLE_INLINE static Color chosen_of(const typename L::Mask& m, const Color& a, const Color& b) {
        return {L::select(m, a.r, b.r), L::select(m, a.g, b.g), L::select(m, a.b, b.b),
                L::select(m, a.a, b.a)};
    }

    /// One level. False: by TextureFunction.
    [[gnu::noinline]] bool filtered(int level, Filter filter, Color* to) const {
        TextureLevel image = texture_.level[level];
        if (image.width >= AxisLanes::size_limit || image.height >= AxisLanes::size_limit ||
            image.stride >= TexelFetch::stride_limit || words_of(texture_) == TexelWords::none)
            return false;
        if (has_volumes && texture_.shape == TextureShape::volume)
            return in_slices(image, level, filter, to);
        if (has_cube_maps && texture_.shape == TextureShape::cube) {
            for (std::int32_t i = 1; i < n_; ++i)
                if (places_.face[i] != places_.face[0])
                    return false;
            image.texels = texture_.faces->texels[places_.face[0]][level];
        }
        return in_image(image, nullptr, filter, to);
    }

    /// LINEAR mixes two images of a volume.
    bool in_slices(const TextureLevel& image, int level, Filter filter, Color* to) const {
        const std::int32_t deep = texture_.depth >> level, depth = deep > 1 ? deep : 1;
        const std::int64_t bytes = std::int64_t{image.stride} * (image.height + 2 * texture_.border_texels);
        if (depth >= AxisLanes::size_limit || bytes * (depth + 1) >= std::int64_t{1} << 31 ||
            is_indirect(texture_.format))
            return false;
        TexelNumbers k;
        const bool linear = filter == Filter::linear;
        if (!AxisLanes(texture_.wrap_r, depth).find(linear, places_.r, lanes, groups_, k) &&
            texture_.border_texels == 0)
            return false;
        const auto by_slice = [&](const U16* numbers, Color* colors) {
            std::uint32_t first[packet_length];
            for (std::int32_t g = 0; g < groups_; ++g)
                for (int lane = 0; lane < lanes; ++lane)
                    first[g * lanes + lane] =
                        static_cast<std::uint32_t>(static_cast<std::int16_t>(numbers[g][lane]) * bytes);
            return in_image(image, first, filter, colors);
        };
        if (!by_slice(k.at, to))
            return false;
        if (!linear)
            return true;
        Color behind[texel_groups];
        if (!by_slice(k.next, behind))
            return false;
        for (std::int32_t g = 0; g < groups_; ++g) {
            const U16 none = L::splat(0);
            to[g] = chosen_of(L::equal(k.weight[g], none), to[g],
                              between_levels<N>(to[g], behind[g], k.weight[g] << 8));
        }
        return true;
    }

    /// `first`: bytes from the texels of the image to those that a fragment looks at.
    bool in_image(const TextureLevel& image, const std::uint32_t* first, Filter filter, Color* to) const {
        const bool linear = filter == Filter::linear;
        TexelNumbers s, t;
        const bool
            in_s = AxisLanes(texture_.wrap_s, image.width).find(linear, places_.s, places_.group, groups_, s),
            in_t =
                AxisLanes(texture_.wrap_t, image.height).find(linear, places_.t, places_.group, groups_, t);
        if (texture_.border_texels == 0 && !(in_s && in_t))
            return false;
        const TexelFetch fetch(texture_, image, first, linear, s, t, groups_);
        if (words_of(texture_) == TexelWords::rgb565)
            mix<TexelFetch::Words>(fetch, linear, s.weight, t.weight, to);
        else
            mix<TexelFetch::Bytes>(fetch, linear, s.weight, t.weight, to);
        return true;
    }

    /// Words: of texels in lanes. The weights are those of the second column and of the second row.
    template <class Words>
    [[gnu::noinline]] void mix(const TexelFetch& fetch, bool linear, const U16* right, const U16* down,
                               Color* to) const {
        Words texel;
        fetch.fetch(texel);
        const auto& [c00, c10, c01, c11] = texel;
        for (std::int32_t g = 0; g < groups_; ++g)
            to[g] = linear ? mixed(c00[g], c10[g], c01[g], c11[g], right[g], down[g]) : unpacked(c00[g]);
    }
    using Colors565 = TexelColors<N, true, true>;
    SPANGLE_INLINE static Color unpacked(const U16& c) { return Colors565::unpack(c); }
    SPANGLE_INLINE static Color unpacked(const LaneBytes& c) {
        return {N::from8(c.at(0)), N::from8(c.at(1)), N::from8(c.at(2)), N::from8(c.at(3))};
    }
    SPANGLE_INLINE static Color mixed(const U16& c00, const U16& c10, const U16& c01, const U16& c11,
                                      const U16& right, const U16& down) {
        return Colors565::mix(typename Colors565::Weights(down), c00, c10, c01, c11, right);
    }
    SPANGLE_INLINE static Color mixed(const LaneBytes& c00, const LaneBytes& c10, const LaneBytes& c01,
                                      const LaneBytes& c11, const U16& right, const U16& down) {
        if constexpr (is_exact<N>) {
            return ExactFilter(right, down)(c00, c10, c01, c11);
        } else {
            const Filter8<lanes> filter(down);
            const auto at = [&](int n) __attribute__((always_inline)) {
                return filter.component(c00.at(n), c10.at(n), c01.at(n), c11.at(n), right);
            };
            return {at(0), at(1), at(2), at(3)};
        }
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
