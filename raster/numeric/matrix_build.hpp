// The matrices that GL's commands make (GL 1.3, 2.10.2), and the inverse transpose that normals need
// (2.10.3).
#pragma once

#include <cstdint>

#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/matrix.hpp"
#include "raster/numeric/trigonometry.hpp"

namespace spangle::numeric {

constexpr Matrix translation(Real x, Real y, Real z) {
    Matrix r = identity();
    r.set(0, 3, to_element(x));
    r.set(1, 3, to_element(y));
    r.set(2, 3, to_element(z));
    return r;
}

constexpr Matrix scaling(Real x, Real y, Real z) {
    Matrix r = identity();
    r.set(0, 0, to_element(x));
    r.set(1, 1, to_element(y));
    r.set(2, 2, to_element(z));
    return r;
}

/// A rotation whose upper left 3 x 3 part has twice the bits of an Element. `rest` is what rounding to
/// Elements has taken off `matrix`. A program may multiply by the same rotation again and again: the rounding
/// of the rotation itself then adds no error.
struct Rotation {
    Matrix matrix = identity();
    Element rest[3][3]; ///< what rounding took off; the indices are column and row

    constexpr void set(int row, int column, std::int64_t q60) {
        const Element nearest = make_element(q60, -60);
        const int up = nearest.e + element_bias + 60; // `up` is at most 0 where nothing was rounded
        matrix.set(row, column, nearest);
        rest[column][row] = make_element(up > 0 ? q60 - nearest.m * (std::int64_t{1} << up) : 0, -60);
    }
};

/// u u^T + cos (I - u u^T) + sin S, where u = (x, y, z) / length. A zero vector gives the identity.
constexpr Rotation rotation(Real degrees, Real x, Real y, Real z) {
    Rotation r;
    const Block3 axis = to_block(x, y, z);
    if (axis.m[0] == 0 && axis.m[1] == 0 && axis.m[2] == 0)
        return r;
    const Unit3Q60 u = normalize_q60(axis);
    const SinCos a = sincos_degrees(degrees);
    const std::int64_t versine = q60_one - a.cos;
    for (int i = 0; i < 3; ++i) {
        const int j = i == 2 ? 0 : i + 1, k = 3 - i - j;
        const std::int64_t even = mul_q60(mul_q60(u.m[i], u.m[j]), versine), odd = mul_q60(u.m[k], a.sin);
        r.set(i, i, a.cos + mul_q60(mul_q60(u.m[i], u.m[i]), versine));
        r.set(j, i, even + odd);
        r.set(i, j, even - odd);
    }
    return r;
}

/// a * b. Orthogonal matrices stay orthogonal within 2^-31 per product, in all directions alike.
constexpr Matrix multiply(const Matrix& a, const Rotation& b) {
    Matrix r = a; // copies the last column, which does not change
    for (int j = 0; j < 3; ++j)
        detail::multiply_column(a, b.matrix, j, 3, b.rest[j], r);
    return r;
}

/// The matrix of Frustum or, without perspective, of Ortho. For l = r, b = t or n = f GL reports
/// INVALID_VALUE and does not call this. The result would be some large matrix.
SPANGLE_RUN_CALL constexpr Matrix projection(Real left, Real right, Real bottom, Real top, Real near,
                                             Real far, bool perspective) {
    const Real low[3] = {left, bottom, near}, high[3] = {right, top, far};
    // `twice` is doubled below: it becomes 2 near, or 2 without perspective.
    Block twice = to_block(perspective ? low[2] : one);
    ++twice.e;
    Matrix m = identity();
    for (int i = 0; i < 3; ++i) {
        const Block from = to_block(low[i]), to = to_block(high[i]), size = sub(to, from);
        const Block middle = div(add(to, from), size);
        m.set(i, perspective ? 2 : 3, to_element(perspective && i != 2 ? middle : negate(middle)));
        const bool divided = perspective && i == 2; // row 2 gets -2 far near / depth, in its last column
        const Block scale = div(divided ? mul(twice, to) : twice, size);
        m.set(i, divided ? 3 : i, to_element(i == 2 ? negate(scale) : scale));
    }
    if (perspective) {
        m.set(3, 2, to_element(-one));
        m.set(3, 3, Element{});
    }
    return m;
}
constexpr Matrix frustum(Real left, Real right, Real bottom, Real top, Real near, Real far) {
    return projection(left, right, bottom, top, near, far, true);
}
constexpr Matrix ortho(Real left, Real right, Real bottom, Real top, Real near, Real far) {
    return projection(left, right, bottom, top, near, far, false);
}

namespace detail {

/// a[i] b[k] - b[i] a[k]. Both products are below 2^60 and exact before the subtraction.
SPANGLE_RUN_CALL constexpr Block determinant2(const Block* a, const Block* b, int i, int k) {
    // This branch only saves time; the result is the same.
    if (wide_words && (a[i].m == 0 || b[k].m == 0) && (b[i].m == 0 || a[k].m == 0))
        return {};
    return sum(mul_s32(a[i].m * 2, b[k].m * 2), a[i].e + b[k].e - 2, mul_s32(b[i].m * 2, a[k].m * -2),
               b[i].e + a[k].e - 2);
}

constexpr int next_axis(int i) {
    return i == 2 ? 0 : i + 1;
}

/// The dot product of two vectors of three.
SPANGLE_RUN_CALL constexpr Block dot(const Block* a, const Block* b) {
    return add(add(mul(a[0], b[0]), mul(a[1], b[1])), mul(a[2], b[2]));
}

} // namespace detail

/// The inverse transpose of the upper left 3 x 3 part, column-major, by which normals are multiplied (GL 1.3,
/// 2.10.3). GL does not define it for a singular matrix. In this case the cofactors are not divided, so
/// directions that survive are right.
struct NormalMatrix {
    Block at[9];
    bool singular = false;

    /// The factor of RESCALE_NORMAL: 1 / length of the third row of the inverse, which is column 3 of this
    /// matrix.
    constexpr Block row_scale() const { return rsqrt(detail::dot(at + 6, at + 6)); }
};

constexpr NormalMatrix inverse_transpose(const Matrix& a) {
    Block v[12];
    to_blocks(a, v, 12);
    NormalMatrix r;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) { // cofactor of (i, j): cyclic indices carry the sign
            const int i1 = detail::next_axis(i), i2 = detail::next_axis(i1), j1 = detail::next_axis(j),
                      j2 = detail::next_axis(j1);
            r.at[3 * j + i] = detail::determinant2(v + 4 * j1, v + 4 * j2, i1, i2);
        }
    const Block determinant = detail::dot(v, r.at);
    r.singular = determinant.m == 0;
    if (!r.singular)
        for (Block& c : r.at)
            c = div(c, determinant);
    return r;
}

constexpr BlockMatrix3 to_block_matrix(const NormalMatrix& n) {
    return to_block_matrix(n.at);
}

namespace detail {

/// pair: the pairs of four columns. rest[i]: the three columns other than i. minor[i]: the pairs that remain
/// of rest[i] without its first, second and third column.
inline constexpr std::uint8_t pair[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
inline constexpr std::uint8_t rest[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
inline constexpr std::uint8_t minor[4][3] = {{5, 4, 3}, {5, 2, 1}, {4, 2, 0}, {3, 1, 0}};

} // namespace detail

/// Computes the inverse from 2 x 2 minors of the upper and the lower half. Returns false, and leaves `out`
/// unchanged, where the determinant is 0.
constexpr bool inverse(const Matrix& a, Matrix& out) {
    // The 2 x 2 minors of each pair of columns: `upper` has those of rows 0 and 1, and `lower` those of rows
    // 2 and 3.
    Block v[4][4], upper[6], lower[6];
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            v[i][j] = element(a, i, j);
    for (int p = 0; p < 6; ++p) {
        const int j = detail::pair[p][0], k = detail::pair[p][1];
        upper[p] = detail::determinant2(v[0], v[1], j, k);
        lower[p] = detail::determinant2(v[2], v[3], j, k);
    }
    Block determinant;
    for (int p = 0; p < 6; ++p) { // Laplace's expansion; pairs 1 and 4 are odd permutations
        const Block term = mul(upper[p], lower[5 - p]);
        determinant = p == 1 || p == 4 ? sub(determinant, term) : add(determinant, term);
    }
    if (determinant.m == 0)
        return false;
    // Row i of the adjugate has no term of column i. It uses the three other columns, and the minors of their
    // pairs.
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const Block* row = v[j ^ 1]; // the row beside j in its half, which is rows 0 and 1, or 2 and 3
            const Block* minors = j < 2 ? lower : upper;
            Block c;
            for (int k = 0; k < 3; ++k) {
                const Block term = mul(row[detail::rest[i][k]], minors[detail::minor[i][k]]);
                c = k == 1 ? sub(c, term) : add(c, term);
            }
            const Block quotient = div(c, determinant);
            out.set(i, j, to_element((i + j) % 2 == 0 ? quotient : negate(quotient)));
        }
    return true;
}

} // namespace spangle::numeric
