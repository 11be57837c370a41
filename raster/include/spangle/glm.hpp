// Makes spangle::fixed a component type of GLM. Include this file instead of <glm/glm.hpp>. All of GLM works
// through the operators and functions of spangle::fixed. Functions that would round at every product, or
// overflow where their result does not, are specialised here with 64-bit sums. glm::value_ptr of a matrix
// points to the bits of GLfixed, which glLoadMatrixx takes.
#pragma once

#include <spangle/fixed.hpp> // numeric_limits must be specialised before GLM is seen

namespace glm {
// GLM calls the functions below both as glm::sin(x) and through argument-dependent lookup.
using spangle::abs, spangle::floor, spangle::ceil, spangle::trunc, spangle::round, spangle::sqrt,
    spangle::inversesqrt;
using spangle::acos, spangle::asin, spangle::atan, spangle::cos, spangle::sin, spangle::tan;
} // namespace glm

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace spangle {

/// A vector of two components.
using fvec2 = glm::vec<2, fixed, glm::defaultp>;
/// A vector of three components.
using fvec3 = glm::vec<3, fixed, glm::defaultp>;
/// A vector of four components.
using fvec4 = glm::vec<4, fixed, glm::defaultp>;
/// A matrix of three columns of three components.
using fmat3 = glm::mat<3, 3, fixed, glm::defaultp>;
/// A matrix of four columns of four components, as GL takes them.
using fmat4 = glm::mat<4, 4, fixed, glm::defaultp>;
/// A quaternion of four components.
using fquat = glm::qua<fixed, glm::defaultp>;

namespace fixed_detail {

/// a . b with 30 fraction bits: four products of 2^60.
template <glm::length_t L, glm::qualifier Q>
constexpr std::int64_t sum_of_products(const glm::vec<L, fixed, Q>& a, const glm::vec<L, fixed, Q>& b) {
    std::int64_t sum = 0;
    for (glm::length_t i = 0; i < L; ++i)
        sum += (std::int64_t{a[i].bits} * b[i].bits) >> 2;
    return sum;
}

constexpr fixed from_sum(std::int64_t sum) {
    return fixed::from_bits(fixed::saturate((sum >> 14) + ((sum >> 13) & 1)));
}

} // namespace fixed_detail
} // namespace spangle

namespace glm {

namespace detail {

// GLM passes std::floor and similar functions by name.
template <length_t L, qualifier Q, bool Aligned> struct compute_floor<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static vec<L, spangle::fixed, Q> call(vec<L, spangle::fixed, Q> const& x) {
        return functor1<vec, L, spangle::fixed, spangle::fixed, Q>::call(spangle::floor, x);
    }
};
template <length_t L, qualifier Q, bool Aligned> struct compute_ceil<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static vec<L, spangle::fixed, Q> call(vec<L, spangle::fixed, Q> const& x) {
        return functor1<vec, L, spangle::fixed, spangle::fixed, Q>::call(spangle::ceil, x);
    }
};
template <length_t L, qualifier Q, bool Aligned> struct compute_round<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static vec<L, spangle::fixed, Q> call(vec<L, spangle::fixed, Q> const& x) {
        return functor1<vec, L, spangle::fixed, spangle::fixed, Q>::call(spangle::round, x);
    }
};
template <length_t L, qualifier Q, bool Aligned> struct compute_trunc<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static vec<L, spangle::fixed, Q> call(vec<L, spangle::fixed, Q> const& x) {
        return functor1<vec, L, spangle::fixed, spangle::fixed, Q>::call(spangle::trunc, x);
    }
};
template <length_t L, qualifier Q, bool Aligned> struct compute_sqrt<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static vec<L, spangle::fixed, Q> call(vec<L, spangle::fixed, Q> const& x) {
        return functor1<vec, L, spangle::fixed, spangle::fixed, Q>::call(spangle::sqrt, x);
    }
};
template <length_t L, qualifier Q, bool Aligned> struct compute_inversesqrt<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static vec<L, spangle::fixed, Q> call(vec<L, spangle::fixed, Q> const& x) {
        return functor1<vec, L, spangle::fixed, spangle::fixed, Q>::call(spangle::inversesqrt, x);
    }
};

template <length_t L, qualifier Q> struct compute_fixed_dot {
    using V = vec<L, spangle::fixed, Q>;
    GLM_FUNC_QUALIFIER static spangle::fixed call(V const& a, V const& b) {
        return spangle::fixed_detail::from_sum(spangle::fixed_detail::sum_of_products(a, b));
    }
};
template <qualifier Q, bool Aligned>
struct compute_dot<vec<2, spangle::fixed, Q>, spangle::fixed, Aligned> : compute_fixed_dot<2, Q> {};
template <qualifier Q, bool Aligned>
struct compute_dot<vec<3, spangle::fixed, Q>, spangle::fixed, Aligned> : compute_fixed_dot<3, Q> {};
template <qualifier Q, bool Aligned>
struct compute_dot<vec<4, spangle::fixed, Q>, spangle::fixed, Aligned> : compute_fixed_dot<4, Q> {};

template <qualifier Q, bool Aligned> struct compute_cross<spangle::fixed, Q, Aligned> {
    using V = vec<3, spangle::fixed, Q>;
    GLM_FUNC_QUALIFIER static V call(V const& a, V const& b) {
        const auto minor = [](spangle::fixed p, spangle::fixed q, spangle::fixed r, spangle::fixed s) {
            return spangle::fixed_detail::from_sum(((std::int64_t{p.bits} * q.bits) >> 2) -
                                                   ((std::int64_t{r.bits} * s.bits) >> 2));
        };
        return V(minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x));
    }
};

/// The root of the 64-bit sum, for lengths up to the whole range. A dot product would have saturated at
/// 181^2.
template <length_t L, qualifier Q, bool Aligned> struct compute_length<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static spangle::fixed call(vec<L, spangle::fixed, Q> const& v) {
        const auto sum = static_cast<std::uint64_t>(spangle::fixed_detail::sum_of_products(v, v));
        if (sum >> 60 != 0)
            return spangle::fixed::from_bits(INT32_MAX);
        return spangle::fixed::from_bits(
            static_cast<std::int32_t>(spangle::fixed_detail::integer_sqrt(sum << 2)));
    }
};

/// v / |v|. A zero vector stays as it is.
template <length_t L, qualifier Q, bool Aligned> struct compute_normalize<L, spangle::fixed, Q, Aligned> {
    GLM_FUNC_QUALIFIER static vec<L, spangle::fixed, Q> call(vec<L, spangle::fixed, Q> const& v) {
        // The vector is scaled up first, so that the length of a short vector has enough bits.
        std::uint32_t any = 0;
        for (length_t i = 0; i < L; ++i)
            any |= static_cast<std::uint32_t>(v[i].bits < 0 ? -std::int64_t{v[i].bits} : v[i].bits);
        vec<L, spangle::fixed, Q> out(v);
        if (any == 0)
            return out;
        int shift = 0;
        while (any >> 29 == 0)
            any <<= 1, ++shift;
        std::uint64_t square = 0;
        for (length_t i = 0; i < L; ++i) {
            const std::int64_t c = std::int64_t{v[i].bits} << shift; // `c` is below 2^32
            square += static_cast<std::uint64_t>(c * c) >> 3;
        }
        const auto length =
            static_cast<std::int64_t>(spangle::fixed_detail::integer_sqrt(square)); // the length over sqrt 8
        for (length_t i = 0; i < L; ++i) {
            // c / (length sqrt 8) in 16 bits: 2^16 / sqrt 8 = 23170.475, as Q.16 1518500250
            const std::int64_t c = std::int64_t{v[i].bits} << shift;
            out[i] = spangle::fixed::from_bits(
                spangle::fixed::quotient((c * 1518500250 + (1 << 15)) >> 16, length));
        }
        return out;
    }
};

/// The adjugate over the determinant. Every stage is scaled to 30 bits by its own largest number. The result
/// is 0 for a singular matrix.
template <qualifier Q, bool Aligned> struct compute_inverse<4, 4, spangle::fixed, Q, Aligned> {
    using M = mat<4, 4, spangle::fixed, Q>;
    GLM_FUNC_QUALIFIER static M call(M const& m) {
        std::int64_t v[16], all[12], adjugate[16];
        for (int k = 0; k < 16; ++k)
            v[k] = m[k / 4][k % 4].bits;
        const int up = scale(v, 16);
        constexpr int pair[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
        for (int p = 0; p < 6;
             ++p) { // 2 x 2 minors of columns 0, 1 and of columns 2, 3 in the rows of the pair
            const int a = pair[p][0], b = pair[p][1];
            all[p] = v[a] * v[4 + b] - v[b] * v[4 + a];
            all[6 + p] = v[8 + a] * v[12 + b] - v[8 + b] * v[12 + a];
        }
        scale(all, 12);
        constexpr int rest[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
        constexpr int minor[4][3] = {{5, 4, 3}, {5, 2, 1}, {4, 2, 0}, {3, 1, 0}};
        for (int i = 0; i < 4; ++i) // cofactor of (row i, column j), stored transposed
            for (int j = 0; j < 4; ++j) {
                const std::int64_t* column = v + 4 * (j ^ 1);
                const std::int64_t* minors = j < 2 ? all + 6 : all;
                const std::int64_t c = column[rest[i][0]] * minors[minor[i][0]] -
                                       column[rest[i][1]] * minors[minor[i][1]] +
                                       column[rest[i][2]] * minors[minor[i][2]];
                adjugate[4 * i + j] = (i + j) % 2 == 0 ? c : -c;
            }
        scale(adjugate, 16);
        std::int64_t determinant[1] = {0};
        for (int i = 0; i < 4; ++i)
            determinant[0] += v[i] * adjugate[4 * i];
        const int up_determinant = scale(determinant, 1);
        M out(spangle::fixed::from_bits(0));
        if (determinant[0] == 0)
            return out;
        // adjugate / determinant * 2^(16 + up), in 16 bits
        const int shift = up + up_determinant;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                out[i][j] = spangle::fixed::from_bits(
                    shifted((adjugate[4 * i + j] * (std::int64_t{1} << 32)) / determinant[0], shift));
        return out;
    }

  private:
    /// Shifts all values so that the largest has 30 bits. Returns the shift, positive to the left.
    static int scale(std::int64_t* v, int count) {
        std::uint64_t any = 0;
        for (int k = 0; k < count; ++k)
            any |= static_cast<std::uint64_t>(v[k] < 0 ? -v[k] : v[k]);
        if (any == 0)
            return 0;
        int up = 0;
        while (any >> 30 != 0)
            any >>= 1, --up;
        while (any >> 29 == 0)
            any <<= 1, ++up;
        for (int k = 0; k < count; ++k)
            v[k] = up >= 0 ? v[k] * (std::int64_t{1} << up) : (v[k] + (std::int64_t{1} << (-up - 1))) >> -up;
        return up;
    }
    static std::int32_t shifted(std::int64_t v, int up) {
        if (up <= -62)
            return 0;
        if (up < 0)
            return spangle::fixed::saturate((v + (std::int64_t{1} << (-up - 1))) >> -up);
        for (; up > 0 && v < INT32_MAX && v > INT32_MIN; --up)
            v *= 2;
        return spangle::fixed::saturate(v);
    }
};

template <qualifier Q, bool Aligned> struct compute_inverse<3, 3, spangle::fixed, Q, Aligned> {
    using M = mat<3, 3, spangle::fixed, Q>;
    GLM_FUNC_QUALIFIER static M call(M const& m) {
        return M(compute_inverse<4, 4, spangle::fixed, Q, Aligned>::call(mat<4, 4, spangle::fixed, Q>(m)));
    }
};

} // namespace detail

/// A matrix times a vector, by one 64-bit sum per row. It rounds once, and uses SMLAL on processors that have
/// it.
template <qualifier Q>
GLM_FUNC_QUALIFIER vec<4, spangle::fixed, Q> operator*(mat<4, 4, spangle::fixed, Q> const& m,
                                                       vec<4, spangle::fixed, Q> const& v) {
    vec<4, spangle::fixed, Q> out;
    for (length_t i = 0; i < 4; ++i) {
        const vec<4, spangle::fixed, Q> row(m[0][i], m[1][i], m[2][i], m[3][i]);
        out[i] = spangle::fixed_detail::from_sum(spangle::fixed_detail::sum_of_products(row, v));
    }
    return out;
}
/// A matrix times a vector of three components, rounded once for each row.
template <qualifier Q>
GLM_FUNC_QUALIFIER vec<3, spangle::fixed, Q> operator*(mat<3, 3, spangle::fixed, Q> const& m,
                                                       vec<3, spangle::fixed, Q> const& v) {
    vec<3, spangle::fixed, Q> out;
    for (length_t i = 0; i < 3; ++i) {
        const vec<3, spangle::fixed, Q> row(m[0][i], m[1][i], m[2][i]);
        out[i] = spangle::fixed_detail::from_sum(spangle::fixed_detail::sum_of_products(row, v));
    }
    return out;
}
/// The product of two matrices. Each element is rounded once.
template <qualifier Q>
GLM_FUNC_QUALIFIER mat<4, 4, spangle::fixed, Q> operator*(mat<4, 4, spangle::fixed, Q> const& a,
                                                          mat<4, 4, spangle::fixed, Q> const& b) {
    return mat<4, 4, spangle::fixed, Q>(a * b[0], a * b[1], a * b[2], a * b[3]);
}
/// The product of two matrices of three columns.
template <qualifier Q>
GLM_FUNC_QUALIFIER mat<3, 3, spangle::fixed, Q> operator*(mat<3, 3, spangle::fixed, Q> const& a,
                                                          mat<3, 3, spangle::fixed, Q> const& b) {
    return mat<3, 3, spangle::fixed, Q>(a * b[0], a * b[1], a * b[2]);
}

} // namespace glm
