// Computes the lighting equation in double, term by term as GL 1.3, 2.13.1 states it. Only hosts have this
// reference.
#pragma once

#include <cmath>
#include <numbers>

#include "gl/context/context.hpp"
#include "gl/vertex/double_math.hpp"

namespace spangle::gl {

class DoubleLighting {
  public:
    struct Input {
        double normal[3]; ///< the normal as given, in object space
    };

    void derive(const Context& context, unsigned) {
        is_enabled_ = context.lighting.lighting;
        has_two_sides_ = context.lighting.two_side;
        index_bits_ = context.drawable.index_bits;
        tracks_color_ = is_enabled_ && context.lighting.color_material && index_bits_ == 0;
        DoubleMath::normal_matrix(context.transform, normal_matrix_);
    }
    void materials_changed() {}
    bool needs_eye() const { return is_enabled_; }
    bool two_sided() const { return is_enabled_ && has_two_sides_; }
    bool tracks_color() const { return tracks_color_; }

    static Input input(const Real (&n)[3]) {
        return {{DoubleMath::number(n[0]), DoubleMath::number(n[1]), DoubleMath::number(n[2])}};
    }

    void light(const Context& context, const Real (&normal)[3], const DoubleMath::Eye& eye, int side,
               raster::DoubleVertex& out) const {
        light(context, input(normal), eye, side, out);
    }
    void light(const Context& context, const Input& vertex, const DoubleMath::Eye& eye, int side,
               raster::DoubleVertex& out) const {
        const LightingState& state = context.lighting;
        const Material& given = state.material[side];
        const Material material = index_bits_ != 0 ? luminance_weights(given) : given;
        double n[3];
        for (int i = 0; i < 3; ++i)
            n[i] = normal_matrix_[i] * vertex.normal[0] + normal_matrix_[3 + i] * vertex.normal[1] +
                   normal_matrix_[6 + i] * vertex.normal[2];
        if (context.transform.normalize)
            unit(n);
        if (side != 0)
            for (double& c : n)
                c = -c;
        double primary[3], specular[3] = {0, 0, 0};
        for (int c = 0; c < 3; ++c)
            primary[c] =
                real(material.emission[c]) + real(material.ambient[c]) * real(state.model_ambient[c]);
        for (unsigned i = 0; i < max_lights; ++i)
            if (state.light_enabled[i])
                add(state, state.light[i], material, eye, n, primary, specular);
        if (index_bits_ != 0) {
            const double d = primary[0] + primary[1] + primary[2],
                         s = clamp(specular[0] + specular[1] + specular[2]), am = real(given.indexes[0]),
                         dm = real(given.indexes[1]), sm = real(given.indexes[2]);
            const double c = am + d * (1.0 - s) * (dm - am) + s * (sm - am);
            return DoubleMath::set_index(c < sm ? c : sm, index_bits_, out);
        }
        const bool separate = state.color_control == GL_SEPARATE_SPECULAR_COLOR;
        for (int c = 0; c < 3; ++c) {
            out.color[c] = clamp(separate ? primary[c] : primary[c] + specular[c]);
            out.secondary[c] = separate ? clamp(specular[c]) : 0.0;
        }
        out.color[3] = clamp(real(material.diffuse[3]));
    }

    static void mix(const Input& a, const Input& b, const DoubleMath::Parameter& t, Input& out) {
        for (int c = 0; c < 3; ++c)
            out.normal[c] = DoubleMath::mix(a.normal[c], b.normal[c], t);
    }

  private:
    bool is_enabled_ = false, has_two_sides_ = false, tracks_color_ = false;
    unsigned index_bits_ = 0;
    double normal_matrix_[9] = {}; ///< stored column by column

    /// Returns the material that replaces the given one for colour index lighting. The sums of its components
    /// are d_l and s_l: .30 R + .59 G + .11 B of the light (GL 1.3, 2.13.5).
    static Material luminance_weights(const Material& material) {
        Material out;
        constexpr double weight[3] = {.30, .59, .11};
        for (int c = 0; c < 3; ++c) {
            out.ambient[c] = out.emission[c] = numeric::zero;
            out.diffuse[c] = out.specular[c] = numeric::from_double(weight[c]);
        }
        out.shininess = material.shininess;
        return out;
    }

    static double real(Real v) { return DoubleMath::number(v); }
    static double clamp(double v) { return v > 0.0 ? (v < 1.0 ? v : 1.0) : 0.0; }
    static double dot(const double (&a)[3], const double (&b)[3]) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
    static void unit(double (&v)[3]) {
        const double l = std::sqrt(dot(v, v));
        if (l > 0.0)
            for (double& c : v)
                c /= l;
    }
    static double power(double base, double exponent) {
        return exponent == 0.0 ? 1.0 : std::pow(clamp(base), exponent);
    }

    static void add(const LightingState& state, const Light& light, const Material& material,
                    const DoubleMath::Eye& position, const double (&n)[3], double (&primary)[3],
                    double (&specular)[3]) {
        double to_light[3], eye[3], strength = 1.0;
        const double w = real(light.position[3]);
        for (int c = 0; c < 3; ++c) {
            eye[c] = position.v[c] / position.v[3];
            to_light[c] = w == 0.0 ? real(light.position[c]) : real(light.position[c]) / w - eye[c];
        }
        if (w != 0.0) {
            const double d = std::sqrt(dot(to_light, to_light));
            strength = 1.0 / (real(light.attenuation[0]) + real(light.attenuation[1]) * d +
                              real(light.attenuation[2]) * d * d);
        }
        unit(to_light);
        if (real(light.spot_cutoff) != 180.0) {
            double axis[3] = {-real(light.spot_direction[0]), -real(light.spot_direction[1]),
                              -real(light.spot_direction[2])};
            unit(axis);
            const double along = dot(to_light, axis);
            if (along < std::cos(real(light.spot_cutoff) * std::numbers::pi / 180.0))
                return;
            strength *= power(along, real(light.spot_exponent));
        }
        const double facing = dot(n, to_light) > 0.0 ? dot(n, to_light) : 0.0;
        double half[3] = {to_light[0], to_light[1], to_light[2] + 1.0};
        if (state.local_viewer) {
            double viewer[3] = {-eye[0], -eye[1], -eye[2]};
            unit(viewer);
            for (int c = 0; c < 3; ++c)
                half[c] = to_light[c] + viewer[c];
        }
        unit(half);
        const double shine = facing > 0.0 ? power(dot(n, half), real(material.shininess)) : 0.0;
        for (int c = 0; c < 3; ++c) {
            primary[c] += strength * (real(material.ambient[c]) * real(light.ambient[c]) +
                                      facing * real(material.diffuse[c]) * real(light.diffuse[c]));
            specular[c] += strength * shine * real(material.specular[c]) * real(light.specular[c]);
        }
    }
};

} // namespace spangle::gl
