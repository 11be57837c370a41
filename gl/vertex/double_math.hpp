// Arithmetic of the vertex pipeline in double, as a reference for FixedMath. It evaluates the formulas of GL
// 1.3 with the state as the program set it. Window positions are snapped to the same n.8 grid as in
// FixedMath. Only hosts have this reference.
#pragma once

#include <cmath>

#include "gl/context/context.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::gl {

struct DoubleMath {
    using Window = raster::DoubleVertex;
    struct Clip {
        double v[4];
    };
    using Eye = Clip;
    using Depth = double;
    using Point = Clip;
    /// A place on an edge, as the distance from the nearer end divided by the edge's length.
    struct Parameter {
        double part;
        bool from_second; ///< true if the nearer end is the second one
    };
    struct Matrix {
        double m[4][4]; ///< indexed by row and column
    };

    struct Transforms {
        Matrix to_clip, to_eye, texture[texture_units];
        double scale[2], center[2], depth_middle, depth_half;
    };

    static Matrix matrix(const numeric::Matrix& a) {
        Matrix out;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                const numeric::Element e = a.at(i, j);
                out.m[i][j] = std::ldexp(static_cast<double>(e.m), e.e + numeric::element_bias);
            }
        return out;
    }

    static Matrix multiply(const Matrix& a, const Matrix& b) {
        Matrix out{};
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                for (int k = 0; k < 4; ++k)
                    out.m[i][j] += a.m[i][k] * b.m[k][j];
        return out;
    }

    static double number(Real v) { return numeric::to_double(v); }

    /// Derives all values anew, whatever has changed.
    static void derive(const TransformState& state, unsigned, Transforms& out) {
        out.to_eye = matrix(state.modelview.entry[state.modelview.top]);
        out.to_clip = multiply(matrix(state.projection.entry[state.projection.top]), out.to_eye);
        for (int u = 0; u < texture_units; ++u)
            out.texture[u] = matrix(state.texture[u].entry[state.texture[u].top]);
        for (int i = 0; i < 2; ++i) {
            out.scale[i] = state.viewport[2 + i] / 2.0;
            out.center[i] = state.viewport[i] + out.scale[i];
        }
        const double n = number(state.depth_range[0]), f = number(state.depth_range[1]);
        out.depth_middle = (n + f) / 2.0;
        out.depth_half = (f - n) / 2.0;
    }

    static Clip times(const Matrix& a, const Real (&v)[4]) {
        return times(a, {number(v[0]), number(v[1]), number(v[2]), number(v[3])});
    }
    static Clip times(const Matrix& a, const double (&v)[4]) {
        Clip out;
        for (int i = 0; i < 4; ++i)
            out.v[i] = a.m[i][0] * v[0] + a.m[i][1] * v[1] + a.m[i][2] * v[2] + a.m[i][3] * v[3];
        return out;
    }
    /// Never divides a vertex by w, so that every vertex of this policy goes through clip coordinates.
    template <int N> struct Projections {
        void add(int, const Transforms& t, const Real (&v)[4], Window& out, bool fog) {
            if (fog)
                set_fog(depth(t, v), out);
        }
        void finish(int) {}
        bool divide(int, const Transforms&, const Real (&)[4], Window&, unsigned&) const { return false; }
    };
    using Place = Window;
    static void keep_place(const Window& from, Place& to) { to = from; }
    static void take_place(const Place& from, Window& to) { to = from; }
    static Depth depth(const Transforms& t, const Real (&v)[4]) { return to_eye(t, v).v[2]; }
    static Clip to_clip(const Transforms& t, const Real (&v)[4]) { return times(t.to_clip, v); }
    static Eye to_eye(const Transforms& t, const Real (&v)[4]) { return times(t.to_eye, v); }
    static Point clip_point(const Transforms& t, const Real (&v)[4]) { return to_clip(t, v); }
    static Point eye_point(const Transforms& t, const Real (&v)[4]) { return to_eye(t, v); }
    static Clip narrow(const Point& v) { return v; }

    static constexpr int guard_band = 4;
    static double distance(const Clip& c, int plane, int band) {
        const double w = plane < 4 ? band * c.v[3] : c.v[3];
        return (plane & 1) != 0 ? w - c.v[plane >> 1] : w + c.v[plane >> 1];
    }
    static bool beyond(const Clip& c, int plane, int band) { return distance(c, plane, band) < 0.0; }
    static bool in_front(const Clip& c) { return c.v[3] > 0.0; }

    struct Plane {
        double at[4] = {};
        bool turned = false; ///< true if `at` is the complement of the given plane
    };
    using Distance = double;

    static Plane plane(const Real (&equation)[4]) {
        Plane p{{number(equation[0]), number(equation[1]), number(equation[2]), number(equation[3])}, false};
        for (const double c : p.at)
            if (c != 0.0) {
                p.turned = c < 0.0;
                break;
            }
        if (p.turned)
            for (double& c : p.at)
                c = -c;
        return p;
    }
    static Distance distance(const Plane& p, const Eye& eye) {
        return p.at[0] * eye.v[0] + p.at[1] * eye.v[1] + p.at[2] * eye.v[2] + p.at[3] * eye.v[3];
    }
    static bool turned(const Plane& p) { return p.turned; }
    static bool outside(const Plane& p, Distance d) { return p.turned ? d > 0.0 : d < 0.0; }

    static Parameter intersect(Distance a, Distance b) {
        a = std::fabs(a);
        b = std::fabs(b);
        return {std::fmin(a, b) / (a + b), b < a};
    }
    /// Returns the point where the edge from a (inside) to b (outside) meets a plane of the view volume. Its
    /// coordinates are sums of minors, as in FixedClipping::clip_edge().
    static Point clip_edge(const Point& a, const Point& b, int plane, int band, const Parameter&) {
        const int c = plane >> 1;
        const double s = (plane & 1) != 0 ? -1.0 : 1.0, k = plane < 4 ? band : 1;
        const double sum = distance(a, plane, band) - distance(b, plane, band);
        const auto minor = [&](int i, int j) { return (a.v[i] * b.v[j] - b.v[i] * a.v[j]) / sum; };
        Point out;
        for (int j = 0; j < 3; ++j)
            out.v[j] = k * minor(3, j) + s * minor(c, j);
        out.v[3] = s * minor(c, 3);
        out.v[c] = -s * k * out.v[3];
        return out;
    }

    static double mix(double a, double b, const Parameter& t) {
        return t.from_second ? b + (a - b) * t.part : a + (b - a) * t.part;
    }
    static Clip mix(const Clip& a, const Clip& b, const Parameter& t) {
        Clip out;
        for (int i = 0; i < 4; ++i)
            out.v[i] = mix(a.v[i], b.v[i], t);
        return out;
    }
    static void mix(const Window& a, const Window& b, const Parameter& t, unsigned units, Window& out) {
        mix_color(a, b, t, out);
        for (int u = 0; u < texture_units; ++u) {
            if ((units >> u & 1) == 0)
                continue;
            out.tex[u].s = mix(a.tex[u].s, b.tex[u].s, t);
            out.tex[u].t = mix(a.tex[u].t, b.tex[u].t, t);
            out.tex[u].q = mix(a.tex[u].q, b.tex[u].q, t);
            out.tex[u].r = mix(a.tex[u].r, b.tex[u].r, t);
        }
    }

    template <class V> static void mix_color(const V& a, const V& b, const Parameter& t, V& out) {
        for (int c = 0; c < 4; ++c)
            out.color[c] = mix(a.color[c], b.color[c], t);
        for (int c = 0; c < 3; ++c)
            out.secondary[c] = mix(a.secondary[c], b.secondary[c], t);
    }

    // Numbers for operations that few vertices need: generated coordinates and normals.

    using Scalar = double;
    static Scalar scalar(Real v) { return number(v); }
    static Scalar scalar(const Eye& v, int i) { return v.v[i]; }
    static Scalar rsqrt(Scalar v) { return v > 0.0 ? 1.0 / std::sqrt(v) : 0.0; }

    /// Returns the matrix that normals are multiplied with, column by column. It includes RESCALE_NORMAL (GL
    /// 1.3, 2.10.3).
    static void normal_matrix(const TransformState& state, Scalar (&out)[9]) {
        const Matrix m = matrix(state.modelview.entry[state.modelview.top]);
        for (int j = 0; j < 3; ++j)
            // Cofactors are the elements of the inverse transpose times the determinant.
            for (int i = 0; i < 3; ++i) {
                const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
                out[3 * j + i] = m.m[i1][j1] * m.m[i2][j2] - m.m[i1][j2] * m.m[i2][j1];
            }
        const double d = m.m[0][0] * out[0] + m.m[1][0] * out[1] + m.m[2][0] * out[2];
        if (d != 0.0)
            for (double& v : out)
                v /= d;
        const double row = out[6] * out[6] + out[7] * out[7] + out[8] * out[8];
        if (state.rescale_normal && row > 0.0)
            for (double& v : out)
                v /= std::sqrt(row);
    }

    static void set_texture(const Transforms& t, const Scalar (&strq)[4], int unit, bool, Window& out) {
        const Clip v = texture_of(t, strq, unit);
        out.tex[unit] = {v.v[0], v.v[1], v.v[3], v.v[2]};
    }
    static Eye texture_of(const Transforms& t, const Scalar (&strq)[4], int unit) {
        return times(t.texture[unit], strq);
    }

    static void project(const Transforms& t, const Clip& c, Window& out) {
        out.inv_w = 1.0 / c.v[3];
        out.x_exact = t.center[0] + t.scale[0] * (c.v[0] / c.v[3]);
        out.y_exact = t.center[1] + t.scale[1] * (c.v[1] / c.v[3]);
        out.x = snap(out.x_exact);
        out.y = snap(out.y_exact);
        const double z = t.depth_middle + t.depth_half * (c.v[2] / c.v[3]);
        out.z = z < 0.0 ? 0.0 : z > 1.0 ? 1.0 : z;
    }

    static std::uint32_t depth_word(const Window& v) {
        return static_cast<std::uint32_t>(std::floor(v.z * 4294967295.0 + 0.5));
    }
    static void window_of(const Transforms& t, const Clip& c, Real (&out)[4]) {
        for (int i = 0; i < 2; ++i)
            out[i] = numeric::from_double(t.center[i] + t.scale[i] * (c.v[i] / c.v[3]));
        out[2] = numeric::from_double(t.depth_middle + t.depth_half * (c.v[2] / c.v[3]));
        out[3] = numeric::from_double(c.v[3]);
    }
    static void color_of(const Window& v, Real (&out)[4]) {
        for (int c = 0; c < 4; ++c)
            out[c] = numeric::from_double(v.color[c]);
    }
    static void to_reals(const Eye& v, Real (&out)[4]) {
        for (int c = 0; c < 4; ++c)
            out[c] = numeric::from_double(v.v[c]);
    }

    static void set_color(Window& out, const Real (&rgba)[4]) {
        for (int c = 0; c < 4; ++c)
            out.color[c] = number(numeric::clamp01(rgba[c]));
        for (int c = 0; c < 3; ++c)
            out.secondary[c] = 0.0;
    }
    static void set_secondary_color(Window& out, const Real (&rgb)[4]) {
        for (int c = 0; c < 3; ++c)
            out.secondary[c] = number(numeric::clamp01(rgb[c]));
    }
    struct Colors {
        double color[4], secondary[3];
    };
    template <class From, class To> static void copy_color(const From& from, To& to) {
        for (int c = 0; c < 4; ++c)
            to.color[c] = from.color[c];
        for (int c = 0; c < 3; ++c)
            to.secondary[c] = from.secondary[c];
    }
    static void set_texture(const Transforms& t, const Real (&stq)[4], int unit, Window& out) {
        const Clip v = times(t.texture[unit], stq);
        out.tex[unit] = {v.v[0], v.v[1], v.v[3], v.v[2]};
    }
    static bool q_is_one(const Window& v, int unit) { return v.tex[unit].q == 1; }
    static void set_sprite(int unit, bool s, bool t, Window& out) {
        out.tex[unit] = {s ? 1.0 : 0.0, t ? 1.0 : 0.0, 1, 0};
    }
    static void fade(Real factor, Window& out) { out.color[3] *= number(factor); }
    static void set_fog(Depth eye_z, Window& out) { out.fog = std::fabs(eye_z); }
    static void set_fog_coordinate(Depth coordinate, Window& out) { out.fog = coordinate; }
    static Depth fog_coordinate(const Window& v) { return v.fog; }
    static Depth fog_coordinate(Real coordinate) { return number(coordinate); }

    /// Stores a colour index as red, in 255ths, as FixedMath::set_index() does.
    static void set_index(double index, unsigned bits, Window& out) {
        const double range = static_cast<double>(1u << bits), part = std::fmod(index, range);
        constexpr double largest = 256.0 - 1.0 / 256.0; // the value of FixedMath::largest_index
        out.color[0] = std::fmin(part < 0.0 ? part + range : part, largest) / 255.0;
        out.color[1] = out.color[2] = out.color[3] = 0.0;
        for (double& c : out.secondary)
            c = 0.0;
    }
    static void set_index(Real index, unsigned bits, Window& out) { set_index(number(index), bits, out); }
    static Real index_of(const Window& v) { return numeric::from_double(v.color[0] * 255.0); }
    static void set_raster(const RasterPosition& from, Window& out) {
        out = Window{};
        out.z = number(numeric::clamp01(from.position[2]));
        out.inv_w = 1.0;
        set_fog_coordinate(number(from.distance), out);
        set_color(out, from.color);
        for (int u = 0; u < texture_units; ++u) {
            const Real(&v)[4] = from.tex_coord[u].v;
            out.tex[u] = {number(v[0]), number(v[1]), number(v[3]), number(v[2])};
        }
    }

  private:
    static std::int32_t snap(double v) {
        constexpr double most = 4.0 * 2048.0 - 1.0;
        const double clamped = v < -most ? -most : v > most ? most : v;
        return static_cast<std::int32_t>(std::floor(clamped * raster::subpixel_one + 0.5));
    }
};

} // namespace spangle::gl
