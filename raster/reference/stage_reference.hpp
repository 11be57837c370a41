// Stages of the reference policy whose code differs from the product's stages in more than the number system.
// These stages are compiled on hosts only.
#pragma once

#include <bit>

#include "raster/ops/stage_color.hpp"
#include "raster/ops/stage_coord.hpp"
#include "raster/ops/stage_depth.hpp"
#include "raster/ops/stage_fog.hpp"
#include "raster/ops/stage_texture_lod.hpp"
#include "raster/ops/stage_texture_one.hpp"
#include "raster/ops/texture_combine.hpp"
#include "raster/reference/policy_double.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Base of the reference stages. They evaluate their planes anew at every pixel.
struct ReferenceStage : StageBase {
    const Span<Double>& span;
    std::int32_t x;
    ReferenceStage(const Span<Double>& s, std::int32_t first) : span(s), x(first) {}
    void step() { ++x; }
    /// The perspective-correct value of a plane (GL 1.3, equation 3.6).
    double divided(const Interpolant<double>& v) const { return span.at(x, v) / span.at(x, span.q); }
};

/// The depth code: the k for which k / (2^m - 1) is nearest to the depth, for m depth bits. The code stands
/// in the top bits of the word, where DepthGeneral and StencilDepth read it.
template <> struct DepthValue<Reference> : StageBase {
    const Span<Double>& span;
    std::int32_t x;
    double max;
    std::uint32_t z;
    DepthValue(const Span<Double>& s, std::int32_t first)
        : span(s), x(first), max(s.state->depth_format == DepthFormat::z16 ? 65535.0 : 16777215.0) {
        code();
    }
    std::uint32_t word() const { return z; }
    void step() {
        ++x;
        code();
    }

  private:
    double offset() const {
        return span.state->fragment.depth_offset ? span.state->primitive->reference_depth_offset : 0;
    }
    void code() {
        const double depth = span.at(x, span.z) + offset();
        const auto k = static_cast<std::uint32_t>(clamp01(depth) * max + 0.5);
        z = max < 65536 ? k << 16 : k << 8;
    }
};

template <> struct OffsetDepthValue<Reference> : DepthValue<Reference> {
    using DepthValue<Reference>::DepthValue;
};

template <bool Alpha> struct GouraudQ<Reference, Alpha> : ReferenceStage {
    static constexpr unsigned out = field_color;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        const auto at = [&](int i) { return clamp01(divided(span.color_q[i])); };
        p.color = {at(0), at(1), at(2), Alpha ? at(3) : 1};
        return true;
    }
};
template <bool Alpha> struct Gouraud<Reference, Alpha> : GouraudQ<Reference, Alpha> {
    using GouraudQ<Reference, Alpha>::GouraudQ;
};

struct ReferenceColorSum : ReferenceStage {
    static constexpr unsigned in = field_color, out = field_color;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        p.color.r = Reference::add(p.color.r, clamp01(divided(span.secondary_q[0])));
        p.color.g = Reference::add(p.color.g, clamp01(divided(span.secondary_q[1])));
        p.color.b = Reference::add(p.color.b, clamp01(divided(span.secondary_q[2])));
        return true;
    }
};
template <bool Projective> struct ColorSum<Reference, Projective> : ReferenceColorSum {
    using ReferenceColorSum::ReferenceColorSum;
};

struct ReferenceFogCoord : ReferenceStage {
    static constexpr unsigned out = field_fog;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        p.fog = divided(span.fog_q);
        return true;
    }
};
template <> struct FogCoord<Reference, true> : ReferenceFogCoord {
    using ReferenceFogCoord::ReferenceFogCoord;
};
template <> struct FogCoord<Reference, false> : ReferenceFogCoord {
    using ReferenceFogCoord::ReferenceFogCoord;
};

/// The fog factor f of an eye distance (GL 1.3, 3.10).
inline double reference_fog(const FragmentState& state, double distance) {
    const double density = std::bit_cast<float>(state.fog_density);
    const double start = std::bit_cast<float>(state.fog_start), end = std::bit_cast<float>(state.fog_end);
    switch (state.fog_mode) {
    case FogMode::exp:
        return clamp01(std::exp(-density * distance));
    case FogMode::exp2:
        return clamp01(std::exp(-density * distance * density * distance));
    case FogMode::linear:
        // FogConstants (draw_state.hpp) treats equal ends in the same way: the divisor is 1 then.
        return clamp01((end - distance) / (end != start ? end - start : 1));
    }
    return 1;
}

template <> struct Fog<Reference> : ReferenceStage {
    static constexpr unsigned in = field_color | field_fog, out = field_color;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        const FragmentState& state = span.state->fragment;
        const double f = reference_fog(state, p.fog);
        const auto mix = [&](double c, int i) {
            return Reference::lerp(Reference::from_units(state.fog_color[i]), c, f);
        };
        p.color = {mix(p.color.r, 0), mix(p.color.g, 1), mix(p.color.b, 2), p.color.a};
        return true;
    }
};

template <int Unit> struct ReferenceCoord : ReferenceStage {
    static constexpr unsigned out = field_coord << Unit;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        const auto& unit = span.unit[Unit];
        p.coord[Unit].s[0] = bounded_or_zero(span.at(x, unit.s) / span.at(x, unit.q));
        p.coord[Unit].t[0] = bounded_or_zero(span.at(x, unit.t) / span.at(x, unit.q));
        return true;
    }
};
template <int Unit> struct Coord<Reference, Unit, true> : ReferenceCoord<Unit> {
    using ReferenceCoord<Unit>::ReferenceCoord;
};
template <int Unit> struct Coord<Reference, Unit, false> : ReferenceCoord<Unit> {
    using ReferenceCoord<Unit>::ReferenceCoord;
};

/// Limits rho to a range in which its logarithm is finite. No level of detail needs values beyond this range.
inline double finite_scale(double rho) {
    constexpr double least = 0x1p-60, most = 0x1p60;
    return std::fmin(std::fmax(rho, least), most);
}

/// lambda = log2 max(|du/dx|, |dv/dx|, |du/dy|, |dv/dy|). GL allows this approximation of rho, and every
/// policy uses it. Lambda has 8 fraction bits by definition.
template <int Unit> struct Lod<Reference, Unit> : ReferenceStage {
    static constexpr unsigned out = field_lod << Unit;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        const auto& unit = span.unit[Unit];
        const double s = span.at(x, unit.s), t = span.at(x, unit.t), q = span.at(x, unit.q);
        const auto slope = [&](double v, double dv, double dq) {
            return std::fabs(dv * q - v * dq) / (q * q);
        };
        const TextureLevel& base = span.state->fragment.unit[Unit].texture->level[0];
        const double du =
            base.width * std::fmax(slope(s, unit.s.dx, unit.q.dx), slope(s, unit.s_dy, unit.q_dy));
        const double dv =
            base.height * std::fmax(slope(t, unit.t.dx, unit.q.dx), slope(t, unit.t_dy, unit.q_dy));
        const bool line = span.state->fragment.unit[Unit].texture->shape == TextureShape::line;
        const double rho = finite_scale(line ? du : std::fmax(du, dv));
        p.lod[Unit][0] = level_of_detail(static_cast<std::int32_t>(std::floor(256 * std::log2(rho) + 0.5)));
        return true;
    }
};

/// Samples by the formulas of GL 1.3, 3.8.7 to 3.8.9. Filter weights and lambda have 8 fraction bits by
/// definition, in the reference, too.
struct ReferenceSampler {
    using Color = Reference::Color;
    const Texture& texture;

    unsigned face = 0; ///< face of a cube map
    double r = 0;      ///< third coordinate of a volume, or the value that depths are compared with

    Color sample(double s, double t, std::int32_t lod8) const {
        const double lambda = std::fmin(std::fmax(lod8, texture.min_lod), texture.max_lod) / 256;
        const bool late =
            texture.mag == Filter::linear && texture.min == Filter::nearest && texture.mip != MipFilter::none;
        if (lambda <= (late ? 0.5 : 0))
            return level(0, texture.mag, s, t);
        const int q = texture.level_count - 1;
        switch (texture.mip) {
        case MipFilter::none:
            return level(0, texture.min, s, t);
        case MipFilter::nearest:
            return level(lambda <= 0.5       ? 0
                         : lambda <= q + 0.5 ? static_cast<int>(std::ceil(lambda + 0.5)) - 1
                                             : q,
                         texture.min, s, t);
        case MipFilter::linear:
            break;
        }
        if (lambda >= q)
            return level(q, texture.min, s, t);
        const int d1 = static_cast<int>(lambda);
        const double k = lambda - d1;
        const Color a = level(d1, texture.min, s, t), b = level(d1 + 1, texture.min, s, t);
        const auto mix = [&](double v, double w) { return (1 - k) * v + k * w; };
        return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
    }

  private:
    /// The wrapped coordinate. With MIRRORED_REPEAT the period is two repeats, of which the second one runs
    /// backwards.
    static double wrapped(Wrap wrap, double s, double n) {
        const auto between = [&](double low, double high) { return s < low ? low : s > high ? high : s; };
        switch (wrap) {
        case Wrap::repeat:
            return s - std::floor(s);
        case Wrap::mirrored_repeat:
            return s - 2 * std::floor(s / 2);
        case Wrap::clamp:
            return between(0, 1);
        case Wrap::clamp_to_edge:
            return between(1 / (2 * n), 1 - 1 / (2 * n));
        case Wrap::clamp_to_border:
            return between(-1 / (2 * n), 1 + 1 / (2 * n));
        }
        return 0;
    }
    /// The texel that stands for texel i of an unbounded image (GL 2.0, 3.8.8). With CLAMP_TO_EDGE, texels
    /// beyond the edge have the weight 0.
    static int equivalent(Wrap wrap, int i, int n) {
        switch (wrap) {
        case Wrap::repeat:
            return ((i % n) + n) % n;
        case Wrap::mirrored_repeat: {
            const int k = ((i % (2 * n)) + 2 * n) % (2 * n);
            return k < n ? k : 2 * n - 1 - k;
        }
        case Wrap::clamp_to_edge:
            return i >= n ? n - 1 : i;
        case Wrap::clamp:
        case Wrap::clamp_to_border:
            break; // texels beyond the edge are border texels
        }
        return i;
    }

    Color level(int d, Filter filter, double s, double t) const {
        TextureLevel image = texture.level[d];
        if (texture.shape == TextureShape::cube)
            image.texels = texture.faces->texels[face][d];
        if (texture.shape != TextureShape::volume)
            return image_at(image, filter, s, t);
        const int depth = texture.depth >> d > 1 ? texture.depth >> d : 1;
        const double w = depth * wrapped(texture.wrap_r, r, depth);
        if (filter == Filter::nearest)
            return slice(image, index(texture.wrap_r, w, depth), depth, filter, s, t);
        const int fixed = place_between(w), k = fixed >> 8;
        const Color a = slice(image, k, depth, filter, s, t), b = slice(image, k + 1, depth, filter, s, t);
        const double weight = (fixed & 255) / 256.0;
        const auto mix = [&](double v, double u) { return (1 - weight) * v + weight * u; };
        return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
    }
    Color slice(TextureLevel image, int k, int depth, Filter filter, double s, double t) const {
        k = equivalent(texture.wrap_r, k, depth);
        if (texture.border_texels == 0 && (k < 0 || k >= depth))
            return border();
        image.texels +=
            k * static_cast<std::ptrdiff_t>(image.stride) * (image.height + 2 * texture.border_texels);
        return image_at(image, filter, s, t);
    }
    /// The place, counted in 256ths of a texel from the centre of the first texel and rounded to the nearest.
    static int place_between(double at) { return static_cast<int>(std::floor((at - 0.5) * 256 + 0.5)); }
    static int index(Wrap wrap, double at, int n) {
        const int i = static_cast<int>(std::floor(at + 1.0 / (1 << nearest_bias_bits)));
        const bool wraps = wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat;
        return !wraps && i == n && at <= n ? n - 1 : i; // without wrapping, s = 1 is in the last texel
    }
    Color border() const {
        const std::uint8_t* const c = texture.border_color;
        return {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0, c[3] / 255.0};
    }

    Color image_at(const TextureLevel& image, Filter filter, double s, double t) const {
        const double u = image.width * wrapped(texture.wrap_s, s, image.width);
        const double v = image.height * wrapped(texture.wrap_t, t, image.height);
        if (filter == Filter::nearest) {
            return texel(image, index(texture.wrap_s, u, image.width),
                         index(texture.wrap_t, v, image.height));
        }
        const int a = place_between(u), b = place_between(v), i = a >> 8, j = b >> 8;
        return bilinear<Reference>(texel(image, i, j), texel(image, i + 1, j), texel(image, i, j + 1),
                                   texel(image, i + 1, j + 1), static_cast<std::uint32_t>(a & 255),
                                   static_cast<std::uint32_t>(b & 255));
    }

    Color texel(const TextureLevel& image, int i, int j) const {
        i = equivalent(texture.wrap_s, i, image.width);
        j = equivalent(texture.wrap_t, j, image.height);
        const bool outside = i < 0 || j < 0 || i >= image.width || j >= image.height;
        if (texture.compares)
            return compared(outside && texture.border_texels == 0 ? border().r : stored(image, i, j).r);
        return outside && texture.border_texels == 0 ? border() : stored(image, i, j);
    }
    /// The result of comparing r with a stored depth. Both are counted in the steps of the texture's depth
    /// format.
    Color compared(double depth) const {
        const double most = texture.format == TexelFormat::z16 ? 65535 : 16777215;
        const auto code = [&](double v) { return static_cast<std::uint32_t>(clamp01(v) * most + 0.5); };
        const double v =
            compare(texture.compare, code(r), static_cast<std::uint32_t>(depth * most + 1e-6)) ? 1 : 0;
        return {v, v, v, v};
    }
    Color stored(const TextureLevel& image, int i, int j) const {
        if (is_indirect(texture.format))
            return read_indirect<Reference>(texture, image, i, j);
        return read_texel<Reference>(texture.format, image.texels +
                                                         static_cast<std::ptrdiff_t>(j) *
                                                             static_cast<std::ptrdiff_t>(image.stride) +
                                                         i * texel_bytes(texture.format));
    }
};

template <int Unit, bool HasLod> struct Texture2D<Reference, Unit, HasLod> : ReferenceStage {
    static constexpr unsigned in = field_color | field_coord << Unit | (HasLod ? field_lod << Unit : 0u);
    static constexpr unsigned out = field_color;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        const TextureUnit& unit = span.state->fragment.unit[Unit];
        apply_env<Reference>(unit.env, unit.texture->base, p.color, texel(p), env_color<Reference>(unit));
        return true;
    }
    Reference::Color texel(const Px<Reference>& p) const {
        const TextureUnit& unit = span.state->fragment.unit[Unit];
        if (wants_r(*unit.texture))
            return in_volume(unit);
        const ReferenceSampler sampler{*unit.texture};
        return sampler.sample(p.coord[Unit].s[0], p.coord[Unit].t[0],
                              HasLod ? p.lod[Unit][0] + unit.lod_bias : 0);
    }

  private:
    Reference::Color in_volume(const TextureUnit& unit) const;
};

/// Samples by three divided coordinates, by the formulas of GL 1.3, 3.8.6 and 3.8.8. Lambda is made from the
/// derivatives of all coordinates.
template <int Unit, bool HasLod>
Reference::Color Texture2D<Reference, Unit, HasLod>::in_volume(const TextureUnit& unit) const {
    const Texture& texture = *unit.texture;
    const auto& at = span.unit[Unit];
    const struct {
        double v, dx, dy;
    } of[3] = {{span.at(x, at.s), at.s.dx, at.s_dy},
               {span.at(x, at.t), at.t.dx, at.t_dy},
               {span.at(x, at.r), at.r.dx, at.r_dy}},
      w = {span.at(x, at.q), at.q.dx, at.q_dy};
    const auto slope = [](const auto& v, const auto& q) {
        return std::fmax(std::fabs(v.dx * q.v - v.v * q.dx), std::fabs(v.dy * q.v - v.v * q.dy)) /
               (q.v * q.v);
    };
    const TextureLevel& base = texture.level[0];
    ReferenceSampler sampler{texture};
    double s, t, rho;
    if (texture.shape == TextureShape::cube) {
        const CubeFace<double> face(of[0].v, of[1].v, of[2].v);
        const double along = of[face.major].v;
        sampler.face = face.face;
        s = ((face.s_back ? -1 : 1) * of[face.s].v / std::fabs(along) + 1) / 2;
        t = ((face.t_back ? -1 : 1) * of[face.t].v / std::fabs(along) + 1) / 2;
        rho =
            base.width * std::fmax(slope(of[face.s], of[face.major]), slope(of[face.t], of[face.major])) / 2;
    } else {
        s = bounded_or_zero(of[0].v / w.v);
        t = bounded_or_zero(of[1].v / w.v);
        sampler.r = bounded_or_zero(of[2].v / w.v);
        rho = base.width * slope(of[0], w);
        if (texture.shape != TextureShape::line)
            rho = std::fmax(rho, base.height * slope(of[1], w));
        if (texture.shape == TextureShape::volume)
            rho = std::fmax(rho, texture.depth * slope(of[2], w));
    }
    const double lambda = std::log2(finite_scale(rho));
    const auto lod = static_cast<std::int32_t>(std::floor(256 * lambda + 0.5));
    return sampler.sample(s, t, HasLod ? level_of_detail(lod) + unit.lod_bias : 0);
}

template <> struct CombineMath<Reference> {
    static constexpr double middle = 0.5;
    static double half() { return middle; }
    static double scaled(double v, unsigned log2) { return clamp01(v * (1 << log2)); }
    static double dot3(const Reference::Color& a, const Reference::Color& b) {
        return clamp01(4 * ((a.r - middle) * (b.r - middle) + (a.g - middle) * (b.g - middle) +
                            (a.b - middle) * (b.b - middle)));
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
