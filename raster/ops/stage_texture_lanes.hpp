// The texels of one unit in the chain of hosts, a packet at a time. All steps from coordinates to filtered
// colours are done in lanes. The bytes are those of TextureFunction and VolumeFunction, which sample the
// fragments that lanes leave to them.
#pragma once

#include "raster/ops/filter_exact.hpp"
#include "raster/ops/stage_texture_one.hpp"
#include "raster/ops/stage_volume_packet.hpp"
#include "raster/ops/texel_as_color.hpp"
#include "raster/ops/texel_fetch.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Samples textures for packets of number system N, which has eight lanes.
template <class N> class LaneTexture {
    using SingleLane = OneLane<N>;
    using L = typename N::L;
    using U16 = typename L::U16;
    using Color = typename N::Color;
    using Sampling = typename TextureFunction<SingleLane>::Sampling;
    using Span = raster::Span<typename N::Policy>;
    static constexpr int lanes = N::lanes;
    static_assert(lanes == 8);

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
        if (stage.sample_in_lanes(texels))
            return;
        for (std::int32_t i = 0; i < k.n; ++i)
            set_lane(texels[i / lanes], i % lanes,
                     stage.function_.sample(coord[i / lanes].s[i % lanes], coord[i / lanes].t[i % lanes],
                                            stage.function_.wants_lod ? k.lod[which][i] : 0));
    }

  private:
    /// The coordinates at which the fragments of a packet sample.
    struct Places {
        const std::uint32_t *s, *t;
        /// Words from the coordinates of one group of eight fragments to those of the next group.
        std::int32_t group;
        const std::int32_t* lod;
        const std::uint32_t* r;    ///< third coordinate in a volume
        const std::uint32_t* face; ///< face of a cube map
    };
    const Texture& texture_;
    const TextureFunction<SingleLane> function_;
    const Places places_;
    const std::int32_t fragment_count_, group_count_;

    LaneTexture(const TextureUnit& unit, const Places& places, std::int32_t n)
        : texture_(*unit.texture), function_(unit), places_(places), fragment_count_(n),
          group_count_((n + lanes - 1) / lanes) {}

    /// One mask for each of a fragment's four texels. A mask is all ones where the texel lies beyond the
    /// image and has the border's colour.
    using BorderMasks = U16[4][texel_groups];

    /// Gives lanes beyond the last fragment the coordinates of that fragment. Stages of one lane leave the
    /// coordinates of these lanes as they were. Dead lanes that meet the border would cost time. Their
    /// colours may be anything: Packet::live keeps them from decisions and from the planes.
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
        const TextureUnit& unit = span.state->fragment.unit[which];
        std::int32_t* const lod = k.lod[which];
        VolumePlaces at;
        find_places(k, span, which, at);
        if (LaneTexture(unit, {at.s, at.t, lanes, lod, at.r, at.face}, k.n).sample_in_lanes(texels))
            return;
        const VolumeFunction<SingleLane> function(unit);
        for (std::int32_t i = 0; i < k.n; ++i)
            set_lane(texels[i / lanes], i % lanes,
                     function.sample({at.s[i], at.t[i], at.r[i], at.face[i], lod[i]}));
    }
    static void find_places(Packet<N>& k, const Span& span, int which, VolumePlaces& to) {
        if constexpr (divides_in_lanes) {
            VolumeLanes<PlacesOf<N>>(k, span, which).find(k.n, to, k.lod[which]);
        } else {
            const VolumeCoords coords(span, which);
            for (std::int32_t i = 0; i < k.n; ++i)
                put_place(coords.at(k.x + i), i, to, k.lod[which]);
        }
        const std::int32_t end = k.n, whole = (end + lanes - 1) & -lanes, last = end - 1;
        for (std::int32_t i = end; i < whole; ++i)
            put_place({to.s[last], to.t[last], to.r[last], to.face[last], k.lod[which][last]}, i, to,
                      k.lod[which]);
    }
    static void put_place(const VolumePlace& from, std::int32_t i, VolumePlaces& to, std::int32_t* lod) {
        to.s[i] = from.s;
        to.t[i] = from.t;
        to.r[i] = from.r;
        to.face[i] = from.face;
        lod[i] = from.lod;
    }

    /// Returns false where fragments take too many levels or filters, or where lanes cannot read the image.
    [[gnu::noinline]] bool sample_in_lanes(Color* texels) const {
        if (!function_.wants_lod)
            return filtered(0, texture_.mag, texels);
        alignas(16) std::uint16_t next[packet_length] = {};
        if (Sampling one; all_alike(one, next))
            return sampled_by(one, next, texels);
        return each_by_its_own(texels);
    }
    /// True where all fragments take the same levels by the same filter. The level grows with lambda, and the
    /// filter changes at most once (TextureFunction::choose_sampling()). So the fragments with the least and
    /// the largest lambda decide. Within one level the weight of the next level grows with lambda, too.
    bool all_alike(Sampling& how, std::uint16_t* next) const {
        std::int32_t least = places_.lod[0], most = least;
        for (std::int32_t i = 1; i < fragment_count_; ++i) {
            const std::int32_t lod = places_.lod[i];
            least = lod < least ? lod : least;
            most = lod > most ? lod : most;
        }
        how = function_.choose_sampling(least);
        if (!how.alike(function_.choose_sampling(most)))
            return false;
        if (how.next == 0)
            return true;
        for (std::int32_t i = 0; i < fragment_count_; ++i)
            next[i] =
                static_cast<std::uint16_t>(function_.weight_behind(function_.with_lod_bias(places_.lod[i])));
        return true;
    }
    [[gnu::noinline]] bool each_by_its_own(Color* texels) const {
        Sampling how[packet_length];
        alignas(16) std::uint16_t next[packet_length] = {};
        for (std::int32_t i = 0; i < fragment_count_; ++i) {
            how[i] = function_.choose_sampling(places_.lod[i]);
            next[i] = static_cast<std::uint16_t>(how[i].next);
        }
        return in_kinds(how, next, texels);
    }
    /// Samples all fragments by one level and filter, or by one pair of levels.
    bool sampled_by(const Sampling& how, const std::uint16_t* next, Color* texels) const {
        if (!filtered(how.level, how.filter, texels))
            return false;
        if (how.next == 0)
            return true;
        Color behind[texel_groups];
        if (!filtered(how.level + 1, how.filter, behind))
            return false;
        for (std::int32_t g = 0; g < group_count_; ++g)
            texels[g] = between_levels<N>(texels[g], behind[g], L::gather(next + g * lanes));
        return true;
    }
    /// The colours of a level that all fragments have sampled through one filter.
    struct Seen {
        int level;
        Filter filter;
        Color colors[texel_groups];
    };
    /// Filters all fragments by each level and filter that some fragment takes. Each level is filtered once,
    /// although two neighbouring pairs of levels share one.
    [[gnu::noinline]] bool in_kinds(const Sampling* how, const std::uint16_t* next, Color* texels) const {
        constexpr int most = packet_length / 8; // with more levels, single fragments are faster
        Seen seen[2 * most];
        int count = 0;
        const auto seen_by = [&](int level, Filter filter) -> const Color* {
            for (int i = 0; i < count; ++i)
                if (seen[i].level == level && seen[i].filter == filter)
                    return seen[i].colors;
            Seen& to = seen[count++];
            to.level = level;
            to.filter = filter;
            return filtered(level, filter, to.colors) ? to.colors : nullptr;
        };
        PacketBits left = first_bits(fragment_count_);
        for (int kind = 0; left != 0; ++kind) {
            if (kind == most)
                return false;
            const Sampling& one = how[std::countr_zero(left)];
            alignas(16) std::uint16_t chosen[packet_length] = {};
            for (std::int32_t i = 0; i < fragment_count_; ++i)
                if (how[i].alike(one)) {
                    chosen[i] = 0xFFFF;
                    left &= ~(PacketBits{1} << i);
                }
            const Color* const found = seen_by(one.level, one.filter);
            const Color* const behind = one.next != 0 ? seen_by(one.level + 1, one.filter) : found;
            if (found == nullptr || behind == nullptr)
                return false;
            for (std::int32_t g = 0; g < group_count_; ++g) {
                const Color mixed = one.next != 0
                                        ? between_levels<N>(found[g], behind[g], L::gather(next + g * lanes))
                                        : found[g];
                texels[g] = kind == 0 ? mixed : chosen_of(L::gather(chosen + g * lanes), mixed, texels[g]);
            }
        }
        return true;
    }
    SPANGLE_INLINE static Color chosen_of(const typename L::Mask& m, const Color& a, const Color& b) {
        return {L::select(m, a.r, b.r), L::select(m, a.g, b.g), L::select(m, a.b, b.b),
                L::select(m, a.a, b.a)};
    }

    /// Samples one level. Returns false where TextureFunction must do it.
    [[gnu::noinline]] bool filtered(int level, Filter filter, Color* to) const {
        TextureLevel image = texture_.level[level];
        if (image.width >= AxisLanes::size_limit || image.height >= AxisLanes::size_limit ||
            image.stride >= TexelFetch::stride_limit || words_of(texture_) == TexelWords::none)
            return false;
        if (has_volumes && texture_.shape == TextureShape::volume)
            return in_slices(image, level, filter, to);
        if (has_cube_maps && texture_.shape == TextureShape::cube) {
            std::uint32_t first[packet_length];
            image.texels = texture_.faces->texels[places_.face[0]][level];
            const bool same = one_face();
            if (!same && !face_offsets(image, level, first))
                return false;
            in_image(image, same ? nullptr : first, filter, to);
            return true;
        }
        in_image(image, nullptr, filter, to);
        return true;
    }

    bool one_face() const {
        std::uint32_t others = 0;
        for (std::int32_t i = 1; i < fragment_count_; ++i)
            others |= places_.face[i] ^ places_.face[0];
        return others == 0;
    }
    /// Finds the offset in bytes from the texels of `image` to those of each fragment's face. Returns false
    /// where a face lies too far away, or where texels are not found by bytes.
    bool face_offsets(const TextureLevel& image, int level, std::uint32_t* first) const {
        if (is_indirect(texture_.format))
            return false;
        const std::int64_t bytes = std::int64_t{image.stride} * (image.height + 2 * texture_.border_texels),
                           far = (std::int64_t{1} << 31) - bytes;
        std::uint32_t to_face[6];
        for (int face = 0; face < 6; ++face) {
            const auto at = reinterpret_cast<std::intptr_t>(texture_.faces->texels[face][level]) -
                            reinterpret_cast<std::intptr_t>(image.texels);
            if (at >= far || at <= -far)
                return false;
            to_face[face] = static_cast<std::uint32_t>(at);
        }
        for (std::int32_t i = 0; i < group_count_ * lanes; ++i)
            first[i] = to_face[places_.face[i]];
        return true;
    }

    /// Samples a volume. With LINEAR two of its images are mixed.
    bool in_slices(const TextureLevel& image, int level, Filter filter, Color* to) const {
        const std::int32_t deep = texture_.depth >> level, depth = deep > 1 ? deep : 1;
        const std::int64_t bytes = std::int64_t{image.stride} * (image.height + 2 * texture_.border_texels);
        if (depth >= AxisLanes::size_limit || bytes * (depth + 1) >= std::int64_t{1} << 31 ||
            is_indirect(texture_.format))
            return false;
        TexelNumbers k;
        const bool linear = filter == Filter::linear;
        const AxisLanes axis(texture_.wrap_r, depth);
        const bool has_all =
            axis.find(linear, places_.r, lanes, group_count_, k) || texture_.border_texels != 0;
        const auto by_slice = [&](U16* numbers, Color* colors) {
            std::uint32_t first[packet_length];
            U16 beyond[texel_groups];
            for (std::int32_t g = 0; g < group_count_; ++g) {
                beyond[g] = has_all ? L::splat(0) : axis.move_inside(numbers[g]);
                for (int lane = 0; lane < lanes; ++lane)
                    first[g * lanes + lane] =
                        static_cast<std::uint32_t>(static_cast<std::int16_t>(numbers[g][lane]) * bytes);
            }
            in_image(image, first, filter, colors);
            for (std::int32_t g = 0; g < group_count_ && !has_all; ++g)
                colors[g] = chosen_of(beyond[g], border(), colors[g]);
        };
        by_slice(k.at, to);
        if (!linear)
            return true;
        Color behind[texel_groups];
        by_slice(k.next, behind);
        for (std::int32_t g = 0; g < group_count_; ++g) {
            const U16 none = L::splat(0);
            to[g] = chosen_of(L::equal(k.weight[g], none), to[g],
                              between_levels<N>(to[g], behind[g], k.weight[g] << 8));
        }
        return true;
    }

    /// Samples one image. `first` holds, for each fragment, an offset in bytes that is added to the address
    /// of the image. Null stands for offsets of 0.
    void in_image(const TextureLevel& image, const std::uint32_t* first, Filter filter, Color* to) const {
        const bool linear = filter == Filter::linear;
        TexelNumbers s, t;
        const AxisLanes along_s(texture_.wrap_s, image.width), along_t(texture_.wrap_t, image.height);
        const bool in_s = along_s.find(linear, places_.s, places_.group, group_count_, s),
                   in_t = along_t.find(linear, places_.t, places_.group, group_count_, t);
        const TexelFetch fetch(texture_, image, first, linear, s, t, group_count_);
        const TexelWords form = words_of(texture_);
        if ((in_s && in_t) || texture_.border_texels != 0) [[likely]] {
            if (has_other_texels && form == TexelWords::colors)
                return mix_colors(fetch, linear, s.weight, t.weight, nullptr, to);
            return form == TexelWords::rgb565
                       ? mix<TexelFetch::Words>(fetch, linear, s.weight, t.weight, nullptr, to)
                       : mix<TexelFetch::Bytes>(fetch, linear, s.weight, t.weight, nullptr, to);
        }
        BorderMasks beyond;
        for (std::int32_t g = 0; g < group_count_; ++g) {
            const U16 none = L::splat(0), at_s = in_s ? none : along_s.move_inside(s.at[g]),
                      at_t = in_t ? none : along_t.move_inside(t.at[g]),
                      next_s = in_s || !linear ? none : along_s.move_inside(s.next[g]),
                      next_t = in_t || !linear ? none : along_t.move_inside(t.next[g]);
            beyond[0][g] = at_s | at_t;
            beyond[1][g] = next_s | at_t;
            beyond[2][g] = at_s | next_t;
            beyond[3][g] = next_s | next_t;
        }
        if (has_other_texels && form == TexelWords::colors)
            return mix_colors(fetch, linear, s.weight, t.weight, &beyond, to);
        if (form == TexelWords::bytes)
            return mix<TexelFetch::Bytes>(fetch, linear, s.weight, t.weight, &beyond, to);
        mix<TexelFetch::Words>(fetch, linear, s.weight, t.weight, nullptr, to);
        // The border's colour has more bits than a word R5 G6 B5, so fragments that meet the border are
        // sampled one by one.
        for (std::int32_t i = 0; i < fragment_count_; ++i) {
            const auto meets = [&](int corner) { return beyond[corner][i / lanes][i % lanes] != 0; };
            // Corners 1 and 2 together have both columns and both rows.
            if (linear ? meets(1) || meets(2) : meets(0))
                set_lane(to[i / lanes], i % lanes, one_fragment(image, first, filter, i));
        }
    }
    /// The colour of one fragment, as chains of one lane find it.
    [[gnu::noinline]] typename SingleLane::Color one_fragment(TextureLevel image, const std::uint32_t* first,
                                                              Filter filter, std::int32_t i) const {
        if (first != nullptr)
            image.texels += static_cast<std::int32_t>(first[i]);
        const std::int32_t at = i / lanes * places_.group + i % lanes;
        const int w = log2_of(image.width), h = log2_of(image.height);
        const std::uint32_t s = places_.s[at], t = places_.t[at];
        if (filter == Filter::nearest)
            return function_.texel(image, wrapped_nearest(texture_.wrap_s, s, w, image.width),
                                   wrapped_nearest(texture_.wrap_t, t, h, image.height));
        return function_.filtered(image, wrapped_linear(texture_.wrap_s, s, w, image.width),
                                  wrapped_linear(texture_.wrap_t, t, h, image.height));
    }
    /// The border's colour in all lanes.
    Color border() const {
        const std::uint8_t* const b = texture_.border_color;
        const auto component = [](std::uint32_t v) { return N::from8(L::splat(v)); };
        return {component(b[0]), component(b[1]), component(b[2]), component(b[3])};
    }

    /// Fetches texels into `Words` and filters them. `right` and `down` are the weights of the second column
    /// and of the second row. Texels that lie `beyond` the image get the border's colour. Null means that
    /// none lies there.
    template <class Words>
    [[gnu::noinline]] void mix(const TexelFetch& fetch, bool linear, const U16* right, const U16* down,
                               const BorderMasks* beyond, Color* to) const {
        Words texel;
        fetch.fetch(texel);
        if constexpr (std::is_same_v<Words, TexelFetch::Bytes>)
            if (beyond != nullptr) [[unlikely]]
                put_border(*beyond, linear ? 4 : 1, texel);
        const auto& [c00, c10, c01, c11] = texel;
        for (std::int32_t g = 0; g < group_count_; ++g)
            to[g] =
                linear ? blend_texels(c00[g], c10[g], c01[g], c11[g], right[g], down[g]) : unpacked(c00[g]);
    }
    /// Does what mix() does, for texels that become colours before they are filtered.
    [[gnu::noinline]] void mix_colors(const TexelFetch& fetch, bool linear, const U16* right, const U16* down,
                                      const BorderMasks* beyond, Color* to) const {
        const TexelFormat format = word_format(texture_);
        TexelFetch::Words word;
        fetch.fetch(word);
        const Color outside = border();
        const auto texel = [&](int corner, std::int32_t g) __attribute__((always_inline)) {
            const Color c = texel_as_color<N>(format, word[corner][g]);
            return beyond == nullptr ? c : chosen_of((*beyond)[corner][g], outside, c);
        };
        for (std::int32_t g = 0; g < group_count_; ++g)
            to[g] = linear ? mixed_colors<N>(texel(0, g), texel(1, g), texel(2, g), texel(3, g), right[g],
                                             down[g])
                           : texel(0, g);
    }
    /// Replaces fetched texels beyond the image by the border's colour.
    [[gnu::noinline]] void put_border(const BorderMasks& beyond, int corners,
                                      TexelFetch::Bytes& texel) const {
        const std::uint8_t* const b = texture_.border_color;
        const U16 low = L::splat(b[1] * 256U + b[0]), high = L::splat(b[3] * 256U + b[2]);
        for (int corner = 0; corner < corners; ++corner)
            for (std::int32_t g = 0; g < group_count_; ++g) {
                LaneBytes& of = texel[corner][g];
                of.low = L::select(beyond[corner][g], low, of.low);
                of.high = L::select(beyond[corner][g], high, of.high);
            }
    }
    using Colors565 = TexelColors<N, true, true>;
    SPANGLE_INLINE static Color unpacked(const U16& c) { return Colors565::unpack(c); }
    SPANGLE_INLINE static Color unpacked(const LaneBytes& c) {
        return {N::from8(c.at(0)), N::from8(c.at(1)), N::from8(c.at(2)), N::from8(c.at(3))};
    }
    SPANGLE_INLINE static Color blend_texels(const U16& c00, const U16& c10, const U16& c01, const U16& c11,
                                             const U16& right, const U16& down) {
        return Colors565::mix(typename Colors565::Weights(down), c00, c10, c01, c11, right);
    }
    SPANGLE_INLINE static Color blend_texels(const LaneBytes& c00, const LaneBytes& c10, const LaneBytes& c01,
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
