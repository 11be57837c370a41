// Perspective-correct colour of the exact tier where only its top bits are stored. They are the top bits of
// the affine colour, unless a step lies between the two colours.
#pragma once

#include "raster/ops/stage_dithered.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The stored word of the divided colour at window (x, y), which is what GouraudQ<Exact, false> gives.
std::uint32_t divided_word(Span<Fixed>& span, std::int32_t x, std::int32_t y);

/// Span::guess says where a step may lie between the affine colour and the divided one. Eight lanes look at
/// sixteen bits of the colour and leave division to other code (Px::open, divide_open), because a loop that
/// calls functions keeps nothing in registers. Dithered colours are counted in steps (Variant::steps), and a
/// threshold moves both colours.
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
    /// With one lane the stage divides at once, and must know where it is.
    struct RowPosition {
        const PlaneRow& row;
    };
    struct NoPosition {
        template <class S> SPANGLE_INLINE explicit NoPosition(const S&) {}
    };
    [[no_unique_address]] std::conditional_t<Count == 1, RowPosition, NoPosition> current_row_;
    /// The test in eight lanes. A component with ones in place of its step bits, negated, is what it lacks of
    /// the next step. The doubt is the same for steps of five bits and of six.
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

/// Divides and stores the colours of the open lanes of eight fragments, the first of which is at (x, y).
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
