// Exact tier: planes over w of primitives whose w varies much, such as a floor that reaches the horizon.
//
// A texture coordinate is the quotient of two planes. Far away, 1/w is a small part of its value nearby. The
// range of w multiplies the loss of planes of 30 bits. So these planes are made in numbers of 61 bits, and
// their guard bits hold true digits.
#include "raster/numeric/wide.hpp"
#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

using numeric::abs_u32;
using numeric::add;
using numeric::clz64;
using numeric::make_wide;
using numeric::mul;
using numeric::scale;
using numeric::sub;
using numeric::Wide;

namespace {

constexpr int position_bits = subpixel_bits + 16; ///< fraction bits of unsnapped window coordinates

/// A window coordinate before snapping; where planes go through snapped vertices, the snapped coordinate.
std::int64_t position(std::int32_t v, std::int16_t rest, bool unsnapped) {
    return std::int64_t{v} * 65536 + (unsnapped ? rest : 0);
}

/// The way from `position` to the centre of the pixel in which the snapped coordinate lies.
std::int64_t to_center(std::int32_t v, std::int64_t position) {
    return (std::int64_t{v & -subpixel_one} + subpixel_one / 2) * 65536 - position;
}

/// Makes planes through the values of an attribute at three vertices.
class WidePlanes {
  public:
    WidePlanes(const FixedVertex& a, const FixedVertex& b, const FixedVertex& c, bool unsnapped) {
        const std::int64_t ax = position(a.x, a.x_rest, unsnapped), ay = position(a.y, a.y_rest, unsnapped);
        x1_ = make_wide(position(b.x, b.x_rest, unsnapped) - ax, -position_bits);
        y1_ = make_wide(position(b.y, b.y_rest, unsnapped) - ay, -position_bits);
        x2_ = make_wide(position(c.x, c.x_rest, unsnapped) - ax, -position_bits);
        y2_ = make_wide(position(c.y, c.y_rest, unsnapped) - ay, -position_bits);
        area_ = sub(mul(x1_, y2_), mul(x2_, y1_));
        inverse_ = area_.m == 0 ? Wide{} : reciprocal(area_);
        center_x_ = make_wide(to_center(a.x, ax), -position_bits);
        center_y_ = make_wide(to_center(a.y, ay), -position_bits);
    }
    /// Whether planes through unsnapped vertices may be used. Coverage is that of snapped vertices, which are
    /// at most half a step away in x and in y. An attribute may go beyond its values at the vertices by at
    /// most a 16th of its range. 1/w, whose values are q, must stay above an eighth of its least value. Other
    /// planes go through the snapped vertices: Setup<Fixed>::unsnap_plane() and snap_where_w_ends() have the
    /// same rules.
    bool serve(const Wide (&q)[3]) const {
        const Wide reach = scale(add(add(abs(x1_), abs(x2_)), add(abs(y1_), abs(y2_))), -subpixel_bits - 1),
                   area = abs(area_);
        Wide least = q[0], most = q[0];
        for (const Wide& v : q) {
            least = less(v, least) ? v : least;
            most = less(most, v) ? v : most;
        }
        const Wide room = sub(least, scale(least, -3));
        return !less(area, scale(reach, 4)) && !less(mul(area, room), mul(sub(most, least), reach));
    }

    /// Writes the plane of an attribute with guard bits, whose last bit without them counts 2^unit.
    void make(Interpolant<std::uint64_t>& to, const Wide (&v)[3], int unit) const {
        const Wide d1 = sub(v[1], v[0]), d2 = sub(v[2], v[0]);
        const Wide dx = mul(sub(mul(d1, y2_), mul(d2, y1_)), inverse_),
                   dy = mul(sub(mul(d2, x1_), mul(d1, x2_)), inverse_);
        const auto fixed = [&](const Wide& w) {
            return static_cast<std::uint64_t>(shift(w.m, unit - guard_bits - w.e));
        };
        // Guard bits are cut off where the plane is read. Half of their range is added here, so that the cut
        // rounds.
        to.value = fixed(add(v[0], add(mul(dx, center_x_), mul(dy, center_y_)))) + (1u << (guard_bits - 1));
        to.dx = fixed(dx);
        to.dy = fixed(dy);
    }

  private:
    Wide x1_, y1_, x2_, y2_; ///< distances from the first vertex to the others, in pixels
    Wide area_, inverse_;    ///< twice the area of the triangle, and its inverse
    Wide center_x_, center_y_;
};

/// The exponent of a power of two that is larger than all of the numbers.
int above(const Wide (&a)[3], int least) {
    for (const Wide& v : a)
        least = v.m != 0 && v.e + 61 > least ? v.e + 61 : least;
    return least;
}

/// The whole repeats in m 2^exponent, within the range that clamped coordinates add back. The result is 0
/// where there are more.
std::int32_t whole_repeats(std::int32_t m, int exponent) {
    const std::int64_t whole = exponent < 0    ? m >> (exponent > -32 ? -exponent : 31)
                               : exponent < 16 ? std::int64_t{m} << exponent
                                               : 0;
    return whole >= -4096 && whole <= 4096 ? static_cast<std::int32_t>(whole) : 0;
}

} // namespace

/// Whether planes of 30 bits may be off by more than 2^-7 texel; thin triangles have planes along an axis
/// instead.
///
/// Coefficients are off by 2^(3 + thin - 31) of the range of an attribute, where 2^thin is the square of the
/// larger side of the window box over the area. The quotient multiplies this by the range of 1/w.
bool Setup<Fixed>::loses_texels(const UnitValues units[]) const {
    int bits = -32;
    for (int i = 0; i < max_texture_units; ++i)
        if (has_textures && state_.needs.unit[i] && !units[i].homogeneous) {
            const int width = state_.log2_width[i], height = state_.log2_height[i],
                      texels = units[i].shift + (width > height ? width : height);
            bits = texels > bits ? texels : bits;
        }
    const Vertex &a = v(0), &b = v(1), &c = *third_vertex_;
    if (&a == &c) // lines and points have no area
        return false;
    const std::int32_t x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
    const int side = 32 - numeric::clz32(abs_u32(x1) | abs_u32(x2) | abs_u32(y1) | abs_u32(y2)),
              area = 64 - clz64(numeric::abs_u64(numeric::mul_s32(x1, y2) - numeric::mul_s32(x2, y1))),
              of_w = numeric::clz32(q_least_) - numeric::clz32(q_range_ | 1);
    return bits - 2 + (of_w > 0 ? of_w : 0) + (3 + 2 * side - area - 31) > -7;
}

/// Makes all planes over w anew.
void Setup<Fixed>::steepen(std::int32_t fog[3]) {
    if (&v(2) != third_vertex_) {
        span_.basis.v[2] = third_vertex_;
        if (has_fog && state_.needs.fog) {
            span_.fog_exponent = -24; // the unit with which load_fog() begins
            load_any_fog(fog);
            span_.fog_exponent += 30; // over_w() below takes 30 bits off
        }
    }
    Wide q[3];
    int nearest = 0;
    for (int i = 0; i < 3; ++i) {
        q[i] = make_wide(std::int64_t{v(i).w_mantissa}, v(i).w_exponent);
        nearest = less(q[nearest], q[i]) ? i : nearest;
    }
    const int highest = v(nearest).w_exponent;
    const int q_unit = highest + 2; // the unit of q that weights() chooses
    WidePlanes planes(v(0), v(1), v(2), true);
    if (!planes.serve(q))
        planes = WidePlanes(v(0), v(1), v(2), false);
    planes.make(span_.q, q, q_unit);
    span_.q_dy = span_.q.dy;
    const auto over_w = [&](Interpolant<std::uint64_t>& to, std::int32_t a, std::int32_t b, std::int32_t c) {
        planes.make(to, {mul(make_wide(a, 0), q[0]), mul(make_wide(b, 0), q[1]), mul(make_wide(c, 0), q[2])},
                    q_unit + 30);
    };
    if (has_full && span_.kind == Kind::full)
        each_color<false>([&](const ColorSource& from, int i, auto&, Interpolant<std::uint64_t>& at) {
            const auto value = [&](int k) { return static_cast<std::int32_t>(from.of[k][i] << 2); };
            over_w(at, value(0), value(1), value(2));
        });
    if (has_fog && state_.needs.fog)
        over_w(span_.fog_q, fog[0], fog[1], fog[2]);
    for (int unit = 0; unit < max_texture_units; ++unit) {
        auto& at = span_.unit[unit];
        if (!has_textures || !state_.needs.unit[unit] || !at.shares_q)
            continue;
        const auto& halves = state_.halves[unit];
        constexpr int bits = 30, least_exponent = -2; // the same numbers as in add_unit()
        int exponent = q_unit + least_exponent + bits;
        Wide values[2][3]; // s/w and t/w of the vertices
        for (int axis = 0; axis < 2; ++axis) {
            const auto mantissa = [axis](const Vertex::TexCoord& c) { return axis == 0 ? c.s : c.t; };
            const int halved = axis == 0 ? halves.s : halves.t;
            // The whole repeats of the nearest vertex are taken off. Those of another vertex would make the
            // plane large where 1/w is large.
            const auto& first = v(nearest).tex[unit];
            const std::int32_t base = whole_repeats(mantissa(first), first.exponent - halved);
            (axis == 0 ? at.s_base : at.t_base) = base;
            for (int i = 0; i < 3; ++i) {
                const auto& c = v(i).tex[unit];
                values[axis][i] =
                    mul(sub(make_wide(mantissa(c), c.exponent - halved), make_wide(base, 0)), q[i]);
            }
            exponent = above(values[axis], exponent);
        }
        exponent -= bits;
        at.exponent = exponent - q_unit;
        planes.make(at.s, values[0], exponent);
        planes.make(at.t, values[1], exponent);
        at.s_dy = at.s.dy;
        at.t_dy = at.t.dy;
    }
}

} // namespace spangle::raster
