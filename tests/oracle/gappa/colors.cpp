// The obligations of colours: products, mixtures, blending, filters.
#include <cstdio>

#include "raster/ops/number.hpp"
#include "tests/oracle/gappa/obligations.hpp"

namespace spangle::gappa {
namespace {

using raster::Balanced;
using raster::Exact;

/// Exact::mul() in units of which Exact::one has 255 2^20. A factor of 32 bits is a sum of four shifts of v,
/// which is less than 4 below 4096 / 255 v; the product is rounded.
void blend_exact() {
    constexpr unsigned one = Exact::one;
    std::printf("@whole = fixed<0, ne>;\n"
                "@down = fixed<0, dn>;\n"
                "a = whole(A); v = whole(V);\n"
                "f = v * 16 + down(v / 16) + down(v / 4096) + down(v / 1048576);\n"
                "exact = v * 4096 / 255;\n"
                "sum = a * f + 1b31;\n"
                "product = down(sum * 1b-32);\n"
                "{ a in [0, %u] /\\ v in [0, %u]\n"
                "  -> f - exact in [-4, 0] /\\ f in [0, 4294967295] /\\ sum in [0, 9223372036854775807]\n"
                "  /\\ product - a * exact * 1b-32 in [-0.75, 0.5] }\n"
                "f - exact -> (down(v / 16) - v / 16) + (down(v / 4096) - v / 4096) +\n"
                "             (down(v / 1048576) - v / 1048576) - v * (1 / 267386880);\n"
                "product - a * exact * 1b-32 -> (product - sum * 1b-32) + 0.5 + a * (f - exact) * 1b-32;\n",
                one, one);
}

/// Exact::mix(): the difference, with two more bits, is a signed word, and the result is rounded down.
void mix_exact() {
    constexpr unsigned one = Exact::one;
    std::printf(
        "@whole = fixed<0, ne>;\n"
        "@down = fixed<0, dn>;\n"
        "a = whole(A); b = whole(B); f = whole(F);\n"
        "difference = (b - a) * 4;\n"
        "mixed = a + down(difference * f * 1b-32);\n"
        "{ a in [0, %u] /\\ b in [0, %u] /\\ f in [0, 1b30]\n"
        "  -> |difference| <= 2147483647 /\\ mixed - (a + (b - a) * f * 1b-30) in [-1, 0] }\n"
        "mixed - (a + (b - a) * f * 1b-30) -> down(difference * f * 1b-32) - difference * f * 1b-32;\n",
        one, one);
}

/// Exact::weighted(): texels are multiplied by weights of 16 bits, and each weight is 1 at most.
void filter_exact() {
    constexpr unsigned one = Exact::one;
    std::printf("@whole = fixed<0, ne>;\n"
                "a = whole(A); b = whole(B); c = whole(C); d = whole(D);\n"
                "j = whole(J); k = whole(K); l = whole(L); m = whole(M);\n"
                "exact = a * j + b * k + c * l + d * m;\n"
                "sum = exact + 65535;\n"
                "filtered = fixed<0, dn>(sum * 1b-16);\n"
                "{ a in [0, %u] /\\ b in [0, %u] /\\ c in [0, %u] /\\ d in [0, %u] /\\ j in [0, 1b16]\n"
                "  /\\ k in [0, 1b16] /\\ l in [0, 1b16] /\\ m in [0, 1b16]\n"
                "  -> sum in [0, 1b47] /\\ filtered - exact * 1b-16 in [-1, 1] }\n"
                "filtered - exact * 1b-16 -> (filtered - sum * 1b-16) + 65535 * 1b-16;\n",
                one, one, one, one);
}

/// Balanced::mul() in 256ths of a 255th, computed in halves of words.
void blend_balanced() {
    constexpr unsigned one = Balanced<1>::one;
    std::printf("@whole = fixed<0, ne>;\n"
                "@down = fixed<0, dn>;\n"
                "a = whole(A); v = whole(V);\n"
                "f = v + down(v / 256);\n"
                "exact = v * 256 / 255;\n"
                "product = down(a * f * 1b-16);\n"
                "{ a in [0, %u] /\\ v in [0, %u]\n"
                "  -> f in [0, 65535] /\\ f - exact in [-2, 0] /\\ product - a * exact * 1b-16 in [-3, 0] }\n"
                "f - exact -> (down(v / 256) - v / 256) - v * (1 / 65280);\n"
                "product - a * exact * 1b-16 -> (product - a * f * 1b-16) + a * (f - exact) * 1b-16;\n",
                one, one);
}

/// Balanced::over() of a stored value of 5 or 6 bits: k / most (1 - a), as the sum of 65025ths has it.
void over_balanced(unsigned bits) {
    using N = Balanced<1>;
    const unsigned most = (1u << bits) - 1;
    std::printf("@whole = fixed<0, ne>;\n"
                "@down = fixed<0, dn>;\n"
                "k = whole(K); rest = whole(R);\n"
                "weight = down((rest + %u) * %u * 1b-16);\n"
                "exact = rest * (65025 / (%u * 65280));\n"
                "stored = k * weight;\n"
                "{ k in [0, %u] /\\ rest in [0, %u]\n"
                "  -> stored in [0, 65535] /\\ stored - k * exact in [-51, 51] }\n"
                "weight - exact -> (weight - (rest + %u) * %u * 1b-16) + (%u * %u * 1b-16) +\n"
                "                  rest * (%u * 1b-16 - 65025 / (%u * 65280));\n"
                "stored - k * exact -> k * (weight - exact);\n",
                N::over_half(bits), N::over_scale(bits), most, most, N::one, N::over_half(bits),
                N::over_scale(bits), N::over_half(bits), N::over_scale(bits), N::over_scale(bits), most);
}
void over_5() {
    over_balanced(5);
}
void over_6() {
    over_balanced(6);
}

} // namespace

const std::vector<Obligation>& color_obligations() {
    static const std::vector<Obligation> all = {
        {"blend_exact", blend_exact},       {"mix_exact", mix_exact}, {"filter_exact", filter_exact},
        {"blend_balanced", blend_balanced}, {"over_5", over_5},       {"over_6", over_6},
    };
    return all;
}

} // namespace spangle::gappa
