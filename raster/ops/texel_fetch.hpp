// Fetches the words of the texels that the fragments of a packet meet, in lanes. The format is looked at once
// per packet.
#pragma once

#include "raster/ops/lane_texels.hpp"
#include "raster/ops/texel_axis.hpp"
#include "raster/ops/texel_other.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// One image, and the places of a packet's fragments in it: one texel or four texels each.
class TexelFetch {
    using L = Lanes<8>;
    using U16 = L::U16;
    using U32 = L::U32;

  public:
    using Words = U16[4][texel_groups]; ///< words R5 G6 B5, or words of TexelWords::colors
    /// Components of 8 bits, with R in the lowest byte. Missing components are filled in.
    using Bytes = LaneBytes[4][texel_groups];

    /// Strides must be below this limit, because offsets are sums of 16-bit products.
    static constexpr std::uint32_t stride_limit = 1u << 15;

    /// `first` holds, for each fragment, an offset in bytes that is added to the address of the image. Null
    /// stands for offsets of 0.
    TexelFetch(const Texture& texture, const TextureLevel& image, const std::uint32_t* first, bool linear,
               const TexelNumbers& s, const TexelNumbers& t, std::int32_t groups)
        : texture_(texture), image_(image), first_texel_(first), s_(s), t_(t), texel_count_(linear ? 4 : 1),
          group_count_(groups),
          texel_steps_(L::splat32(image.stride << 16 |
                                  static_cast<std::uint32_t>(texel_bytes(sampled(texture.format))))),
          has_pairs_(linear && image.width + 2 * texture.border_texels > 1),
          last_left_column_(L::splat(static_cast<std::uint32_t>(image.width - 2 + texture.border_texels))) {}

    [[gnu::noinline]] void fetch(Words& to) const {
        if (is_indirect(texture_.format))
            return each_number([&](int corner, std::int32_t g, auto numbers) __attribute__((always_inline)) {
                to[corner][g] = L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                    const auto [s, t] = numbers(lane);
                    return static_cast<std::uint16_t>(Lanes<1>::load(palette_entry(texture_, image_, s, t)));
                });
            });
        const auto put = [&](int corner, std::int32_t g, const U16& texel) __attribute__((always_inline)) {
            to[corner][g] = texel;
        };
        if (has_other_texels && texture_.format == TexelFormat::rgb332)
            each_texel<1>(put);
        else
            each_texel<2>(put);
    }
    [[gnu::noinline]] void fetch(Bytes& to) const {
        const auto put = [&](auto bytes) __attribute__((always_inline)) {
            return [&to, bytes ](int corner, std::int32_t g, const auto& texel)
                __attribute__((always_inline)) {
                to[corner][g] = bytes(texel);
            };
        };
        switch (sampled(texture_.format)) {
        case TexelFormat::a8:
            return each_texel<1>(put([](const U16& a) __attribute__((always_inline)) {
                return LaneBytes{L::splat(0xFFFF), a << 8 | 0xFF};
            }));
        case TexelFormat::l8:
            return each_texel<1>(put([](const U16& l) __attribute__((always_inline)) {
                return LaneBytes{l << 8 | l, l | 0xFF00};
            }));
        case TexelFormat::i8:
            return each_texel<1>(put([](const U16& i) __attribute__((always_inline)) {
                const U16 both = i << 8 | i;
                return LaneBytes{both, both};
            }));
        case TexelFormat::la88:
            return each_texel<2>(put([](const U16& la) __attribute__((always_inline)) {
                const U16 l = la & 0xFF;
                return LaneBytes{l << 8 | l, la};
            }));
        case TexelFormat::rgb888:
            return each_texel<3>(put([](const LaneWords& word) __attribute__((always_inline)) {
                const LaneBytes rgb = LaneBytes::of(word);
                return LaneBytes{rgb.low, rgb.high | 0xFF00};
            }));
        case TexelFormat::rgba8888:
            return each_texel<4>(put([](const LaneWords& word)
                                         __attribute__((always_inline)) { return LaneBytes::of(word); }));
        default:
            if constexpr (has_other_texels)
                fetch_others(to);
        }
    }

  private:
    const Texture& texture_;
    const TextureLevel& image_;
    const std::uint32_t* const first_texel_;
    const TexelNumbers &s_, &t_;
    const int texel_count_;
    const std::int32_t group_count_;
    const LaneWords texel_steps_; ///< bytes from texel to texel and from row to row
    const bool has_pairs_;        ///< each fragment reads two columns, and the image has at least two
    const U16 last_left_column_;  ///< the last column that has a right neighbour

    /// Calls f(corner, group, texels along s, texels along t) for each corner and group.
    template <class F> SPANGLE_INLINE void each_group(F f) const {
        for (int corner = 0; corner < texel_count_; ++corner) {
            const U16* const s = (corner & 1) != 0 ? s_.next : s_.at;
            const U16* const t = (corner & 2) != 0 ? t_.next : t_.at;
            for (std::int32_t g = 0; g < group_count_; ++g)
                f(corner, g, s[g], t[g]);
        }
    }
    /// The addresses of the texels of one group.
    struct Places {
        const std::uint8_t* texels;
        std::int32_t offset[8];
        SPANGLE_INLINE const std::uint8_t* operator()(std::uint32_t lane) const {
            return texels + offset[lane];
        }
    };
    SPANGLE_INLINE Places places(std::int32_t g, const U16& s, const U16& t) const {
        U32 offsets = lane_products_added(lane_joined(s, t), texel_steps_);
        if (first_texel_ != nullptr)
            offsets += L::gather(first_texel_ + 8 * g);
        Places to{image_.texels, {}};
        L::store32(reinterpret_cast<std::uint8_t*>(to.offset), offsets);
        // The offsets go through memory: GCC 12 would take lanes out of vectors, which is longer.
        asm("" : "+m"(to.offset)); // NOLINT(hicpp-no-assembler)
        return to;
    }
    /// Calls f(corner, group, places) for each corner and group.
    template <class F> SPANGLE_INLINE void each_place(F f) const {
        each_group([&](int corner, std::int32_t g, const U16& s, const U16& t)
                       __attribute__((always_inline)) { f(corner, g, places(g, s, t)); });
    }
    /// Calls put(corner, group, texels as they lie in memory) for texels of `Size` bytes, 1 to 4. Two columns
    /// that are neighbours, or the same column, are loaded together. Where an image repeats, the two columns
    /// may be far apart.
    template <unsigned Size, class Put> SPANGLE_INLINE void each_texel(Put put) const {
        for (std::int32_t g = 0; g < group_count_; ++g) {
            const U16 &at = s_.at[g], &next = s_.next[g];
            if (has_pairs_) {
                // The columns `left` and `left` + 1 exist. `at` and `next` must each be one of these two
                // columns.
                const U16 left = L::minimum_signed(L::minimum_signed(at, next), last_left_column_);
                if (!L::any_bits(((at - left) | (next - left)) & 0xFFFE)) [[likely]] {
                    const U16 is_at = L::equal(at, left), is_next = L::equal(next, left);
                    for (int row = 0; row < 2; ++row) {
                        const auto [near, far] =
                            two_texels<Size>(places(g, left, row == 0 ? t_.at[g] : t_.next[g]));
                        put(2 * row, g, L::select(is_at, near, far));
                        put(2 * row + 1, g, L::select(is_next, near, far));
                    }
                    continue;
                }
            }
            for (int corner = 0; corner < texel_count_; ++corner)
                put(corner, g,
                    one_texel<Size>(
                        places(g, (corner & 1) != 0 ? next : at, (corner & 2) != 0 ? t_.next[g] : t_.at[g])));
        }
    }
    template <unsigned Size> SPANGLE_INLINE static auto one_texel(const Places& at) {
        if constexpr (Size == 1)
            return byte(at, 0);
        else if constexpr (Size == 2)
            return two_bytes<2>(at);
        else if constexpr (Size == 3)
            return lane_joined(two_bytes<1>(at), byte(at, 2));
        else
            return L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                return word_of<std::uint32_t, 4>(at(lane));
            });
    }
    template <unsigned Size> SPANGLE_INLINE static auto two_texels(const Places& at) {
        if constexpr (Size == 1) {
            const U16 both = two_bytes<1>(at);
            return LanePairs<U16>{both & 0xFF, both >> 8};
        } else if constexpr (Size == 2) {
            const LaneWords both = L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                return word_of<std::uint32_t, 2>(at(lane));
            });
            return both.halves();
        } else if constexpr (Size == 3) { // two words hold the six bytes of two texels
            const auto word = [&](int from) __attribute__((always_inline)) {
                return L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                    return word_of<std::uint32_t, 1>(at(lane) + from);
                });
            };
            return LanePairs<LaneWords>{word(0) & 0xFFFFFF, word(2) >> 8};
        } else {
            return LaneWords::generate_pairs([&](std::uint32_t lane) __attribute__((always_inline)) {
                return word_of<std::uint64_t, 4>(at(lane));
            });
        }
    }
    /// Calls f(corner, group, numbers) for each corner and each group of eight lanes. numbers(lane) returns
    /// the number of the lane's texel along s and its number along t.
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
    SPANGLE_INLINE static U16 byte(const Places& at, int n) {
        return L::generate([&](std::uint32_t lane)
                               __attribute__((always_inline)) { return std::uint16_t{at(lane)[n]}; });
    }
    /// Loads a word whose lowest byte comes first in memory, as lanes need it.
    template <class Word, int Aligned> SPANGLE_INLINE static Word word_of(const std::uint8_t* at) {
        Word v;
        __builtin_memcpy(&v, __builtin_assume_aligned(at, Aligned), sizeof v);
        return v;
    }
    template <int Aligned> SPANGLE_INLINE static U16 two_bytes(const Places& at) {
        return L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
            return word_of<std::uint16_t, Aligned>(at(lane));
        });
    }
    /// Fetches texels of other formats. Palettes and blocks are found by numbers, and other texels by
    /// addresses.
    [[gnu::noinline]] void fetch_others(Bytes& to) const {
        const auto words = [&](int corner, std::int32_t g, auto word) {
            to[corner][g] = LaneBytes::of(L::generate(word));
        };
        if (!is_indirect(texture_.format))
            return each_place([&](int corner, std::int32_t g, const Places& at) {
                words(corner, g, [&](std::uint32_t lane) { return word_4444(at(lane)); });
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
