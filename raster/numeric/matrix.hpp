// 4 x 4 matrices as GL's stacks hold them. Every element is an int32 mantissa with its own exponent. So a
// query returns the value that was set, and a million accumulated rotations drift less than in float.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/numeric/block.hpp"

namespace spangle::numeric {

/// value = m * 2^(e + element_bias). |m| is in [2^30, 2^31) unless the least bit would fall below 2^-149.
struct Element {
    std::int32_t m = 0;
    std::int8_t e = 0;
};

/// Least bits from 2^-149 (the float denormals) to 2^104 (the largest floats).
inline constexpr int element_bias = -22;
inline constexpr int element_least = -149, element_most = 104;

/// A column-major matrix: element (row i, column j) is at 4 * j + i. Mantissas and exponents are separate
/// arrays, which take 80 bytes instead of 128. A new matrix is the identity.
struct Matrix {
    static constexpr std::int32_t one = 1 << 30;
    static constexpr std::int8_t one_e = -30 - element_bias;
    std::int32_t m[16] = {};
    std::int8_t e[16] = {};

    constexpr Matrix() {
        for (int i = 0; i < 16; i += 5) {
            m[i] = one;
            e[i] = one_e;
        }
    }

    constexpr Element at(int row, int column) const { return {m[4 * column + row], e[4 * column + row]}; }
    constexpr void set(int row, int column, Element v) {
        m[4 * column + row] = v.m;
        e[4 * column + row] = v.e;
    }
};

// --- elements
// ------------------------------------------------------------------------------------------------------

/// The Element nearest to v * 2^e. A value that is too large saturates, and one that is too small becomes a
/// denormal or 0.
constexpr Element make_element(std::int64_t v, std::int32_t e) {
    if (v == 0)
        return {};
    const std::uint64_t magnitude = abs_u64(v);
    const int zeros = clz64(magnitude);
    std::int32_t drop = 33 - zeros; // the mantissa keeps 31 bits
    if (e + drop < element_least)
        drop = element_least - e;
    std::uint64_t m = shift_right_even(magnitude, drop);
    if (m >> 31 != 0)
        m >>= 1, ++drop; // rounding up gave 2^31, one bit too many
    const std::int32_t least = e + drop;
    const bool over = least > element_most;
    const auto mantissa = static_cast<std::int32_t>(over ? 0x7FFFFFFF : m);
    return {v < 0 ? -mantissa : mantissa,
            static_cast<std::int8_t>((over ? element_most : least) - element_bias)};
}

constexpr Element to_element(Real v) {
    const std::uint32_t biased = v.bits >> 23 & 255;
    if (wide_words && biased >= 8) { // this branch is only faster: 24 bits need no rounding
        const auto m = static_cast<std::int32_t>((v.bits & 0x7FFFFF) << 7 | 1u << 30);
        return {(v.bits >> 31) != 0 ? -m : m,
                static_cast<std::int8_t>(static_cast<std::int32_t>(biased) - 157 - element_bias)};
    }
    const detail::Unpacked u = detail::unpack(v);
    const auto m = static_cast<std::int64_t>(u.mantissa);
    return make_element(u.negative ? -m : m, u.exponent);
}
constexpr Element to_element(Block v) {
    return make_element(v.m, v.e);
}

constexpr Real to_real(Element v) {
    return pack_real(v.m < 0, abs_u32(v.m), v.e + element_bias);
}
constexpr Block to_block(Element v) {
    if (wide_words && abs_u32(v.m) >> 30 != 0) { // this branch only saves time
        const std::int32_t half = (v.m >> 1) + (v.m & 1);
        return {half > block_max ? block_max : half, v.e + element_bias + 1};
    }
    return make_block(v.m, v.e + element_bias);
}

// --- matrices
// ------------------------------------------------------------------------------------------------------

namespace detail {
/// The identity is no constant, because compilers would write it out wherever a matrix begins.
[[gnu::noinline]] inline Matrix make_identity() {
    return {};
}
} // namespace detail

constexpr Matrix identity() {
    return runs_inline || std::is_constant_evaluated() ? Matrix{} : detail::make_identity();
}

/// Element (row, column) as a block, for arithmetic.
constexpr Block element(const Matrix& a, int row, int column) {
    return to_block(a.at(row, column));
}

/// The matrix of 16 numbers in column-major order, as LoadMatrix takes them.
constexpr Matrix matrix_from_reals(const Real (&v)[16]) {
    Matrix r = identity();
    for (int i = 0; i < 16; ++i)
        r.set(i & 3, i >> 2, to_element(v[i]));
    return r;
}

constexpr void to_reals(const Matrix& a, Real (&out)[16]) {
    for (int i = 0; i < 16; ++i)
        out[i] = to_real(a.at(i & 3, i >> 2));
}

constexpr Matrix transpose(const Matrix& a) {
    Matrix r = identity();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            r.set(i, j, a.at(j, i));
    return r;
}

namespace detail {

/// The sum of n products a[k] * b[k]. Each product, which is below 2^62, is aligned to the largest exponent
/// with two bits of room for carries. So alignment loses less than 2^-58 of the largest product. Of more than
/// four terms only four may be large.
SPANGLE_RUN_INLINE constexpr Element sum_of_products(const Element* a, const Element* b, int n) {
    constexpr std::int32_t none = -0x10000;
    std::int64_t product[6] = {};
    std::int32_t top = none;
    for (int k = 0; k < n; ++k) { // in most matrices, half of the products are 0
        product[k] = mul_s32(a[k].m, b[k].m);
        if (product[k] == 0)
            continue;
        const std::int32_t exponent = a[k].e + b[k].e - clz64(abs_u64(product[k]));
        if (exponent > top)
            top = exponent;
    }
    if (top == none)
        return {};
    top += 3; // the largest product shifted to 2^61 at most: four of them stay below 2^63
    std::int64_t sum = 0;
    for (int k = 0; k < n; ++k) {
        if (product[k] == 0)
            continue;
        sum += shift_right_round(product[k], top - (a[k].e + b[k].e));
    }
    return make_element(sum, top + 2 * element_bias);
}

/// Copies n elements of a matrix, which lie `step` apart in its arrays.
SPANGLE_RUN_INLINE constexpr void gather(const Matrix& a, int first, int step, int n, Element* out) {
#pragma GCC unroll runs_inline ? 4 : 1
    for (int k = 0; k < n; ++k) {
        const int at = first + k * step;
        out[k] = {a.m[at], a.e[at]};
    }
}
constexpr void column_of(const Matrix& a, int j, Element (&out)[4]) {
    gather(a, 4 * j, 1, 4, out);
}

template <int N> constexpr Element sum_of_products(const Element (&a)[N], const Element (&b)[N]) {
    static_assert(N <= 6);
    return sum_of_products(a, b, N);
}

/// Whether the n elements of `column` are column j of the identity, with zeros for the rest. A matrix times
/// such a column is column j of that matrix.
SPANGLE_INLINE constexpr bool is_unit(const Element* column, int n, int j) {
    std::int32_t others = 0;
    for (int k = 0; k < n; ++k)
        others |= k == j ? 0 : column[k].m;
    return others == 0 && column[j].m == Matrix::one && column[j].e == Matrix::one_e;
}

/// Returns a times b, as sum_of_products() does for a sum that has no other term.
SPANGLE_INLINE constexpr Element only_product(Element a, Element b) {
    if (b.m == Matrix::one && b.e == Matrix::one_e)
        return a;
    const std::int64_t v = mul_s32(a.m, b.m);
    const std::int32_t e = a.e + b.e + 2 * element_bias;
    // A sum has room for one bit less than the largest product.
    return clz64(abs_u64(v)) < 3 ? make_element(shift_right_round(v, 1), e + 1) : make_element(v, e);
}

/// Does the work of multiply_column() for 4 x 4 matrices. Elements that are 0 add nothing to a sum, so this
/// leaves them out.
SPANGLE_INLINE constexpr void multiply_sparse_column(const Matrix& a, const Matrix& b, int j, Matrix& r) {
    int at[4] = {}, count = 0; // elements of b's column that are not 0
    for (int k = 0; k < 4; ++k)
        if (b.m[4 * j + k] != 0)
            at[count++] = k;
    for (int i = 0; i < 4; ++i) {
        Element row[4], column[4];
        int n = 0;
        for (int k = 0; k < count; ++k)
            if (a.m[4 * at[k] + i] != 0) {
                row[n] = a.at(i, at[k]);
                column[n++] = b.at(at[k], j);
            }
        r.set(i, j,
              n == 0   ? Element{}
              : n == 1 ? only_product(row[0], column[0])
                       : sum_of_products(row, column, n));
    }
}

/// Writes column j of a * b to r, which holds column j of a. Rows and columns have `half` elements: 4, or 3
/// for 3 x 3 matrices, for which `rest` holds further bits of b. `half` decides, and not `rest`, because
/// compilers do not know that its address is not null.
SPANGLE_RUN_INLINE constexpr void multiply_column(const Matrix& a, const Matrix& b, int j, int half,
                                                  const Element* rest, Matrix& r) {
    Element column[6];
    const int n = half == 3 ? 6 : 4;
    gather(b, 4 * j, 1, half, column);
    for (int i = half; i < n; ++i)
        column[i] = rest[i - half];
    if (runs_inline && is_unit(column, n, j)) // this branch only saves time
        return;
    if (wide_words && half == 4) // this branch only saves time
        return multiply_sparse_column(a, b, j, r);
    for (int i = 0; i < 4; ++i) {
        Element row[6];
        gather(a, i, 4, half, row);
        if (half == 3)
            gather(a, i, 4, half, row + half);
        r.set(i, j, sum_of_products(row, column, n));
    }
}

} // namespace detail

/// The row vector v times a.
constexpr void row_times(const Real (&v)[4], const Matrix& a, Real (&out)[4]) {
    const Element row[4] = {to_element(v[0]), to_element(v[1]), to_element(v[2]), to_element(v[3])};
    for (int j = 0; j < 4; ++j) {
        Element column[4];
        detail::column_of(a, j, column);
        out[j] = to_real(detail::sum_of_products(row, column));
    }
}

/// a * b (GL 1.3, 2.10.2: MultMatrix makes C * M). Each element is within 2^-31 of itself plus 2^-58 of its
/// largest term. Translations, and rotations about an axis, do not change some columns.
SPANGLE_RUN_CALL constexpr Matrix multiply(const Matrix& a, const Matrix& b) {
    Matrix r = a;
    for (int j = 0; j < 4; ++j)
        detail::multiply_column(a, b, j, 4, nullptr, r);
    return r;
}

} // namespace spangle::numeric
