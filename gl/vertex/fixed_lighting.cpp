#include "gl/vertex/fixed_lighting.hpp"

#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LIGHTING

#include "raster/numeric/power.hpp"
#include "raster/numeric/trigonometry.hpp"

namespace spangle::gl {

namespace {

constexpr int intensity_bits = 20, factor_bits = 30, sum_bits = 44;

std::int32_t intensity(Real v) {
    return numeric::to_fixed(v, intensity_bits);
}

[[gnu::noinline]] void set_intensities(const Real* from, std::int32_t (&to)[3]) {
    for (int c = 0; c < 3; ++c)
        to[c] = intensity(from[c]);
}

/// Returns the product of two intensities, saturated.
std::int32_t times(std::int32_t a, std::int32_t b) {
    return numeric::saturate_i32((numeric::mul_s32(a, b) + (1 << (intensity_bits - 1))) >> intensity_bits);
}

/// Returns an intensity times a factor in Q2.30, from 0 to 4. The product has 44 fraction bits and is at most
/// 2^57, so that the terms of all lights fit 64 bits.
std::int64_t weighted(std::int32_t intensity, std::uint32_t factor) {
    return (static_cast<std::int64_t>(intensity) * factor) >> 6;
}

/// Adds a light's colours, times a factor in Q2.30, to the sums.
SPANGLE_RUN_INLINE void add_weighted(const std::int32_t (&light)[3], std::uint32_t factor,
                                     std::int64_t (&sum)[3]) {
    for (int c = 0; c < 3; ++c)
        sum[c] += weighted(light[c], factor);
}

/// Returns the product of two factors in Q2.30, saturated below 4.
std::uint32_t scaled(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t p = (numeric::mul_u32(a, b) + (1u << 29)) >> 30;
    return p > 0xFFFFFFFFu ? 0xFFFFFFFFu : static_cast<std::uint32_t>(p);
}

/// Returns the cosine, or 0 if the cosine is negative.
std::uint32_t clamp_cosine(std::int32_t cosine) {
    return cosine < 0 ? 0u : static_cast<std::uint32_t>(cosine);
}

/// Converts a block to a factor in Q2.30. Negative blocks become 0, and others saturate below 4.
std::uint32_t to_factor(numeric::Block v) {
    if (v.m <= 0)
        return 0;
    const std::int32_t half = numeric::to_fixed(v, factor_bits - 1); // the value saturates at 4
    return static_cast<std::uint32_t>(half) << 1;
}

/// The strength that attenuation and spot leave of a light, as factor * 2^shift. An attenuation divisor below
/// 1 makes a light brighter without a bound (GL 1.3, 2.13.1).
struct Strength {
    std::uint32_t factor = 1u << factor_bits;
    int shift = 0;
};

constexpr int term_bits = 57; ///< a term of a sum is at most 2^term_bits

Strength to_strength(numeric::Block v) {
    if (v.m <= 0)
        return {0, 0};
    const int log2 = 31 - numeric::clz32(static_cast<std::uint32_t>(v.m)) + v.e;
    const int shift = log2 < 2 ? 0 : log2 - 1 < term_bits ? log2 - 1 : term_bits;
    v.e -= shift;
    return {to_factor(v), shift};
}

/// Adds a light's colours, times factor * 2^shift, to the sums. Each term is saturated, so that the sums fit
/// 64 bits.
void add_strong(const std::int32_t (&light)[3], std::uint32_t factor, int shift, std::int64_t (&sum)[3]) {
    if (shift == 0)
        return add_weighted(light, factor, sum);
    constexpr std::int64_t most = std::int64_t{1} << term_bits;
    for (int c = 0; c < 3; ++c) {
        const std::int64_t term = weighted(light[c], factor), room = most >> shift;
        sum[c] += term > room ? most : term < -room ? -most : term * (std::int64_t{1} << shift);
    }
}

/// Converts a sum to a colour component in colour units, clamped to 0 to 1.
SPANGLE_RUN_CALL std::uint32_t to_color(std::int64_t sum) {
    const std::int64_t c = numeric::clamp<std::int64_t>(sum, 0, std::int64_t{1} << sum_bits);
    return FixedMath::color_units(static_cast<std::uint32_t>((c + (1 << 13)) >> (sum_bits - 30)));
}

/// Returns max(n . u, 0) in Q2.30, saturated below 4. `fraction_bits` are those of n.
std::uint32_t cosine(const std::int32_t (&n)[3], int fraction_bits, const numeric::Unit3& u) {
    const std::int64_t sum =
        numeric::mul_s32(n[0], u.m[0]) + numeric::mul_s32(n[1], u.m[1]) + numeric::mul_s32(n[2], u.m[2]);
    if (sum <= 0)
        return 0;
    const std::int64_t d = numeric::shift_right_round(sum, fraction_bits);
    return d > 0xFFFFFFFF ? 0xFFFFFFFFu : static_cast<std::uint32_t>(d);
}

/// Returns cosine^exponent in Q2.30. A cosine above 1 comes from rounding or from a normal that is not unit,
/// and counts as 1. `exponent` has the form of numeric::power_exponent().
std::uint32_t specular_factor(std::uint32_t cosine, std::uint32_t exponent) {
    constexpr std::uint32_t one = 1u << factor_bits;
    return static_cast<std::uint32_t>(
        numeric::pow_unit(static_cast<std::int32_t>(cosine > one ? one : cosine), exponent));
}

numeric::Unit3 half_vector(const numeric::Unit3& to_light, const numeric::Unit3& to_eye) {
    return numeric::normalize(numeric::add(numeric::to_block(to_light), numeric::to_block(to_eye)));
}

/// Formats of plain lighting (FixedLighting::MaterialProducts::plain): cosines have 29 fraction bits in a
/// signed word, and sums have 49 fraction bits.
constexpr int plain_factor_bits = 29, plain_sum_bits = intensity_bits + plain_factor_bits;

/// Converts v * 2^e to a factor of plain lighting. Values that are not positive become 0, and others saturate
/// below 4.
std::int32_t plain_factor(std::int32_t v, std::int32_t e) {
    const std::int32_t up = e + plain_factor_bits;
    if (v <= 0 || up < -31)
        return 0;
    if (up < 0)
        return v >> -up;
    return up < numeric::clz32(static_cast<std::uint32_t>(v)) ? v << up : 0x7FFFFFFF;
}

/// Converts a sum of plain lighting to a colour component in colour units, clamped to 0 to 1. The sum
/// includes half a unit for rounding.
std::uint32_t plain_color(std::int64_t sum) {
    const auto high = static_cast<std::uint32_t>(static_cast<std::uint64_t>(sum) >> 32);
    if (high >> (plain_sum_bits - 32) != 0) // the sum is 1 or more, or negative
        return sum < 0 ? 0 : raster::color_one;
    return FixedMath::color_units(static_cast<std::uint32_t>(sum >> (plain_sum_bits - 30)));
}

/// Returns N^T u for a normal matrix N. The product of this row with a normal as given equals the product of
/// u with the normal in eye space.
numeric::BlockRow3 in_object_space(const numeric::NormalMatrix& normal, const numeric::Unit3& u,
                                   const numeric::Columns<3>& column) {
    numeric::Block v[3], along[3];
    for (int i = 0; i < 3; ++i)
        along[i] = numeric::make_block(u.m[i], -30);
    for (int j = 0; j < 3; ++j)
        v[j] = numeric::detail::dot(normal.at + 3 * j, along);
    return numeric::to_block_row(v, column);
}

/// Returns the material that replaces the given one for colour index lighting. The sums of its components are
/// d_l and s_l: .30 R + .59 G + .11 B of the light (GL 1.3, 2.13.5).
Material weighing(const Material& material) {
    Material out;
    constexpr Real weight[3] = {numeric::from_float(0.30f), numeric::from_float(0.59f),
                                numeric::from_float(0.11f)};
    for (int c = 0; c < 3; ++c) {
        out.ambient[c] = out.emission[c] = numeric::zero;
        out.diffuse[c] = out.specular[c] = weight[c];
    }
    out.shininess = material.shininess;
    return out;
}

constexpr numeric::Unit3 toward_viewer{{0, 0, numeric::unit_one}};

} // namespace

void FixedLighting::derive(const Context& context, unsigned dirty) {
    if ((dirty & (dirty_lights | dirty_normals)) != 0)
        derive_lights(context);
    else if ((dirty & dirty_materials) != 0)
        has_material_products_ = false;
    if (!is_enabled_)
        return;
    // Where normals are made unit, there is no product of a light and the normal matrix. A change of lights
    // alone then needs neither.
    const unsigned asked = dirty_modelview | dirty_normals;
    const bool faces = (dirty & dirty_lights) != 0 && !makes_unit_normals();
    if ((dirty & asked) != 0 || (!keeps_normals && faces))
        derive_normals(context.transform);
    else if (keeps_normals && faces)
        face_lights(kept_normals_.get());
}

/// Derives everything that does not depend on the matrices. Lights do not depend on them, since they are
/// stored in eye space.
void FixedLighting::derive_lights(const Context& context) {
    const LightingState& state = context.lighting;
    is_enabled_ = state.lighting;
    index_bits_ = context.drawable.index_bits;
    // COLOR_MATERIAL has no effect on colour index lighting (GL 1.3, appendix B, corollary 16).
    tracks_color_ = is_enabled_ && state.color_material && !indexed();
    has_material_products_ = false;
    if (!is_enabled_)
        return;
    has_two_sides_ = state.two_side;
    has_local_viewer_ = state.local_viewer;
    has_separate_specular_ = raster::has_color_sum && state.color_control == GL_SEPARATE_SPECULAR_COLOR;
    normalizes_ = context.transform.normalize;
    set_intensities(state.model_ambient, model_ambient_);
    light_count_ = 0;
    needs_eye_ = has_local_viewer_;
    all_lights_are_simple_ = !has_local_viewer_;
    for (unsigned i = 0; i < max_lights; ++i) {
        if (!state.light_enabled[i])
            continue;
        derive_source(state.light[i], lights_[light_count_]);
        all_lights_are_simple_ = all_lights_are_simple_ && lights_[light_count_].simple();
        needs_eye_ = needs_eye_ || !lights_[light_count_].directional;
        ++light_count_;
    }
}

/// Derives the normal matrix and what depends on it.
void FixedLighting::derive_normals(const TransformState& transform) {
    const numeric::NormalMatrix normal = FixedMath::normal_matrix(transform);
    // This build multiplies normals with `facing` of each light only, not with the normal matrix.
    if constexpr (always_has_given_normals) {
        normal_matrix_.column = numeric::detail::column_exponents<3, 3>(normal.at);
    } else {
        normal_matrix_ = numeric::to_block_matrix(normal);
        const std::int32_t(&row)[3] = normal_matrix_.row;
        const bool common = row[0] == row[1] && row[1] == row[2];
        has_material_products_ = has_material_products_ && common == rows_share_exponent_;
        rows_share_exponent_ = common;
    }
    face_lights(normal);
    kept_normals_.keep(normal);
}

void FixedLighting::face_lights(const numeric::NormalMatrix& normal) {
    for (int i = 0; i < light_count_; ++i)
        if (lights_[i].directional && !makes_unit_normals())
            lights_[i].facing = in_object_space(normal, lights_[i].to_light, normal_matrix_.column);
}

void FixedLighting::derive_source(const Light& light, LightSource& out) const {
    set_intensities(light.ambient, out.ambient);
    set_intensities(light.diffuse, out.diffuse);
    const Real(&p)[4] = light.position;
    // x, y and z get a common exponent without w. A small w would otherwise vanish under the exponent of the
    // largest component.
    const numeric::Block3 position = numeric::to_block(p[0], p[1], p[2]);
    if (has_specular)
        set_intensities(light.specular, out.specular);
    out.directional = !has_local_lights || numeric::is_zero(p[3]);
    if (out.directional) {
        out.to_light = numeric::normalize(position);
        if (has_specular)
            out.half = half_vector(out.to_light, toward_viewer);
    } else {
        out.position = numeric::mul(position, numeric::reciprocal(numeric::to_block(p[3])));
    }
    if (!has_local_lights)
        return;
    out.spot = !(light.spot_cutoff == no_spot_cutoff);
    if (out.spot) {
        out.spot_axis = numeric::normalize(numeric::to_block(light.spot_direction));
        out.spot_cosine =
            static_cast<std::int32_t>((numeric::sincos_degrees(light.spot_cutoff).cos + (1 << 29)) >> 30);
        out.spot_exponent = numeric::power_exponent(light.spot_exponent);
    }
    for (int i = 0; i < 3; ++i)
        out.attenuation[i] = numeric::to_block(light.attenuation[i]);
    const bool none = light.attenuation[0] == numeric::one && numeric::is_zero(light.attenuation[1]) &&
                      numeric::is_zero(light.attenuation[2]);
    out.attenuated = !out.directional && !none;
}

void FixedLighting::fold(const Context& context) {
    for (int side = 0; side < (two_sided() ? 2 : 1); ++side) {
        const Material& material = context.lighting.material[side];
        if (!raster::has_indices) {
            multiply_material(material, material_products_[side]);
            continue;
        }
        multiply_material(indexed() ? weighing(material) : material, material_products_[side]);
        for (int i = 0; i < 3; ++i)
            material_products_[side].index[i] = material.indexes[i];
    }
    has_material_products_ = true;
}

void FixedLighting::multiply_material(const Material& material, MaterialProducts& out) const {
    out.alpha = FixedMath::color_units(material.diffuse[3]);
    if (has_specular)
        out.shininess = numeric::power_exponent(material.shininess);
    out.has_specular = false;
    std::uint32_t brightest = 0;
    for (int c = 0; c < 3; ++c) {
        const std::int32_t ambient = intensity(material.ambient[c]), diffuse = intensity(material.diffuse[c]),
                           specular = intensity(material.specular[c]);
        std::int64_t base = std::int64_t{intensity(material.emission[c])} + times(ambient, model_ambient_[c]);
        for (int i = 0; i < light_count_; ++i) {
            const LightSource& s = lights_[i];
            const std::int32_t own = times(ambient, s.ambient[c]);
            if (has_local_lights)
                out.ambient[i][c] = s.simple() ? 0 : own;
            if (s.simple())
                base += own;
            out.diffuse[i][c] = times(diffuse, s.diffuse[c]);
            brightest |= numeric::abs_u32(out.diffuse[i][c]);
            if (!has_specular)
                continue;
            out.specular[i][c] = times(specular, s.specular[c]);
            out.has_specular = out.has_specular || out.specular[i][c] != 0;
        }
        out.base[c] = numeric::saturate_i32(base);
        out.plain_base[c] =
            std::int64_t{out.base[c]} * (1 << plain_factor_bits) + (std::int64_t{1} << (plain_sum_bits - 31));
    }
    // With diffuse products below 2^28, the sum of the base and eight products with factors of 31 bits stays
    // below 2^63.
    out.plain = all_lights_are_simple_ && !out.has_specular &&
                (!makes_unit_normals() || rows_share_exponent_) && brightest < 1u << 28 && !indexed();
}

/// Adds a light's diffuse colour, times `factor` (the cosine n . l), to the sums of plain lighting.
SPANGLE_RUN_INLINE void FixedLighting::add_factor(const std::int32_t (&diffuse)[3], std::int32_t factor,
                                                  std::int64_t (&sum)[3]) {
#pragma GCC unroll numeric::runs_inline ? 3 : 1
    for (int c = 0; c < 3; ++c)
        sum[c] += numeric::mul_s32(diffuse[c], factor);
}

/// Returns the cosine n . l of plain lighting: (N^T l) . n for normals as given, and (N n) . l / |N n| for
/// normals made unit.
SPANGLE_INLINE std::int32_t FixedLighting::facing(const LightSource& source, const PlainNormal& n, bool unit,
                                                  int side) {
    const std::int32_t along = unit ? static_cast<std::int32_t>(
                                          numeric::row_sum<3>(source.to_light.m, n.m, 1 << 29) >> 30)
                                    : numeric::row_times<3>(source.facing.m, n.m),
                       seen = side == 0 ? along : -along;
    if (unit)
        return plain_factor(numeric::mul_high_s32(seen, n.inverse), n.e);
    return plain_factor(seen, n.e + source.facing.e + 1);
}

/// Sets the colour of a vertex in plain lighting: base + sum over the lights of (n . l) * diffuse.
SPANGLE_INLINE void FixedLighting::add_plain_light(int side, raster::FixedVertex& out, const PlainNormal& n,
                                                   bool unit) const {
    const MaterialProducts& fold = material_products_[side];
    std::int64_t sum[3] = {fold.plain_base[0], fold.plain_base[1], fold.plain_base[2]};
    for (int i = 0; i < light_count_; ++i)
        add_factor(fold.diffuse[i], facing(lights_[i], n, unit, side), sum);
    set_plain_color(fold, sum, out);
}

SPANGLE_RUN_INLINE void FixedLighting::set_plain_color(const MaterialProducts& fold,
                                                       const std::int64_t (&sum)[3],
                                                       raster::FixedVertex& out) {
#pragma GCC unroll numeric::runs_inline ? 3 : 1
    for (int c = 0; c < 3; ++c) {
        out.color[c] = plain_color(sum[c]);
#if SPANGLE_SECONDARY_COLORS
        out.secondary[c] = 0;
#endif
    }
    out.color[3] = fold.alpha;
}

void FixedLighting::light_with_given_normal(const Real (&normal)[3], int side,
                                            raster::FixedVertex& out) const {
    const numeric::Mantissas<3> n = numeric::load(normal_matrix_.column, normal);
    add_plain_light(side, out, {{n.m[0], n.m[1], n.m[2]}, n.e, 0}, false);
}

/// Lights a vertex in plain lighting, with a normal that is made unit. False: the product of matrix and
/// normal is too short for an exact direction, and nothing was lit. light_with_all_terms() must light the
/// vertex then.
bool FixedLighting::light_with_unit_normal(const Real (&normal)[3], int side,
                                           raster::FixedVertex& out) const {
    const numeric::Mantissas<3> loaded = numeric::load(normal_matrix_.column, normal);
    PlainNormal n;
    std::uint64_t square = 0;
#pragma GCC unroll numeric::runs_inline ? 3 : 1
    for (int i = 0; i < 3; ++i) {
        n.m[i] = numeric::row_times<3>(normal_matrix_.m + 3 * i, loaded.m);
        square += static_cast<std::uint64_t>(numeric::mul_s32(n.m[i], n.m[i]));
    }
    const int zeros = numeric::clz64(square) & ~1; // `zeros` is even, and at least 4
    if (zeros > 16)
        return false;
    // 1/|n| = r * 2^(zeros / 2 - 62)
    const std::uint32_t r =
        numeric::rsqrt(numeric::low_word_after(static_cast<std::int64_t>(square), 32 - zeros));
    n.inverse = static_cast<std::int32_t>(r >> 1);
    n.e = zeros / 2 - 29;
    add_plain_light(side, out, n, true);
    return true;
}

FixedLighting::Direction FixedLighting::direction_of(const Real (&normal)[3], int side) const {
    const numeric::Block3 n = numeric::transform(normal_matrix_, normal);
    Direction out;
    if (makes_unit_normals()) {
        const numeric::Unit3 u = numeric::normalize(n);
        out = {{u.m[0], u.m[1], u.m[2]}, 30};
    } else {
        out.fraction_bits = 28;
        for (int i = 0; i < 3; ++i)
            out.m[i] = numeric::scale_saturate(n.m[i], n.e + out.fraction_bits);
    }
    if (side != 0)
        for (std::int32_t& m : out.m)
            m = numeric::negate_saturate(m);
    return out;
}

void FixedLighting::add_directional(const LightSource& source, const MaterialProducts& fold, int i,
                                    const Direction& n, Sum (&primary)[3], Sum (&specular)[3]) const {
    const std::uint32_t facing = cosine(n.m, n.fraction_bits, source.to_light);
    if (facing == 0)
        return;
    add_weighted(fold.diffuse[i], facing, primary);
    if (!has_specular || !fold.has_specular_of(i))
        return;
    add_weighted(fold.specular[i], specular_factor(cosine(n.m, n.fraction_bits, source.half), fold.shininess),
                 specular);
}

/// Adds a light of any kind. Positional lights, spots, and all lights under a local viewer need this
/// function. For other lights its result equals that of add_directional().
void FixedLighting::add_general(const LightSource& source, const MaterialProducts& fold, int i,
                                const numeric::Block3& to_eye, const Direction& n, Sum (&primary)[3],
                                Sum (&specular)[3]) const {
    numeric::Unit3 to_light = source.to_light;
    Strength strength;
    if (!source.directional) {
        const numeric::Block3 path = numeric::add(source.position, to_eye);
        to_light = numeric::normalize(path);
        if (source.attenuated) {
            const numeric::Block d = numeric::length(path);
            const numeric::Block divisor = numeric::add(
                source.attenuation[0],
                numeric::mul(d, numeric::add(source.attenuation[1], numeric::mul(d, source.attenuation[2]))));
            strength = to_strength(numeric::reciprocal(divisor));
        }
    }
    if (source.spot) {
        const std::int32_t along = numeric::negate_saturate(numeric::dot(to_light, source.spot_axis));
        if (along < source.spot_cosine)
            // No light leaves the cone of a spot, ambient light included.
            return;
        strength.factor = scaled(strength.factor, specular_factor(clamp_cosine(along), source.spot_exponent));
    }
    add_strong(fold.ambient[i], strength.factor, strength.shift, primary);
    const std::uint32_t facing = cosine(n.m, n.fraction_bits, to_light);
    if (facing == 0)
        return;
    add_strong(fold.diffuse[i], scaled(facing, strength.factor), strength.shift, primary);
    if (!has_specular || !fold.has_specular_of(i))
        return;
    numeric::Unit3 half = source.half;
    if (has_local_viewer_ || !source.directional)
        half = half_vector(to_light, has_local_viewer_ ? numeric::normalize(to_eye) : toward_viewer);
    add_strong(fold.specular[i],
               scaled(specular_factor(cosine(n.m, n.fraction_bits, half), fold.shininess), strength.factor),
               strength.shift, specular);
}

void FixedLighting::light_with_all_terms(const Real (&normal)[3], const numeric::Block4& eye, int side,
                                         raster::FixedVertex& out) const {
    const MaterialProducts& fold = material_products_[side];
    const Direction n = direction_of(normal, side);
    Sum primary[3], specular[3] = {0, 0, 0};
    for (int c = 0; c < 3; ++c)
        primary[c] = std::int64_t{fold.base[c]} * (1 << (sum_bits - intensity_bits));
    numeric::Block3 to_eye; // the vector from the vertex to the eye
    if (needs_eye())
        to_eye =
            numeric::negate(numeric::mul(numeric::xyz(eye), numeric::reciprocal(numeric::component(eye, 3))));
    for (int i = 0; i < light_count_; ++i) {
        const bool simple = lights_[i].simple() && !has_local_viewer_;
        if (!has_local_lights || simple)
            add_directional(lights_[i], fold, i, n, primary, specular);
        else
            add_general(lights_[i], fold, i, to_eye, n, primary, specular);
    }
    if (indexed())
        return set_index(fold, primary, specular, out);
    for (int c = 0; c < 3; ++c) {
        out.color[c] = to_color(has_separate_specular_ ? primary[c] : primary[c] + specular[c]);
#if SPANGLE_SECONDARY_COLORS
        out.secondary[c] = has_separate_specular_ ? to_color(specular[c]) : 0;
#endif
    }
    out.color[3] = fold.alpha;
}

/// Sets the colour index a_m + d (1 - s') (d_m - a_m) + s' (s_m - a_m), at most s_m (GL 1.3, 2.13.5). In this
/// formula, s' is min(s, 1).
void FixedLighting::set_index(const MaterialProducts& fold, const Sum (&primary)[3], const Sum (&specular)[3],
                              raster::FixedVertex& out) const {
    using Number = FixedMath::Scalar;
    constexpr Sum one = Sum{1} << sum_bits;
    const auto number = [](Sum v) { return Number{numeric::make_block(v, -sum_bits)}; };
    const Sum d = primary[0] + primary[1] + primary[2], s = specular[0] + specular[1] + specular[2],
              clamped_s = s < one ? s : one;
    const Number am = FixedMath::scalar(fold.index[0]), dm = FixedMath::scalar(fold.index[1]),
                 sm = FixedMath::scalar(fold.index[2]);
    const Number c = am + number(d) * number(one - clamped_s) * (dm - am) + number(clamped_s) * (sm - am);
    const bool beyond = numeric::compare(c.v, sm.v) > 0;
    FixedMath::set_index(FixedMath::real(beyond ? sm.v : c.v), index_bits_, out);
}

void FixedLighting::mix(const Input& a, const Input& b, const FixedMath::Parameter& t, Input& out) {
    for (int c = 0; c < 3; ++c)
        out.normal[c] = numeric::to_real(
            FixedMath::mix(numeric::to_block(a.normal[c]), numeric::to_block(b.normal[c]), t));
}

} // namespace spangle::gl

#endif
