// A span is one row of one primitive, as set-up hands it to the stages. The numeric policy decides the types
// of the numbers.
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
/// Affine planes count modulo 2^32. Their words are unsigned, so that wrapping is defined:
/// - z: the depth code of 16 bits in the top bits, with half a code added; z24 has a code of 24 bits in the
///   top bits of 64;
/// - colours: 255ths in 8.24, with half an 8.8 step added, or half a 255th (Variant::color_bias);
/// - texture s, t: as TexCoords (number.hpp) describes;
/// - fog: s7.24.
///
/// Projective planes count modulo 2^64 in two's complement. They are 30-bit values with 16 guard bits below,
/// normalised per primitive.
struct Fixed {
    using Vertex = FixedVertex;
    using Affine = std::uint32_t;
    using Projective = std::uint64_t;
};

inline constexpr int guard_bits = 16;

/// Fraction bits of texture coordinates that do not wrap (TexCoords, number.hpp).
inline constexpr int clamped_coord_bits = 28;

/// A plane: its value at the centre of the anchor pixel, and its differences from pixel to pixel and from row
/// to row. at() multiplies, so no error accumulates and any pixel can be the first.
template <class T> struct Interpolant {
    T value, dx, dy;
    constexpr T at(std::int32_t columns, std::int32_t rows) const {
        if constexpr (sizeof(T) == 8 && !numeric::long_products)
            return value + numeric::times(dx, columns) + numeric::times(dy, rows);
        T start = value + static_cast<T>(columns) * dx;
        if constexpr (sizeof(T) == 4)
            start = numeric::factor32(start); // makes compilers use two multiply-accumulates
        return start + static_cast<T>(rows) * dy;
    }
};

/// The slopes of attributes over a primitive. Let d1 and d2 be the differences of an attribute from a
/// reference vertex to the two other vertices. Then d/dx = (d1 dx[0] + d2 dx[1]) 2^-exponent, and d/dy
/// likewise. All slopes share one exponent, and thin_aspect (setup.hpp) bounds the loss of the smaller
/// coefficients.
struct Coefficients {
    std::int32_t dx[2], dy[2];
    /// The way from the reference vertex to the centre of its pixel, also as factors of d1 and d2.
    std::int32_t center[2];
    int exponent;
};

/// The data from which planes of a primitive are made later, when a fragment asks for them.
struct Basis {
    const FixedVertex* v[3]; ///< reference vertices; the values of planes start at the first one
    Coefficients by;         ///< slopes for d1 = v1 - v0 and d2 = v2 - v0
    /// 1/w of the three vertices; the largest lies in [2^29, 2^30). Valid only where set-up has read it.
    std::int32_t q[3];
};

/// True where colours may be of Kind::full. Colours of the fast tier are affine where the build has neither a
/// chain nor a listed span of this kind (compile()). Planes that no listed span reads take no bytes.
inline constexpr bool has_full =
    has_perspective && (has_chain || tiers != 1u << static_cast<unsigned>(Tier::fast) || spans_of_full.some);

/// Declares planes of texture units as members of a span. In builds without texture units the macro makes
/// them static, so all spans share one place that no stage reads.
#if SPANGLE_TEXTURE_UNITS
#define SPANGLE_OF_TEXTURES(plane) plane
#else
#define SPANGLE_OF_TEXTURES(plane)                                                                           \
    static constinit inline plane {}
#endif

/// Pixel x of a span is column x of the primitive's row, counted from its unscissored left edge. Runs, lanes
/// and rounding are anchored there. So scissor, bands, lane width and integer translation change no byte
/// (docs/architecture/fragments.md, "Runs of texture coordinates").
template <class P> struct Span {
    /// Whether all planes exist. Planes that no span of this build reads share one place: an array of one
    /// plane, or one place for all spans.
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
    std::int32_t anchor_x, anchor_y; ///< window position of the pixel at which planes have their `value`
    Kind kind;
    bool gray; ///< colours are gray: red stands for green and blue, too (Variant::gray)
    /// Column, modulo 4, of the fragment from which fused lists count. It is set only where fused lists
    /// dither.
    std::uint8_t dither_column;
    std::uint32_t flat_word; ///< the colour of Kind::flat, as a 16-bit surface stores it

    Basis basis;
    Affine z; ///< the depth plane of depth buffers of 16 bits
    struct NoPlane {};
    /// The depth plane of depth buffers of 24 bits. It has 40 bits below the code and is off by less than
    /// half a code anywhere.
    [[no_unique_address]] std::conditional_t<!all && has_format(DepthFormat::z24s8),
                                             Interpolant<std::uint64_t>, NoPlane>
        z24;
    Affine color_value[4];         ///< planes of R, G, B and A
    Affine secondary[secondaries]; ///< planes of R, G and B
    Affine fog;
    /// The fog coordinates of all fragments lie in [0, 1). Set-up finds this out only in builds with lanes.
    bool fog_inside;
    SPANGLE_OF_TEXTURES(Affine s[max_texture_units]);
    SPANGLE_OF_TEXTURES(Affine t[max_texture_units]);

    Projective q;                      ///< 1/w, > 0; its largest value at a vertex lies in [2^29, 2^30)
    Projective color_q[colors_over_w]; ///< colour * 1/w
    Projective secondary_q[secondaries];
    Projective fog_q;
    struct Unit {
        /// The planes of s/w and t/w. Where coordinates are affine, only dx is set, for the level of detail.
        Projective s, t;
        Projective q;                            ///< q/w; not written when `shares_q`
        typename P::Projective s_dy, t_dy, q_dy; ///< differences from row to row, for the level of detail
        std::int32_t exponent; ///< (s/w) / (q/w) * 2^exponent is s in repeats of the texture
        /// Whole repeats that were taken off before interpolation. Wrap modes that clamp add them back.
        std::int32_t s_base, t_base;
        bool shares_q = true; ///< q is 1 at every vertex, and Span::q serves this unit
        Projective r;         ///< r/w; set only where Needs::r is set
        typename P::Projective r_dy;
    };
    SPANGLE_OF_TEXTURES(Unit unit[max_texture_units]);
    typename P::Projective q_dy;
    /// The guess of colours of Kind::full (stage_guess.hpp). color_value is at most the exact colour, which
    /// is at most one doubt more. Where `project` is not null, the projective planes of colours do not exist
    /// yet, and `project` makes them from `basis`.
    struct ColorGuess {
        /// The limits from which on the doubt may reach the next step. They are compared with the bits of a
        /// component below a step of 5 or 6 bits, shifted to the top.
        std::uint32_t doubt5, doubt6;
        void (*project)(Span&);
        void doubt(std::uint32_t most) { // `most` must be above 0
            doubt5 = most >> 27 == 0 ? 0 - (most << 5) : 0;
            doubt6 = most >> 26 == 0 ? 0 - (most << 6) : 0;
        }
    } guess;
    std::int32_t fog_exponent; ///< fog_q / q * 2^fog_exponent is the fog coordinate
    /// Colors::of_pixels: the colours from pixel 0 on, in the form that DrawState::words says.
    const void* pixels;

    /// The value of a plane at pixel `column`.
    template <class T>
    SPANGLE_RUN_CALL constexpr T at(std::int32_t column, const Interpolant<T>& plane) const {
        return plane.at(column + (x - anchor_x), y - anchor_y);
    }
};
#undef SPANGLE_OF_TEXTURES

} // namespace spangle::raster
