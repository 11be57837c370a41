// A span is one row of one primitive, as set-up hands it to the stages. The numeric policy decides the types
// of its numbers.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/fused_keys.hpp"
#include "raster/span/kind.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

struct DrawState;
struct Surface;

/// The numeric policy of the product.
///
/// Affine planes count mod 2^32 (unsigned, so that wrapping is defined):
///   z: the depth code of 16 bits in the top bits, with half a code added; z24 has 24 bits in the top bits of
///   64;
///   colours: 255ths in 8.24, with half an 8.8 step added (half a 255th where Variant::color_bias says so);
///   texture s, t: see TexCoords (number.hpp);
///   fog: s7.24.
/// Projective planes count mod 2^64 in two's complement: 30-bit values with 16 guard bits below, normalised
/// per primitive.
struct Fixed {
    using Vertex = FixedVertex;
    using Affine = std::uint32_t;
    using Projective = std::uint64_t;
};

inline constexpr int guard_bits = 16;

/// Fraction bits of texture coordinates that do not wrap (number.hpp, TexCoords).
inline constexpr int clamped_coord_bits = 28;

/// A plane: its value at the centre of the anchor pixel, and its differences from pixel to pixel and from row
/// to row. `at` is exact: no error accumulates and any pixel can be first.
template <class T> struct Interpolant {
    T value, dx, dy;
    constexpr T at(std::int32_t columns, std::int32_t rows) const {
        if constexpr (sizeof(T) == 8 && !numeric::long_products)
            return value + numeric::times(dx, columns) + numeric::times(dy, rows);
        T start = value + static_cast<T>(columns) * dx;
        if constexpr (sizeof(T) == 4)
            start =
                numeric::factor32(start); // compiles to two multiply-accumulates, not to a sum of products
        return start + static_cast<T>(rows) * dy;
    }
};

/// The slopes of attributes over a primitive, per unit of their differences d1 and d2 from a reference vertex
/// to two others: d/dx = (d1 dx[0] + d2 dx[1]) 2^-exponent, d/dy likewise. All slopes share one exponent;
/// thin_aspect (setup.hpp) bounds what the smaller coefficients lose by that.
struct Coefficients {
    std::int32_t dx[2], dy[2];
    std::int32_t center[2]; ///< from the reference vertex to the centre of its pixel, in the same form
    int exponent;
};

/// What the planes of a primitive are made from, for planes that are made only when a fragment asks for them.
struct Basis {
    const FixedVertex* v[3]; ///< reference vertices; the values of planes start at the first one
    Coefficients by;         ///< slopes for d1 = v1 - v0 and d2 = v2 - v0
    std::int32_t
        q[3]; ///< 1/w of the three vertices, largest in [2^29, 2^30); valid where set-up had to look at it
};

/// True where colours may be of Kind::full. Colours of the fast tier are affine where there is neither a
/// chain nor a listed span of that kind (compile()): planes that no listed span reads take no bytes.
inline constexpr bool has_full =
    has_perspective && (has_chain || tiers != 1u << static_cast<unsigned>(Tier::fast) || spans_of_full.some);

/// Declares planes of texture units as members of a span. Builds without texture units make them static
/// instead: all spans share one place that no stage reads.
#if SPANGLE_TEXTURE_UNITS
#define SPANGLE_OF_TEXTURES(plane) plane
#else
#define SPANGLE_OF_TEXTURES(plane)                                                                           \
    static constinit inline plane {}
#endif

/// Pixel x of a span is column `x` of the primitive's row counted from its unscissored left edge: runs, lanes
/// and rounding are anchored there, so scissor, bands, lane width and integer translation change no byte
/// (docs/architecture/fragments.md, "Runs of texture coordinates").
template <class P> struct Span {
    /// Planes that no span of this build reads share one place: an array of one plane, or one place for all
    /// spans.
    static constexpr bool all = !std::is_same_v<P, Fixed>;
    static constexpr int secondaries = all || has_color_sum ? 3 : 1, colors_over_w = all || has_full ? 4 : 1;
    using Affine = Interpolant<typename P::Affine>;
    using Projective = Interpolant<typename P::Projective>;

    const DrawState* state;
    const Surface* target;
    std::uint8_t* color;             ///< address of pixel `begin` in the colour plane
    std::uint8_t* depth;             ///< address of pixel `begin` in the depth plane; null without one
    std::int32_t begin, end;         ///< pixels to draw, 0 <= begin < end <= length
    std::int32_t length;             ///< pixels of the unscissored row
    std::int32_t x, y;               ///< window position of pixel 0
    std::int32_t anchor_x, anchor_y; ///< window position of the pixel at which the planes have their values
    Kind kind;
    bool gray; ///< the colour is gray: its red stands for green and blue, too (Variant::gray)
    std::uint8_t
        dither_column; ///< where fused lists dither: column, mod 4, of the fragment from which they count
    std::uint32_t flat_word; ///< Kind::flat: the colour as a 16-bit surface stores it

    Basis basis;
    Affine z; ///< the depth plane of depth buffers of 16 bits
    struct NoPlane {};
    /// The depth plane of depth buffers of 24 bits. With 40 bits below the code it is within half a code
    /// anywhere.
    [[no_unique_address]] std::conditional_t<!all && has_format(DepthFormat::z24s8),
                                             Interpolant<std::uint64_t>, NoPlane>
        z24;
    Affine color_value[4];         ///< planes of R, G, B and A
    Affine secondary[secondaries]; ///< planes of R, G and B
    Affine fog;
    bool
        fog_inside; ///< the fog coordinates of all fragments lie in [0, 1) (known only where there are lanes)
    SPANGLE_OF_TEXTURES(Affine s[max_texture_units]);
    SPANGLE_OF_TEXTURES(Affine t[max_texture_units]);

    Projective q;                      ///< 1/w, > 0; its largest value at a vertex lies in [2^29, 2^30)
    Projective color_q[colors_over_w]; ///< colour * 1/w
    Projective secondary_q[secondaries];
    Projective fog_q;
    struct Unit {
        Projective s,
            t;        ///< s/w and t/w; where coordinates are affine only dx is set, for the level of detail
        Projective q; ///< q/w; not written when `shares_q`
        typename P::Projective s_dy, t_dy, q_dy; ///< differences from row to row, for the level of detail
        std::int32_t exponent;                   ///< (s/w) / (q/w) * 2^exponent = s in repeats of the texture
        std::int32_t s_base,
            t_base;           ///< whole repeats taken off before interpolation (clamping wraps add them back)
        bool shares_q = true; ///< q is 1 at every vertex: use Span::q
        Projective r;         ///< r/w; set where Needs::r says so
        typename P::Projective r_dy;
    };
    SPANGLE_OF_TEXTURES(Unit unit[max_texture_units]);
    typename P::Projective q_dy;
    /// A guess of the colours of Kind::full (stage_guess.hpp): color_value is at most the exact colour, and
    /// the exact colour is at most a doubt more. The projective planes of colours exist when `project` is
    /// null; until then `project` makes them from `basis`.
    struct ColorGuess {
        /// Compared with the bits of a component below a step of 5 or 6 bits, moved to the top: from this
        /// value on the doubt may reach the next step.
        std::uint32_t doubt5, doubt6;
        void (*project)(Span&);
        void doubt(std::uint32_t most) { // most > 0
            doubt5 = most >> 27 == 0 ? 0 - (most << 5) : 0;
            doubt6 = most >> 26 == 0 ? 0 - (most << 6) : 0;
        }
    } guess;
    std::int32_t fog_exponent; ///< fog_q / q * 2^fog_exponent = fog coordinate
    const void*
        pixels; ///< Colors::of_pixels: the colours of pixel 0 and up, in the form that DrawState::words says

    /// The value of a plane at pixel `column`.
    template <class T>
    SPANGLE_RUN_CALL constexpr T at(std::int32_t column, const Interpolant<T>& plane) const {
        return plane.at(column + (x - anchor_x), y - anchor_y);
    }
};
#undef SPANGLE_OF_TEXTURES

} // namespace spangle::raster
