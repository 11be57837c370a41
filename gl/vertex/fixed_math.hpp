// Arithmetic of the vertex pipeline in integers. Values are in block form before the perspective division,
// and window coordinates are fixed point. pipeline.hpp documents how the pipeline uses each operation.
// DoubleMath and ShadowMath have the same operations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "gl/context/context.hpp"
#include "gl/pixel/index.hpp"
#include "gl/vertex/fixed_clipping.hpp"
#include "raster/numeric/block.hpp"
#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/matrix_build.hpp"
#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/line_end.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::gl {

struct FixedMath : FixedClipping {
    using Window = raster::FixedVertex;
    /// Homogeneous clip coordinates, with one exponent for all four. Tests against w, and quotients such as
    /// x/w, do not depend on it.
    using Clip = numeric::Block4;
    using Eye = numeric::Block4;
    using Depth = numeric::Block;

    /// A 32-bit factor in a machine word. 64-bit machines need not extend it at every use.
    using Factor = std::conditional_t<numeric::wide_words, std::int64_t, std::int32_t>;
    SPANGLE_INLINE static std::int64_t product(Factor a, std::int32_t b) {
        if constexpr (numeric::wide_words)
            return a * b;
        return numeric::mul_s32(static_cast<std::int32_t>(a), b);
    }

    /// Maps a quotient from -1 to 1 to a window coordinate: middle + half * quotient. The window coordinate
    /// is n.8 for x and y, and Q0.30 for depth.
    struct Range {
        std::int32_t middle = 0;
        Factor minus_half = 0;
        /// rounded_middle is the middle with the fraction bits of the product, plus half a unit of the
        /// result. 32-bit machines do without it, because they seldom need it.
        static constexpr bool keeps_rounded = numeric::wide_words;
        std::conditional_t<keeps_rounded, std::int64_t, std::int32_t> rounded_middle = 0;

        Range() = default;
        /// Makes a range from its middle `at` and from `minus`, -half. `bits` counts the fraction bits of
        /// half and of a quotient together.
        Range(std::int32_t at, std::int32_t minus, [[maybe_unused]] int bits)
            : middle(at), minus_half(minus) {
            if constexpr (keeps_rounded)
                rounded_middle = ((std::int64_t{at} << 1) + 1) * (std::int64_t{1} << (bits - 1));
        }

        /// Returns middle + half * q, rounded to nearest, for the negated quotient minus_q. `bits` counts the
        /// fraction bits of half and q together.
        SPANGLE_INLINE std::int32_t place(std::int32_t minus_q, int bits) const {
            if (!numeric::wide_words && bits == 32)
                return numeric::add_high_rounded(middle, static_cast<std::int32_t>(minus_half), minus_q);
            if constexpr (keeps_rounded)
                return static_cast<std::int32_t>((rounded_middle + product(minus_half, minus_q)) >> bits);
            const std::int64_t rounded = product(minus_half, minus_q) + (std::int64_t{1} << (bits - 1));
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(middle) +
                                             numeric::low_word_after(rounded, bits));
        }
        /// Returns place() of a quotient that is held in 64 bits. The result is undefined if the quotient
        /// does not fit a word.
        SPANGLE_INLINE std::int32_t place(std::int64_t minus_q, int bits) const {
            return place(static_cast<std::int32_t>(minus_q), bits);
        }
        /// Returns what rounding cut off in place() with 32 fraction bits, in 2^-16 of the result's unit. The
        /// value is the upper half of the product's low word.
        SPANGLE_INLINE std::int16_t rest(Factor minus_q) const {
            const std::uint32_t low =
                static_cast<std::uint32_t>(minus_half) * static_cast<std::uint32_t>(minus_q);
            return static_cast<std::int16_t>(low >> 16);
        }
    };
    /// Bits that x, y and z are shifted left less than w; Projections explains why.
    static constexpr std::int32_t lift_room[3] = {3, 3, 1};
    using Quotient = Factor;
    static constexpr int quotient_bits = 27, depth_quotient_bits = 29;
    /// Fraction bits of half a viewport. A window coordinate is then the high word of a product.
    static constexpr int half_bits = 32 - quotient_bits;

    /// The elements of a matrix as Factors, row by row.
    struct WideRows {
        Factor m[16] = {};
        void set(const numeric::BlockMatrix& a) {
            for (int i = 0; i < 16; ++i)
                m[i] = a.m[i];
        }
        const Factor* of(const numeric::BlockMatrix&) const { return m; }
    };
    /// Replaces WideRows on 32-bit machines, where the elements of a matrix are Factors already.
    struct Rows {
        static void set(const numeric::BlockMatrix&) {}
        static const std::int32_t* of(const numeric::BlockMatrix& a) { return a.m; }
    };

    /// Block forms of the matrices and of the viewport. derive() makes them again when part of the transform
    /// state has changed.
    struct Transforms {
        /// Shifts of rows x, y and z for the division: 31 - n on 64-bit machines, n elsewhere. n is the row's
        /// exponent less that of row w, less lift_room. See Lifted.
        std::int32_t lift[3] = {};
        std::int32_t w_exponent = 0; ///< exponent of 1/w, less that of the vertex
        /// divide() refuses a vertex whose w has more leading zeros, because a shift would exceed 31 bits.
        std::uint32_t most_zeros = 0;
        Range x, y;  ///< maps to the viewport, in window coordinates n.8
        Range depth; ///< maps to the depth range, in Q0.30
        numeric::BlockMatrix to_clip;
        /// The rows of to_clip.
        [[no_unique_address]] std::conditional_t<numeric::wide_words, WideRows, Rows> rows;
#if SPANGLE_TEXTURE_UNITS
        numeric::BlockMatrix texture[texture_units]; ///< set unless the matrix is the identity
#endif
        bool texture_is_identity[texture_units];

        /// The modelview matrix in block form, made when first asked for.
        const numeric::BlockMatrix& to_eye() const {
            if (!has_eye)
                make_eye();
            return eye;
        }
        /// Row 2 of the modelview matrix, for vertices that are loaded for to_clip. It is made when first
        /// asked for.
        const numeric::BlockRow& eye_z() const {
            if (!has_depth)
                make_depth();
            return depth_row;
        }

        // Most draws need neither eye coordinates nor depths. `eye` and `depth_row` are therefore made when a
        // vertex first needs them. They come from the context's own modelview matrix, which does not change
        // within a draw.
        const numeric::Matrix* modelview = nullptr;
        mutable bool has_eye = false, has_depth = false;
        mutable numeric::BlockMatrix eye;
        mutable numeric::BlockRow depth_row;

      private:
        [[gnu::noinline]] void make_eye() const {
            eye = numeric::to_block_matrix(*modelview);
            has_eye = true;
        }
        [[gnu::noinline]] void make_depth() const {
            depth_row = numeric::to_block_row(*modelview, 2, to_clip.column);
            has_depth = true;
        }
    };

    /// Derives what depends on state that has changed. `dirty` is a set of Dirty bits.
    static void derive(const TransformState& state, unsigned dirty, Transforms& out) {
        if ((dirty & (dirty_modelview | dirty_projection)) != 0)
            derive_positions(state, out);
        if ((dirty & dirty_texture_matrices) != 0)
            derive_textures(state, out);
        if ((dirty & dirty_viewport) != 0)
            derive_window(state, out);
    }

    /// Derives the matrices by which positions are multiplied.
    static void derive_positions(const TransformState& state, Transforms& out) {
        const numeric::Matrix& modelview = state.modelview.entry[state.modelview.top];
        out.modelview = &modelview;
        out.has_eye = out.has_depth = false;
        out.to_clip = numeric::to_block_matrix(
            numeric::multiply(state.projection.entry[state.projection.top], modelview));
        out.rows.set(out.to_clip);
        // Exponents of rows x, y and z less the exponent of row w, less lift_room.
        std::int32_t lift[3];
        for (int i = 0; i < 3; ++i) {
            lift[i] = out.to_clip.row[i] - out.to_clip.row[3] - lift_room[i];
            out.lift[i] = numeric::wide_words ? 31 - lift[i] : lift[i];
        }
        out.w_exponent = -63 - out.to_clip.row[3];
        out.most_zeros = most_zeros(lift);
    }

    static void derive_textures(const TransformState& state, Transforms& out) {
        for (int u = 0; u < texture_units; ++u) {
            const numeric::Matrix& texture = state.texture[u].entry[state.texture[u].top];
            out.texture_is_identity[u] = is_identity(texture);
#if SPANGLE_TEXTURE_UNITS
            if (!out.texture_is_identity[u])
                out.texture[u] = numeric::to_block_matrix(texture);
#endif
        }
    }

    /// Derives the maps to the viewport and to the depth range.
    static void derive_window(const TransformState& state, Transforms& out) {
        const GLint* v = state.viewport;
        const std::int32_t half_width = v[2] * (raster::subpixel_one / 2),
                           half_height = v[3] * (raster::subpixel_one / 2);
        constexpr std::int32_t half_one = 1 << half_bits;
        out.x = {v[0] * raster::subpixel_one + half_width, -half_width * half_one, 32};
        out.y = {v[1] * raster::subpixel_one + half_height, -half_height * half_one, 32};
        const std::int32_t n = numeric::to_fixed(state.depth_range[0], 30),
                           f = numeric::to_fixed(state.depth_range[1], 30);
        out.depth = {(n >> 1) + (f >> 1) + (n & f & 1), (n - f) / 2, depth_quotient_bits};
    }

    /// Transforms a position to clip coordinates. The position is loaded under the exponents of the matrix's
    /// columns, so that both large and small coordinates keep their bits.
    static Clip to_clip(const Transforms& t, const Real (&v)[4]) {
        return numeric::transform(t.to_clip, v);
    }
    static Depth depth(const Transforms& t, const Real (&v)[4]) {
        return numeric::product(t.eye_z(), numeric::load(t.to_clip.column, v));
    }
    static Eye to_eye(const Transforms& t, const Real (&v)[4]) {
        return numeric::transform(t.to_eye(), v);
    }
    /// Clip and eye coordinates with mantissas of 60 bits, for vertices that are clipped.
    static Point clip_point(const Transforms& t, const Real (&v)[4]) {
        return numeric::transform_wide(t.to_clip, v);
    }
    static Point eye_point(const Transforms& t, const Real (&v)[4]) {
        return numeric::transform_wide(t.to_eye(), v);
    }
    static Clip narrow(const Point& v) {
        return numeric::to_block(v);
    }

    /// Takes N vertices from positions to window coordinates: perspective division, viewport and depth range
    /// (GL 1.3, 2.10.1). All vertices are added before the first one is divided, so that no operation waits
    /// for the result of another.
    ///
    /// Let `zeros` be the count of leading zeros of the word w, and X and W the values of x and w, exponents
    /// included. The words are shifted to w' = w * 2^zeros and x' = x * 2^(zeros + n), with n as at
    /// Transforms::lift. Then x' / w' = X / (8 W), and a word x' holds every X up to 4 W without rounding.
    /// For z the quotient is Z / (2 W), and a word z' holds every Z up to W.
    template <int N> class Projections {
      public:
        SPANGLE_INLINE void add(int i, const Transforms& t, const Real (&position)[4], Window& out,
                                bool fog) {
            numeric::Mantissas<4> v = numeric::load(t.to_clip.column, position);
            if (fog)
                set_fog(numeric::product(t.eye_z(), v), out);
            add(i, t, v);
        }
        /// Adds a vertex with loaded coordinates. If `Point` is true, the vertex's w is 2^power.
        template <bool Point = false>
        SPANGLE_INLINE void add(int i, const Transforms& t, numeric::Mantissas<4>& v, int power = 0) {
            const auto* const rows = t.rows.of(t.to_clip);
            Clipped& clip = clip_[i];
            clip.w = static_cast<std::uint32_t>(row<Point>(rows + 12, v, power));
            clip.x = row<Point>(rows, v, power);
            clip.y = row<Point>(rows + 4, v, power);
            clip.z = row<Point>(rows + 8, v, power);
            clip.e = v.e;
            if constexpr (!at_once)
                reciprocals_of_w_.set(i, clip.w << (numeric::clz32(clip.w) & 31));
        }
        /// Computes 1/w of the first `count` vertices.
        SPANGLE_INLINE void finish([[maybe_unused]] int count) {
            if constexpr (!at_once)
                reciprocals_of_w_.finish(count);
        }

        /// Sets the window coordinates of vertex i. `planes` gets the planes of the view volume that the
        /// vertex is outside of, in bits 0 to 5. Bits 8 to 13 get the planes of the guard band, near and far
        /// that must clip the vertex. False: the vertex is not in front of the eye, or its quotients overflow
        /// because it is far outside.
        SPANGLE_INLINE bool divide(int i, const Transforms& t, const Real (&)[4], Window& out,
                                   unsigned& planes) const {
            const Clipped& clip = clip_[i];
            // The number of zeros is 3 to 31, but 0 if w is negative and 32 if w is 0.
            const int zeros = numeric::clz32(clip.w);
            if (static_cast<std::uint32_t>(zeros) - 1 >= t.most_zeros)
                return false;
            const Lifted x(clip.x, zeros, t.lift[0]), y(clip.y, zeros, t.lift[1]),
                z(clip.z, zeros, t.lift[2]);
            if (raster::has_perspective && !numeric::wide_words &&
                (x.overflow_bits() | y.overflow_bits() | z.overflow_bits()) != 0)
                return false;
            if (!drawn(clip, zeros, t))
                return false;
            const std::uint32_t r = inverse(i, zeros); // 1/w = r * 2^(zeros - 62 - e)
            const int up = r >> 31 == 0 ? 1 : 0;       // r is 2^31 if w is a power of two
            out.w_mantissa = r << up;
            out.w_exponent = static_cast<std::int16_t>(zeros + t.w_exponent - clip.e - up);
            // -r fits a signed word, even if r is 2^31.
            const auto minus_r = static_cast<std::int32_t>(0u - r);
            const Quotient minus_x = x.times(minus_r), minus_y = y.times(minus_r), minus_z = z.times(minus_r);
            out.x = t.x.place(minus_x, 32);
            out.y = t.y.place(minus_y, 32);
            out.z = static_cast<std::uint32_t>(t.depth.place(minus_z, depth_quotient_bits));
            set_rest(out, t.x.rest(minus_x), t.y.rest(minus_y));
            planes = 0;
            if (!beyond(minus_x, one) && !beyond(minus_y, one) && !beyond(minus_z, z_one)) [[likely]]
                return true;
            planes = planes_of(minus_x, minus_y, minus_z, one, z_one) |
                     planes_of(minus_x, minus_y, minus_z, 4 * one, z_one) << 8;
            return true;
        }

        /// Sets the end of a line to the window position of vertex i. False: the vertex is outside of `area`
        /// or of the near and far planes, and `out` is undefined. `area` must come from inside_viewport().
        SPANGLE_INLINE bool place(int i, const Transforms& t, const raster::DrawState::Area& area,
                                  raster::LineEnd& out, numeric::LeadingZeros<>& count) const {
            const Clipped& clip = clip_[i];
            const int zeros = count.of(clip.w);
            if (static_cast<std::uint32_t>(zeros) - 1 >= t.most_zeros)
                return false;
            const Lifted x(clip.x, zeros, t.lift[0]), y(clip.y, zeros, t.lift[1]),
                z(clip.z, zeros, t.lift[2]);
            if ((x.overflow_bits() | y.overflow_bits() | z.overflow_bits()) != 0 || !drawn(clip, zeros, t))
                return false;
            const auto minus_r = static_cast<std::int32_t>(0u - inverse(i, zeros));
            out.x = t.x.place(x.times(minus_r), 32);
            out.y = t.y.place(y.times(minus_r), 32);
            const Quotient minus_z = z.times(minus_r);
            out.depth = raster::depth_code(
                static_cast<std::uint32_t>(t.depth.place(minus_z, depth_quotient_bits)), 16);
            return area.holds(out.x, out.y) && !beyond(minus_z, z_one);
        }

      private:
        /// Clip coordinates of a vertex: words with a common exponent e.
        struct Clipped {
            std::int32_t x, y, z, e;
            std::uint32_t w;
        } clip_[N];
        /// True if divide() computes each reciprocal by itself. Computing several reciprocals at once gains
        /// nothing where branches are cheap.
        static constexpr bool at_once = numeric::cheap_branches;
        struct None {};
        [[no_unique_address]] std::conditional_t<at_once, None, numeric::Reciprocals<N>> reciprocals_of_w_;

        /// True if the build can draw the vertex. A build without perspective draws only vertices whose w is
        /// 1.
        SPANGLE_INLINE static bool drawn(const Clipped& clip, int zeros, const Transforms& t) {
            return raster::has_perspective ||
                   (clip.w << zeros == 1u << 31 && zeros + t.w_exponent - clip.e == -31);
        }
        SPANGLE_INLINE std::uint32_t inverse(int i, int zeros) const {
            if constexpr (!raster::has_perspective)
                return 1u << 31;
            if constexpr (at_once)
                return numeric::reciprocal(clip_[i].w << zeros);
            else
                return reciprocals_of_w_.at(i);
        }
    };

    /// Returns the part of an area that no vertex beyond the left, right, bottom or top plane falls into.
    /// Rounding may move such a vertex onto the rim of the viewport, so the rim is left out.
    static raster::DrawState::Area inside_viewport(const Transforms& t, raster::DrawState::Area area) {
        const auto clip_axis = [](const Range& range, std::int32_t& begin, std::uint32_t& size) {
            const auto half = static_cast<std::int32_t>(-range.minus_half) >> half_bits;
            const std::int32_t end = begin + static_cast<std::int32_t>(size), rim = range.middle + half;
            if (begin <= range.middle - half)
                begin = range.middle - half + 1;
            size = static_cast<std::uint32_t>(end < rim ? end : rim) - static_cast<std::uint32_t>(begin);
            if (end <= begin || rim <= begin)
                size = 0;
        };
        clip_axis(t.x, area.x, area.w);
        clip_axis(t.y, area.y, area.h);
        return area;
    }
    /// Sets the end of a line to the window position of a vertex, if the vertex is visible. `area` must come
    /// from inside_viewport(). The position's x, y and z may have any bits; its w must be 1. False: the
    /// vertex is not visible, or this quick test cannot tell.
    SPANGLE_INLINE static bool seen(const Transforms& t, const Real (&position)[4],
                                    const raster::DrawState::Area& area, raster::LineEnd& out,
                                    numeric::LeadingZeros<>& count) {
        numeric::Mantissas<4> v;
        if (!numeric::load_usual(t.to_clip.column, position, v))
            return false;
        Projections<1> projection;
        if constexpr (numeric::long_products) {
            projection.add(0, t, v);
        } else {
            const std::int32_t power = t.to_clip.column.e[3] - v.e;
            if (power < 0) // w = 1 would be less than one unit of the common exponent
                return false;
            projection.template add<true>(0, t, v, power);
        }
        projection.finish(1);
        return projection.place(0, t, area, out, count);
    }

    /// The part of a window vertex that Projections sets: all words before its colour.
    struct Place {
        std::uint32_t word[offsetof(Window, color) / sizeof(std::uint32_t)];
    };
    static void keep_place(const Window& from, Place& to) {
        __builtin_memcpy(&to, &from, sizeof to);
    }
    static void take_place(const Place& from, Window& to) {
        __builtin_memcpy(&to, &from, sizeof from);
    }

    // Clipping (GL 1.3, 2.11). Planes 0 to 5 are left, right, bottom, top, near and far.

    using FixedClipping::beyond;
    using FixedClipping::distance;
    using FixedClipping::mix;
    /// True if a vertex is outside of a plane, which means w < v or w < -v for its coordinate v. The first
    /// four planes bound `band` times the viewport; near and far planes have no band.
    static bool beyond(const Clip& c, int plane, int band) {
        const std::int64_t w = plane < 4 ? std::int64_t{c.m[3]} * band : c.m[3], v = c.m[plane >> 1];
        return (plane & 1) != 0 ? w < v : w < -v;
    }
    /// True if w is positive. A vertex with w <= 0 between the near and far planes is the degenerate corner
    /// of the volume, which is never drawn.
    static bool in_front(const Clip& c) {
        return c.m[3] > 0;
    }

    /// A user clip plane. A plane and its complement are stored as the same plane, one of them as `turned`.
    /// Vertices on both are therefore equal to the bit, and each pixel belongs to one side (GL 1.3, 2.11).
    struct Plane {
        numeric::Block4 at{};
        bool turned = false;
    };

    static Plane plane(const Real (&equation)[4]) {
        bool turned = false;
        for (const Real c : equation)
            if (!numeric::is_zero(c)) {
                turned = numeric::is_negative(c);
                break;
            }
        // The equation is negated before rounding, which rounds halves up. Both planes therefore get the same
        // words.
        const auto at = [&](int i) { return turned ? -equation[i] : equation[i]; };
        return {numeric::to_block(at(0), at(1), at(2), at(3)), turned};
    }
    static numeric::Block distance(const Plane& p, const Eye& eye) {
        return numeric::dot(p.at, eye);
    }
    static numeric::Wide distance(const Plane& p, const Point& eye) {
        return numeric::dot(p.at, eye);
    }
    static bool turned(const Plane& p) {
        return p.turned;
    }
    template <class Distance> static bool outside(const Plane& p, const Distance& d) {
        return p.turned ? d.m > 0 : d.m < 0;
    }

    /// Mixes the associated data of a new vertex (GL 1.3, 2.13.8). Bit u of `units` says that texture
    /// coordinates u are in use, and bit u + third_coordinate that their r is in use, too.
    static void mix(const Window& a, const Window& b, const Parameter& t, unsigned units, Window& out) {
        mix_color(a, b, t, out);
        for (int u = 0; u < texture_units; ++u) {
            if ((units >> u & 1) == 0)
                continue;
            const bool with_r = (units >> (u + third_coordinate) & 1) != 0;
            const auto strq = [&](const Window& v) {
                return numeric::Block4{{v.tex[u].s, v.tex[u].t, with_r ? v.r[u] : 0, v.tex[u].q},
                                       v.tex[u].exponent};
            };
            set_texture(out, u, mix(strq(a), strq(b), t));
            set_q_is_one(out, u, a.tex[u].q_is_one != 0 && b.tex[u].q_is_one != 0);
        }
    }

    template <class V> static void mix_color(const V& a, const V& b, const Parameter& t, V& out) {
        mix_words(4, a.color, b.color, t, out.color);
#if SPANGLE_SECONDARY_COLORS
        mix_words(3, a.secondary, b.secondary, t, out.secondary);
#endif
    }

    // Numbers of any size, for operations that few vertices need: generated coordinates and normals.

    struct Scalar {
        numeric::Block v;

        [[gnu::noinline]] friend Scalar operator*(Scalar a, Scalar b) { return {numeric::mul(a.v, b.v)}; }
        [[gnu::noinline]] friend Scalar operator+(Scalar a, Scalar b) { return {numeric::add(a.v, b.v)}; }
        friend Scalar operator-(Scalar a, Scalar b) { return a + Scalar{numeric::negate(b.v)}; }
    };
    static Scalar scalar(Real v) {
        return {numeric::to_block(v)};
    }
    static Scalar scalar(const Eye& v, int i) {
        return {numeric::component(v, i)};
    }
    static Scalar rsqrt(Scalar v) {
        return {numeric::rsqrt(v.v)};
    }

    /// Returns the matrix that normals are multiplied with, column by column. It includes RESCALE_NORMAL (GL
    /// 1.3, 2.10.3).
    static void normal_matrix(const TransformState& state, Scalar (&out)[9]) {
        const numeric::NormalMatrix normal = normal_matrix(state);
        for (int i = 0; i < 9; ++i)
            out[i] = {normal.at[i]};
    }
    static numeric::NormalMatrix normal_matrix(const TransformState& state) {
        numeric::NormalMatrix normal = numeric::inverse_transpose(state.modelview.entry[state.modelview.top]);
        if (has_full_lighting && state.rescale_normal) {
            const numeric::Block scale = normal.row_scale();
            for (numeric::Block& element : normal.at)
                element = numeric::mul(element, scale);
        }
        return normal;
    }

    // The division and the viewport for a vertex that was clipped.

    /// Sets window coordinates by perspective division, viewport and depth range (GL 1.3, 2.10.1). The vertex
    /// must be within the guard band and in front of the eye.
    static void project(const Transforms& t, const Clip& c, Window& out) {
        const auto w = static_cast<std::uint32_t>(c.m[3]);
        const int zeros = numeric::clz32(w);
        const std::uint32_t r = numeric::reciprocal(w << zeros); // 1/w = r * 2^(zeros - 62 - e)
        const bool top = (r >> 31) != 0;                         // this is true only if w is a power of two
        out.w_mantissa = top ? r : r << 1;
        out.w_exponent = static_cast<std::int16_t>(zeros - 62 - c.e - (top ? 0 : 1));
        // A new vertex between extreme ends (|x| > 2^30 w) misses its plane by the rounding of 30-bit
        // mantissas. The division would magnify that error, so x and y are limited to the guard band.
        constexpr int bits = 28;
        std::int16_t x_rest, y_rest;
        out.x = limit(place(t.x, c.m[0], r, zeros, bits, bits + half_bits, &x_rest), x_rest);
        out.y = limit(place(t.y, c.m[1], r, zeros, bits, bits + half_bits, &y_rest), y_rest);
        set_rest(out, x_rest, y_rest);
        const std::int64_t depth = place(t.depth, c.m[2], r, zeros, 30, 30);
        out.z = static_cast<std::uint32_t>(numeric::clamp<std::int64_t>(depth, 0, raster::depth_one));
    }

    // Values that selection and feedback return.

    /// Converts a value that is returned to the program. The function is not inlined, since such values need
    /// small code more than speed.
    [[gnu::noinline]] static Real real(numeric::Block v) {
        return numeric::to_real(v);
    }

    /// Returns window z times 2^32 - 1, rounded to nearest, as hit records store it (GL 1.3, 5.2).
    static std::uint32_t depth_word(const Window& v) {
        return static_cast<std::uint32_t>((std::uint64_t{v.z} * 0xFFFFFFFF + raster::depth_one / 2) >> 30);
    }
    /// Returns window x, y and z before snapping, and w of the clip coordinates (GL 1.3, 5.3).
    [[gnu::noinline]] static void window_of(const Transforms& t, const Clip& c, Real (&out)[4]) {
        const numeric::Block w = numeric::component(c, 3);
        const auto place = [&](int i, std::int32_t middle, int bits, Factor half, int more) {
            const numeric::Block quotient = numeric::div(numeric::component(c, i), w);
            return numeric::to_real(
                numeric::add(numeric::make_block(middle, -bits),
                             numeric::mul(numeric::make_block(half, -bits - more), quotient)));
        };
        out[0] = place(0, t.x.middle, raster::subpixel_bits, -t.x.minus_half, half_bits);
        out[1] = place(1, t.y.middle, raster::subpixel_bits, -t.y.minus_half, half_bits);
        out[2] = place(2, t.depth.middle, 30, -t.depth.minus_half, 0);
        out[3] = real(w);
    }
    [[gnu::noinline]] static void color_of(const Window& v, Real (&out)[4]) {
        constexpr numeric::Block unit = numeric::reciprocal(numeric::make_block(raster::color_one, 0));
        for (int c = 0; c < 4; ++c)
            out[c] = real(numeric::mul(numeric::make_block(v.color[c], 0), unit));
    }
    /// Sets generated coordinates, or those of a unit that uses r. `q_is_one` says that q was given as 1 and
    /// is not generated. Under an identity matrix, q then stays 1.
    static void set_texture(const Transforms& t, const Scalar (&strq)[4], int unit, bool q_is_one,
                            Window& out) {
        const Eye v = texture_of(t, strq, unit);
        set_texture(out, unit, v);
        set_q_is_one(out, unit, (q_is_one && t.texture_is_identity[unit]) || is_one(v.m[3], v.e));
    }
    /// Returns s, t, r and q after the texture matrix of the unit.
    static Eye texture_of([[maybe_unused]] const Transforms& t, const Scalar (&strq)[4],
                          [[maybe_unused]] int unit) {
        const numeric::Block4 v = numeric::to_block(strq[0].v, strq[1].v, strq[2].v, strq[3].v);
#if SPANGLE_TEXTURE_UNITS
        if (!t.texture_is_identity[unit])
            return numeric::transform(t.texture[unit], v);
#endif
        return v;
    }
    [[gnu::noinline]] static void to_reals(const Eye& v, Real (&out)[4]) {
        for (int c = 0; c < 4; ++c)
            out[c] = real(numeric::component(v, c));
    }

    // Attributes of vertices.

    static void set_color(Window& out, const Real (&rgba)[4]) {
        for (int c = 0; c < 4; ++c)
            out.color[c] = color_units(rgba[c]);
#if SPANGLE_SECONDARY_COLORS
        for (int c = 0; c < 3; ++c)
            out.secondary[c] = 0;
#endif
    }
    static void set_secondary_color([[maybe_unused]] Window& out, [[maybe_unused]] const Real (&rgb)[4]) {
#if SPANGLE_SECONDARY_COLORS
        for (int c = 0; c < 3; ++c)
            out.secondary[c] = color_units(rgb[c]);
#endif
    }

    /// The colours of a window vertex.
    struct Colors {
        std::uint32_t color[4];
#if SPANGLE_SECONDARY_COLORS
        std::uint32_t secondary[3];
#endif
    };
    template <class From, class To> static void copy_color(const From& from, To& to) {
        const auto copy = [](const auto& words, auto& out) {
            if constexpr (numeric::wide_words)
                // On 32-bit machines this copy might become a function call.
                __builtin_memcpy(out, words, sizeof out);
            else
                for (std::size_t c = 0; c < sizeof out / sizeof out[0]; ++c)
                    out[c] = words[c];
        };
        copy(from.color, to.color);
#if SPANGLE_SECONDARY_COLORS
        copy(from.secondary, to.secondary);
#endif
    }

    /// Sets the texture coordinates of a unit whose matrix is the identity.
    static void set_texture(const Real (&stq)[4], int unit, Window& out) {
        const numeric::Mantissas<3> v = numeric::load<3>({}, {stq[0], stq[1], stq[3]});
        set_texture(out, unit, numeric::Block3{{v.m[0], v.m[1], v.m[2]}, v.e});
        set_q_is_one(out, unit, stq[3] == numeric::one);
    }
    static void set_texture(const Transforms& t, const Real (&stq)[4], int unit, Window& out) {
        if (t.texture_is_identity[unit])
            return set_texture(stq, unit, out);
#if SPANGLE_TEXTURE_UNITS
        const numeric::Block4 v = numeric::transform(t.texture[unit], stq);
        set_texture(out, unit, numeric::Block3{{v.m[0], v.m[1], v.m[3]}, v.e});
        set_q_is_one(out, unit, is_one(v.m[3], v.e));
#endif
    }

    static bool q_is_one(const Window& v, int unit) {
        return v.tex[unit].q_is_one != 0;
    }

    /// Sets the coordinates of a corner of a point sprite: s and t are 0 or 1, r is 0 and q is 1 (GL 2.0,
    /// 3.3).
    static void set_sprite(int unit, bool s, bool t, Window& out) {
        const auto whole = [](bool one) { return one ? numeric::one : numeric::zero; };
        const Real stq[4] = {whole(s), whole(t), numeric::zero, numeric::one};
        set_texture(stq, unit, out);
#if SPANGLE_TEXTURE_UNITS &&                                                                                 \
    (SPANGLE_FEATURE_TEXTURE_3D || SPANGLE_FEATURE_TEXTURE_CUBE_MAP || SPANGLE_FEATURE_DEPTH_TEXTURES)
        out.r[unit] = 0;
#endif
    }
    /// Multiplies alpha by a factor from 0 to 1.
    static void fade(Real factor, Window& out) {
        const auto f = static_cast<std::uint32_t>(numeric::to_fixed(factor, 30));
        out.color[3] = static_cast<std::uint32_t>((numeric::mul_u32(out.color[3], f) + (1u << 29)) >> 30);
    }

    /// Sets the fog distance to |z_e|. GL 1.3, 3.10 allows this in place of the distance to the eye.
    static void set_fog(Depth eye_z, Window& out) {
        set_fog_coordinate({eye_z.m < 0 ? -eye_z.m : eye_z.m, eye_z.e}, out);
    }
    /// Sets the fog distance to a fog coordinate, which may be negative (GL 1.4, 3.10).
    static void set_fog_coordinate([[maybe_unused]] Depth coordinate, [[maybe_unused]] Window& out) {
#if SPANGLE_FEATURE_FOG
        out.fog_mantissa = coordinate.m;
        out.fog_exponent = static_cast<std::int16_t>(coordinate.e);
#endif
    }
    static Depth fog_coordinate(const Window& v) {
        return {v.fog_mantissa, v.fog_exponent};
    }
    static Depth fog_coordinate(Real coordinate) {
        return numeric::to_block(coordinate);
    }

    /// Largest colour index in units of 2^-20. A colour index is stored as red and interpolated like red.
    /// Interpolation has room for values below 256, of which 2^12 units are left for the error of its set-up.
    static constexpr std::uint32_t largest_index = (256u << raster::color_fraction_bits) - (1u << 12);
    [[gnu::noinline]] static void set_index(Real index, unsigned bits, Window& out) {
        const std::uint32_t units = index_units(index, bits);
        out.color[0] = units < largest_index ? units : largest_index;
        out.color[1] = out.color[2] = out.color[3] = 0;
#if SPANGLE_SECONDARY_COLORS
        for (std::uint32_t& c : out.secondary)
            c = 0;
#endif
    }
    static Real index_of(const Window& v) {
        return real(numeric::make_block(v.color[0], -raster::color_fraction_bits));
    }

    /// Makes a window vertex of the raster position, for the fragments of pixel rectangles and bitmaps. It
    /// has depth, colour and texture coordinates, but no x and y.
    static void set_raster(const RasterPosition& from, Window& out) {
        out = Window{};
        out.z = static_cast<std::uint32_t>(numeric::to_fixed(numeric::clamp01(from.position[2]), 30));
        out.w_mantissa = 1u << 31; // with w = 1, texture coordinates are divided by q alone
        out.w_exponent = -31;
        set_fog_coordinate(fog_coordinate(from.distance), out);
        set_color(out, from.color);
        for (int u = 0; u < texture_units; ++u) {
            const Real(&v)[4] = from.tex_coord[u].v;
            // The units that use r are not known here, so all four coordinates are set.
            set_texture(out, u, numeric::to_block(v));
            set_q_is_one(out, u, v[3] == numeric::one);
        }
    }

    /// Converts a colour component, clamped to 0 to 1, to 255ths with 20 fraction bits. Its product with 255
    /// in Q.30 is exact before rounding.
    static std::uint32_t color_units(Real component) {
        const auto c = static_cast<std::uint32_t>(numeric::to_fixed(numeric::clamp01(component), 30));
        return color_units(c);
    }
    /// Converts a colour component in Q0.30 to 255ths with 20 fraction bits.
    static std::uint32_t color_units(std::uint32_t c) {
        return static_cast<std::uint32_t>((numeric::mul_u32(c, 255) + (1u << 9)) >> 10);
    }

  private:
    /// Returns the largest count of leading zeros of w with which no coordinate is shifted by more than 31.
    /// `lift` is n of Transforms::lift.
    static std::uint32_t most_zeros(const std::int32_t (&lift)[3]) {
        std::int32_t most = 31;
        for (int i = 0; i < 3; ++i) {
            const std::int32_t own = 31 - lift[i];
            most = own < most ? own : most;
        }
        return most < 0 ? 0 : static_cast<std::uint32_t>(most);
    }

    /// Returns the product of one row and a vertex. The empty instruction at its end keeps the compiler from
    /// computing all four rows at once, for which there are too few registers.
    template <bool Point, class Element>
    SPANGLE_INLINE static std::int32_t row(const Element* elements, numeric::Mantissas<4>& v,
                                           [[maybe_unused]] int power) {
#pragma GCC unroll numeric::runs_inline ? 4 : 1
        for (std::int32_t& m : v.m)
            m = numeric::factor32(m);
        std::int32_t r;
        if constexpr (Point)
            r = numeric::row_times_point<4>(elements, v.m, power);
        else
            r = numeric::row_times(elements, v.m);
        asm volatile("" : "+r"(v.m[0]) : "r"(r)); // NOLINT(hicpp-no-assembler): no instruction
        return r;
    }

    /// A coordinate v shifted to v * 2^n, with n = zeros + lift and 0 <= n < 32. times() returns the high
    /// word of a product with it, rounded. On 64-bit machines, the product is shifted down by 31 - n instead,
    /// so that it fits for every v.
    struct Lifted {
        std::int32_t v;
        int by; ///< the shift n, or 31 - n on 64-bit machines
        SPANGLE_INLINE Lifted(std::int32_t value, int zeros, std::int32_t lift)
            : v(value), by(static_cast<int>(numeric::wide_words ? lift - zeros : lift + zeros)) {}
        SPANGLE_INLINE std::int32_t word(int n) const {
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(v) << n);
        }
        /// Returns a value that is not 0 if a word has no room for the shifted coordinate.
        SPANGLE_INLINE std::int32_t overflow_bits() const {
            const int n = numeric::wide_words ? 31 - by : by;
            return (word(n) >> n) ^ v;
        }
        SPANGLE_INLINE Quotient times(std::int32_t factor) const {
            if constexpr (numeric::wide_words)
                return ((numeric::mul_s32(v, factor) >> by) + 1) >> 1;
            // Only planes_of() uses this saturated quotient.
            if (!raster::has_perspective && overflow_bits() != 0)
                return v < 0 ? INT32_MAX : INT32_MIN;
            return numeric::mul_high_rounded(word(by), factor);
        }
    };
    static constexpr std::uint32_t one = 1u << quotient_bits, z_one = 1u << depth_quotient_bits;
    static bool beyond(Quotient q, std::uint32_t most) {
        return static_cast<std::make_unsigned_t<Quotient>>(q) + most > 2 * most;
    }
    /// Returns the planes that a vertex is beyond, from its negated quotients. `xy` and `z` are the bounds of
    /// the quotients.
    static unsigned planes_of(Quotient minus_x, Quotient minus_y, Quotient minus_z, std::uint32_t xy,
                              std::uint32_t z) {
        const auto most = static_cast<std::int32_t>(xy), most_z = static_cast<std::int32_t>(z);
        return (minus_x > most ? 1u : 0u) | (minus_x < -most ? 2u : 0u) | (minus_y > most ? 4u : 0u) |
               (minus_y < -most ? 8u : 0u) | (minus_z > most_z ? 16u : 0u) | (minus_z < -most_z ? 32u : 0u);
    }

    static bool is_identity(const numeric::Matrix& m) {
        for (int i = 0; i < 16; ++i) {
            const std::int32_t wanted = i % 5 == 0 ? numeric::Matrix::one : 0;
            if (m.m[i] != wanted || (wanted != 0 && m.e[i] != numeric::Matrix::one_e))
                return false;
        }
        return true;
    }

    /// Returns m / w with `bits` fraction bits, rounded to nearest; |m / w| <= 4. r and `zeros` are those of
    /// project().
    static std::int64_t quotient(std::int32_t m, std::uint32_t r, int zeros, int bits) {
        const int shift = 62 - zeros - bits;
        const std::int64_t product = static_cast<std::int64_t>(m) * r;
        return numeric::shift_right_round(product, shift);
    }

    /// Returns the position of m / w within a range. The quotient has `quotient_has` fraction bits and is
    /// limited to 2^30. Its product with half the range has `bits` fraction bits. `rest` gets what rounding
    /// cut off, in 2^-16 of the result's unit.
    SPANGLE_RUN_CALL static std::int64_t place(const Range& range, std::int32_t m, std::uint32_t r, int zeros,
                                               int quotient_has, int bits, std::int16_t* rest = nullptr) {
        // `most` is 4 with 28 fraction bits, and 1 with 30.
        constexpr std::int64_t most = std::int64_t{1} << 30;
        const auto q = static_cast<std::int32_t>(
            numeric::clamp<std::int64_t>(quotient(m, r, zeros, quotient_has), -most, most));
        const std::int64_t from_middle = -product(range.minus_half, q);
        if (rest != nullptr)
            *rest = static_cast<std::int16_t>(from_middle >> (bits - 16));
        return range.middle + (((std::int64_t{1} << (bits - 1)) + from_middle) >> bits);
    }

    /// Limits a coordinate to what the rasterizer accepts. Only rounding during clipping exceeds the limit.
    static std::int32_t limit(std::int64_t v, std::int16_t& rest) {
        constexpr std::int64_t most = 4 * 2048 * raster::subpixel_one - 1;
        if (v < -most || v > most)
            rest = 0;
        return static_cast<std::int32_t>(numeric::clamp<std::int64_t>(v, -most, most));
    }
    SPANGLE_INLINE static void set_rest([[maybe_unused]] Window& out, [[maybe_unused]] std::int16_t x,
                                        [[maybe_unused]] std::int16_t y) {
#if SPANGLE_TIER_SET & 1
        out.x_rest = x;
        out.y_rest = y;
#endif
    }

    // Vertices have no room for texture coordinates in a build without texture units
    // (raster/span/vertex.hpp).
    static void set_texture([[maybe_unused]] Window& out, [[maybe_unused]] int unit,
                            [[maybe_unused]] const numeric::Block4& strq) {
#if SPANGLE_TEXTURE_UNITS
        set_texture(out, unit, numeric::Block3{{strq.m[0], strq.m[1], strq.m[3]}, strq.e});
#if SPANGLE_FEATURE_TEXTURE_3D || SPANGLE_FEATURE_TEXTURE_CUBE_MAP || SPANGLE_FEATURE_DEPTH_TEXTURES
        out.r[unit] = strq.m[2];
#endif
#endif
    }
    static void set_texture([[maybe_unused]] Window& out, [[maybe_unused]] int unit,
                            [[maybe_unused]] const numeric::Block3& stq) {
#if SPANGLE_TEXTURE_UNITS
        out.tex[unit].s = stq.m[0];
        out.tex[unit].t = stq.m[1];
        out.tex[unit].q = stq.m[2];
        out.tex[unit].exponent = static_cast<std::int16_t>(stq.e);
#endif
    }
    /// True if m * 2^e is exactly 1. A matrix that does not change q leaves it 1.
    static bool is_one(std::int32_t m, int e) {
        return e <= 0 && e >= -30 && m == 1 << -e;
    }
    static void set_q_is_one([[maybe_unused]] Window& out, [[maybe_unused]] int unit,
                             [[maybe_unused]] bool is_one) {
#if SPANGLE_TEXTURE_UNITS
        out.tex[unit].q_is_one = is_one ? 1 : 0;
#endif
    }
};

} // namespace spangle::gl
