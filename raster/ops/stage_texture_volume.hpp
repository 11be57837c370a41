// Textures with three coordinates: volumes, cube maps, and depths that are compared with r (GL 1.3, 3.8.6 to
// 3.8.8; GL 1.4, 3.8.14). In every tier each fragment divides.
#pragma once

#include "raster/ops/guarded_row.hpp"
#include "raster/ops/log2.hpp"
#include "raster/ops/stage_coord.hpp"
#include "raster/ops/stage_texture.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The place at which one fragment samples: coordinates in the form of TexCoords, a face of a cube, and
/// lambda.
struct VolumePlace {
    std::uint32_t s, t, r;
    unsigned face;
    std::int32_t lod;
};

/// The face of a direction, and the components that are s and t in it (GL 1.3, table 3.20). Where components
/// are equally large, z goes before y, and y before x.
template <class T> struct CubeFace {
    unsigned face;
    int s, t, major;     ///< index of the direction's component: 0, 1 or 2
    bool s_back, t_back; ///< the component is negated
    CubeFace(T x, T y, T z) {
        const auto ax = size_of(x), ay = size_of(y), az = size_of(z);
        if (az >= ax && az >= ay) {
            const bool back = z < 0;
            *this = {back ? 5u : 4u, 0, 1, 2, back, true};
        } else if (ay >= ax) {
            const bool back = y < 0;
            *this = {back ? 3u : 2u, 0, 2, 1, false, back};
        } else {
            const bool back = x < 0;
            *this = {back ? 1u : 0u, 2, 1, 0, !back, true};
        }
    }

  private:
    static std::uint32_t size_of(std::int32_t v) { return numeric::abs_u32(v); }
    static double size_of(double v) { return v < 0 ? -v : v; }
    CubeFace(unsigned f, int s_of, int t_of, int m, bool s_negative, bool t_negative)
        : face(f), s(s_of), t(t_of), major(m), s_back(s_negative), t_back(t_negative) {}
};

/// Finds the places at which the fragments of a span sample one unit.
class VolumeCoords {
  public:
    VolumeCoords(const Span<Fixed>& span, int unit)
        : unit_coords_(span.unit[unit]), texture_(*span.state->fragment.unit[unit].texture),
          has_lod_(raster::wants_lod(texture_)), planes_{plane(span, unit_coords_.s, unit_coords_.s_dy),
                                                         plane(span, unit_coords_.t, unit_coords_.t_dy),
                                                         plane(span, unit_coords_.r, unit_coords_.r_dy),
                                                         plane(span, unit_coords_.q, unit_coords_.q_dy)} {}

    [[gnu::noinline]] VolumePlace at(std::int32_t x) const {
        const std::int32_t v[3] = {planes_[0].at.value(x), planes_[1].at.value(x), planes_[2].at.value(x)};
        const bool cube = has_cube_maps && texture_.shape == TextureShape::cube;
        VolumePlace place;
        place.face = 0;
        // Each coordinate is one of the planes, which may be negated. q is what the others are divided by.
        Part s{v[0], 0, false}, t{v[1], 1, false}, q{0, 3, false};
        if (cube) {
            const CubeFace<std::int32_t> face(v[0], v[1], v[2]);
            place.face = face.face;
            s = {v[face.s], face.s, face.s_back};
            t = {v[face.t], face.t, face.t_back};
            q = {v[face.major], face.major, v[face.major] < 0};
        } else {
            q.v = planes_[3].at.value(x);
        }
        const Inverse inverse(positive(q.value()));
        const int exponent = cube ? 0 : unit_coords_.exponent;
        const auto repeats = [&](std::int32_t of) SPANGLE_RUN_LAMBDA {
            const std::int64_t n = inner::to_repeats(of, inverse, exponent);
            // In a cube map -1 .. 1 becomes 0 .. 1: s = (sc / |ma| + 1) / 2.
            return cube ? (n + (std::int64_t{1} << 32)) >> 1 : n;
        };
        place.s = word(repeats(s.value()), texture_.wrap_s);
        place.t = word(repeats(t.value()), texture_.wrap_t);
        const bool volume = texture_.shape == TextureShape::volume;
        place.r = 0;
        if (volume)
            place.r = word(repeats(v[2]), texture_.wrap_r);
        else if (!cube)
            place.r =
                static_cast<std::uint32_t>(numeric::clamp<std::int64_t>(repeats(v[2]) >> 2, 0, 1 << 30));
        place.lod = has_lod_ ? lambda(s, t, {v[2], 2, false}, q) : 0;
        return place;
    }

  private:
    /// A plane along the row, and its differences from column to column and from row to row.
    struct Plane {
        GuardedRow at;
        std::int32_t dx, dy;
    };
    static Plane plane(const Span<Fixed>& span, const Span<Fixed>::Projective& of, std::uint64_t dy) {
        return {{span, of}, unguarded(of.dx), unguarded(dy)};
    }
    /// The value of a plane at a fragment. `back` negates the plane.
    struct Part {
        std::int32_t v;
        int plane;
        bool back;
        std::int32_t of(std::int32_t n) const {
            return back ? static_cast<std::int32_t>(0 - static_cast<std::uint32_t>(n)) : n;
        }
        std::int32_t value() const { return of(v); }
    };

    const Span<Fixed>::Unit& unit_coords_;
    const Texture& texture_;
    const bool has_lod_;
    const Plane planes_[4]; ///< s, t, r and q

    [[gnu::noinline]] std::int32_t lambda(const Part& s, const Part& t, const Part& r, const Part& q) const {
        const bool cube = has_cube_maps && texture_.shape == TextureShape::cube;
        const TextureLevel& base = texture_.level[0];
        std::int32_t most = steps(s, q, base.width);
        const auto also = [&](std::int32_t other) { most = other > most ? other : most; };
        if (texture_.shape != TextureShape::line)
            also(steps(t, q, base.height));
        if (texture_.shape == TextureShape::volume)
            also(steps(r, q, texture_.depth));
        return level_of_detail(most - 2 * log2_of_word8(static_cast<std::uint32_t>(positive(q.value()))) +
                               (cube ? -256 : unit_coords_.exponent << 8));
    }
    static std::int32_t positive(std::int32_t q) { return q > 0 ? q : 1; }

    static std::uint32_t word(std::int64_t repeats, Wrap wrap) {
        // The unit of mirrored coordinates is two repeats, after which mirroring begins again.
        const bool mirrored = wrap == Wrap::mirrored_repeat;
        return inner::to_coord(mirrored ? repeats >> 1 : repeats, mirrored || wrap == Wrap::repeat, 0);
    }

    /// log2 of the step of v / q times q^2, of the larger step of both directions, in 256ths.
    [[gnu::noinline]] std::int32_t steps(const Part& v, const Part& q, std::uint32_t size) const {
        const Plane &of_v = planes_[v.plane], &of_q = planes_[q.plane];
        const auto step = [&](std::int32_t dv, std::int32_t dq) {
            return numeric::abs_u64(numeric::mul_s32(v.of(dv), q.value()) -
                                    numeric::mul_s32(v.value(), q.of(dq)));
        };
        const std::uint64_t dx = step(of_v.dx, of_q.dx), dy = step(of_v.dy, of_q.dy);
        return log2_fraction8(dx > dy ? dx : dy) + log2_fraction8(size);
    }
};

/// Samples a texture for one fragment. All modes are known only at run time.
template <class N> class VolumeFunction {
    using Color = typename N::Color;

  public:
    explicit VolumeFunction(const TextureUnit& unit) : slice_(unit), texture_(*unit.texture) {}

    [[gnu::noinline]] Color sample(const VolumePlace& place) const {
        const auto how = slice_.wants_lod ? slice_.choose_sampling(place.lod)
                                          : typename TextureFunction<N>::Sampling{0, texture_.mag, 0};
        const Color a = level(place, how.level, how.filter);
        return how.next == 0 ? a
                             : between_levels<N>(a, level(place, how.level + 1, how.filter),
                                                 static_cast<typename N::L::U16>(how.next));
    }

  private:
    TextureFunction<N> slice_;
    const Texture& texture_;

    Color level(const VolumePlace& place, int level, Filter filter) const {
        TextureLevel image = texture_.level[level];
        if (has_volumes && texture_.shape == TextureShape::volume)
            return in_volume(place, image, level, filter);
        if (has_cube_maps && texture_.shape == TextureShape::cube)
            image.texels = texture_.faces->texels[place.face][level];
        return in_image(place, image, filter);
    }

    Color in_image(const VolumePlace& place, const TextureLevel& image, Filter filter) const {
        const int w = log2_of(image.width), h = log2_of(image.height);
        if (filter == Filter::nearest)
            return texel(place, image, wrapped_nearest(texture_.wrap_s, place.s, w, image.width),
                         wrapped_nearest(texture_.wrap_t, place.t, h, image.height));
        const TexelIndex i = wrapped_linear(texture_.wrap_s, place.s, w, image.width),
                         j = wrapped_linear(texture_.wrap_t, place.t, h, image.height);
        if (!texture_.compares)
            return slice_.filtered(image, i, j);
        const std::int32_t i0 = wrap_texel(texture_.wrap_s, i.i, image.width),
                           i1 = wrap_texel(texture_.wrap_s, i.i + 1, image.width),
                           j0 = wrap_texel(texture_.wrap_t, j.i, image.height),
                           j1 = wrap_texel(texture_.wrap_t, j.i + 1, image.height);
        return bilinear<N>(texel(place, image, i0, j0), texel(place, image, i1, j0),
                           texel(place, image, i0, j1), texel(place, image, i1, j1), i.weight, j.weight);
    }

    Color in_volume(const VolumePlace& place, const TextureLevel& base, int level, Filter filter) const {
        const std::int32_t deep = texture_.depth >> level, depth = deep > 1 ? deep : 1;
        const int log2_depth = log2_of(depth);
        if (filter == Filter::nearest) {
            const std::int32_t k = wrapped_nearest(texture_.wrap_r, place.r, log2_depth, depth);
            return slice(place, base, k, depth, filter);
        }
        const TexelIndex k = wrapped_linear(texture_.wrap_r, place.r, log2_depth, depth);
        const Color a = slice(place, base, wrap_texel(texture_.wrap_r, k.i, depth), depth, filter);
        if (k.weight == 0)
            return a;
        return between_levels<N>(
            a, slice(place, base, wrap_texel(texture_.wrap_r, k.i + 1, depth), depth, filter),
            static_cast<typename N::L::U16>(k.weight << 8));
    }
    Color slice(const VolumePlace& place, const TextureLevel& base, std::int32_t k, std::int32_t depth,
                Filter filter) const {
        if (texture_.border_texels == 0 && (k < 0 || k >= depth))
            return slice_.border;
        TextureLevel image = base;
        const std::ptrdiff_t bytes =
            static_cast<std::ptrdiff_t>(base.stride) * (base.height + 2 * texture_.border_texels);
        image.texels += k * bytes;
        return in_image(place, image, filter);
    }

    /// The texel, or for a depth texture the result of its comparison with r. For the comparison r is counted
    /// in the steps of a depth buffer (GL 1.4, 3.8.14).
    Color texel(const VolumePlace& place, const TextureLevel& image, std::int32_t i, std::int32_t j) const {
        if (!has_depth_textures || !texture_.compares)
            return slice_.texel(image, i, j);
        const std::uint32_t most = texture_.format == TexelFormat::z16 ? 0xFFFF : 0xFFFFFF;
        const auto r = static_cast<std::uint32_t>((std::uint64_t{place.r} * most + (1u << 29)) >> 30);
        const bool passes = compare(texture_.compare, r, depth_of(image, i, j, most));
        const typename N::T v = N::from_units(passes ? color_one : 0);
        return {v, v, v, v};
    }
    std::uint32_t depth_of(const TextureLevel& image, std::int32_t i, std::int32_t j,
                           std::uint32_t most) const {
        if (!slice_.stored(image, i, j)) // the red of the border's colour is compared
            return static_cast<std::uint32_t>(std::uint64_t{texture_.border_color[0]} * most / 255);
        const std::uint8_t* const at = slice_.address(image, i, j);
        if (most == 0xFFFF)
            return Lanes<1>::load(at);
        std::uint32_t code;
        __builtin_memcpy(&code, at, 4);
        return code;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
