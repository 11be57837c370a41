// A span: one row of one primitive, as set-up hands it to the stages. The numeric policy says in which
// numbers.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/fused_keys.hpp"
#include "raster/span/kind.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

struct DrawState;
struct Surface;

/// The policy of the product.
///
/// Affine:     mod 2^32 (unsigned, so wrap is defined). z: depth code of 16 bits in the top bits, half a code
///             added, or of 24 bits in the top bits of 64 (z24); colours: 8.24
///             255ths, half an 8.8 step added (half a 255th where DrawState::color_bias says so); texture s,
///             t: see Coord; fog: s7.24.
/// Projective: mod 2^64 two's complement, 30-bit values with 16 guard bits below, normalised per primitive.
struct Fixed {
    using Vertex = FixedVertex;
    using Affine = std::uint32_t;
    using Projective = std::uint64_t;
};

inline constexpr int guard_bits = 16;

/// Fraction bits of texture coordinates that do not wrap (number.hpp, TexCoords).
inline constexpr int clamped_coord_bits = 28;

/// A plane: value at the centre of the anchor pixel, differences from pixel to pixel and from row to row.
/// `at` is exact: no error accumulates and any pixel can be first.
template <class T> struct Interpolant {
    T value, dx, dy;
    constexpr T at(std::int32_t columns, std::int32_t rows) const {
        if constexpr (sizeof(T) == 8 && !numeric::long_products)
            return value + numeric::times(dx, columns) + numeric::times(dy, rows);
        T start = value + static_cast<T>(columns) * dx;
        if constexpr (sizeof(T) == 4)
            start = numeric::factor32(start); // two multiply-accumulates, no sum of products
        return start + static_cast<T>(rows) * dy;
    }
};

/// How attributes vary over a primitive, per unit of their differences d1 and d2 from a reference vertex to
/// two others: d/dx = (d1 dx[0] + d2 dx[1]) 2^-exponent, d/dy likewise. One exponent: thin_aspect (setup.hpp)
/// bounds what the smaller coefficients lose.
struct Coefficients {
    std::int32_t dx[2], dy[2];
    std::int32_t center[2]; ///< from the reference vertex to the centre of its pixel, likewise
    int exponent;
};

/// What the planes of a primitive are made of, for those that are made when a fragment asks for them.
struct Basis {
    const FixedVertex* v[3]; ///< reference vertices; values start at the first
    Coefficients by;         ///< with d1 = v1 - v0 and d2 = v2 - v0
    std::int32_t q[3];       ///< 1/w of these, largest in [2^29, 2^30), where set-up had to look at it
};

/// Colours may be of Kind::full. Those of the fast tier are affine where there is no chain and no span of
/// that kind was asked for (compile()): what no listed span does takes no bytes.
inline constexpr bool has_full =
    has_perspective && (has_chain || tiers != 1u << static_cast<unsigned>(Tier::fast) || spans_of_full.some);

/// Places of planes in a span, or in all of them together where none looks at them.
#if SPANGLE_TEXTURE_UNITS
#define SPANGLE_OF_TEXTURES(plane) plane
#else
#define SPANGLE_OF_TEXTURES(plane)                                                                           \
    static constinit inline plane {}
#endif

/// Pixel x of a span is column `x` of the primitive's row counted from its unscissored left edge: runs, lanes
/// and rounding are anchored there, so scissor, bands, lane width and integer translation change no byte
/// (design 2).
template <class P> struct Span {
    /// Planes that no span of this build looks at have one place together, or one in all spans.
    static constexpr bool all = !std::is_same_v<P, Fixed>;
    static constexpr int secondaries = all || has_color_sum ? 3 : 1, colors_over_w = all || has_full ? 4 : 1;
    using Affine = Interpolant<typename P::Affine>;
    using Projective = Interpolant<typename P::Projective>;

    const DrawState* state;
    const Surface* target;
    std::uint8_t* color;             ///< pixel `begin` of the span in memory
    std::uint8_t* depth;             ///< same, in the depth plane; null without one
    std::int32_t begin, end;         ///< pixels to draw, 0 <= begin < end <= length
    std::int32_t length;             ///< of the unscissored row
    std::int32_t x, y;               ///< window position of pixel 0
    std::int32_t anchor_x, anchor_y; ///< window position that the planes start from
    Kind kind;
    bool gray;                 ///< red stands for green and blue, too (Variant::gray)
    std::uint8_t counted_from; ///< where fused lists dither: column of the fragment they count from, mod 4
    std::uint32_t flat_word;   ///< Kind::flat: the colour as stored in a 16-bit surface

    Basis basis;
    Affine z; ///< where the depth buffer has 16 bits
    struct Absent {};
    /// Where it has 24: with 40 bits below them a plane is within half a code anywhere.
    [[no_unique_address]] std::conditional_t<!all && has_format(DepthFormat::z24s8),
                                             Interpolant<std::uint64_t>, Absent>
        z24;
    Affine color_value[4];         ///< RGBA
    Affine secondary[secondaries]; ///< RGB
    Affine fog;
    bool fog_inside; ///< no fragment's is below 0 or as much as 1 (where there are lanes)
    SPANGLE_OF_TEXTURES(Affine s[max_texture_units]);
    SPANGLE_OF_TEXTURES(Affine t[max_texture_units]);

    Projective q;                      ///< 1/w, > 0, largest vertex in [2^29, 2^30)
    Projective color_q[colors_over_w]; ///< colour * 1/w
    Projective secondary_q[secondaries];
    Projective fog_q;
    struct Unit {
        Projective s, t; ///< s/w and t/w; of affine coordinates only dx, for the level of detail
        Projective q;    ///< q/w; not written when `shares_q`
        typename P::Projective s_dy, t_dy, q_dy; ///< differences from row to row, for the level of detail
        std::int32_t exponent;                   ///< (s/w) / (q/w) * 2^exponent = s in repeats of the texture
        std::int32_t s_base,
            t_base;           ///< whole repeats taken off before interpolation (clamping wraps add them back)
        bool shares_q = true; ///< q is 1 at every vertex: use Span::q
        Projective r;         ///< r/w, where Needs::r
        typename P::Projective r_dy;
    };
    SPANGLE_OF_TEXTURES(Unit unit[max_texture_units]);
    typename P::Projective q_dy;
    /// Colours of Kind::full, where they are guessed (stage_guess.hpp): color_value is at most the colour,
    /// and the colour at most a doubt more. Their projective planes exist when `project` is null; until then
    /// it makes them of the basis.
    struct Guess {
        /// The bits below a step of 5 or 6 bits, as top bits, from which on the doubt may reach the next one.
        std::uint32_t open5, open6;
        void (*project)(Span&);
        void doubt(std::uint32_t most) { // most > 0
            open5 = most >> 27 == 0 ? 0 - (most << 5) : 0;
            open6 = most >> 26 == 0 ? 0 - (most << 6) : 0;
        }
    } guess;
    std::int32_t fog_exponent; ///< fog_q / q * 2^fog_exponent = fog coordinate
    const void* pixels;        ///< Colors::of_pixels: those of pixel 0 and up, as DrawState::words says

    /// A plane at pixel `column`.
    template <class T>
    SPANGLE_RUN_CALL constexpr T at(std::int32_t column, const Interpolant<T>& plane) const {
        return plane.at(column + (x - anchor_x), y - anchor_y);
    }
};
#undef SPANGLE_OF_TEXTURES

} // namespace spangle::raster
