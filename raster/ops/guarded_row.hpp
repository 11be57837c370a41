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

/// unguarded() of a projective plane at any pixel of a row; `Long`: registers hold the plane's words.
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

/// With words of 32 bits a product for the value and one for the guard bits take the place of a long product.
/// Guard bits are summed with whatever they carry: pixels of a row are below 2^14 (clip guard band and
/// surface), so the sum is below 2^31.
template <> class GuardedRowOf<false> {
  public:
    GuardedRowOf() = default;
    SPANGLE_INLINE GuardedRowOf(const Span<Fixed>& span, const Span<Fixed>::Projective& plane)
        : first_(span.at(0, plane)), step_(plane.dx) {}
    SPANGLE_INLINE std::int32_t value(std::int32_t x) const {
        const auto steps = static_cast<std::uint32_t>(x);
        const std::uint32_t guard = first_.guard + steps * step_.guard;
        return static_cast<std::int32_t>(first_.value + steps * step_.value + (guard >> guard_bits));
    }

  private:
    struct Parts {
        std::uint32_t value, guard;
        Parts() = default;
        SPANGLE_INLINE explicit Parts(std::uint64_t v)
            : value(static_cast<std::uint32_t>(v >> guard_bits)),
              guard(static_cast<std::uint32_t>(v) & ((1u << guard_bits) - 1)) {}
    };
    Parts first_, step_;
};
using GuardedRow = GuardedRowOf<numeric::wide_words>;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
