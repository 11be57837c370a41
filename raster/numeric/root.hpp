// The square root of a real.
#pragma once

#include "raster/numeric/real.hpp"
#include "raster/numeric/rsqrt.hpp"

namespace spangle::numeric {

/// sqrt(v), rounded. The result is 0 unless v is positive. The root of a 62-bit integer has 31 bits, which is
/// seven more than the result keeps.
constexpr Real sqrt(Real v) {
    const detail::Unpacked u = detail::unpack(v);
    if (u.mantissa == 0 || u.negative)
        return zero;
    const int up = 38 - (u.exponent & 1);
    return pack_real(false, detail::integer_sqrt(std::uint64_t{u.mantissa} << up), (u.exponent - up) / 2);
}

} // namespace spangle::numeric
