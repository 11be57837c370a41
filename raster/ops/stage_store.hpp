// The last stages of most lists: a colour becomes the bits of a pixel (docs/architecture/numbers.md,
// "Colours").
#pragma once

#include <cstring>

#include "raster/ops/stage_thresholds.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"
#include "raster/surface/quantize.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Loads and stores 16-bit words of a surface R5 G6 B5. A loaded or given word is in the byte order of the
/// host.
template <class L, PixelFormat Format> struct Words565 {
    static constexpr bool swaps =
        (Format == PixelFormat::rgb565_be) == (std::endian::native == std::endian::little);
    SPANGLE_INLINE static typename L::U16 load(const std::uint8_t* at) {
        const typename L::U16 word = L::load(at);
        return swaps ? L::swap_bytes(word) : word;
    }
    /// The word in the byte order of the surface.
    SPANGLE_INLINE static typename L::U16 to_wire_order(typename L::U16 word) {
        return swaps ? L::swap_bytes(word) : word;
    }
    /// Loads one word into both halves of 32 bits. Only lists of one lane call this.
    SPANGLE_INLINE static std::uint32_t load_both(const std::uint8_t* at) {
        const std::uint32_t word = L::load(at), other = swaps ? __builtin_bswap32(word) : word << 16;
        return other | (swaps ? other >> 16 : word);
    }
    SPANGLE_INLINE static void store(std::uint8_t* at, typename L::U16 word) {
        L::store(at, to_wire_order(word));
    }
    /// Stores the words of live lanes. Memory under the other lanes keeps its value.
    SPANGLE_INLINE static void store_where(typename L::Mask live, std::uint8_t* at, typename L::U16 word) {
        L::store(at, L::select(live, to_wire_order(word), L::load(at)));
    }
};

/// Pixels of three or four components of 8 bits, in lanes. A lane is a word with R in the lowest byte. A
/// pixel has `Bytes` bytes in memory.
template <class L, int Bytes> struct Bytes888 {
    SPANGLE_INLINE static typename L::U32 load(const std::uint8_t* at) {
        if constexpr (Bytes == 4)
            return L::load32(at);
        else
            return L::generate([at](std::uint32_t lane) __attribute__((always_inline)) {
                const std::uint8_t* const p = at + static_cast<int>(lane) * Bytes;
                return p[0] | std::uint32_t{p[1]} << 8 | std::uint32_t{p[2]} << 16;
            });
    }
    SPANGLE_INLINE static void store_where(const typename L::Mask& live, std::uint8_t* at,
                                           const typename L::U32& word) {
        if constexpr (Bytes == 4)
            return L::store32(at, L::select(live, word, L::load32(at)));
        for (int lane = 0; lane < L::count; ++lane)
            if (L::lane(live, lane))
                store_one(at + Bytes * lane, word.lane(lane));
    }
    /// The components of a colour as a word in this form. Alpha is left out of pixels with three bytes.
    template <class N> SPANGLE_INLINE static typename L::U32 pack(const typename N::Color& c) {
        const auto byte = [](const typename N::T& v) { return L::widened(N::to8(v)); };
        const auto rgb = byte(c.r) | byte(c.g) << 8 | byte(c.b) << 16;
        return Bytes == 4 ? rgb | byte(c.a) << 24 : rgb;
    }

  private:
    SPANGLE_INLINE static void store_one(std::uint8_t* at, std::uint32_t word) {
        for (int i = 0; i < Bytes; ++i)
            at[i] = static_cast<std::uint8_t>(word >> (8 * i));
    }
};

/// Reads the components of pixels as Bytes888 describes them, one component at a time. With one lane each
/// component is a byte of memory.
template <class L, int Bytes> class Components888 {
  public:
    SPANGLE_INLINE explicit Components888(const std::uint8_t* at) : word_(Bytes888<L, Bytes>::load(at)) {}
    SPANGLE_INLINE typename L::U16 of(int n) const { return L::byte(word_, n); }

  private:
    typename L::U32 word_;
};
template <int Bytes> class Components888<Lanes<1>, Bytes> {
  public:
    SPANGLE_INLINE explicit Components888(const std::uint8_t* at) : at_(at) {}
    SPANGLE_INLINE std::uint32_t of(int n) const { return at_[n < Bytes ? n : 0]; }

  private:
    const std::uint8_t* at_;
};

/// Joins 5, 6 and 5 bits of the components to one word. Without dithering these bits are the top bits of
/// components rounded to 8 bits.
template <class N>
SPANGLE_INLINE typename N::L::U16 pack565(typename N::L::U16 r5, typename N::L::U16 g6,
                                          typename N::L::U16 b5) {
    return (r5 << 11) | (g6 << 5) | b5;
}
template <class N> SPANGLE_INLINE typename N::L::U16 truncated565(const typename N::Color& c) {
    if constexpr (is_balanced<N>) // components are rounded and cut in place
        return ((c.r + 128) & 0xF800) | (((c.g + 128) >> 5) & 0x07E0) | ((c.b + 128) >> 11);
    return ((N::to8(c.r) & 0xF8) << 8) | ((N::to8(c.g) & 0xFC) << 3) | (N::to8(c.b) >> 3);
}
/// The dithered word of one colour. The threshold is in 32nds of a step.
template <class N>
SPANGLE_INLINE typename N::L::U16 dithered565(const typename N::Color& c, typename N::L::U16 threshold32) {
    return pack565<N>(N::template dithered<5>(c.r, threshold32), N::template dithered<6>(c.g, threshold32),
                      N::template dithered<5>(c.b, threshold32));
}
/// The dithered words of colours in lanes. Thresholds have the form of N::Threshold.
template <class N>
SPANGLE_INLINE typename N::L::U16 dithered565_lanes(const typename N::Color& c,
                                                    typename N::L::U16 threshold) {
    return Raw565<N::lanes>::word({N::template tops<5>(c.r, threshold), N::template tops<6>(c.g, threshold),
                                   N::template tops<5>(c.b, threshold)})
        .word;
}
/// The dithered word of components in steps (Balanced::in_steps). The threshold is a fraction of a step of
/// five bits, and the step is 2^10.
template <class N>
SPANGLE_INLINE typename N::L::U16 steps565(const typename N::Color& c, typename N::L::U16 threshold) {
    const typename N::L::U16 r = c.r + threshold, g = c.g + (threshold >> 1), b = c.b + threshold;
    return ((r & 0x7C00) << 1) | ((g >> 4) & 0x07E0) | (b >> 10);
}

/// Stores colours without dithering, in all channels.
template <class N, PixelFormat Format> struct Store : StageBase {
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using L = typename N::L;
    static constexpr bool anywhere = true;
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
            if constexpr (N::lanes > 1) {
                using Words = Bytes888<L, bytes>;
                Words::store_where(p.live, at, Words::template pack<N>(p.color));
            } else {
                at[0] = static_cast<std::uint8_t>(N::to8(p.color.r));
                at[1] = static_cast<std::uint8_t>(N::to8(p.color.g));
                at[2] = static_cast<std::uint8_t>(N::to8(p.color.b));
                if constexpr (bytes == 4)
                    at[3] = static_cast<std::uint8_t>(N::to8(p.color.a));
            }
        }
        return true;
    }
};

/// Stores colours with ordered dithering by window coordinates (GL 1.3, 4.1.8). Components of 8 bits are
/// stored without dithering.
template <class N, PixelFormat Format> struct StoreDithered : Store<N, Format> {
    using L = typename N::L;
    static constexpr bool anywhere = !is_565(Format);
    using Thresholds = inner::ThresholdsOf<N>;
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
            // begin_here() keeps compilers from loading thresholds and factors earlier, where they would take
            // registers.
            if constexpr (N::lanes == 1 && numeric::three_operands)
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

/// Stores dithered colours whose components are counted in steps (counts_steps()).
template <class N, PixelFormat Format> struct StoreSteps : StageBase {
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using L = typename N::L;
    inner::DitherRow<L> dither;
    template <class S> SPANGLE_INLINE StoreSteps(const S& s, std::int32_t x) : dither(s.x + x, s.y) {}
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        dither = inner::DitherRow<L>(s.x + x, s.y);
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

/// Merges a colour with stored bits by a logical operation, and writes only the bits of a mask (GL 1.3,
/// 4.1.9, 4.2.2).
struct LogicTable {
    /// Entry i is all ones where the operation gives 1. Entries 0 to 3 are for the colour's bit and the
    /// stored bit 11, 10, 01 and 00.
    std::uint32_t truth[4];
    explicit LogicTable(const FragmentState& state) {
        const auto op = static_cast<unsigned>(state.logic ? state.logic_op : LogicOp::copy);
        for (unsigned i = 0; i < 4; ++i)
            truth[i] = 0u - (op >> i & 1u);
    }
    /// Merges the colour's bits `s` with the stored bits `d` where `bits` has ones. The other bits are those
    /// of `d`.
    std::uint32_t merged(std::uint32_t s, std::uint32_t d, std::uint32_t bits) const {
        return merged(s, d, bits, truth);
    }
    /// Does what merged() above does, for words in lanes. `of` holds each entry of `truth` in all lanes.
    template <class Word>
    SPANGLE_INLINE static Word merged(const Word& s, const Word& d, const Word& bits, const Word (&of)[4]) {
        const Word result = (of[0] & s & d) | (of[1] & s & ~d) | (of[2] & ~s & d) | (of[3] & ~s & ~d);
        return (result & bits) | (d & ~bits);
    }
};

/// LogicTable::merged() with its constants taken together for one lane: each bit of the result is a
/// polynomial of the bits s and d, over exclusive or.
struct MergedWords {
    std::uint32_t always, by_color, by_stored, by_both;
    MergedWords(const LogicTable& logic, std::uint32_t bits) {
        const auto& t = logic.truth;
        always = t[3] & bits;
        by_color = (t[1] ^ t[3]) & bits;
        by_stored = ((t[2] ^ t[3]) & bits) | ~bits;
        by_both = (t[0] ^ t[1] ^ t[2] ^ t[3]) & bits;
    }
    SPANGLE_INLINE std::uint32_t of(std::uint32_t s, std::uint32_t d) const {
        return always ^ (by_color & s) ^ ((by_stored ^ (by_both & s)) & d);
    }
};

/// Stores the result of the logical operation with the stored bits. Masked channels keep their bits. Dithers
/// when the state says so (GL 1.3, 4.1.9, 4.2.2).
template <class N, PixelFormat Format> struct StoreMerged : StageBase {
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using L = typename N::L;
    static constexpr int bytes = format_info(Format).bytes_per_pixel;
    inner::DitherRow<L> dither;
    bool dithers;
    std::uint32_t open[4]; ///< all ones where a channel is written
    LogicTable logic;
    template <class S>
    SPANGLE_INLINE StoreMerged(const S& s, std::int32_t x)
        : dither(s.x + x, s.y), dithers(s.state->fragment.dither), logic(s.state->fragment) {
        for (unsigned i = 0; i < 4; ++i)
            open[i] = 0u - (s.state->fragment.color_mask >> i & 1u);
    }

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto& c = p.color;
        std::uint8_t* const at = p.color_plane + bytes * p.i;
        if constexpr (N::lanes > 1) {
            store_lanes(p.live, at, c);
        } else if constexpr (is_565(Format)) {
            const MergedWords merged(logic, open_565());
            const std::uint32_t word = dithers ? dithered565<N>(c, dither.threshold()) : truncated565<N>(c);
            Words565<L, Format>::store(at, merged.of(word, Words565<L, Format>::load(at)));
        } else {
            const MergedWords merged(logic, open_bytes());
            std::uint32_t word = N::to8(c.r) | N::to8(c.g) << 8 | N::to8(c.b) << 16, stored = 0;
            if constexpr (bytes == 4)
                word |= N::to8(c.a) << 24;
            for (int i = 0; i < bytes; ++i)
                stored |= std::uint32_t{at[i]} << (8 * i);
            word = merged.of(word, stored);
            for (int i = 0; i < bytes; ++i)
                at[i] = static_cast<std::uint8_t>(word >> (8 * i));
        }
        return true;
    }
    SPANGLE_INLINE void step() { dither.step(); }

  private:
    SPANGLE_INLINE std::uint32_t open_565() const {
        return (open[0] & 0xF800) | (open[1] & 0x07E0) | (open[2] & 0x1F);
    }
    SPANGLE_INLINE std::uint32_t open_bytes() const {
        return (open[0] & 0xFF) | (open[1] & 0xFF00) | (open[2] & 0xFF0000) | (open[3] & 0xFF000000);
    }
    template <class Word, class Splat>
    SPANGLE_INLINE Word merged(const Word& s, const Word& d, Word bits, Splat splat) const {
        const Word truth[4] = {splat(logic.truth[0]), splat(logic.truth[1]), splat(logic.truth[2]),
                               splat(logic.truth[3])};
        return LogicTable::merged(s, d, bits, truth);
    }
    SPANGLE_INLINE void store_lanes(const typename L::Mask& live, std::uint8_t* at,
                                    const typename N::Color& c) const {
        if constexpr (is_565(Format)) {
            using Words = Words565<L, Format>;
            const auto word = dithers ? pack565<N>(N::template dithered<5>(c.r, dither.threshold()),
                                                   N::template dithered<6>(c.g, dither.threshold()),
                                                   N::template dithered<5>(c.b, dither.threshold()))
                                      : truncated565<N>(c);
            Words::store_where(live, at, merged(word, Words::load(at), L::splat(open_565()), &L::splat));
        } else {
            using Words = Bytes888<L, bytes>;
            Words::store_where(
                live, at,
                merged(Words::template pack<N>(c), Words::load(at), L::splat32(open_bytes()), &L::splat32));
        }
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
