// The lighting equation of GL 1.3, 2.13.1 in double, written from the text of the specification, and the GL
// calls that set the same scene. The file shares no code with the library.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "boards/scenes/gl.hpp"

namespace spangle::test {

using Vec3 = std::array<double, 3>;
using Vec4 = std::array<double, 4>;
using Mat4 = std::array<double, 16>; ///< column-major

inline double dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 scaled(const Vec3& a, double s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
inline Vec3 sum(const Vec3& a, const Vec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 unit(const Vec3& a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? scaled(a, 1 / length) : a;
}

inline Mat4 identity() {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}
inline Mat4 times(const Mat4& a, const Mat4& b) {
    Mat4 r{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k)
                r[4 * j + i] += a[4 * k + i] * b[4 * j + k];
    return r;
}
inline Vec4 times(const Mat4& a, const Vec4& v) {
    Vec4 r{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            r[i] += a[4 * j + i] * v[j];
    return r;
}
/// Multiplies with the upper left 3 x 3 of a matrix.
inline Vec3 times(const Mat4& a, const Vec3& v) {
    Vec3 r{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            r[i] += a[4 * j + i] * v[j];
    return r;
}
/// Returns element (row, column) of the inverse of the upper left 3 x 3.
inline std::array<Vec3, 3> inverse3(const Mat4& m) {
    std::array<Vec3, 3> r;
    double determinant = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            r[i][j] = m[4 * i1 + j1] * m[4 * i2 + j2] - m[4 * i2 + j1] * m[4 * i1 + j2];
        }
    for (std::size_t i = 0; i < 3; ++i)
        determinant += m[4 * i] * r[i][0];
    for (Vec3& row : r)
        row = scaled(row, 1 / determinant);
    return r;
}

struct LightSource { // GL 1.3, table 2.7
    bool on = false;
    Vec4 ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1}, specular{0, 0, 0, 1}, position{0, 0, 1, 0};
    Vec3 spot_direction{0, 0, -1};
    double spot_exponent = 0, spot_cutoff = 180, constant = 1, linear = 0, quadratic = 0;
};

struct SurfaceMaterial { // GL 1.3, table 2.7
    Vec4 ambient{0.2f, 0.2f, 0.2f, 1}, diffuse{0.8f, 0.8f, 0.8f, 1}, specular{0, 0, 0, 1},
        emission{0, 0, 0, 1};
    double shininess = 0;
};

/// A vertex and everything on which its colour depends; all numbers are floats.
struct LitVertex {
    std::array<LightSource, 8> light;
    SurfaceMaterial material[2];
    Vec4 scene_ambient{0.2f, 0.2f, 0.2f, 1};
    bool local_viewer = false, separate_specular = false, normalize = false, rescale = false;
    Mat4 light_matrix = identity(); ///< modelview matrix when the lights are set
    Mat4 modelview = identity();    ///< modelview matrix when the vertex is given
    Vec4 position{0, 0, 0, 1};
    Vec3 normal{0, 0, 1};

    LitVertex() {
        light[0].on = true;
        light[0].diffuse = light[0].specular = {1, 1, 1, 1};
    }
};

struct LitColor {
    Vec4 primary;
    Vec3 secondary;
    double margin; ///< distance of the nearest cosine from where the equation jumps
};

inline double clamped(double v) {
    return v < 0 ? 0 : v > 1 ? 1 : v;
}

inline Vec3 eye_normal(const LitVertex& v) {
    const std::array<Vec3, 3> inverse = inverse3(v.modelview);
    Vec3 n{};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
            n[j] += v.normal[i] * inverse[i][j];
    if (v.rescale)
        n = scaled(n, 1 / std::sqrt(dot(inverse[2], inverse[2])));
    return v.normalize ? unit(n) : n;
}

/// Returns the colour of a side: 0 is the front, 1 the back.
inline LitColor equation(const LitVertex& v, int side) {
    const SurfaceMaterial& m = v.material[side];
    const Vec3 n = scaled(eye_normal(v), side == 0 ? 1 : -1);
    const Vec4 eye4 = times(v.modelview, v.position);
    const Vec3 eye = scaled({eye4[0], eye4[1], eye4[2]}, 1 / eye4[3]);
    LitColor out{{}, {}, 1};
    Vec3 primary, secondary{};
    for (std::size_t c = 0; c < 3; ++c)
        primary[c] = m.emission[c] + m.ambient[c] * v.scene_ambient[c];
    for (const LightSource& l : v.light) {
        if (!l.on)
            continue;
        const Vec4 p = times(v.light_matrix, l.position);
        const Vec3 at{p[0], p[1], p[2]};
        const Vec3 path = p[3] == 0 ? at : sum(scaled(at, 1 / p[3]), scaled(eye, -1));
        const Vec3 to_light = unit(path);
        const double d = std::sqrt(dot(path, path));
        double strength = p[3] == 0 ? 1 : 1 / (l.constant + l.linear * d + l.quadratic * d * d);
        if (l.spot_cutoff != 180) {
            const double along = -dot(to_light, unit(times(v.light_matrix, l.spot_direction)));
            const double edge = std::cos(l.spot_cutoff * std::acos(-1.0) / 180);
            out.margin = std::fmin(out.margin, std::fabs(along - edge));
            strength *= along < edge - 1e-12 ? 0 : std::pow(std::fmax(along, 0), l.spot_exponent);
        }
        const double facing = dot(n, to_light);
        const bool shines = m.specular[0] != 0 || m.specular[1] != 0 || m.specular[2] != 0;
        if (shines)
            out.margin = std::fmin(out.margin, std::fabs(facing));
        const Vec3 to_eye = v.local_viewer ? unit(scaled(eye, -1)) : Vec3{0, 0, 1};
        const double highlight =
            facing > 0 ? std::pow(std::fmax(dot(n, unit(sum(to_light, to_eye))), 0), m.shininess) : 0;
        for (std::size_t c = 0; c < 3; ++c) {
            primary[c] +=
                strength * (m.ambient[c] * l.ambient[c] + std::fmax(facing, 0) * m.diffuse[c] * l.diffuse[c]);
            (v.separate_specular ? secondary : primary)[c] +=
                strength * highlight * m.specular[c] * l.specular[c];
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        out.primary[c] = clamped(primary[c]);
        out.secondary[c] = clamped(secondary[c]);
    }
    out.primary[3] = clamped(m.diffuse[3]);
    return out;
}

template <std::size_t N> std::array<GLfloat, N> floats(const std::array<double, N>& v) {
    std::array<GLfloat, N> f;
    for (std::size_t i = 0; i < N; ++i)
        f[i] = static_cast<GLfloat>(v[i]);
    return f;
}

/// Sets the state of the scene; the vertex is not given.
inline void specify(const LitVertex& v) {
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(v.light_matrix.data());
    for (GLenum i = 0; i < 8; ++i) {
        const LightSource& l = v.light[i];
        const GLenum light = GL_LIGHT0 + i;
        (l.on ? glEnable : glDisable)(light);
        glLightfv(light, GL_AMBIENT, floats(l.ambient).data());
        glLightfv(light, GL_DIFFUSE, floats(l.diffuse).data());
        glLightfv(light, GL_SPECULAR, floats(l.specular).data());
        glLightfv(light, GL_POSITION, floats(l.position).data());
        glLightfv(light, GL_SPOT_DIRECTION, floats(l.spot_direction).data());
        for (const auto& [name, value] : {std::pair<GLenum, double>{GL_SPOT_EXPONENT, l.spot_exponent},
                                          {GL_SPOT_CUTOFF, l.spot_cutoff},
                                          {GL_CONSTANT_ATTENUATION, l.constant},
                                          {GL_LINEAR_ATTENUATION, l.linear},
                                          {GL_QUADRATIC_ATTENUATION, l.quadratic}})
            glLightf(light, name, static_cast<GLfloat>(value));
    }
    for (int side = 0; side < 2; ++side) {
        const SurfaceMaterial& m = v.material[side];
        const GLenum face = side == 0 ? GL_FRONT : GL_BACK;
        glMaterialfv(face, GL_AMBIENT, floats(m.ambient).data());
        glMaterialfv(face, GL_DIFFUSE, floats(m.diffuse).data());
        glMaterialfv(face, GL_SPECULAR, floats(m.specular).data());
        glMaterialfv(face, GL_EMISSION, floats(m.emission).data());
        glMaterialf(face, GL_SHININESS, static_cast<GLfloat>(m.shininess));
    }
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, floats(v.scene_ambient).data());
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, v.local_viewer ? 1 : 0);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                  v.separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    (v.normalize ? glEnable : glDisable)(GL_NORMALIZE);
    (v.rescale ? glEnable : glDisable)(GL_RESCALE_NORMAL);
    glLoadMatrixd(v.modelview.data());
}

} // namespace spangle::test
