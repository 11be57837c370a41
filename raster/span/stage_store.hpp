// The end of every list: a colour becomes bits of the surface (docs/architecture.md, "Numbers").
#pragma once

#include <cstring>

#include "raster/span/draw_state.hpp"
#include "raster/span/stage_thresholds.hpp"
#include "raster/surface/quantize.hpp"

namespace spangle::raster {

/// 16-bit words of a 565 surface, host order.
template <class L, PixelFormat Format> struct Words565 {
    static constexpr bool swaps =
        (Format == PixelFormat::rgb565_be) == (std::endian::native == std::endian::little);
    SPANGLE_INLINE static typename L::U16 load(const std::uint8_t* at) {
        const typename L::U16 word = L::load(at);
        return swaps ? L::swap_bytes(word) : word;
    }
    /// As it lies in memory.
    SPANGLE_INLINE static typename L::U16 ordered(typename L::U16 word) {
        return swaps ? L::swap_bytes(word) : word;
    }
    /// The word in both halves of one of 32 bits. One lane.
    SPANGLE_INLINE static std::uint32_t load_both(const std::uint8_t* at) {
        const std::uint32_t word = L::load(at), other = swaps ? __builtin_bswap32(word) : word << 16;
        return other | (swaps ? other >> 16 : word);
    }
    SPANGLE_INLINE static void store(std::uint8_t* at, typename L::U16 word) { L::store(at, ordered(word)); }
    /// Other lanes keep what they hold.
    SPANGLE_INLINE static void store_where(typename L::Mask live, std::uint8_t* at, typename L::U16 word) {
        L::store(at, L::select(live, ordered(word), L::load(at)));
    }
};

/// 5, 6 and 5 bits of a colour in one word; without dither the top bits of the rounded 8-bit value.
template <class N>
SPANGLE_INLINE typename N::L::U16 pack565(typename N::L::U16 r5, typename N::L::U16 g6,
                                          typename N::L::U16 b5) {
    return (r5 << 11) | (g6 << 5) | b5;
}
template <class N> SPANGLE_INLINE typename N::L::U16 truncated565(const typename N::Color& c) {
    if constexpr (is_balanced<N>) // rounded, and cut where it lies
        return ((c.r + 128) & 0xF800) | (((c.g + 128) >> 5) & 0x07E0) | ((c.b + 128) >> 11);
    return ((N::to8(c.r) & 0xF8) << 8) | ((N::to8(c.g) & 0xFC) << 3) | (N::to8(c.b) >> 3);
}
/// One lane; thresholds in 32nds.
template <class N>
SPANGLE_INLINE typename N::L::U16 dithered565(const typename N::Color& c, typename N::L::U16 threshold32) {
    return pack565<N>(N::template dithered<5>(c.r, threshold32), N::template dithered<6>(c.g, threshold32),
                      N::template dithered<5>(c.b, threshold32));
}
/// The word of N::Threshold.
template <class N>
SPANGLE_INLINE typename N::L::U16 dithered565_lanes(const typename N::Color& c,
                                                    typename N::L::U16 threshold) {
    return Raw565<N::lanes>::word({N::template tops<5>(c.r, threshold), N::template tops<6>(c.g, threshold),
                                   N::template tops<5>(c.b, threshold)})
        .word;
}
/// Of components counted in steps (Balanced::in_steps), thresholds in those of five bits.
template <class N>
SPANGLE_INLINE typename N::L::U16 steps565(const typename N::Color& c, typename N::L::U16 threshold) {
    const typename N::L::U16 r = c.r + threshold, g = c.g + (threshold >> 1), b = c.b + threshold;
    return ((r & 0x7C00) << 1) | ((g >> 4) & 0x07E0) | (b >> 10);
}

/// Dithering off, all channels written.
template <class N, PixelFormat Format> struct Store : StageBase {
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using L = typename N::L;
    template <class S> SPANGLE_INLINE Store(const S&, std::int32_t) {}

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (is_565(Format)) {
            std::uint8_t* const at = p.color_plane + p.bytes();
            const typename L::U16 word = truncated565<N>(p.color);
            if constexpr (N::lanes > 1)
                Words565<L, Format>::store_where(p.live, at, word);
            else
                Words565<L, Format>::store(at, word);
        } else {
            constexpr int bytes = format_info(Format).bytes_per_pixel;
            std::uint8_t* const at = p.color_plane + bytes * p.i;
            at[0] = static_cast<std::uint8_t>(N::to8(p.color.r));
            at[1] = static_cast<std::uint8_t>(N::to8(p.color.g));
            at[2] = static_cast<std::uint8_t>(N::to8(p.color.b));
            if constexpr (bytes == 4)
                at[3] = static_cast<std::uint8_t>(N::to8(p.color.a));
        }
        return true;
    }
};

/// Ordered dithering on window coordinates (GL 1.3, 4.1.10); components of 8 bits are stored as they are.
template <class N, PixelFormat Format> struct StoreDithered : Store<N, Format> {
    using L = typename N::L;
    using Thresholds = detail::ThresholdsOf<N>;
    Thresholds dither;
    template <class S>
    SPANGLE_INLINE StoreDithered(const S& s, std::int32_t x) : Store<N, Format>(s, x), dither(s.x + x, s.y) {}
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        dither = Thresholds(s.x + x, s.y);
    }

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (!is_565(Format)) {
            return Store<N, Format>::operator()(p);
        } else {
            std::uint8_t* const at = p.color_plane + p.bytes();
            if constexpr (N::lanes == 1 && numeric::three_operands) // thresholds and factors take registers
                numeric::begin_here();
            if constexpr (N::lanes > 1)
                Words565<L, Format>::store_where(p.live, at, dithered565_lanes<N>(p.color, dither.word(0)));
            else
                Words565<L, Format>::store(at, dithered565<N>(p.color, dither.threshold()));
            return true;
        }
    }
    SPANGLE_INLINE void step() { dither.step(); }
};

/// The same of what is counted in steps (counts_steps()).
template <class N, PixelFormat Format> struct StoreSteps : StageBase {
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using L = typename N::L;
    detail::DitherRow<L> dither;
    template <class S> SPANGLE_INLINE StoreSteps(const S& s, std::int32_t x) : dither(s.x + x, s.y) {}
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        dither = detail::DitherRow<L>(s.x + x, s.y);
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        std::uint8_t* const at = p.color_plane + p.bytes();
        const typename L::U16 word = steps565<N>(p.color, dither.threshold() << 5);
        if constexpr (N::lanes > 1)
            Words565<L, Format>::store_where(p.live, at, word);
        else
            Words565<L, Format>::store(at, word);
        return true;
    }
    SPANGLE_INLINE void step() { dither.step(); }
};

/// A logical operation on stored bits, and those that stay (GL 1.3, 4.1.9, 4.2.2).
struct LogicTable {
    std::uint32_t truth[4]; ///< all ones where it gives 1: of both, the colour, the stored, neither
    explicit LogicTable(const FragmentState& state) {
        const auto op = static_cast<unsigned>(state.logic ? state.logic_op : LogicOp::copy);
        for (unsigned i = 0; i < 4; ++i)
            truth[i] = 0u - (op >> i & 1u);
    }
    /// The colour's bits `s` over the stored `d`, where `bits` has ones.
    std::uint32_t merged(std::uint32_t s, std::uint32_t d, std::uint32_t bits) const {
        const std::uint32_t result =
            (truth[0] & s & d) | (truth[1] & s & ~d) | (truth[2] & ~s & d) | (truth[3] & ~s & ~d);
        return (result & bits) | (d & ~bits);
    }
};

/// Bits come from the logical operation with what is stored, or stay, where a channel is masked; dithers when
/// the state says so (GL 1.3, 4.1.9, 4.2.2).
template <class N, PixelFormat Format> struct StoreMerged : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using L = typename N::L;
    detail::DitherRow<L> dither;
    bool dithers;
    std::uint32_t open[4]; ///< all ones where a channel is written
    LogicTable logic;
    SPANGLE_INLINE StoreMerged(const Span<typename N::Policy>& s, std::int32_t x)
        : dither(s.x + x, s.y), dithers(s.state->fragment.dither), logic(s.state->fragment) {
        for (unsigned i = 0; i < 4; ++i)
            open[i] = 0u - (s.state->fragment.color_mask >> i & 1u);
    }

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto& c = p.color;
        if constexpr (is_565(Format)) {
            std::uint8_t* const at = p.color_plane + p.bytes();
            const std::uint32_t bits = (open[0] & 0xF800) | (open[1] & 0x07E0) | (open[2] & 0x1F);
            const std::uint32_t word = dithers ? dithered565<N>(c, dither.threshold()) : truncated565<N>(c);
            Words565<L, Format>::store(at, logic.merged(word, Words565<L, Format>::load(at), bits));
        } else {
            constexpr int bytes = format_info(Format).bytes_per_pixel;
            std::uint8_t* const at = p.color_plane + bytes * p.i;
            const typename N::T channel[4] = {c.r, c.g, c.b, c.a};
            for (int i = 0; i < bytes; ++i)
                at[i] = static_cast<std::uint8_t>(logic.merged(N::to8(channel[i]), at[i], open[i]));
        }
        return true;
    }
    SPANGLE_INLINE void step() { dither.step(); }
};

} // namespace spangle::raster
