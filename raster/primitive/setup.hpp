// Set-up makes interpolants of spans from vertices.
#pragma once

#include <cstdint>

#include "raster/span/draw_state.hpp"
#include "raster/span/span.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

/// Computes the plane equations of one primitive, for the attributes that its state needs, and writes them
/// into a span. Each policy specialises this class.
template <class P> class Setup;

/// Set-up of the fixed policy. All products fit 64 bits. Coefficients of gradients have 30 bits: an attribute
/// is off by less than 2^-18 of its range anywhere in a triangle (thin_aspect below), 2^-27 in a compact one.
/// Values start at the pixel of the lowest vertex, so that the order of vertices, integer translation, the
/// scissor rectangle and bands change nothing.
///
/// Planes go through the vertices that coverage sees, which are snapped to 1/256 pixel. Depth does so in
/// every tier. In the exact tier the planes of all other attributes go through the vertices before snapping
/// (unsnap()). Where a bound says that texture coordinates over w would lose more than 2^-7 texel even so,
/// the exact tier makes their planes in numbers of 61 bits (steepen()).
template <> class Setup<Fixed> {
  public:
    using Vertex = FixedVertex;

    /// Sets up a triangle. a, b, c are sorted by y, then x; area2 is twice their signed area, not 0.
    Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& provoking,
          std::int64_t area2);
    /// |area2| as word 2^exponent, rounded up.
    struct Area {
        std::uint32_t word; ///< 0 for a thin triangle (thin_aspect)
        std::int32_t exponent;
        std::int32_t sign; ///< negative where area2 is negative
        /// Makes the area of a triangle whose window box has an area `box`, in square subpixels, that fits a
        /// word.
        SPANGLE_INLINE static Area in_box(std::int32_t area2, std::uint32_t box) {
            const std::uint32_t word = numeric::abs_u32(area2);
            // A triangle is not thin if box <= thin_aspect |area2|.
            return {(box - 1) / thin_aspect < word ? word : 0, 0, area2};
        }
    };
    Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& provoking,
          const Area& area);
    /// Sets up a line. Attributes vary along its major axis only, from a at coordinate `begin` to b at `end`,
    /// in subpixels.
    Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& provoking, bool along_x,
          std::int32_t begin, std::int32_t end)
        : Setup(span, a, b, provoking, along_x, begin, end, along_x) {}
    /// Sets up a line whose planes vary along x or y (`along_x`), while `begin` and `end` are x or y of the
    /// vertices (`of_x`).
    Setup(Span<Fixed>& span, const Vertex& a, const Vertex& b, const Vertex& provoking, bool along_x,
          std::int32_t begin, std::int32_t end, bool of_x);
    /// Sets up a point, on which no attribute varies.
    Setup(Span<Fixed>& span, const Vertex& v);

    // A gradient's coefficient is at most 2^30, the difference of an attribute between two vertices below
    // 2^31.

    /// Where the ratio of window box to area is larger, a triangle is interpolated along its longer axis
    /// only. Two-dimensional gradients would lose too much there. All its centres lie within a fraction of a
    /// pixel of a line.
    static constexpr std::uint32_t thin_aspect = 1 << 10;

  private:
    /// The gradient of an attribute per pixel with all 64 bits, of which an affine plane keeps the low word.
    struct Slope {
        std::uint64_t dx, dy;
    };
    struct Gradient {
        std::int64_t dx, dy; ///< differences from pixel to pixel
        std::int64_t center; ///< change of the attribute from the lowest vertex to the centre of its pixel
    };
    /// The primary or secondary colours of the three reference vertices. of[k] is the colour of vertex k.
    struct ColorSource {
        const std::uint32_t* of[3];
        std::uint32_t first(int i) const { return of[0][i]; }
        std::int32_t difference(int k, int i) const { return static_cast<std::int32_t>(of[k][i] - of[0][i]); }
    };
    /// A function that is called for each colour component. Small builds have one loop that takes any
    /// function of this type.
    struct ColorVisitor {
        void* f;
        void (*add)(void* f, const ColorSource& from, int i, Interpolant<std::uint32_t>& at,
                    Interpolant<std::uint64_t>& over_w);
        void operator()(const ColorSource& from, int i, Interpolant<std::uint32_t>& at,
                        Interpolant<std::uint64_t>& over_w) const {
            add(f, from, i, at, over_w);
        }
    };
    /// s and t (or s/w, t/w, q/w) of the reference vertices of one unit.
    struct UnitValues {
        std::int32_t s[3], t[3], q[3], r[3];
        std::int64_t s0, t0; ///< s and t of vertex 0, in repeats with 32 fraction bits
        int shift;           ///< the unit of s and t is 2^(shift - 32) repeats
        bool homogeneous;    ///< true where q is not 1: q is set, and s and t are over w
    };

    /// The axis along which attributes of a line, or of a thin triangle, vary.
    struct Axis {
        std::int32_t begin, end;
        bool along_x; ///< true where planes vary along x, false where along y
        bool of_x;    ///< true where begin and end are x of vertices, false where y
    };

    void set_anchor(std::int32_t x, std::int32_t y);
    void unsnap();
    void snap();
    bool unsnap_plane();
    bool unsnap_axis();
    bool colors_stay_inside(std::uint32_t range) const;
    void snap_where_w_ends();
    void along_axis(const Vertex& from, const Vertex& to, const Axis& axis);
    static Area area_word(std::uint64_t area, std::int32_t sign);
    static Area area_of(const Vertex& a, const Vertex& b, const Vertex& c, std::int64_t area2);
    void along_longer_axis(const Vertex& a, const Vertex& b, const Vertex& c);
    void in_plane(std::uint32_t top, int zeros, bool negative);
    template <bool Rgb> void attributes_of(const Vertex& provoking);
    [[gnu::noinline]] void set_up_exact_colors(std::uint32_t bits);
    void attributes(const Vertex& provoking);
    void triangle_attributes(const Vertex& provoking);
    template <bool Rgb> void set_up_without_coordinates(std::uint32_t color_bits, const Vertex& painted);
    void set_up_with_coordinates(std::uint32_t color_bits, const Vertex& painted);
    bool weights();
    void load_weights();
    void weights_of_several_exponents();
    void load_unit(int unit, UnitValues& u) const;
    void load_homogeneous(int unit, UnitValues& u) const;
    void load_fog(std::int32_t fog[3]) const;
    void load_any_fog(std::int32_t fog[3]) const;
    bool is_within_tolerance(std::uint32_t range, std::uint64_t four_tolerances) const;
    bool unit_affine(int unit, const UnitValues& u, bool same_w) const;
    template <bool Rgb> std::uint32_t color_bits();
    bool nearly_affine(std::uint32_t bits) const;
    bool colors_affine(std::uint32_t bits);
    bool colors_within_tolerance(std::uint32_t bits, std::uint32_t four) const;
    template <bool Rgb> std::uint32_t color_range() const;
    template <bool Rgb> bool needs_division(std::uint32_t bits);
    bool is_gray(std::uint32_t color_bits, const Vertex& painted) const;
    const Vertex& v(int i) const { return *span_.basis.v[i]; }
    std::int32_t& q(int i) const { return span_.basis.q[i]; }
    Coefficients& by() const { return span_.basis.by; }
    ColorSource primary() const { return {{v(0).color, v(1).color, v(2).color}}; }
    ColorSource secondary() const { return {{v(0).secondary, v(1).secondary, v(2).secondary}}; }
    Kind choose_kind(const UnitValues units[], bool same_w, std::uint32_t color_bits,
                     const std::int32_t fog[3]);

    static Gradient gradient(const Coefficients& by, std::int32_t d1, std::int32_t d2);
    static std::uint64_t projective(const Coefficients& by, Interpolant<std::uint64_t>& at,
                                    const std::int32_t v[3]);
    static Interpolant<std::uint64_t> scaled_plane(const Coefficients& by, std::int32_t d1, std::int32_t d2,
                                                   int up);
    Slope add_steep(Interpolant<std::uint32_t>& at, std::uint32_t first, std::int32_t d1, std::int32_t d2,
                    int up);
    void add_words(Interpolant<std::uint32_t>& at, std::uint32_t first, const std::int32_t v[3], int up);
    std::uint64_t add_projective(Interpolant<std::uint64_t>& at, const std::int32_t v[3]);
    void add_depth();
    bool has_24_bits() const {
        return has_format(DepthFormat::z24s8) && state_.needs.z && state_.depth_format != DepthFormat::z16;
    }
    void add_depth_24(const Vertex& a, const Vertex& b, const Vertex& c);
    void add_depth_24_along();
    void constant_colors(const Vertex& painted);
    void colors(std::uint32_t bits, const Vertex& painted);
    template <bool Rgb> void varying_colors(std::uint32_t bits);
    template <bool Rgb = false, class F> void each_color(F add) const;
    template <bool Rgb, class F> void every_color(F add) const;
    void any_color(ColorVisitor add) const;
    void steep_colors(std::uint32_t bias);
    template <class Steps, class F> void each_step(Steps in_steps, F add) const;
    template <class F> void each_step(F add) const;
    void steep_steps(std::uint32_t bias);
    void stepped_colors(std::uint32_t bits, std::uint32_t bias);
    void stepped_colors_apart(std::uint32_t bits, std::uint32_t bias);
    template <bool Rgb> void window_colors(std::uint32_t bits, std::uint32_t less);
    void projective_colors();
    void guessed_colors(std::uint32_t bits);
    void divided_colors();
    template <bool Rgb> void affine_colors(std::uint32_t bits, std::uint32_t bias);
    static void project(Span<Fixed>& span);
    void over_w(std::int32_t v[3]) const;
    void add_unit(int unit, UnitValues& u);
    bool loses_texels(const UnitValues units[]) const;
    void steepen(std::int32_t fog[3]);

    Span<Fixed>& span_;
    const DrawState& state_;
    Axis axis_;
    /// The vertex of a triangle besides v(0) and v(1). On lines and points it is v(0), and thin triangles
    /// have v(0) as v(2).
    const Vertex* third_vertex_;
    /// How far an attribute may lie beyond its values at the vertices, within coverage, as a part of its
    /// range in 2^-32. It is 0 where planes go through snapped vertices. Exact tier only.
    std::uint32_t beyond_;
    std::uint32_t q_least_, q_range_;
    std::uint32_t
        widest_color_range_; ///< largest range of a colour component; set only where attributes_of() needs it
};

} // namespace spangle::raster
