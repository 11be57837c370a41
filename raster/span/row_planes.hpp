// The planes of a primitive side by side, so that a row starts all of them at once.
#pragma once

#include <utility>

#include "raster/span/instructions.hpp"
#include "raster/span/lanes.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster::inline SPANGLE_INSTRUCTIONS {

/// Four of them in a vector. What is constant lies in lanes: a store to the surface might change anything
/// else.
template <int Count> class RowPlanes {
  public:
    using L = Lanes<8>;
    /// From this row up and its column x to the right, in this row.
    template <class S, class... Plane>
    SPANGLE_INLINE explicit RowPlanes(const S& row, std::int32_t x, const Plane&... of)
        : x_(row.x + x), y_(row.y) {
        static_assert(sizeof...(of) == Count);
        set(dx_, of.dx...);
        set(dy_, of.dy...);
        set(origin_, row.at(x, of)...);
        each([&](int k) __attribute__((always_inline)) { row_[k] = origin_[k]; });
    }
    /// Window columns from x on, less than 2^16 further than where these were made.
    SPANGLE_INLINE void start(std::int32_t x) {
        const L::U16 columns = splat(x - x_);
        each([&](int k) __attribute__((always_inline)) { at_[k] = row_[k] + L::times(dx_[k], columns); });
    }
    SPANGLE_INLINE void next_row() {
        each([&](int k) __attribute__((always_inline)) { row_[k] += dy_[k]; });
    }
    /// Less than 2^16 rows further up than where these were made.
    SPANGLE_INLINE void to_row(std::int32_t y) {
        const L::U16 rows = splat(y - y_);
        each([&](int k) __attribute__((always_inline)) { row_[k] = origin_[k] + L::times(dy_[k], rows); });
    }
    /// Of the first lane, in all.
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
    Planes dx_, dy_, origin_, row_, at_; ///< origin_, row_: at x_

    /// Not a loop, whose index would keep all of it in memory.
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

/// And their high halves, exactly, in eight lanes. Nothing but the four of the first lane is kept from group
/// to group: registers are few.
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
    /// Where the sum of low halves wraps, it carries.
    template <int I> SPANGLE_INLINE L::U16 high() const {
        const L::Words& at = this->at_[I / 4];
        return L::splat_half<I % 4 * 2 + 1>(at) + above_[I] +
               L::at_most(L::splat_half<I % 4 * 2>(at), room_[I]);
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
        room_[I] = ~(low * columns);
        above_[I] = high * columns + L::mul_high(low, columns) + 1;
    }
    /// What a plane has more than in the first lane: its high half and 1, what its low half leaves to 2^16
    /// - 1.
    L::U16 above_[Count], room_[Count];
};

} // namespace spangle::raster::inline SPANGLE_INSTRUCTIONS
