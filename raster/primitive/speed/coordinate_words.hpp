// Texture and fog coordinates in words, with short forms for what programs usually draw.
#pragma once

#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

/// Does what to_fixed() does, for a word and 32 fraction bits. It is inline where nothing can saturate: |m|
/// 2^30 is at most 2^61.
SPANGLE_RUN_INLINE std::int64_t to_repeats(std::int32_t m, int exponent) {
    const int up = exponent + 32;
    return up >= 0 && up <= 30 ? numeric::mul_s32(m, 1 << up) : to_fixed(m, exponent, 32);
}

/// m 2^-down, rounded to nearest. It is inline where words are shifted by less than their bits.
SPANGLE_INLINE std::int64_t to_fixed_below(std::int64_t m, int down) {
    if (down > 0 && down < 32) [[likely]] // |m| is at most 2^61
        return static_cast<std::int64_t>(scaled_words(m + (std::int32_t{1} << (down - 1)), down));
    return to_fixed(m, -down, 0);
}

/// Loads fog coordinates in units of 2^span.fog_exponent, which is 2^-24 where all of them fit s7.24.
SPANGLE_INLINE void Setup<Fixed>::load_fog(std::int32_t fog[3]) const {
    span_.fog_exponent = -24;
    const auto& of = state_.fog;
    const auto offset = static_cast<std::int32_t>(of.offset);
    bool near = of.offset == offset && numeric::abs_u32(offset) < 1u << 29;
#pragma GCC unroll numeric::runs_inline ? 3 : 1
    for (int i = 0; i < 3; ++i) {
        near = near && half_below(numeric::mul_s32(v(i).fog_mantissa, of.scale),
                                  -25 - v(i).fog_exponent - of.scale_exponent, fog[i]);
        fog[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(fog[i]) +
                                           static_cast<std::uint32_t>(offset));
    }
    if (!near) [[unlikely]]
        load_any_fog(fog);
}

/// Does what add_steep() does for one coordinate. It is inline where fits_lifted() holds for the differences.
[[gnu::noinline]] inline void Setup<Fixed>::add_words(Interpolant<std::uint32_t>& at, std::uint32_t first,
                                                      const std::int32_t v[3], int up) {
    const std::int32_t d1 = v[1] - v[0], d2 = v[2] - v[0];
    const int n = by().exponent - up;
    if (const auto lift = static_cast<std::uint32_t>(32 - n); fits_lifted(difference_bits(d1, d2), lift))
        return add_lifted(at, first, d1, d2, lift, by());
    if (n <= 32 || n >= 64) [[unlikely]]
        return void(add_steep(at, first, d1, d2, up));
    const auto word = [&](const std::int32_t(&c)[2]) {
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(lifted_word(d1, d2, c)) >> (n - 32));
    };
    at.dx = word(by().dx);
    at.dy = word(by().dy);
    at.value = first + word(by().center);
}

} // namespace spangle::raster
