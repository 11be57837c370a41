// Perspective-correct colour of the exact tier on surfaces that store only its top bits. The affine colour
// has the same top bits, unless a step of these bits lies between the two colours.
#pragma once

#include "raster/ops/stage_dithered.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The stored word of the divided colour at window position (x, y). It is the word that GouraudQ<Exact,
/// false> leads to.
std::uint32_t divided_word(Span<Fixed>& span, std::int32_t x, std::int32_t y);

/// Colours that are guessed from the affine colour. Span::guess says where a step may lie between the affine
/// colour and the divided colour. Eight lanes look at 16 bits of the colour and leave divisions to
/// divide_open(): a loop that calls functions keeps nothing in registers. The lanes that need a division are
/// told in Px::open. Dithered colours are counted in steps (Variant::steps). A threshold moves the affine and
/// the divided colour by the same amount.
template <int Count, bool Dither>
using GuessedTops =
    GouraudTops<Count, std::conditional_t<Dither, RowFractions<Count>, NoFractions<Raw565<Count>>>>;
template <int Count, bool Dither> struct GouraudGuessed : GuessedTops<Count, Dither> {
    using N = Raw565<Count>;
    using L = typename N::L;

    template <class S>
    SPANGLE_INLINE GouraudGuessed(const S& at, std::int32_t x)
        : GuessedTops<Count, Dither>(at, x), current_row_{at}, limit_(at.planes.guess) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::Tops v = this->tops(p);
        if constexpr (Count == 1) {
            if (v.r << 5 >= limit_.doubt5 || v.g << 6 >= limit_.doubt6 || v.b << 5 >= limit_.doubt5)
                [[unlikely]] {
                p.color.word = divided_word(current_row_.row.planes, current_row_.row.dither_column + p.i,
                                            current_row_.row.y);
                return true;
            }
        } else {
            p.open = limit_.reached(v);
        }
        p.color = Dither ? N::joined(v) : N::word(v);
        return true;
    }

  private:
    /// The place of the fragment: with one lane the stage calls divided_word() at once, and needs window
    /// coordinates.
    struct RowPosition {
        const PlaneRow& row;
    };
    struct NoPosition {
        template <class S> SPANGLE_INLINE explicit NoPosition(const S&) {}
    };
    [[no_unique_address]] std::conditional_t<Count == 1, RowPosition, NoPosition> current_row_;
    /// The test in eight lanes. Ones in place of the step bits make a component a negative half-word: minus
    /// what it lacks of the next step. Steps of five bits and of six bits have the same doubt.
    class MissingToNextStep {
      public:
        SPANGLE_INLINE explicit MissingToNextStep(const Span<Fixed>::ColorGuess& guess)
            : lane_limit_(L::splat((guess.doubt5 >> (16 + 5)) - (1u << (16 - 5)) - 1)) {}
        SPANGLE_INLINE typename L::Mask reached(const typename N::Tops& v) const {
            const typename L::U16 five = L::maximum_signed(v.r | rest(5), v.b | rest(5)),
                                  least = L::maximum_signed(five, v.g | rest(6));
            return L::less_signed(lane_limit_, least);
        }

      private:
        SPANGLE_INLINE static std::uint16_t rest(int bits) {
            return static_cast<std::uint16_t>(0xFFFF0000u >> bits);
        }
        typename L::U16 lane_limit_;
    };
    std::conditional_t<Count == 1, Span<Fixed>::ColorGuess, MissingToNextStep> limit_;
};

/// Divides and stores the colours of the open lanes of eight fragments. The first fragment is at window
/// position (x, y).
template <PixelFormat Format, class L = Lanes<8>>
[[gnu::noinline]] void divide_open(Span<Fixed>& span, typename L::Place color, const Lanes<8>::Mask& open,
                                   std::int32_t x, std::int32_t y) {
    each_open(open, [&](int i) {
        const std::uint32_t word = divided_word(span, x + i % L::columns, y + i / L::columns);
        Words565<Lanes<1>, Format>::store(L::pixel(color, i, 2), word);
    });
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
