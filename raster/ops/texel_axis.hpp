// Finds which texels the fragments of a packet meet along one axis of an image, in lanes. The wrap modes are
// those of GL 1.3, 3.8.7, for images of any size.
#pragma once

#include "raster/ops/lane_texels.hpp"
#include "raster/ops/packet.hpp"
#include "raster/ops/texel.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Groups of eight lanes in a packet.
inline constexpr std::int32_t texel_groups = (packet_length + 7) / 8;

/// Numbers of texels along one axis. The numbers -1 and the size of the axis are texels of the border. LINEAR
/// mixes in the texel `next`, whose `weight` is in 256ths.
struct TexelNumbers {
    Lanes<8>::U16 at[texel_groups], next[texel_groups], weight[texel_groups];
};

/// One axis of an image. A coordinate becomes a place, which counts texels with 16 fraction bits, rounded
/// down. The tier's rules (linear_origin(), nearest_bias()) then add multiples of 2^-16 texel and round down
/// again. So the first rounding changes no texel and no weight.
class AxisLanes {
    using L = Lanes<8>;
    using U16 = L::U16;
    using U32 = L::U32;

  public:
    /// Places on larger axes do not fit 32 bits, because coordinates that do not wrap reach 8 images to both
    /// sides.
    static constexpr std::int32_t size_limit = 4096;

    AxisLanes(Wrap wrap, std::int32_t size)
        : wrap_(wrap), repeats_(wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat),
          period_(wrap == Wrap::mirrored_repeat ? 2 * size : size),
          shift_(is_power_of_two(size) ? (repeats_ ? 16 : clamped_coord_bits - 16) - log2_of(period_) : -1),
          texel_count_(L::splat(static_cast<std::uint32_t>(period_))), last_texel_(texel_count_ - 1) {}

    /// Finds the texels of `groups` groups of eight words in `coord`, which are `group` words apart. Returns
    /// false where a fragment meets a texel beyond the image.
    bool find(bool linear, const std::uint32_t* coord, std::int32_t group, std::int32_t groups,
              TexelNumbers& to) const {
        return linear ? find_linear(coord, group, groups, to) : find_nearest(coord, group, groups, to);
    }

    /// Moves numbers beyond the image to its edge, on an axis that does not repeat. Returns all ones in lanes
    /// whose number was moved.
    SPANGLE_INLINE U16 move_inside(U16& number) const {
        const U16 inside = L::clamped_signed(number, L::splat(0), last_texel_),
                  moved = ~L::equal(inside, number);
        number = inside;
        return moved;
    }

  private:
    Wrap wrap_;
    bool repeats_;
    std::int32_t period_; ///< texels of one period of a repeating axis, or of the image
    int shift_;           ///< right shift from a coordinate to a texel's place; -1: a product gives the place
    U16 texel_count_, last_texel_;

    static constexpr std::uint32_t bias = 1u << (16 - nearest_bias_bits),
                                   /// The values of nearest_bias() and linear_origin(), in 2^-16 texel.
        origin = (1u << 15) - (1u << 7);

    SPANGLE_INLINE U32 place(const U32& v) const {
        if (shift_ >= 0)
            return repeats_ ? v >> shift_ : lane_shifted_signed(v, shift_);
        const auto [low, high] = v.halves();
        if (repeats_)
            return lane_joined(high * texel_count_, L::mul_high(high, texel_count_)) +
                   L::widened(L::mul_high(low, texel_count_));
        return (lane_joined(high * texel_count_, L::mul_high_signed(high, texel_count_))
                << (32 - clamped_coord_bits)) +
               (lane_joined(low * texel_count_, L::mul_high(low, texel_count_)) >> (clamped_coord_bits - 16));
    }
    /// Calls f(group, coordinates) for all groups.
    template <class F>
    SPANGLE_INLINE static void each(const std::uint32_t* coord, std::int32_t group, std::int32_t groups,
                                    F f) {
        for (std::int32_t g = 0; g < groups; ++g, coord += group)
            f(g, L::gather(coord));
    }

    /// Wraps a texel number that is one beyond the end of the period; from_beginning() wraps one that is
    /// before its beginning.
    SPANGLE_INLINE U16 from_end(const U16& i) const {
        return i - (L::less_signed(last_texel_, i) & texel_count_);
    }
    SPANGLE_INLINE U16 from_beginning(const U16& i) const {
        return i + (L::less_signed(i, L::splat(0)) & texel_count_);
    }
    /// Mirrors numbers in the second half of the period, where the image runs backwards.
    SPANGLE_INLINE U16 mirrored(const U16& i) const {
        return last_texel_ - L::maximum_signed(i, last_texel_ - i);
    }

    [[gnu::noinline]] bool find_nearest(const std::uint32_t* coord, std::int32_t group, std::int32_t groups,
                                        TexelNumbers& to) const {
        const auto texel = [&](const U32& v) __attribute__((always_inline)) {
            return L::high_half(place(v) + L::splat32(bias));
        };
        if (repeats_) {
            const bool mirror = wrap_ == Wrap::mirrored_repeat;
            each(
                coord, group, groups, [&](std::int32_t g, const U32& v) __attribute__((always_inline)) {
                    const U16 i = from_end(texel(v));
                    to.at[g] = mirror ? mirrored(i) : i;
                });
            return true;
        }
        if (wrap_ != Wrap::clamp_to_border) {
            each(
                coord, group, groups, [&](std::int32_t g, const U32& v) __attribute__((always_inline)) {
                    to.at[g] = L::clamped_signed(texel(v), L::splat(0), last_texel_);
                });
            return true;
        }
        U16 outside = L::splat(0);
        each(
            coord, group, groups, [&](std::int32_t g, const U32& v) __attribute__((always_inline)) {
                const U16 i = L::clamped_signed(texel(v), L::splat(0xFFFF), texel_count_);
                // A coordinate of 1 belongs to the last texel (GL 1.3, 3.8.8).
                const L::Mask beyond = L::less(L::splat32(1u << clamped_coord_bits), v);
                to.at[g] = i + (L::equal(i, texel_count_) & ~beyond);
                outside |= to.at[g] | (last_texel_ - to.at[g]);
            });
        return !L::any(L::less_signed(outside, L::splat(0)));
    }

    [[gnu::noinline]] bool find_linear(const std::uint32_t* coord, std::int32_t group, std::int32_t groups,
                                       TexelNumbers& to) const {
        const auto each_place = [&](auto moved, auto f) __attribute__((always_inline)) {
            each(
                coord, group, groups, [&](std::int32_t g, const U32& v) __attribute__((always_inline)) {
                    const U32 at = moved(place(v)) - L::splat32(origin);
                    to.weight[g] = L::low_half(at) >> 8;
                    f(g, L::high_half(at));
                });
        };
        const auto as_it_is = [](const U32& v) __attribute__((always_inline)) {
            return v;
        };
        if (repeats_) {
            const bool mirror = wrap_ == Wrap::mirrored_repeat;
            each_place(
                as_it_is, [&](std::int32_t g, const U16& i) __attribute__((always_inline)) {
                    const U16 at = from_beginning(i), next = from_end(at + 1);
                    to.at[g] = mirror ? mirrored(at) : at;
                    to.next[g] = mirror ? mirrored(next) : next;
                });
            return true;
        }
        if (wrap_ == Wrap::clamp_to_edge) {
            each_place(
                as_it_is, [&](std::int32_t g, const U16& i) __attribute__((always_inline)) {
                    to.at[g] = L::clamped_signed(i, L::splat(0), last_texel_);
                    to.next[g] = L::clamped_signed(i + 1, L::splat(0), last_texel_);
                });
            return true;
        }
        U16 outside = L::splat(0);
        const auto into_border = [&](std::int32_t g, const U16& i) __attribute__((always_inline)) {
            to.at[g] = L::clamped_signed(i, L::splat(0xFFFF), texel_count_);
            to.next[g] = L::clamped_signed(i + 1, L::splat(0xFFFF), texel_count_);
            outside |= to.at[g] | (last_texel_ - to.next[g]);
        };
        if (wrap_ == Wrap::clamp_to_border)
            each_place(as_it_is, into_border);
        // CLAMP limits the coordinate to [0, 1] first. At the edge half of the border is mixed in.
        else
            each_place(
                [&](const U32& v) __attribute__((always_inline)) {
                    return L::minimum(L::positive(v), L::splat32(static_cast<std::uint32_t>(period_) << 16));
                },
                into_border);
        return !L::any(L::less_signed(outside, L::splat(0)));
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
