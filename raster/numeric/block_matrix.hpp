// The matrix the vertex pipeline multiplies with, derived from the stacks when dirty: int32 mantissas scaled
// per row and per column. Columns are what makes it right: in Ortho(0, 320, ...) 1/160 meets an x of 320 and
// -1 a w of 1, and far from the origin large terms cancel; with one exponent for all, the small elements
// would lose the bits that count.
#pragma once

#include <cstdint>

#include "raster/numeric/block.hpp"
#include "raster/numeric/matrix.hpp"

namespace spangle::numeric {

/// Element (i, j) = m[N * j + i] * 2^(row[i] + column[j] - 31), |m| < 2^31.
template <int N> struct BlockMatrixN {
    std::int32_t m[N * N] = {};
    std::int16_t row[N] = {};
    std::int16_t column[N] = {};
    bool uniform = true; ///< all columns have the same exponent: the vertex is used as it is
};

using BlockMatrix = BlockMatrixN<4>;
using BlockMatrix3 = BlockMatrixN<3>; ///< for normals

namespace detail {

/// 2^n > |v|, the least n.
constexpr std::int32_t width(Block v) {
    return v.e + 32 - clz32(abs_u32(v.m));
}

/// Where N x N blocks, column-major, are scaled: columns by their largest element, then rows by theirs.
template <int N> constexpr BlockMatrixN<N> scale_blocks(const Block (&a)[N * N]) {
    constexpr std::int32_t none = -0x10000;
    BlockMatrixN<N> r;
    std::int32_t column[N], least = 0x10000, most = none;
    for (int j = 0; j < N; ++j) {
        column[j] = none;
        for (int i = 0; i < N; ++i)
            if (a[N * j + i].m != 0 && width(a[N * j + i]) > column[j])
                column[j] = width(a[N * j + i]);
        if (column[j] == none)
            continue; // a column of zeros has no say
        if (column[j] < least)
            least = column[j];
        if (column[j] > most)
            most = column[j];
    }
    if (most == none)
        return r;
    r.uniform = most == least;
    for (int j = 0; j < N; ++j)
        r.column[j] = block_exponent(r.uniform || column[j] == none ? most : column[j]);
    for (int i = 0; i < N; ++i) {
        std::int32_t row = none;
        for (int j = 0; j < N; ++j)
            if (a[N * j + i].m != 0 && width(a[N * j + i]) - r.column[j] > row)
                row = width(a[N * j + i]) - r.column[j];
        r.row[i] = block_exponent(row == none ? 0 : row);
        for (int j = 0; j < N; ++j) {
            const Block v = a[N * j + i];
            r.m[N * j + i] = scale_saturate(v.m, v.e + 31 - r.row[i] - r.column[j]);
        }
    }
    return r;
}

/// High word of row i times v, rounded: four products of (2^31 - 1) * (2^30 - 1) and the half stay below
/// 2^63.
SPANGLE_INLINE constexpr std::int32_t row_times(const BlockMatrix& a, int i, const std::int32_t (&v)[4]) {
    const std::int64_t sum = (std::int64_t{1} << 31) + mul_s32(a.m[i], v[0]) + mul_s32(a.m[4 + i], v[1]) +
                             mul_s32(a.m[8 + i], v[2]) + mul_s32(a.m[12 + i], v[3]);
    return static_cast<std::int32_t>(sum >> 32);
}
SPANGLE_INLINE constexpr std::int32_t row_times(const BlockMatrix3& a, int i, const std::int32_t (&v)[3]) {
    const std::int64_t sum = (std::int64_t{1} << 31) + mul_s32(a.m[i], v[0]) + mul_s32(a.m[3 + i], v[1]) +
                             mul_s32(a.m[6 + i], v[2]);
    return static_cast<std::int32_t>(sum >> 32);
}

} // namespace detail

/// The elements as blocks, 30 bits each.
constexpr BlockMatrix to_block_matrix(const Matrix& a) {
    Block v[16];
    for (int i = 0; i < 16; ++i)
        v[i] = to_block(a.at(i & 3, i >> 2));
    return detail::scale_blocks<4>(v);
}

/// Column-major.
constexpr BlockMatrix3 to_block_matrix(const Block (&v)[9]) {
    return detail::scale_blocks<3>(v);
}

namespace detail {

/// a times a vertex whose columns have been scaled.
SPANGLE_INLINE constexpr Block4 rows_times(const BlockMatrix& a, const Block4& s) {
    const std::int32_t up = s.e + 1; // the high word is worth 2^(32 - 31)
    return common_exponent<4, Block4>(
        {row_times(a, 0, s.m), row_times(a, 1, s.m), row_times(a, 2, s.m), row_times(a, 3, s.m)},
        {up + a.row[0], up + a.row[1], up + a.row[2], up + a.row[3]});
}
SPANGLE_INLINE constexpr Block3 rows_times(const BlockMatrix3& a, const Block3& s) {
    const std::int32_t up = s.e + 1;
    return common_exponent<3, Block3>({row_times(a, 0, s.m), row_times(a, 1, s.m), row_times(a, 2, s.m)},
                                      {up + a.row[0], up + a.row[1], up + a.row[2]});
}

} // namespace detail

/// a * v, normalised by its own largest component. v is loaded under the exponents of the columns, so each of
/// its floats keeps the bits that count: x/w, y/w, z/w are within 2^-25 of their terms at worst.
constexpr Block4 transform(const BlockMatrix& a, const Real (&v)[4]) {
    using namespace detail;
    const Scaled s[4] = {scaled(v[0]), scaled(v[1]), scaled(v[2]), scaled(v[3])};
    return rows_times(a, common_exponent<4, Block4>({s[0].m, s[1].m, s[2].m, s[3].m},
                                                    {s[0].e + a.column[0], s[1].e + a.column[1],
                                                     s[2].e + a.column[2], s[3].e + a.column[3]}));
}
constexpr Block3 transform(const BlockMatrix3& a, const Real (&v)[3]) {
    using namespace detail;
    const Scaled s[3] = {scaled(v[0]), scaled(v[1]), scaled(v[2])};
    return rows_times(
        a, common_exponent<3, Block3>({s[0].m, s[1].m, s[2].m},
                                      {s[0].e + a.column[0], s[1].e + a.column[1], s[2].e + a.column[2]}));
}

/// The same of a vertex in block form, which keeps 30 bits of its own largest component.
constexpr Block4 transform(const BlockMatrix& a, const Block4& v) {
    const std::int32_t e = v.e;
    if (a.uniform)
        return detail::rows_times(
            a, {{v.m[0], v.m[1], v.m[2], v.m[3]}, detail::block_exponent(e + a.column[0])});
    return detail::rows_times(a, detail::common_exponent<4, Block4>(
                                     {v.m[0], v.m[1], v.m[2], v.m[3]},
                                     {e + a.column[0], e + a.column[1], e + a.column[2], e + a.column[3]}));
}
constexpr Block3 transform(const BlockMatrix3& a, const Block3& v) {
    const std::int32_t e = v.e;
    if (a.uniform)
        return detail::rows_times(a, {{v.m[0], v.m[1], v.m[2]}, detail::block_exponent(e + a.column[0])});
    return detail::rows_times(
        a, detail::common_exponent<3, Block3>({v.m[0], v.m[1], v.m[2]},
                                              {e + a.column[0], e + a.column[1], e + a.column[2]}));
}

} // namespace spangle::numeric
