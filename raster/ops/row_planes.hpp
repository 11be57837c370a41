// Holds the planes of a primitive side by side in vectors, so that a row starts all planes at once.
#pragma once

#include <utility>

#include "raster/ops/lanes.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Up to eight planes, four in each vector. Constants are kept in registers as lanes. A store to the surface
/// might change any value in memory, which would then be loaded again.
template <int Count> class RowPlanes {
  public:
    using L = Lanes<8>;
    /// Starts the planes at column x of this row. They are valid from this row up, and from this column to
    /// the right.
    template <class S, class... Plane>
    SPANGLE_INLINE explicit RowPlanes(const S& row, std::int32_t x, const Plane&... of)
        : x_(row.x + x), y_(row.y) {
        static_assert(sizeof...(of) == Count);
        set(dx_, of.dx...);
        set(dy_, of.dy...);
        set(origin_, row.at(x, of)...);
        each([&](int k) __attribute__((always_inline)) { row_[k] = origin_[k]; });
    }
    /// Starts at window column x, which is less than 2^16 columns to the right of the constructor's column.
    SPANGLE_INLINE void start(std::int32_t x) {
        const L::U16 columns = splat(x - x_);
        each([&](int k) __attribute__((always_inline)) { at_[k] = row_[k] + L::times(dx_[k], columns); });
    }
    SPANGLE_INLINE void next_row() {
        each([&](int k) __attribute__((always_inline)) { row_[k] += dy_[k]; });
    }
    /// Goes to window row y, which is less than 2^16 rows above the constructor's row.
    SPANGLE_INLINE void to_row(std::int32_t y) {
        const L::U16 rows = splat(y - y_);
        each([&](int k) __attribute__((always_inline)) { row_[k] = origin_[k] + L::times(dy_[k], rows); });
    }
    /// The value of plane I in the first lane, repeated in all lanes.
    template <int I> SPANGLE_INLINE L::U32 first() const {
        constexpr int k = I / 4, lane = I % 4;
        const L::Words v = __builtin_shufflevector(at_[k], at_[k], lane, lane, lane, lane);
        return {v, v};
    }

  protected:
    static constexpr int vectors = (Count + 3) / 4;
    static_assert(vectors <= 2);
    using Planes = L::Words[vectors];
    const std::int32_t x_, y_;
    Planes dx_, dy_, origin_, row_, at_; ///< values of planes; origin_ and row_ are those at column x_

    /// Calls f for each vector. This is not a loop, because a loop's index would keep all planes in memory.
    template <class F> SPANGLE_INLINE static void each(F f) {
        f(0);
        if constexpr (vectors > 1)
            f(1);
    }

  private:
    SPANGLE_INLINE static L::U16 splat(std::int32_t n) { return L::splat(static_cast<std::uint32_t>(n)); }
    template <class... V> SPANGLE_INLINE static void set(Planes& to, V... of) {
        const std::uint32_t v[4 * vectors] = {of...};
        each([&](int k) __attribute__((always_inline)) {
            to[k] = L::Words{v[4 * k], v[4 * k + 1], v[4 * k + 2], v[4 * k + 3]};
        });
    }
};

/// Planes, and the exact high halves of their values in eight lanes. Only the values of the first lane are
/// kept from group to group, because registers are few.
template <int Count> class LanePlanes : public RowPlanes<Count> {
  public:
    using L = Lanes<8>;
    template <class S, class... Plane>
    SPANGLE_INLINE explicit LanePlanes(const S& row, std::int32_t x, const Plane&... of)
        : RowPlanes<Count>(row, x, of...) {
        set_offsets(std::make_integer_sequence<int, Count>{});
    }
    SPANGLE_INLINE void step() {
        this->each([&](int k) __attribute__((always_inline)) { this->at_[k] += this->dx_[k] << 3; });
    }
    /// The high half of plane I in each lane. The comparison adds the carry of the low halves.
    template <int I> SPANGLE_INLINE L::U16 high() const {
        const L::Words& at = this->at_[I / 4];
        return L::splat_half<I % 4 * 2 + 1>(at) + high_difference_[I] +
               L::at_most(L::splat_half<I % 4 * 2>(at), carry_limit_[I]);
    }
    template <int I> SPANGLE_INLINE L::U32 words() const {
        return this->template first<I>() + L::offsets(this->dx_[I / 4][I % 4], 0);
    }

  private:
    template <int... I> SPANGLE_INLINE void set_offsets(std::integer_sequence<int, I...>) {
        (set_offset<I>(), ...);
    }
    template <int I> SPANGLE_INLINE void set_offset() {
        const L::U16 columns = L::offsets16(L::splat(1), L::splat(0));
        const L::U16 low = L::splat_half<I % 4 * 2>(this->dx_[I / 4]),
                     high = L::splat_half<I % 4 * 2 + 1>(this->dx_[I / 4]);
        carry_limit_[I] = ~(low * columns);
        high_difference_[I] = high * columns + L::mul_high(low, columns) + 1;
    }
    /// The difference of a plane between each lane and the first lane. high_difference_ is the high half of
    /// the difference plus 1. carry_limit_ is 2^16 - 1 minus its low half.
    L::U16 high_difference_[Count], carry_limit_[Count];
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
