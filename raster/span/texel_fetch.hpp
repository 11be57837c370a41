// The words of the texels that the fragments of a packet meet, in lanes: formats are looked at once per
// packet.
#pragma once

#include "raster/span/instructions.hpp"
#include "raster/span/lane_texels.hpp"
#include "raster/span/texel_axis.hpp"
#include "raster/span/texel_other.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// One image and where the fragments of a packet look at it: at one texel, or at four.
class TexelFetch {
    using L = Lanes<8>;
    using U16 = L::U16;

  public:
    using Words = U16[4][texel_groups]; ///< R5 G6 B5
    using Bytes =
        LaneBytes[4][texel_groups]; ///< components of 8 bits, R lowest, whatever a format has of them

    /// Offsets are sums of products of 16 bits.
    static constexpr std::uint32_t stride_limit = 1u << 15;

    /// `first`: bytes from the texels of the image to those that a fragment looks at, null for 0.
    TexelFetch(const Texture& texture, const TextureLevel& image, const std::uint32_t* first, bool linear,
               const TexelNumbers& s, const TexelNumbers& t, std::int32_t groups)
        : texture_(texture), image_(image), first_(first), s_(s), t_(t), corners_(linear ? 4 : 1),
          groups_(groups),
          steps_(L::splat32(image.stride << 16 |
                            static_cast<std::uint32_t>(texel_bytes(sampled(texture.format))))) {}

    [[gnu::noinline]] void fetch(Words& to) const {
        if (is_indirect(texture_.format))
            return each_number([&](int corner, std::int32_t g, auto numbers) __attribute__((always_inline)) {
                to[corner][g] = L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                    const auto [s, t] = numbers(lane);
                    return static_cast<std::uint16_t>(Lanes<1>::load(palette_entry(texture_, image_, s, t)));
                });
            });
        each_place([&](int corner, std::int32_t g, auto place)
                       __attribute__((always_inline)) { to[corner][g] = two_bytes<2>(place); });
    }
    [[gnu::noinline]] void fetch(Bytes& to) const {
        const auto each = [&](auto bytes) __attribute__((always_inline)) {
            each_place([&](int corner, std::int32_t g, auto place)
                           __attribute__((always_inline)) { to[corner][g] = bytes(place); });
        };
        switch (sampled(texture_.format)) {
        case TexelFormat::a8:
            return each([](auto place) __attribute__((always_inline)) {
                return LaneBytes{L::splat(0xFFFF), byte(place, 0) << 8 | 0xFF};
            });
        case TexelFormat::l8:
            return each([](auto place) __attribute__((always_inline)) {
                const U16 l = byte(place, 0);
                return LaneBytes{l << 8 | l, l | 0xFF00};
            });
        case TexelFormat::i8:
            return each([](auto place) __attribute__((always_inline)) {
                const U16 i = byte(place, 0), both = i << 8 | i;
                return LaneBytes{both, both};
            });
        case TexelFormat::la88:
            return each([](auto place) __attribute__((always_inline)) {
                const U16 la = two_bytes<2>(place), l = la & 0xFF;
                return LaneBytes{l << 8 | l, la};
            });
        case TexelFormat::rgb888:
            return each([](auto place) __attribute__((always_inline)) {
                return LaneBytes{two_bytes<1>(place), byte(place, 2) | 0xFF00};
            });
        case TexelFormat::rgba8888:
            return each([](auto place) __attribute__((always_inline)) {
                const L::U32 word = L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                    return texel_word<TexelFormat::rgba8888>(
                        static_cast<const std::uint8_t*>(__builtin_assume_aligned(place(lane), 4)));
                });
                return LaneBytes::of(word);
            });
        default:
            if constexpr (has_other_texels)
                fetch_others(to);
        }
    }

  private:
    const Texture& texture_;
    const TextureLevel& image_;
    const std::uint32_t* const first_;
    const TexelNumbers &s_, &t_;
    const int corners_;
    const std::int32_t groups_;
    const LaneWords steps_; ///< bytes from texel to texel and from row to row

    /// f(corner, group, texels along s, texels along t)
    template <class F> SPANGLE_INLINE void each_group(F f) const {
        for (int corner = 0; corner < corners_; ++corner) {
            const U16* const s = (corner & 1) != 0 ? s_.next : s_.at;
            const U16* const t = (corner & 2) != 0 ? t_.next : t_.at;
            for (std::int32_t g = 0; g < groups_; ++g)
                f(corner, g, s[g], t[g]);
        }
    }
    /// f(corner, group, place(lane)), places of texels in memory.
    template <class F> SPANGLE_INLINE void each_place(F f) const {
        const std::uint8_t* const texels = image_.texels;
        each_group([&](int corner, std::int32_t g, const U16& s, const U16& t)
                       __attribute__((always_inline)) {
                           L::U32 offsets = lane_products_added(lane_joined(s, t), steps_);
                           if (first_ != nullptr)
                               offsets += L::gather(first_ + 8 * g);
                           std::int32_t offset[8];
                           L::store32(reinterpret_cast<std::uint8_t*>(offset), offsets);
                           // Through memory: GCC 12 would take lanes out of vectors, which is longer.
                           asm("" : "+m"(offset)); // NOLINT(hicpp-no-assembler)
                           const auto place = [&](std::uint32_t lane) __attribute__((always_inline)) {
                               return texels + offset[lane];
                           };
                           f(corner, g, place);
                       });
    }
    /// f(corner, group, numbers(lane)): what along s and along t.
    template <class F> SPANGLE_INLINE void each_number(F f) const {
        each_group([&](int corner, std::int32_t g, const U16& s,
                       const U16& t) __attribute__((always_inline)) {
            f(
                corner, g, [&](std::uint32_t lane) __attribute__((always_inline)) {
                    struct Numbers {
                        std::int32_t s, t;
                    };
                    return Numbers{static_cast<std::int16_t>(s[lane]), static_cast<std::int16_t>(t[lane])};
                });
        });
    }
    template <class Place> SPANGLE_INLINE static U16 byte(Place place, int n) {
        return L::generate([&](std::uint32_t lane)
                               __attribute__((always_inline)) { return std::uint16_t{place(lane)[n]}; });
    }
    template <int Aligned, class Place> SPANGLE_INLINE static U16 two_bytes(Place place) {
        return L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
            std::uint16_t v;
            __builtin_memcpy(&v, __builtin_assume_aligned(place(lane), Aligned), 2);
            return v;
        });
    }
    /// Palettes and blocks are found by numbers, other formats by bytes.
    [[gnu::noinline]] void fetch_others(Bytes& to) const {
        const auto words = [&](int corner, std::int32_t g, auto word) {
            to[corner][g] = LaneBytes::of(L::generate(word));
        };
        if (!is_indirect(texture_.format))
            return each_place([&](int corner, std::int32_t g, auto place) {
                words(corner, g, [&](std::uint32_t lane) { return word_4444(place(lane)); });
            });
        each_number([&](int corner, std::int32_t g, auto numbers) {
            words(corner, g, [&](std::uint32_t lane) {
                const auto [s, t] = numbers(lane);
                return other_word(texture_, image_, s, t);
            });
        });
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
