// Lists whose colour is 16 bits from its source to the surface: the two ends of them.
#pragma once

#include "raster/span/stage.hpp"

namespace spangle::raster {

/// One colour for the whole primitive.
template <int Count> struct FlatWord : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<Count>;
    typename N::T word;
    template <class S> SPANGLE_INLINE FlatWord(const S& s, std::int32_t) : word(N::L::splat(s.flat_word)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = word;
        return true;
    }
};

/// The word in the byte order of the surface.
template <int Count, PixelFormat Format> struct StoreRaw : StageBase {
    static_assert(Format == PixelFormat::rgb565_be || Format == PixelFormat::rgb565_le);
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using N = Raw565<Count>;
    using L = typename N::L;
    static constexpr bool swaps =
        (Format == PixelFormat::rgb565_be) == (std::endian::native == std::endian::little);
    template <class S> SPANGLE_INLINE StoreRaw(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        std::uint8_t* const at = p.color_plane + 2 * p.i;
        typename L::U16 word = p.color.word;
        if constexpr (swaps)
            word = L::swap_bytes(word);
        if (Count > 1 || p.selects)
            word = L::select(p.live, word, L::load(at));
        L::store(at, word);
        return true;
    }
};

} // namespace spangle::raster
