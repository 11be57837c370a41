// Runs both arithmetics of the vertex pipeline at once. The fixed-point numbers decide and draw, and each has
// a twin in double that it is compared with (docs/architecture/fragments.md, "Policies"). Only hosts have
// this policy.
#pragma once

#include "gl/vertex/double_math.hpp"
#include "gl/vertex/fixed_math.hpp"
#include "raster/reference/shadow.hpp"

namespace spangle::gl {

/// A fixed-point number and its twin in double.
template <class F, class D> struct FixedAndDouble {
    F fixed;
    D twin;
};

struct ShadowMath {
    using Window = raster::ShadowVertex;
    using Clip = FixedAndDouble<FixedMath::Clip, DoubleMath::Clip>;
    using Eye = FixedAndDouble<FixedMath::Eye, DoubleMath::Eye>;
    using Depth = FixedAndDouble<FixedMath::Depth, DoubleMath::Depth>;
    using Point = FixedAndDouble<FixedMath::Point, DoubleMath::Point>;
    using Parameter = FixedAndDouble<FixedMath::Parameter, DoubleMath::Parameter>;
    using Transforms = FixedAndDouble<FixedMath::Transforms, DoubleMath::Transforms>;

    static void derive(const TransformState& state, unsigned dirty, Transforms& out) {
        FixedMath::derive(state, dirty, out.fixed);
        DoubleMath::derive(state, dirty, out.twin);
    }
    template <int N> class Projections {
      public:
        void add(int i, const Transforms& t, const Real (&v)[4], Window& out, bool fog) {
            if (fog)
                set_fog(depth(t, v), out);
            fixed_.add(i, t.fixed, v, out.fixed, fog);
        }
        void finish(int count) { fixed_.finish(count); }
        bool divide(int i, const Transforms& t, const Real (&v)[4], Window& out, unsigned& planes) const {
            if (!fixed_.divide(i, t.fixed, v, out.fixed, planes))
                return false;
            if (planes >> 8 == 0) // other vertices are clipped, not drawn
                project_twin(t, DoubleMath::to_clip(t.twin, v), out);
            return true;
        }

      private:
        FixedMath::Projections<N> fixed_;
    };
    using Place = Window;
    static void keep_place(const Window& from, Place& to) { to = from; }
    static void take_place(const Place& from, Window& to) { to = from; }
    static Depth depth(const Transforms& t, const Real (&v)[4]) {
        return {FixedMath::depth(t.fixed, v), DoubleMath::depth(t.twin, v)};
    }
    static Clip to_clip(const Transforms& t, const Real (&v)[4]) {
        return {FixedMath::to_clip(t.fixed, v), DoubleMath::to_clip(t.twin, v)};
    }
    static Eye to_eye(const Transforms& t, const Real (&v)[4]) {
        return {FixedMath::to_eye(t.fixed, v), DoubleMath::to_eye(t.twin, v)};
    }
    static Point clip_point(const Transforms& t, const Real (&v)[4]) {
        return {FixedMath::clip_point(t.fixed, v), DoubleMath::clip_point(t.twin, v)};
    }
    static Point eye_point(const Transforms& t, const Real (&v)[4]) {
        return {FixedMath::eye_point(t.fixed, v), DoubleMath::eye_point(t.twin, v)};
    }
    static Clip narrow(const Point& v) { return {FixedMath::narrow(v.fixed), v.twin}; }

    // The fixed-point numbers make all decisions.
    static constexpr int guard_band = FixedMath::guard_band;
    template <class C> static bool beyond(const C& c, int plane, int band) {
        return FixedMath::beyond(c.fixed, plane, band);
    }
    static bool in_front(const Clip& c) { return FixedMath::in_front(c.fixed); }

    using Plane = FixedAndDouble<FixedMath::Plane, DoubleMath::Plane>;
    using Distance = FixedAndDouble<numeric::Wide, DoubleMath::Distance>;

    static Plane plane(const Real (&equation)[4]) {
        return {FixedMath::plane(equation), DoubleMath::plane(equation)};
    }
    static Distance distance(const Point& c, int plane, int band) {
        return {FixedMath::distance(c.fixed, plane, band), DoubleMath::distance(c.twin, plane, band)};
    }
    static Distance distance(const Plane& p, const Point& eye) {
        return {FixedMath::distance(p.fixed, eye.fixed), DoubleMath::distance(p.twin, eye.twin)};
    }
    static FixedAndDouble<numeric::Block, double> distance(const Plane& p, const Eye& eye) {
        return {FixedMath::distance(p.fixed, eye.fixed), DoubleMath::distance(p.twin, eye.twin)};
    }
    static bool turned(const Plane& p) { return p.fixed.turned; }
    template <class D> static bool outside(const Plane& p, const D& d) {
        return FixedMath::outside(p.fixed, d.fixed);
    }

    /// Returns the place where an edge meets a plane. Its twin may not cross the plane, since its numbers
    /// differ a little. The twin then takes the parameter of the fixed-point edge.
    static Parameter intersect(const Distance& a, const Distance& b) {
        const FixedMath::Parameter fixed = FixedMath::intersect(a.fixed, b.fixed);
        if ((a.twin < 0) != (b.twin < 0))
            return {fixed, DoubleMath::intersect(a.twin, b.twin)};
        return {fixed, {std::ldexp(static_cast<double>(fixed.part.m), fixed.part.e), fixed.from_second}};
    }
    static Point clip_edge(const Point& a, const Point& b, int plane, int band, const Parameter& t) {
        const bool crosses =
            !DoubleMath::beyond(a.twin, plane, band) && DoubleMath::beyond(b.twin, plane, band);
        return {FixedMath::clip_edge(a.fixed, b.fixed, plane, band, t.fixed),
                crosses ? DoubleMath::clip_edge(a.twin, b.twin, plane, band, t.twin)
                        : DoubleMath::mix(a.twin, b.twin, t.twin)};
    }
    static Point mix(const Point& a, const Point& b, const Parameter& t) {
        return {FixedMath::mix(a.fixed, b.fixed, t.fixed), DoubleMath::mix(a.twin, b.twin, t.twin)};
    }
    static Clip mix(const Clip& a, const Clip& b, const Parameter& t) {
        return {FixedMath::mix(a.fixed, b.fixed, t.fixed), DoubleMath::mix(a.twin, b.twin, t.twin)};
    }
    static Depth mix(const Depth& a, const Depth& b, const Parameter& t) {
        return {FixedMath::mix(a.fixed, b.fixed, t.fixed), DoubleMath::mix(a.twin, b.twin, t.twin)};
    }
    static void mix(const Window& a, const Window& b, const Parameter& t, unsigned units, Window& out) {
        FixedMath::mix(a.fixed, b.fixed, t.fixed, units, out.fixed);
        DoubleMath::mix(a.twin, b.twin, t.twin, units, out.twin);
    }
    template <class V> static void mix_color(const V& a, const V& b, const Parameter& t, V& out) {
        FixedMath::mix_color(a.fixed, b.fixed, t.fixed, out.fixed);
        DoubleMath::mix_color(a.twin, b.twin, t.twin, out.twin);
    }

    struct Scalar {
        FixedMath::Scalar fixed;
        double twin;

        friend Scalar operator*(Scalar a, Scalar b) { return {a.fixed * b.fixed, a.twin * b.twin}; }
        friend Scalar operator+(Scalar a, Scalar b) { return {a.fixed + b.fixed, a.twin + b.twin}; }
        friend Scalar operator-(Scalar a, Scalar b) { return {a.fixed - b.fixed, a.twin - b.twin}; }
    };
    static Scalar scalar(Real v) { return {FixedMath::scalar(v), DoubleMath::scalar(v)}; }
    static Scalar scalar(const Eye& v, int i) {
        return {FixedMath::scalar(v.fixed, i), DoubleMath::scalar(v.twin, i)};
    }
    static Scalar rsqrt(Scalar v) { return {FixedMath::rsqrt(v.fixed), DoubleMath::rsqrt(v.twin)}; }
    static void normal_matrix(const TransformState& state, Scalar (&out)[9]) {
        FixedMath::Scalar fixed[9];
        double twin[9];
        FixedMath::normal_matrix(state, fixed);
        DoubleMath::normal_matrix(state, twin);
        for (int i = 0; i < 9; ++i)
            out[i] = {fixed[i], twin[i]};
    }
    static void set_texture(const Transforms& t, const Scalar (&strq)[4], int unit, bool q_is_one,
                            Window& out) {
        FixedMath::set_texture(t.fixed, {strq[0].fixed, strq[1].fixed, strq[2].fixed, strq[3].fixed}, unit,
                               q_is_one, out.fixed);
        DoubleMath::set_texture(t.twin, {strq[0].twin, strq[1].twin, strq[2].twin, strq[3].twin}, unit,
                                q_is_one, out.twin);
        report_texture(out.fixed.tex[unit], out.twin.tex[unit]);
    }
    static Eye texture_of(const Transforms& t, const Scalar (&strq)[4], int unit) {
        return {
            FixedMath::texture_of(t.fixed, {strq[0].fixed, strq[1].fixed, strq[2].fixed, strq[3].fixed},
                                  unit),
            DoubleMath::texture_of(t.twin, {strq[0].twin, strq[1].twin, strq[2].twin, strq[3].twin}, unit)};
    }

    static void project(const Transforms& t, const Clip& c, Window& out) {
        FixedMath::project(t.fixed, c.fixed, out.fixed);
        project_twin(t, c.twin, out);
    }
    /// Projects the twin. It continues with the snapped position of the fixed-point vertex, so that later
    /// differences come from the arithmetic alone.
    static void project_twin(const Transforms& t, const DoubleMath::Clip& c, Window& out) {
        const bool sound = c.v[3] > 0.0;
        if (sound) {
            DoubleMath::project(t.twin, c, out.twin);
            report_position(out);
            // The vertex is so close to the plane of the eye that its twin is behind that plane.
        } else {
            out.twin.x_exact = out.fixed.x / double{raster::subpixel_one};
            out.twin.y_exact = out.fixed.y / double{raster::subpixel_one};
            out.twin.z = out.fixed.z / double{raster::depth_one};
            out.twin.inv_w = inverse_w(out.fixed);
        }
        out.twin.x = out.fixed.x;
        out.twin.y = out.fixed.y;
    }

    // Values that are returned to the program come from the fixed-point numbers.
    static std::uint32_t depth_word(const Window& v) { return FixedMath::depth_word(v.fixed); }
    static void window_of(const Transforms& t, const Clip& c, Real (&out)[4]) {
        FixedMath::window_of(t.fixed, c.fixed, out);
    }
    static void color_of(const Window& v, Real (&out)[4]) { FixedMath::color_of(v.fixed, out); }
    static void to_reals(const Eye& v, Real (&out)[4]) { FixedMath::to_reals(v.fixed, out); }

    static void set_color(Window& out, const Real (&rgba)[4]) {
        FixedMath::set_color(out.fixed, rgba);
        DoubleMath::set_color(out.twin, rgba);
        report_color(out);
    }
    static void set_secondary_color(Window& out, const Real (&rgb)[4]) {
        FixedMath::set_secondary_color(out.fixed, rgb);
        DoubleMath::set_secondary_color(out.twin, rgb);
        report_color(out);
    }
    struct Colors {
        FixedMath::Colors fixed;
        DoubleMath::Colors twin;
    };
    template <class From, class To> static void copy_color(const From& from, To& to) {
        FixedMath::copy_color(from.fixed, to.fixed);
        DoubleMath::copy_color(from.twin, to.twin);
    }
    static void set_texture(const Transforms& t, const Real (&stq)[4], int unit, Window& out) {
        FixedMath::set_texture(t.fixed, stq, unit, out.fixed);
        DoubleMath::set_texture(t.twin, stq, unit, out.twin);
        report_texture(out.fixed.tex[unit], out.twin.tex[unit]);
    }
    static bool q_is_one(const Window& v, int unit) { return FixedMath::q_is_one(v.fixed, unit); }
    static void set_sprite(int unit, bool s, bool t, Window& out) {
        FixedMath::set_sprite(unit, s, t, out.fixed);
        DoubleMath::set_sprite(unit, s, t, out.twin);
    }
    static void fade(Real factor, Window& out) {
        FixedMath::fade(factor, out.fixed);
        DoubleMath::fade(factor, out.twin);
    }
    static void set_raster(const RasterPosition& from, Window& out) {
        FixedMath::set_raster(from, out.fixed);
        DoubleMath::set_raster(from, out.twin);
    }
    static void set_fog(const Depth& eye_z, Window& out) {
        FixedMath::set_fog(eye_z.fixed, out.fixed);
        DoubleMath::set_fog(eye_z.twin, out.twin);
        report_relative(raster::ShadowStage::vertex_fog,
                        std::ldexp(static_cast<double>(out.fixed.fog_mantissa), out.fixed.fog_exponent),
                        out.twin.fog);
    }

    static void set_fog_coordinate(const Depth& coordinate, Window& out) {
        FixedMath::set_fog_coordinate(coordinate.fixed, out.fixed);
        DoubleMath::set_fog_coordinate(coordinate.twin, out.twin);
    }
    static Depth fog_coordinate(const Window& v) {
        return {FixedMath::fog_coordinate(v.fixed), DoubleMath::fog_coordinate(v.twin)};
    }
    static Depth fog_coordinate(Real coordinate) {
        return {FixedMath::fog_coordinate(coordinate), DoubleMath::fog_coordinate(coordinate)};
    }
    static void set_index(Real index, unsigned bits, Window& out) {
        FixedMath::set_index(index, bits, out.fixed);
        DoubleMath::set_index(index, bits, out.twin);
        report_color(out);
    }
    static Real index_of(const Window& v) { return FixedMath::index_of(v.fixed); }

    /// Reports the differences of primary and secondary colour.
    static void report_color(const Window& v) {
        raster::ShadowReport* const report = raster::shadow_report();
        if (report == nullptr)
            return;
        raster::ShadowRecord& record = (*report)[raster::ShadowStage::vertex_color];
        for (int c = 0; c < 4; ++c)
            record.add(v.fixed.color[c] / double{raster::color_one}, v.twin.color[c], 1.0);
        for (int c = 0; c < 3; ++c)
            record.add(v.fixed.secondary[c] / double{raster::color_one}, v.twin.secondary[c], 1.0);
    }

  private:
    static double inverse_w(const raster::FixedVertex& v) {
        return std::ldexp(static_cast<double>(v.w_mantissa), v.w_exponent);
    }

    static void report_relative(raster::ShadowStage stage, double fixed, double exact) {
        raster::ShadowReport* const report = raster::shadow_report();
        if (report != nullptr && exact != 0.0)
            (*report)[stage].add_difference((fixed - exact) / exact, exact);
    }

    static void report_position(const Window& v) {
        raster::ShadowReport* const report = raster::shadow_report();
        if (report == nullptr)
            return;
        constexpr double one = raster::subpixel_one, band = 4 * 2048 - 1 / one;
        (*report)[raster::ShadowStage::window_x].add(v.fixed.x / one, v.twin.x_exact, band);
        (*report)[raster::ShadowStage::window_y].add(v.fixed.y / one, v.twin.y_exact, band);
        (*report)[raster::ShadowStage::snapping].add(v.fixed.x, v.twin.x);
        (*report)[raster::ShadowStage::snapping].add(v.fixed.y, v.twin.y);
        (*report)[raster::ShadowStage::window_z].add(v.fixed.z / double{raster::depth_one}, v.twin.z, 1.0);
        report_relative(raster::ShadowStage::inverse_w, inverse_w(v.fixed), v.twin.inv_w);
    }

    static void report_texture(const raster::FixedVertex::TexCoord& fixed,
                               const raster::DoubleVertex::TexCoord& twin) {
        raster::ShadowReport* const report = raster::shadow_report();
        const double q = fixed.q_is_one != 0 ? std::ldexp(1.0, -fixed.exponent) : fixed.q;
        if (report == nullptr || !(q > 0.0) || !(twin.q > 0.0))
            return;
        (*report)[raster::ShadowStage::vertex_coord].add(fixed.s / q, twin.s / twin.q);
        (*report)[raster::ShadowStage::vertex_coord].add(fixed.t / q, twin.t / twin.q);
    }
};

} // namespace spangle::gl
