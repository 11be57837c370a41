// The obligations of vertices: sums of products, 1/a, 1/sqrt(a).
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/reciprocal.hpp"
#include "raster/numeric/rsqrt.hpp"
#include "tests/oracle/gappa/obligations.hpp"

namespace spangle::gappa {
namespace {

using namespace spangle::numeric;

constexpr long long matrix_most = 0x7FFFFFFF; // in BlockMatrix |m| < 2^31
constexpr long long vertex_most = block_max;  // in Block4 |m| < 2^30
constexpr int half_bit = 31;                  // row_times rounds at 2^31

/// A row of a block matrix times a vertex: the 64-bit sum, its high word, and the sum of three products of
/// blocks.
void accumulators() {
    std::printf("@whole = fixed<0, ne>;\n"
                "m0 = whole(M0); m1 = whole(M1); m2 = whole(M2); m3 = whole(M3);\n"
                "v0 = whole(V0); v1 = whole(V1); v2 = whole(V2); v3 = whole(V3);\n"
                "sum = 1b%d + m0 * v0 + m1 * v1 + m2 * v2 + m3 * v3;\n"
                "high = fixed<0, dn>(sum * 1b-32);\n"
                "dot3 = v0 * v1 + v1 * v2 + v2 * v3;\n",
                half_bit);
    std::printf("{ ");
    for (int i = 0; i < 4; ++i)
        std::printf("m%d in [-%lld, %lld] /\\ v%d in [-%lld, %lld]%s", i, matrix_most, matrix_most, i,
                    vertex_most, vertex_most, i < 3 ? " /\\ " : "\n");
    std::printf("  -> sum in [-9223372036854775808, 9223372036854775807]\n"
                "  /\\ high in [-2147483648, 2147483647]\n"
                "  /\\ dot3 in [-4611686018427387904, 4611686018427387904] }\n");
}

/// Returns the largest relative error of the reciprocal's table at both ends of each interval, in parts of
/// 2^-40. The error is linear in a within an interval.
std::int64_t reciprocal_seed_error() {
    std::int64_t worst = 0;
    for (std::uint64_t i = 0; i < 256; ++i)
        for (std::uint64_t a : {(256 + i) << 23, ((257 + i) << 23) - 1}) {
            // The product has 62 fraction bits.
            const std::uint64_t product = a * detail::reciprocal_seed(static_cast<std::uint32_t>(a));
            const std::int64_t error = static_cast<std::int64_t>(product - (std::uint64_t{1} << 62)) >> 22;
            const std::int64_t size = (error < 0 ? -error : error) + 1;
            if (size > worst)
                worst = size;
        }
    return worst;
}

/// Returns the largest relative error of the table of 1/sqrt(a) at both ends of each interval, in parts of
/// 2^-40. The error is monotone within an interval.
std::int64_t rsqrt_seed_error() {
    double worst = 0;
    for (std::uint32_t i = 128; i < 512; ++i)
        for (const std::uint64_t a : {std::uint64_t{i} << 23, (std::uint64_t{i + 1} << 23) - 1}) {
            const double seed = detail::rsqrt_seed(i - 128) * 0x1p-15;
            worst = std::fmax(worst, std::fabs(seed * std::sqrt(static_cast<double>(a) * 0x1p-32) - 1));
        }
    return static_cast<std::int64_t>(worst * 0x1p40) + 1;
}

double bound(int tenths) {
    return std::exp2(-tenths / 10.0);
}

/// An element of a product of matrices: four products of mantissas, the largest of which is shifted to 2^61.
/// With `half`, a product of 62 bits is halved; a smaller product is shifted up, and no further.
void matrix_sum() {
    std::printf(
        "@whole = fixed<0, ne>;\n"
        "a = whole(A); b = whole(B); half = fixed<0, up>(a * b * 1b-1);\n"
        "t0 = whole(T0); t1 = whole(T1); t2 = whole(T2); t3 = whole(T3);\n"
        "sum = t0 + t1 + t2 + t3;\n"
        "{ |a| <= %lld /\\ |b| <= %lld /\\ |t0| <= 2305843009213693951 /\\ |t1| <= 2305843009213693951\n"
        "  /\\ |t2| <= 2305843009213693951 /\\ |t3| <= 2305843009213693951\n"
        "  -> |half| <= 2305843009213693951 /\\ |sum| <= 9223372036854775807 }\n",
        matrix_most, matrix_most);
}

// In the next scripts E is the relative error of a step's input, given as a hypothesis. The rewriting rule
// spells out Newton's identity, which Gappa cannot find by itself. Gappa checks the use of the rule; the rest
// is roundings.

void reciprocal_first() {
    const long long seed = reciprocal_seed_error();
    // r is the seed; p is mul_high_u32(a, r) in Q.30; r1 is the step, truncated to Q.30.
    std::printf("a = fixed<-32, dn>(A_);\n"
                "r = fixed<-15, dn>(R_);\n"
                "p fixed<-30, dn>= a * r;\n"
                "r1 fixed<-30, dn>= r * (2 - p);\n"
                "M = r * (2 - a * r);\n"
                "{ a in [0.5, 1] /\\ r in [0.99, 2] /\\ (r - 1/a) / (1/a) in [-%lldb-40, %lldb-40]\n"
                "  -> (r1 - 1/a) / (1/a) in [-%.17g, 1b-29] }\n"
                "(r1 - 1/a) / (1/a) -> (r1 - M) * a - ((r - 1/a) / (1/a)) * ((r - 1/a) / (1/a)) { a <> 0 };\n"
                "r1 - M -> (r1 - r * (2 - p)) + r * (a * r - p);\n",
                seed, seed, bound(reciprocal_1_accuracy));
}

void reciprocal_second() {
    // d is the residual with 48 fraction bits, one signed word; r2 is rounded to Q.30.
    std::printf("a = fixed<-32, dn>(A_);\n"
                "r = fixed<-30, dn>(R_);\n"
                "E = 1 - a * r;\n"
                "d = fixed<-48, dn>(E);\n"
                "r2 fixed<-30, ne>= r + r * d;\n"
                "M = r + r * E;\n"
                "{ a in [0.5, 1] /\\ r in [0.99, 2.0001] /\\ (r - 1/a) / (1/a) "
                "in [-%.17g, 1b-29]\n"
                "  -> r2 - 1/a in [-%.17g, %.17g] /\\ d * 1b48 in [-2147483648, 2147483647] }\n"
                "E -> -((r - 1/a) / (1/a)) { a <> 0 };\n"
                "r2 - 1/a -> (r2 - M) - (1/a) * (((r - 1/a) / (1/a)) * ((r - 1/a) / (1/a))) { a <> 0 };\n"
                "r2 - M -> (r2 - (r + r * d)) + r * (d - E);\n",
                bound(reciprocal_1_accuracy), reciprocal_ulp_percent / 100.0 * 0x1p-30,
                reciprocal_ulp_percent / 100.0 * 0x1p-30);
}

void rsqrt_first() {
    const long long seed = rsqrt_seed_error();
    // r is the seed, whose square is exact; p is a times the square, truncated to Q.30; r1 is the step,
    // truncated to Q.30.
    std::printf("a = fixed<-32, dn>(A_);\n"
                "r = fixed<-15, dn>(R_);\n"
                "T = 1 / sqrt(a);\n"
                "p fixed<-30, dn>= a * (r * r);\n"
                "r1 fixed<-30, dn>= r * (3 - p) / 2;\n"
                "M = r * (3 - a * (r * r)) / 2;\n"
                "Q = (r - T) / T;\n"
                "{ a in [0.25, 1] /\\ r in [0.99, 2] /\\ T in [1, 2] /\\ Q in [-%lldb-40, %lldb-40]\n"
                "  -> (r1 - T) / T in [-%.17g, 1b-29] }\n"
                "(r1 - T) / T -> (r1 - M) / T - (Q * Q) * (3 + Q) / 2;\n"
                "r1 - M -> (r1 - r * (3 - p) / 2) + r * (a * (r * r) - p) / 2;\n",
                seed, seed, bound(rsqrt_1_accuracy));
}

void rsqrt_second() {
    // s is r^2 rounded to Q.30; d is half the residual with 48 fraction bits, one signed word; r2 is rounded
    // to Q.30.
    std::printf("a = fixed<-32, dn>(A_);\n"
                "r = fixed<-30, dn>(R_);\n"
                "T = 1 / sqrt(a);\n"
                "s fixed<-30, ne>= r * r;\n"
                "F = (1 - a * s) / 2;\n"
                "d = fixed<-48, dn>(F);\n"
                "r2 fixed<-30, ne>= r + r * d;\n"
                "M = r + r * ((1 - a * (r * r)) / 2);\n"
                "Q = (r - T) / T;\n"
                "{ a in [0.25, 1] /\\ r in [0.99, 2] /\\ T in [1, 2] /\\ Q in [-%.17g, 1b-29]\n"
                "  -> (r2 - T) / T in [-%.17g, %.17g] /\\ d * 1b48 in [-2147483648, 2147483647] }\n"
                "F -> -(Q + Q * Q / 2) - a * (s - r * r) / 2 { a <> 0 };\n"
                "(r2 - T) / T -> (r2 - M) / T - (3 * (Q * Q) + Q * Q * Q) / 2;\n"
                "r2 - M -> (r2 - (r + r * d)) + r * (d - F) - r * (a * (s - r * r)) / 2;\n",
                bound(rsqrt_1_accuracy), bound(rsqrt_accuracy), bound(rsqrt_accuracy));
}

/// normalize(): u is a component of v / |v|. The square of |v| lost less than 2^-32 of [1/4, 1] when it
/// became a word. E is the error of rsqrt().
void normalize() {
    std::printf("lost = 1 / sqrt(1 - theta);\n"
                "unit = fixed<-30, ne>(u * (lost * (1 + E)));\n"
                "{ u in [-1, 1] /\\ theta in [0, 1b-30] /\\ E in [-%.17g, %.17g]\n"
                "  -> unit - u in [-1b-28, 1b-28] }\n"
                "unit - u -> (unit - u * (lost * (1 + E))) + u * ((lost - 1) + lost * E);\n",
                bound(rsqrt_accuracy), bound(rsqrt_accuracy));
}

/// dot() of two unit vectors, whose components are 1 at most.
void dot_units() {
    std::printf(
        "@whole = fixed<0, ne>;\n"
        "x = whole(X); y = whole(Y); z = whole(Z); k = whole(K); l = whole(L); m = whole(M);\n"
        "sum = x * k + y * l + z * m + 1b29;\n"
        "{ |x| <= 1b30 /\\ |y| <= 1b30 /\\ |z| <= 1b30 /\\ |k| <= 1b30 /\\ |l| <= 1b30 /\\ |m| <= 1b30\n"
        "  -> |sum| <= 4611686018427387904 }\n");
}

} // namespace

const std::vector<Obligation>& vertex_obligations() {
    static const std::vector<Obligation> all = {
        {"accumulators", accumulators},
        {"matrix_sum", matrix_sum},
        {"reciprocal_first", reciprocal_first},
        {"reciprocal_second", reciprocal_second},
        {"rsqrt_first", rsqrt_first},
        {"rsqrt_second", rsqrt_second},
        {"normalize", normalize},
        {"dot_units", dot_units},
    };
    return all;
}

} // namespace spangle::gappa
