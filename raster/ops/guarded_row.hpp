// The values of a projective plane along a row.
#pragma once

#include <cstdint>

#include "raster/span/instructions.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The value of a projective plane without its guard bits.
SPANGLE_INLINE std::int32_t unguarded(std::uint64_t v) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(v >> guard_bits));
}

/// A number of a projective plane in two words of 32 bits: the value, and the guard bits below it.
struct GuardedWords {
    static constexpr std::uint32_t guard_mask = (1u << guard_bits) - 1;
    std::uint32_t value, guard;

    GuardedWords() = default;
    SPANGLE_INLINE explicit GuardedWords(std::uint64_t v)
        : value(static_cast<std::uint32_t>(v >> guard_bits)),
          guard(static_cast<std::uint32_t>(v) & guard_mask) {}
    /// The value, without guard bits, after a number of steps. The guard bits are summed with their carries:
    /// the pixels of a row are below 2^14 (clip guard band and surface), so the sum is below 2^31.
    SPANGLE_INLINE std::int32_t after(std::uint32_t steps, const GuardedWords& step) const {
        const std::uint32_t sum = guard + steps * step.guard;
        return static_cast<std::int32_t>(value + steps * step.value + (sum >> guard_bits));
    }
};

/// The values of a projective plane, without guard bits (unguarded()), at any pixel of a row. `Long`: the
/// processor's registers hold numbers of 64 bits.
template <bool Long> class GuardedRowOf {
  public:
    GuardedRowOf() = default;
    SPANGLE_INLINE GuardedRowOf(const Span<Fixed>& span, const Span<Fixed>::Projective& plane)
        : first_(span.at(0, plane)), step_(plane.dx) {}
    SPANGLE_INLINE std::int32_t value(std::int32_t x) const {
        return unguarded(first_ + static_cast<std::uint32_t>(x) * step_);
    }

  private:
    std::uint64_t first_, step_;
};

/// With words of 32 bits one product for the value and one for the guard bits replace a product of 64 bits.
template <> class GuardedRowOf<false> {
  public:
    GuardedRowOf() = default;
    SPANGLE_INLINE GuardedRowOf(const Span<Fixed>& span, const Span<Fixed>::Projective& plane)
        : first_(span.at(0, plane)), step_(plane.dx) {}
    SPANGLE_INLINE std::int32_t value(std::int32_t x) const {
        return first_.after(static_cast<std::uint32_t>(x), step_);
    }

  private:
    GuardedWords first_, step_;
};
using GuardedRow = GuardedRowOf<numeric::wide_words>;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
