// Computes where edges meet planes, in integers (GL 1.3, 2.11). One end of an edge may lie in the window, and
// the other as far away as floats reach. Each coordinate therefore has 60 bits and its own exponent here.
#pragma once

#include <cstdint>

#include "raster/numeric/block.hpp"
#include "raster/numeric/wide.hpp"

namespace spangle::gl {

struct FixedClipping {
    using Point = numeric::Wide4; ///< homogeneous coordinates of a vertex while it is clipped
    /// A place on an edge, as the distance from the nearer end divided by the edge's length. Attributes are
    /// mixed starting from the nearer end, so that a value equal at both ends stays exact.
    struct Parameter {
        /// `part` is the fraction. `inverse` is 1 / the sum of both ends' distances from the plane.
        numeric::Wide part, inverse;
        numeric::Block t; ///< `part` as a block
        std::int32_t q30; ///< `part` as Q0.30
        bool from_second; ///< true if the nearer end is the second one
    };

    /// Planes 0 to 5 are left, right, bottom, top, near and far. The first four bound an area of `band` (1 or
    /// 4) times the viewport's width and height.
    static constexpr int guard_band = 4;
    static int band_bits(int plane, int band) { return plane < 4 && band != 1 ? 2 : 0; }

    /// True if a point is outside of a plane of the view volume: w < v or w < -v for its coordinate v.
    static bool beyond(const Point& c, int plane, int band) {
        const numeric::Wide v = c[plane >> 1];
        return numeric::less(numeric::scale(c[3], band_bits(plane, band)),
                             (plane & 1) != 0 ? v : numeric::negate(v));
    }
    static numeric::Wide distance(const Point& c, int plane, int band) {
        const numeric::Wide v = c[plane >> 1];
        return numeric::add(numeric::scale(c[3], band_bits(plane, band)),
                            (plane & 1) != 0 ? numeric::negate(v) : v);
    }

    /// Returns the place where an edge meets a plane. a and b, the distances of its ends from the plane, have
    /// different signs.
    static Parameter intersect(numeric::Wide a, numeric::Wide b) {
        a = numeric::abs(a);
        b = numeric::abs(b);
        Parameter p;
        p.from_second = numeric::less(b, a);
        p.inverse = numeric::reciprocal(numeric::add(a, b));
        p.part = numeric::mul(p.from_second ? b : a, p.inverse);
        p.t = numeric::to_block(p.part);
        p.q30 = numeric::to_fixed(p.t, 30);
        return p;
    }

    /// Returns the point where the edge from a (inside) to b (outside) meets a plane of the view volume. The
    /// point is (-d_b a + d_a b) / (d_a - d_b), with the distance d = k w + s c of a point. k is the band, s
    /// is 1 or -1, and c is the coordinate of the plane.
    ///
    /// Each coordinate is a sum of minors a_i b_j - b_i a_j, which lose nothing to cancellation. Products
    /// with d_a and d_b would lose the edge's direction if one end is 2^40 times as far away as the other.
    [[gnu::noinline]] static Point clip_edge(const Point& a, const Point& b, int plane, int band,
                                             const Parameter& p) {
        const int c = plane >> 1, up = band_bits(plane, band);
        const bool minus = (plane & 1) != 0;
        const auto minor = [&](int i, int j) {
            return numeric::mul(numeric::sub(numeric::mul(a[i], b[j]), numeric::mul(b[i], a[j])), p.inverse);
        };
        const auto signed_minor = [&](int j) {
            const numeric::Wide v = minor(c, j);
            return minus ? numeric::negate(v) : v;
        };
        Point out;
        const numeric::Wide w = signed_minor(3);
        out.set(3, w);
        // The new point is exactly on the plane, however w is rounded.
        const numeric::Wide rim = numeric::scale(w, up);
        out.set(c, minus ? rim : numeric::negate(rim));
        for (int j = 0; j < 3; ++j)
            if (j != c)
                out.set(j, numeric::add(numeric::scale(minor(3, j), up), signed_minor(j)));
        return out;
    }

    static numeric::Block mix(numeric::Block a, numeric::Block b, const Parameter& p) {
        const numeric::Block &from = p.from_second ? b : a, &to = p.from_second ? a : b;
        return numeric::add(from, numeric::mul(numeric::sub(to, from), p.t));
    }
    static numeric::Block4 mix(const numeric::Block4& a, const numeric::Block4& b, const Parameter& p) {
        numeric::Block out[4];
        for (int i = 0; i < 4; ++i)
            out[i] = mix(numeric::component(a, i), numeric::component(b, i), p);
        return numeric::to_block(out[0], out[1], out[2], out[3]);
    }
    [[gnu::noinline]] static Point mix(const Point& a, const Point& b, const Parameter& p) {
        const Point &from = p.from_second ? b : a, &to = p.from_second ? a : b;
        Point out;
        for (int i = 0; i < 4; ++i)
            out.set(i, numeric::add(from[i], numeric::mul(numeric::sub(to[i], from[i]), p.part)));
        return out;
    }
    /// Mixes n words of an attribute. The words of both ends must differ by less than 2^31.
    SPANGLE_RUN_INLINE static void mix_words(int n, const std::uint32_t* a, const std::uint32_t* b,
                                             const Parameter& p, std::uint32_t* out) {
        const std::uint32_t *const from = p.from_second ? b : a, *const to = p.from_second ? a : b;
        for (int c = 0; c < n; ++c) {
            const auto d = static_cast<std::int32_t>(to[c] - from[c]); // colours have 28 bits, and q30 has 30
            out[c] = static_cast<std::uint32_t>(static_cast<std::int64_t>(from[c]) +
                                                ((numeric::mul_s32(d, p.q30) + (1 << 29)) >> 30));
        }
    }
};

} // namespace spangle::gl
