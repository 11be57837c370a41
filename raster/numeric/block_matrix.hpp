// The matrix by which the vertex pipeline multiplies, derived from the stacks when they have changed. Its
// int32 mantissas are scaled per row and per column. The scale per column keeps the bits that count. In
// Ortho(0, 320, ...) 1/160 is multiplied by an x of 320 and -1 by a w of 1, and far from the origin large
// terms cancel. With one exponent for all elements, small elements would lose these bits.
#pragma once

#include <cstdint>

#include "raster/numeric/block.hpp"
#include "raster/numeric/matrix.hpp"

namespace spangle::numeric {

/// Integers with one exponent, not normalised: value i is m[i] * 2^e.
template <int N> struct Mantissas {
    std::int32_t m[N];
    std::int32_t e;
};

/// Exponents by which the components of a vertex are scaled before they get one exponent.
template <int N> struct Columns {
    std::int32_t e[N] = {};
    /// A vertex whose largest component has this exponent or more loses its components with a biased exponent
    /// of 0.
    std::int32_t least = 32;
    /// The number of exponents from `least` on with which all components are finite, and none is shifted by
    /// more than 255.
    std::uint32_t usual = 221;
};

/// Element (i, j) is m[N * i + j] * 2^(row[i] + column.e[j] - 31). The magnitudes of a row sum to less than
/// 2^31.
template <int N> struct BlockMatrixN {
    std::int32_t m[N * N] = {};
    std::int32_t row[N] = {};
    Columns<N> column;
};

using BlockMatrix = BlockMatrixN<4>;
using BlockMatrix3 = BlockMatrixN<3>; ///< the matrix by which normals are multiplied

/// One row of a matrix under given column exponents. The row has its own exponent.
template <int N> struct BlockRowN {
    std::int32_t m[N] = {};
    std::int32_t e = 0;
};
using BlockRow = BlockRowN<4>;
using BlockRow3 = BlockRowN<3>;

namespace detail {

inline constexpr std::int32_t no_exponent = -0x10000;

/// The least n for which 2^n > |v|. v is not 0.
constexpr std::int32_t width(Block v) {
    return v.e + block_bits;
}

/// Finds the exponent of each column from its largest element. The matrix is column-major and has `rows`
/// rows. A column of zeros gets the exponent of the largest column.
SPANGLE_RUN_INLINE constexpr void set_columns(int n, int rows, const Block* a, std::int32_t* out,
                                              std::int32_t& least, std::uint32_t& usual) {
    std::int32_t most = no_exponent;
    for (int j = 0; j < n; ++j) {
        out[j] = no_exponent;
        for (int i = 0; i < rows; ++i)
            if (a[rows * j + i].m != 0 && width(a[rows * j + i]) > out[j])
                out[j] = width(a[rows * j + i]);
        if (out[j] > most)
            most = out[j];
    }
    const bool zeros = most == no_exponent;
    std::int32_t lowest = zeros ? 0 : block_exponent(most);
    if (!zeros)
        least = lowest + 32;
    for (int j = 0; j < n; ++j) {
        out[j] = zeros ? 0 : block_exponent(out[j] == no_exponent ? most : out[j]);
        lowest = out[j] < lowest ? out[j] : lowest;
    }
    if (!zeros)
        usual = lowest + 253 > least ? static_cast<std::uint32_t>(lowest + 253 - least) : 0;
}
template <int N, int R> constexpr Columns<N> column_exponents(const Block (&a)[R * N]) {
    Columns<N> r;
    set_columns(N, R, a, r.e, r.least, r.usual);
    return r;
}

/// Scales the elements of one row, which lie `stride` apart, to the exponents of columns and a row exponent
/// of at least `exponent`. The magnitudes of the mantissas sum to less than 2^31. Returns the row exponent.
SPANGLE_RUN_INLINE constexpr std::int32_t scale_words(int n, const Block* a, int stride,
                                                      const std::int32_t* column, std::int32_t exponent,
                                                      std::int32_t* out) {
    std::int32_t own = no_exponent;
    for (int j = 0; j < n; ++j)
        if (a[stride * j].m != 0 && width(a[stride * j]) - column[j] > own)
            own = width(a[stride * j]) - column[j];
    if (own == no_exponent) // all elements are 0, and any exponent is right
        own = exponent == no_exponent ? 0 : exponent;
    // The loop has at most three rounds, because n <= 4.
    for (exponent = own > exponent ? own : exponent;; ++exponent) {
        std::uint64_t sum = 0;
        for (int j = 0; j < n; ++j) {
            const Block v = a[stride * j];
            out[j] = wide_words && v.m == 0 ? 0 : scale_saturate(v.m, v.e + 31 - exponent - column[j]);
            sum += abs_u32(out[j]);
        }
        if (sum < std::uint64_t{1} << 31)
            return block_exponent(exponent);
    }
}
template <int N>
constexpr std::int32_t scale_row(const Block* a, int stride, const Columns<N>& column, std::int32_t exponent,
                                 std::int32_t* out) {
    return scale_words(N, a, stride, column.e, exponent, out);
}

/// Scales all rows. Rows of positions are never finer than the last row, by which they are divided. Rows of
/// normals get one exponent, if that costs none of them more than 4 bits.
SPANGLE_RUN_INLINE constexpr void scale_rows(int n, const Block* a, const std::int32_t* column,
                                             std::int32_t* row, std::int32_t* out) {
    std::int32_t exponent = no_exponent, most = no_exponent, least = -no_exponent;
    for (int i = n - 1; i >= 0; --i) {
        row[i] = scale_words(n, a + i, n, column, exponent, out + n * i);
        if (n == 4)
            exponent = row[3];
        most = row[i] > most ? row[i] : most;
        least = row[i] < least ? row[i] : least;
    }
    if (n == 3 && most - least <= 4)
        for (int i = 0; i < n; ++i)
            row[i] = scale_words(n, a + i, n, column, most, out + n * i);
}
template <int N> constexpr BlockMatrixN<N> scale_blocks(const Block (&a)[N * N]) {
    BlockMatrixN<N> r;
    r.column = column_exponents<N, N>(a);
    scale_rows(N, a, r.column.e, r.row, r.m);
    return r;
}

/// Does what load() does, for a vertex whose components are all far smaller than the columns expect. Such
/// vertices are rare, so this is never inline.
template <int N>
[[gnu::noinline]] constexpr Mantissas<N> load_small(const Columns<N>& column, const Real (&v)[N]) {
    Mantissas<N> out{};
    out.e = reals_under_one(N, v, column.e, out.m);
    return out;
}

/// Finds the exponents of the components, scaled by their columns, from the exponents of the floats alone.
/// Returns the largest exponent.
template <int N>
SPANGLE_INLINE constexpr std::int32_t product_exponents(const Columns<N>& column, const Real (&v)[N],
                                                        std::int32_t (&e)[N]) {
    std::int32_t top = e[0] = static_cast<std::int32_t>((v[0].bits >> 23) & 255) + column.e[0];
#pragma GCC unroll runs_inline ? 4 : 1
    for (int i = 1; i < N; ++i) {
        e[i] = static_cast<std::int32_t>((v[i].bits >> 23) & 255) + column.e[i];
        top = e[i] > top ? e[i] : top;
    }
    return top;
}

/// Brings the components to an exponent two above the largest, which leaves 30 bits. `shifted` shifts an
/// unsigned word to the right.
template <int N, class Shifted>
SPANGLE_INLINE constexpr Mantissas<N> align_mantissas(const Real (&v)[N], const std::int32_t (&e)[N],
                                                      std::int32_t top, const Shifted& shifted) {
    Mantissas<N> out{};
    top += 2; // each mantissa has at most 30 bits
    std::uint32_t one = 0x80000000u;
    one = kept_in_register(one);
#pragma GCC unroll runs_inline ? 4 : 1
    for (int i = 0; i < N; ++i) {
        const std::uint32_t magnitude = shifted(v[i].bits << 8 | one, static_cast<std::uint32_t>(top - e[i]));
        const std::uint32_t sign = 0u - (v[i].bits >> 31);
        out.m[i] = static_cast<std::int32_t>((magnitude ^ sign) - sign);
    }
    out.e = top - 127 - 31;
    return out;
}

} // namespace detail

/// v[i] * 2^column.e[i] with one exponent, |m| < 2^30, within an ulp towards 0. The float exponent of the
/// largest component decides. The implicit one of a 0 or a denormal is shifted out, unless all components are
/// as small.
template <int N> SPANGLE_INLINE constexpr Mantissas<N> load(const Columns<N>& column, const Real (&v)[N]) {
    // Uses the code for four components, the last of which has no effect.
    if constexpr (N == 3 && !runs_inline) {
        Columns<4> wide;
        wide.e[3] = detail::no_exponent;
        wide.least = column.least;
        Real padded[4] = {};
        for (int i = 0; i < N; ++i) {
            wide.e[i] = column.e[i];
            padded[i] = v[i];
        }
        const Mantissas<4> r = load<4>(wide, padded);
        return {{r.m[0], r.m[1], r.m[2]}, r.e};
    }
    std::int32_t e[N];
    const std::int32_t top = detail::product_exponents<N>(column, v, e);
    if (top < column.least) [[unlikely]]
        return detail::load_small<N>(column, v);
    return detail::align_mantissas<N>(
        v, e, top, [](std::uint32_t m, std::uint32_t down) __attribute__((always_inline)) {
            return shifted_out(m, down);
        });
}

/// Does what load() does, for floats of any bits. Returns false where a component may not be finite, where
/// all are far too small, or where some vanish beside others.
template <int N>
SPANGLE_INLINE constexpr bool load_usual(const Columns<N>& column, const Real (&v)[N], Mantissas<N>& out) {
    std::int32_t e[N];
    const std::int32_t top = detail::product_exponents<N>(column, v, e);
    if (static_cast<std::uint32_t>(top - column.least) >= column.usual) [[unlikely]]
        return false;
    out = detail::align_mantissas<N>(
        v, e, top, [](std::uint32_t m, std::uint32_t down) __attribute__((always_inline)) {
            return shifted_some(m, down);
        });
    return true;
}

/// `sum` plus a row times v. The magnitudes of the row are below 2^31 together, and those of v below 2^30, so
/// |row times v| < 2^61.
template <int N, class Element>
SPANGLE_INLINE constexpr std::int64_t row_sum(const Element* row, const std::int32_t (&v)[N],
                                              std::int64_t sum) {
#pragma GCC unroll runs_inline ? 4 : 1
    for (int j = 0; j < N; ++j)
        if constexpr (sizeof(Element) == sizeof(v[0]))
            sum += mul_long(row[j], v[j]);
        else
            sum += row[j] * v[j];
    return sum;
}
/// The high word of a row times v, rounded. It is below 2^29.
template <int N, class Element>
SPANGLE_INLINE constexpr std::int32_t row_times(const Element* row, const std::int32_t (&v)[N]) {
    return high_rounded(row_sum<N>(row, v, 0));
}

/// Does what row_times() does, for a v whose last component is 2^power, 0 <= power < 32. Without long
/// products this saves a product.
template <int N>
SPANGLE_INLINE constexpr std::int32_t row_times_point(const std::int32_t* row, const std::int32_t (&v)[N],
                                                      int power) {
    std::int64_t sum = shifted_up(row[N - 1], power);
#pragma GCC unroll runs_inline ? 4 : 1
    for (int j = 0; j < N - 1; ++j)
        sum = detail::add_halves(sum, row[j], v[j]);
    return high_rounded(sum);
}

/// Converts the first `count` elements to blocks of 30 bits each, column-major.
SPANGLE_RUN_INLINE constexpr void to_blocks(const Matrix& a, Block* v, int count = 16) {
    for (int i = 0; i < count; ++i)
        v[i] = to_block(a.at(i & 3, i >> 2));
}
constexpr BlockMatrix to_block_matrix(const Matrix& a) {
    Block v[16];
    to_blocks(a, v);
    return detail::scale_blocks<4>(v);
}

/// Makes a matrix for normals from elements in column-major order.
constexpr BlockMatrix3 to_block_matrix(const Block (&v)[9]) {
    return detail::scale_blocks<3>(v);
}

/// Row i of a, for vertices that are loaded with these columns. The columns may belong to another matrix.
constexpr BlockRow to_block_row(const Matrix& a, int i, const Columns<4>& column) {
    BlockRow r;
    if constexpr (runs_inline) { // converts one row, and not the whole matrix
        Block v[4];
        for (int j = 0; j < 4; ++j)
            v[j] = element(a, i, j);
        r.e = detail::scale_row<4>(v, 1, column, detail::no_exponent, r.m);
        return r;
    }
    Block v[16];
    to_blocks(a, v);
    r.e = detail::scale_row<4>(v + i, 4, column, detail::no_exponent, r.m);
    return r;
}

constexpr BlockRow3 to_block_row(const Block (&v)[3], const Columns<3>& column) {
    BlockRow3 r;
    r.e = detail::scale_row<3>(v, 1, column, detail::no_exponent, r.m);
    return r;
}

// --- normalised results

namespace detail {

/// Loads a vertex in block form with the exponents of columns.
template <int N, class B> constexpr Mantissas<N> load(const Columns<N>& column, const B& v) {
    std::int32_t m[N], e[N];
    for (int i = 0; i < N; ++i) {
        m[i] = v.m[i];
        e[i] = v.e + column.e[i];
    }
    return common_exponent<N, Mantissas<N>>(m, e);
}

template <int N, class B> constexpr B product(const BlockMatrixN<N>& a, const Mantissas<N>& v) {
    std::int32_t m[N], e[N];
    for (int i = 0; i < N; ++i) {
        m[i] = row_times<N>(a.m + N * i, v.m);
        e[i] = v.e + a.row[i] + 1; // the high word counts 2^32, and mantissas of rows count 2^-31
    }
    return common_exponent<N, B>(m, e);
}

} // namespace detail

/// a times a vertex that is loaded with its columns. The result is normalised by its largest component.
constexpr Block4 product(const BlockMatrix& a, const Mantissas<4>& v) {
    return detail::product<4, Block4>(a, v);
}
constexpr Block3 product(const BlockMatrix3& a, const Mantissas<3>& v) {
    return detail::product<3, Block3>(a, v);
}
constexpr Block product(const BlockRow& a, const Mantissas<4>& v) {
    return make_block(row_sum<4>(a.m, v.m, 0), v.e + a.e - 31);
}

/// a * v, normalised by its own largest component. v is loaded with the exponents of the columns, so each of
/// its floats keeps the bits that count. x/w, y/w and z/w are within 2^-25 of their terms at worst.
constexpr Block4 transform(const BlockMatrix& a, const Real (&v)[4]) {
    return product(a, load(a.column, v));
}
constexpr Block3 transform(const BlockMatrix3& a, const Real (&v)[3]) {
    return product(a, load(a.column, v));
}

/// Does what transform() does, for a vertex in block form. It keeps 30 bits of the vertex's largest
/// component.
constexpr Block4 transform(const BlockMatrix& a, const Block4& v) {
    return product(a, detail::load<4>(a.column, v));
}
constexpr Block3 transform(const BlockMatrix3& a, const Block3& v) {
    return product(a, detail::load<3>(a.column, v));
}

} // namespace spangle::numeric
