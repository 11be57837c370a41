// Samples a texture in double by the formulas of GL 1.3, 3.8.6 to 3.8.9 (docs/features.md F03, F10 to F12,
// F21). By Spangle's definition, filter weights have 8 bits, and NEAREST looks 2^-13 texel further.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <spangle/GL/gl.h>

namespace spangle::test::oracle {

using Rgba = std::array<double, 4>;

/// The texels of one level and face, border included, as R, G, B, A of the base format.
struct Image {
    int size[3] = {1, 1, 1}; ///< size in texels, without border
    int border[3] = {};
    std::vector<Rgba> texels;

    int whole(int axis) const { return size[axis] + 2 * border[axis]; }
    Rgba& at(int i, int j, int k) {
        return texels[static_cast<std::size_t>(((k + border[2]) * whole(1) + j + border[1]) * whole(0) + i +
                                               border[0])];
    }
};

struct Texture {
    GLenum target = GL_TEXTURE_2D;
    GLenum min = GL_NEAREST, mag = GL_NEAREST, wrap[3] = {GL_REPEAT, GL_REPEAT, GL_REPEAT};
    Rgba border_color{};
    std::vector<std::vector<Image>> faces; ///< levels of each face

    int dimensions() const { return target == GL_TEXTURE_1D ? 1 : target == GL_TEXTURE_3D ? 3 : 2; }
};

inline double wrapped(GLenum mode, double s, double n) {
    switch (mode) {
    case GL_REPEAT:
        return s - std::floor(s);
    case GL_CLAMP:
        return std::fmin(std::fmax(s, 0), 1);
    case GL_CLAMP_TO_EDGE:
        return std::fmin(std::fmax(s, 1 / (2 * n)), 1 - 1 / (2 * n));
    case GL_CLAMP_TO_BORDER:
        return std::fmin(std::fmax(s, -1 / (2 * n)), 1 + 1 / (2 * n));
    default: // MIRRORED_REPEAT: the number of the texel is mirrored later
        return s - 2 * std::floor(s / 2);
    }
}

/// (size - 1) - mirror((i mod 2 size) - size), where mirror(a) = a >= 0 ? a : -(1 + a).
inline int mirrored(int i, int n) {
    const int a = ((i % (2 * n)) + 2 * n) % (2 * n) - n;
    return n - 1 - (a >= 0 ? a : -(1 + a));
}

/// The number of a texel on an axis and, with LINEAR, the next texel and its weight.
struct Pick {
    int i[2];
    double weight;
};
inline Pick pick(GLenum mode, bool linear, double s, int n) {
    const double u = n * wrapped(mode, s, n);
    Pick p{};
    if (linear) {
        const double v = std::floor((u - 0.5) * 256 + 0.5) / 256;
        p.i[0] = static_cast<int>(std::floor(v));
        p.weight = v - p.i[0];
    } else {
        p.i[0] = static_cast<int>(std::floor(u + 1.0 / 8192));
        if (p.i[0] == n && mode != GL_REPEAT && mode != GL_MIRRORED_REPEAT && u <= n)
            p.i[0] = n - 1;
    }
    p.i[1] = p.i[0] + 1;
    for (int& i : p.i) {
        if (mode == GL_REPEAT)
            i = ((i % n) + n) % n;
        else if (mode == GL_MIRRORED_REPEAT)
            i = mirrored(i, n);
        else if (mode == GL_CLAMP_TO_EDGE)
            i = i < 0 ? 0 : i >= n ? n - 1 : i;
    }
    return p;
}

inline Rgba texel(const Texture& t, Image image, int i, int j, int k) {
    const int at[3] = {i, j, k};
    for (int axis = 0; axis < 3; ++axis)
        if (at[axis] < -image.border[axis] || at[axis] >= image.size[axis] + image.border[axis])
            return t.border_color;
    return image.at(i, j, k);
}

inline Rgba level_color(const Texture& t, const Image& image, GLenum filter, const double (&c)[3]) {
    Rgba sum{};
    Pick p[3];
    const bool linear = filter == GL_LINEAR;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] =
            axis < t.dimensions() ? pick(t.wrap[axis], linear, c[axis], image.size[axis]) : Pick{{0, 0}, 0};
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        int at[3];
        for (int axis = 0; axis < 3; ++axis) {
            const bool behind = (corner >> axis & 1) != 0;
            weight *= behind ? p[axis].weight : 1 - p[axis].weight;
            at[axis] = p[axis].i[behind ? 1 : 0];
        }
        if (weight == 0)
            continue;
        const Rgba v = texel(t, image, at[0], at[1], at[2]);
        for (std::size_t i = 0; i < 4; ++i)
            sum[i] += weight * v[i];
    }
    return sum;
}

/// Chooses the face of a cube map by table 3.20 of the specification.
inline std::size_t cube_face(double x, double y, double z, double (&st)[3]) {
    const double ax = std::fabs(x), ay = std::fabs(y), az = std::fabs(z);
    double sc, tc, ma;
    std::size_t face;
    if (ax > ay && ax > az) {
        face = x > 0 ? 0 : 1, ma = ax, sc = x > 0 ? -z : z, tc = -y;
    } else if (ay > az) {
        face = y > 0 ? 2 : 3, ma = ay, sc = x, tc = y > 0 ? z : -z;
    } else {
        face = z > 0 ? 4 : 5, ma = az, sc = z > 0 ? x : -x, tc = -y;
    }
    st[0] = (sc / ma + 1) / 2;
    st[1] = (tc / ma + 1) / 2;
    st[2] = 0;
    return face;
}

/// Returns the texture's colour at s, t, r; lambda is already clamped.
inline Rgba sample(const Texture& t, double s, double tt, double r, double lambda) {
    double at[3] = {s, tt, r};
    const std::size_t face = t.target == GL_TEXTURE_CUBE_MAP ? cube_face(s, tt, r, at) : 0;
    const std::vector<Image>& levels = t.faces[face];
    const bool nearest_mipmap = t.min == GL_NEAREST_MIPMAP_NEAREST || t.min == GL_NEAREST_MIPMAP_LINEAR;
    const double c = t.mag == GL_LINEAR && nearest_mipmap ? 0.5 : 0;
    const int q = static_cast<int>(levels.size()) - 1;
    if (lambda <= c)
        return level_color(t, levels[0], t.mag, at);
    const GLenum within =
        t.min == GL_LINEAR || t.min == GL_LINEAR_MIPMAP_NEAREST || t.min == GL_LINEAR_MIPMAP_LINEAR
            ? GL_LINEAR
            : GL_NEAREST;
    if (t.min == GL_NEAREST || t.min == GL_LINEAR)
        return level_color(t, levels[0], within, at);
    if (t.min == GL_NEAREST_MIPMAP_NEAREST || t.min == GL_LINEAR_MIPMAP_NEAREST) {
        const int d = lambda <= 0.5       ? 0
                      : lambda <= q + 0.5 ? static_cast<int>(std::ceil(lambda + 0.5)) - 1
                                          : q;
        return level_color(t, levels[static_cast<std::size_t>(d)], within, at);
    }
    const int d1 = lambda >= q ? q : static_cast<int>(std::floor(lambda)), d2 = lambda >= q ? q : d1 + 1;
    const double f = lambda - std::floor(lambda);
    const Rgba a = level_color(t, levels[static_cast<std::size_t>(d1)], within, at),
               b = level_color(t, levels[static_cast<std::size_t>(d2)], within, at);
    Rgba out;
    for (std::size_t i = 0; i < 4; ++i)
        out[i] = d1 == d2 ? a[i] : (1 - f) * a[i] + f * b[i];
    return out;
}

} // namespace spangle::test::oracle
