// Matrix times vector as the vertex pipeline does it: one block exponent per column of the matrix, folded
// into the vertex while it is loaded, so that large translations and small rotations both keep their bits.
// The result depends on the matrix and the vertex alone.
#pragma once

#include "raster/numeric/block.hpp"
#include "raster/numeric/matrix.hpp"

namespace spangle::numeric {

/// Row i, column j of the matrix is m[i][j] * 2^e[j]; |m| < 2^30, each column normalised by its largest
/// element.
struct ColumnMatrix {
    std::int32_t m[4][4] = {};
    std::int16_t e[4] = {};
};

constexpr ColumnMatrix to_columns(const Matrix& a) {
    ColumnMatrix r;
    for (int j = 0; j < 4; ++j) {
        const Block4 column =
            to_block(to_block(a.at(0, j)), to_block(a.at(1, j)), to_block(a.at(2, j)), to_block(a.at(3, j)));
        for (int i = 0; i < 4; ++i)
            r.m[i][j] = column.m[i];
        r.e[j] = column.e;
    }
    return r;
}

/// M v. Relative to the largest |m[i][j] v[j]| of the vector the error is <= 2^-28.
SPANGLE_INLINE constexpr Block4 transform(const ColumnMatrix& a, Real x, Real y, Real z, Real w) {
    const detail::Scaled v[4] = {detail::scaled(x), detail::scaled(y), detail::scaled(z), detail::scaled(w)};
    const Block4 u = detail::common_exponent<4, Block4>(
        {v[0].m, v[1].m, v[2].m, v[3].m},
        {v[0].e + a.e[0], v[1].e + a.e[1], v[2].e + a.e[2], v[3].e + a.e[3]});
    std::int64_t sum[4];
    for (int i = 0; i < 4; ++i) // four products of 2^60
        sum[i] = mul_s32(a.m[i][0], u.m[0]) + mul_s32(a.m[i][1], u.m[1]) + mul_s32(a.m[i][2], u.m[2]) +
                 mul_s32(a.m[i][3], u.m[3]);
    return detail::from_sums<4, Block4>(sum, u.e);
}

/// The same for a vector of three (normals, directions); the fourth row and column are not looked at.
constexpr Block3 transform(const ColumnMatrix& a, Real x, Real y, Real z) {
    const detail::Scaled v[3] = {detail::scaled(x), detail::scaled(y), detail::scaled(z)};
    const Block3 u = detail::common_exponent<3, Block3>({v[0].m, v[1].m, v[2].m},
                                                        {v[0].e + a.e[0], v[1].e + a.e[1], v[2].e + a.e[2]});
    std::int64_t sum[3];
    for (int i = 0; i < 3; ++i)
        sum[i] = mul_s32(a.m[i][0], u.m[0]) + mul_s32(a.m[i][1], u.m[1]) + mul_s32(a.m[i][2], u.m[2]);
    return detail::from_sums<3, Block3>(sum, u.e);
}

} // namespace spangle::numeric
