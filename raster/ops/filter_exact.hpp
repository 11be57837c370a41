// The LINEAR filter of the exact tier in lanes, for texels with components of 8 bits. The bits are those of
// bilinear<Exact>().
#pragma once

#include "raster/ops/lane_texels.hpp"
#include "raster/ops/number_wide.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Filters four texels by the weights of column i + 1 and of row j + 1, in 256ths.
///
/// A component is k 2^20, and the weights sum to 2^16. So the weighted sum of all k, times 2^4, is the
/// filtered component, and nothing is rounded. The sum along a row fits 16 bits. Products of rows are signed,
/// so each row is reduced by 2^15 first. The sum of both rows is 2^23 too small then.
class ExactFilter {
    using L = Lanes<8>;
    using U16 = L::U16;

  public:
    SPANGLE_INLINE ExactFilter(const U16& right, const U16& down)
        : right_weight_(right), row_weights_(lane_joined(256 - down, down)) {}

    SPANGLE_INLINE ExactLanes::Color operator()(const LaneBytes& c00, const LaneBytes& c10,
                                                const LaneBytes& c01, const LaneBytes& c11) const {
        const auto at = [&](int n) __attribute__((always_inline)) {
            return component(row(c00.at(n), c10.at(n)), row(c01.at(n), c11.at(n)));
        };
        return {at(0), at(1), at(2), at(3)};
    }

  private:
    U16 right_weight_;
    LaneWords row_weights_; ///< weights of rows j and j + 1, in 256ths

    SPANGLE_INLINE U16 row(const U16& c, const U16& next) const {
        return ((c << 8) + (next - c) * right_weight_) ^ 0x8000;
    }
    SPANGLE_INLINE ExactLanes::T component(const U16& near, const U16& far) const {
        return (lane_products_added(lane_joined(near, far), row_weights_) + L::splat32(1u << 23))
               << (color_fraction_bits - 16);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
