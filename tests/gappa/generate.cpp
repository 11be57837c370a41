// Prints the proof obligations with the numbers of the headers: table errors, widths, bounds. `generate NAME`
// writes one Gappa script to stdout.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/reciprocal.hpp"
#include "raster/numeric/rsqrt.hpp"
#include "raster/primitive/diamond.hpp"
#include "raster/primitive/edge.hpp"

namespace {

using namespace spangle::numeric;

constexpr long long matrix_most = 0x7FFFFFFF; // BlockMatrix: |m| < 2^31
constexpr long long vertex_most = block_max;  // Block4: |m| < 2^30
constexpr int half_bit = 31;                  // row_times rounds at 2^31

/// Row of a block matrix times a vertex: the 64-bit sum, its high word, and the sum of three products of
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

/// Largest relative error of the reciprocal's table over each interval's two ends, in parts of 2^-40: the
/// error is linear in a within an interval.
std::int64_t reciprocal_seed_error() {
    std::int64_t worst = 0;
    for (std::uint64_t i = 0; i < 256; ++i)
        for (std::uint64_t a : {(256 + i) << 23, ((257 + i) << 23) - 1}) {
            const std::uint64_t product = a * detail::reciprocal_seed(static_cast<std::uint32_t>(a)); // Q.62
            const std::int64_t error = static_cast<std::int64_t>(product - (std::uint64_t{1} << 62)) >> 22;
            const std::int64_t size = (error < 0 ? -error : error) + 1;
            if (size > worst)
                worst = size;
        }
    return worst;
}

double bound(int tenths) {
    return std::exp2(-tenths / 10.0);
}

// In all of these E is the relative error of what a step starts from, given as a hypothesis, and the
// rewriting rule spells out Newton's identity, which Gappa cannot find by itself; it checks the rule's use,
// and the rest is roundings.

void reciprocal_first() {
    const long long seed = reciprocal_seed_error();
    // r: the seed; p: mul_high_u32(a, r) in Q.30; r1: the step, truncated to Q.30.
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
    // d: the residual with 48 fraction bits, one signed word; r2: rounded to Q.30.
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

void rsqrt_second() {
    // s: r^2 rounded to Q.30; d: half the residual with 48 fraction bits, one signed word; r2: rounded to
    // Q.30.
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

/// Set-up and walk of an edge, anything in the guard band.
void edge_wide() {
    using namespace spangle::raster;
    static_assert(edge_max_denominator == std::int64_t{2} * guard_band * subpixel_one);
    const long long guard = guard_band, extent = 2 * guard;
    std::printf("@whole = fixed<0, ne>;\n"
                "dx = whole(DX); dy = whole(DY); above = whole(AB); inside = whole(IN);\n"
                "part = whole(PA); rest = whole(RE); x0 = whole(X0);\n"
                "numerator = above * dx + inside * dy;\n"
                "denominator = dy * %d;\n"
                "stepped = rest + part * %d;\n"
                "{ x0 in [-%lld, %lld] /\\ dx in [-%lld, %lld] /\\ dy in [1, %lld] /\\ above in [0, %lld]\n"
                "  /\\ inside in [-%d, %d] /\\ part in [0, %lld] /\\ rest in [-%lld, 0]\n"
                "  -> |numerator| <= 9223372036854775807 /\\ denominator in [1, 2147483647]\n"
                "  /\\ stepped in [-2147483648, 2147483647] }\n",
                subpixel_one, subpixel_one, guard, guard, extent, extent, extent, extent + subpixel_one,
                subpixel_one / 2, subpixel_one / 2, extent - 1, extent * subpixel_one);
}

/// SmallEdge: how far the column at any of its rows is short of the exact one; the bias tells an edge that
/// meets a centre from one that passes it by 1 / (256 dy) when that is less than 2^-24 and 2^-22 at least.
void edge_small() {
    using namespace spangle::raster;
    const int most = SmallEdge::extent, rows = most / subpixel_one + 1;
    std::printf("@whole = fixed<0, ne>;\n"
                "dx = whole(DX); dy = whole(DY); above = whole(AB); n = whole(N);\n"
                "slope = dx / dy;\n"
                "step = fixed<-32, dn>(slope);\n"
                "up = fixed<-32, dn>(step * above / %d);\n"
                "rows = above / %d + n;\n"
                "short = slope * rows - (up + n * step);\n"
                "lifted = dx + dy * 16384;\n"
                "finest = 1 / (%d * dy);\n"
                "{ |dx| <= %d /\\ dy in [1, %d] /\\ above in [0, %d] /\\ n in [0, %d] /\\ rows in [0, %d]\n"
                "  -> short in [0, 1b-25] /\\ lifted in [0, 4294967295] /\\ finest in [1b-22, 1]\n"
                "  /\\ (dy - 1) * 262144 in [0, 4294967295] }\n"
                "short -> (slope - step) * rows + (step * above / %d - up);\n",
                subpixel_one, subpixel_one, subpixel_one, most, most, most, rows, rows, subpixel_one);
}

/// Diamond::first() in 32 bits: the numerator is not negative either, |slope| being 1 at most.
void diamond_first() {
    using namespace spangle::raster;
    const int most = Diamond<LineLanes<1>>::small_length, half = subpixel_one / 2;
    std::printf("@whole = fixed<0, ne>;\n"
                "from = whole(FR); rise = whole(RI); inside = whole(IN); length = whole(LE);\n"
                "tie = whole(TI); slope = rise / length;\n"
                "numerator = from * rise + (inside + %d) * length - tie;\n"
                "{ from in [-%d, %d] /\\ |rise| <= %d /\\ inside in [0, %d] /\\ length in [1, %d]\n"
                "  /\\ tie in [0, 1] /\\ |slope| <= 1\n"
                "  -> |numerator| <= 2147483647 /\\ from * slope + inside + %d in [129, 1150] }\n",
                2 * subpixel_one, half, half + subpixel_one - 1, most, subpixel_one - 1, most,
                2 * subpixel_one);
}

} // namespace

struct Obligation {
    const char* name;
    void (*print)();
};

constexpr Obligation obligations[] = {
    {"accumulators", accumulators},
    {"reciprocal_first", reciprocal_first},
    {"reciprocal_second", reciprocal_second},
    {"rsqrt_second", rsqrt_second},
    {"edge_wide", edge_wide},
    {"edge_small", edge_small},
    {"diamond_first", diamond_first},
};

int main(int argc, char** argv) {
    for (const Obligation& o : obligations)
        if (argc == 2 && std::strcmp(argv[1], o.name) == 0)
            return o.print(), 0;
    std::fprintf(stderr, "usage: generate NAME, with NAME one of");
    for (const Obligation& o : obligations)
        std::fprintf(stderr, " %s", o.name);
    std::fprintf(stderr, "\n");
    return 2;
}
