// Generates texture coordinates from positions and normals (GL 1.3, 2.10.4), for every numeric policy.
#pragma once

#include "gl/context/context.hpp"
#include "gl/context/features.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_TEXGEN

template <class M> class TexGen {
  public:
    using Scalar = typename M::Scalar;

    /// Derives values from state that has changed. `dirty` holds the Dirty bits that were set since the last
    /// call.
    void derive(const Context& context, unsigned dirty) {
        if ((dirty & (dirty_others | dirty_normals)) != 0)
            derive_units(context);
        else if ((dirty & dirty_modelview) == 0)
            return;
        if (uses_normals_)
            M::normal_matrix(context.transform, normal_matrix_);
    }

    /// Units with a generated coordinate; bit u stands for unit u.
    unsigned units() const { return generating_units_; }
    /// True if the unit does not generate q.
    bool keeps_q(int unit) const { return unit_[unit].mode[3] == GL_NONE; }

    /// Sets the coordinates of a vertex before the texture matrix. Coordinates that are not generated come
    /// from `current`.
    [[gnu::noinline]] void generate(const typename M::Transforms& transforms, int unit,
                                    const Real (&position)[4], const Real (&normal)[3],
                                    const Real (&current)[4], Scalar (&out)[4]) const {
        const Unit& gen = unit_[unit];
        const typename M::Eye eye4 = M::to_eye(transforms, position);
        Scalar object[4], eye[4], n[3], r[3];
        for (int k = 0; k < 4; ++k) {
            object[k] = M::scalar(position[k]);
            eye[k] = M::scalar(eye4, k);
        }
        if (gen.mapped) {
            eye_normal(normal, n);
            reflect(eye, n, r);
        }
        for (int c = 0; c < 4; ++c)
            switch (gen.mode[c]) {
            case GL_OBJECT_LINEAR:
                out[c] = dot(gen.plane[c], object, 4);
                break;
            case GL_EYE_LINEAR:
                out[c] = dot(gen.plane[c], eye, 4);
                break;
            // SPHERE_MAP has c < 2, since cmd::TexGen() accepts the mode for S and T only.
            case GL_SPHERE_MAP:
                out[c] = sphere(r, c);
                break;
            case GL_REFLECTION_MAP:
                out[c] = r[c];
                break;
            case GL_NORMAL_MAP:
                out[c] = n[c];
                break;
            default:
                out[c] = M::scalar(current[c]);
            }
    }

  private:
    struct Unit {
        GLenum mode[4] = {};
        bool mapped = false; ///< true if a coordinate needs the normal
        Scalar plane[4][4];
    };
    unsigned generating_units_ = 0;
    bool normalizes_ = false, uses_normals_ = false;
    Unit unit_[texture_units];
    Scalar normal_matrix_[9]; ///< stored column by column

    void derive_units(const Context& context) {
        generating_units_ = 0;
        uses_normals_ = false;
        for (int u = 0; u < texture_units; ++u) {
            const TextureUnitState& state = context.texture.unit[u];
            Unit& unit = unit_[u];
            unit.mapped = false;
            for (int c = 0; c < 4; ++c) {
                const TexGenState& gen = state.gen[c];
                unit.mode[c] = state.gen_on[c] ? gen.mode : GLenum{GL_NONE};
                if (!state.gen_on[c])
                    continue;
                generating_units_ |= 1u << u;
                const bool linear = gen.mode == GL_OBJECT_LINEAR || gen.mode == GL_EYE_LINEAR;
                for (int k = 0; linear && k < 4; ++k)
                    unit.plane[c][k] =
                        M::scalar((gen.mode == GL_EYE_LINEAR ? gen.eye_plane : gen.object_plane)[k]);
                unit.mapped = unit.mapped || !linear;
            }
            uses_normals_ = uses_normals_ || unit.mapped;
        }
        normalizes_ = context.transform.normalize;
    }

    /// Returns the scalar product of n components. The components of `a` are `step` apart.
    static Scalar dot(const Scalar* a, const Scalar* b, int n, int step = 1) {
        Scalar sum = a[0] * b[0];
        for (int k = 1; k < n; ++k)
            sum = sum + a[k * step] * b[k];
        return sum;
    }

    static void make_unit(Scalar (&v)[3]) {
        const Scalar by = M::rsqrt(dot(v, v, 3));
        for (Scalar& c : v)
            c = c * by;
    }

    void eye_normal(const Real (&given)[3], Scalar (&n)[3]) const {
        const Scalar v[3] = {M::scalar(given[0]), M::scalar(given[1]), M::scalar(given[2])};
        for (int i = 0; i < 3; ++i)
            n[i] = dot(normal_matrix_ + i, v, 3, 3);
        if (normalizes_)
            make_unit(n);
    }

    /// Sets r to the reflection vector u - 2 n (n . u), where u is the unit vector from the eye to the
    /// vertex.
    static void reflect(const Scalar (&eye)[4], const Scalar (&n)[3], Scalar (&r)[3]) {
        // The product with w has the direction of the quotient by w, even if w is negative.
        Scalar u[3] = {eye[0] * eye[3], eye[1] * eye[3], eye[2] * eye[3]};
        make_unit(u);
        const Scalar along = dot(n, u, 3), twice = along + along;
        for (int i = 0; i < 3; ++i)
            r[i] = u[i] - n[i] * twice;
    }

    /// Returns coordinate c of the sphere map: r / m + 1/2, where m = 2 sqrt(rx rx + ry ry + (rz + 1)(rz +
    /// 1)).
    static Scalar sphere(const Scalar (&r)[3], int c) {
        constexpr Real one_half = numeric::from_float(0.5f);
        const Scalar half = M::scalar(one_half);
        const Scalar high[3] = {r[0], r[1], r[2] + M::scalar(numeric::one)};
        return r[c] * (M::rsqrt(dot(high, high, 3)) * half) + half;
    }
};

#else

/// Replaces TexGen in a build without generated coordinates. The current coordinates stay as they are.
template <class M> class TexGen {
  public:
    using Scalar = typename M::Scalar;
    void derive(const Context&, unsigned) {}
    static constexpr unsigned units() { return 0; }
    static constexpr bool keeps_q(int) { return true; }
    static void generate(const typename M::Transforms&, int, const Real (&)[4], const Real (&)[3],
                         const Real (&)[4], Scalar (&)[4]) {}
};

#endif

} // namespace spangle::gl
