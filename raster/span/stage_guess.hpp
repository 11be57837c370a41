// Perspective-correct colour of the exact tier where nothing but its top bits is stored: these are those of
// the affine colour unless a step lies between the two.
#pragma once

#include "raster/span/rows.hpp"
#include "raster/span/stage_color.hpp"
#include "raster/span/stage_raw.hpp"

namespace spangle::raster {

/// The colour of the fragment at window (x, y), divided: what GouraudQ<Exact, false> gives, as it is stored.
std::uint32_t divided_word(Span<Fixed>& span, std::int32_t x, std::int32_t y);

/// Span::guess says by how much the affine colour may be below. Eight lanes leave it to others to divide
/// (Px::open, divide_open): a loop that calls keeps nothing in registers.
template <int Count> struct GouraudGuessed : Gouraud<Raw565<Count>, false> {
    using N = Raw565<Count>;
    using L = typename N::L;
    const PlaneRow& row;
    typename L::U32 doubt;

    SPANGLE_INLINE GouraudGuessed(const PlaneRow& at, std::int32_t x)
        : Gouraud<N, false>(at, x), row(at), doubt(L::splat32(at.planes.guess.doubt)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        Gouraud<N, false>::operator()(p);
        // Bits that a step of 5 or 6 bits changes.
        const typename L::U32 red_blue = changes(this->r.at) | changes(this->b.at),
                              green = changes(this->g.at);
        const typename L::U16 steps =
            (L::high_half(red_blue) & L::splat(0xF800)) | (L::high_half(green) & L::splat(0xFC00));
        if constexpr (Count == 1) {
            if (steps != 0) [[unlikely]]
                p.color.word = divided_word(row.planes, row.counted_from + p.i, row.y);
        } else {
            p.open = ~L::equal(steps, L::splat(0));
        }
        return true;
    }

  private:
    SPANGLE_INLINE typename L::U32 changes(const typename L::U32& v) const { return (v + doubt) ^ v; }
};

/// Writes the colours of those lanes of eight fragments, from column x on, that a guess left open.
template <PixelFormat Format>
[[gnu::noinline]] void divide_open(Span<Fixed>& span, std::uint8_t* color, const Lanes<8>::Mask& open,
                                   std::int32_t x, std::int32_t y) {
    using One = StoreRaw<1, Format>;
    for (int half = 0; half < 2; ++half)
        for (std::uint64_t left = Lanes<8>::half(open, half); left != 0;) {
            const int bit = std::countr_zero(left), i = 4 * half + bit / 16;
            left &= ~(std::uint64_t{0xFFFF} << bit);
            const std::uint32_t word = divided_word(span, x + i, y);
            Lanes<1>::store(color + 2 * i, One::swaps ? Lanes<1>::swap_bytes(word) : word);
        }
}

} // namespace spangle::raster
