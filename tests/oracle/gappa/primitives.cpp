// The obligations of primitives: edges, diamonds, planes.
#include <cstdio>

#include "raster/primitive/diamond.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/span/span.hpp"
#include "tests/oracle/gappa/obligations.hpp"

namespace spangle::gappa {
namespace {

/// Set-up and walk of an edge anywhere in the guard band.
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

/// SmallEdge: bounds how far the column at any of its rows is short of the exact one. The bias tells an edge
/// that meets a centre from an edge that passes it by 1 / (256 dy), if that distance is at least 2^-22 and
/// the column is short by less than 2^-24.
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

/// Diamond::first() in 32 bits: the numerator is never negative, because |slope| is 1 at most.
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

/// LowEdge: everything fits words. The error of the column at any row is less than what the bias of 32 leaves
/// of the 64 units between two meetings of an edge and a row.
void edge_low() {
    using namespace spangle::raster;
    const int most = LowEdge::extent, rows = most / subpixel_one;
    std::printf("@whole = fixed<0, ne>;\n"
                "@cut = fixed<0, zr>;\n"
                "@down = fixed<0, dn>;\n"
                "dx = whole(DX); dy = whole(DY); above = whole(AB); n = whole(N);\n"
                "slope = cut(dx * 524288 / dy);\n"
                "rest = dx * 524288 - slope * dy;\n"
                "fine = cut(rest * 128 / dy);\n"
                "step = slope * 128 + fine;\n"
                "exact = dx * 67108864 / dy;\n"
                "rows = above / %d + n;\n"
                "share = above / dy;\n"
                "product = dx * 524288 * share;\n"
                "short = exact * rows - (down(slope * above / 2) + down(fine * above / %d) + n * step);\n"
                "{ |dx| <= %d /\\ dy in [1, %d] /\\ above in [0, %d] /\\ n in [0, %d] /\\ rows in [0, %d]\n"
                "  /\\ share in [0, 1]\n"
                "  -> short in [-15, 17] /\\ |dx * 524288| <= 2147483647 /\\ |product| <= 2147483647\n"
                "  /\\ |rest * 128 / dy| <= 128 }\n"
                "rest -> (dx * 524288 / dy - slope) * dy { dy <> 0 };\n"
                "rest * 128 / dy -> (dx * 524288 / dy - slope) * 128 { dy <> 0 };\n"
                "exact - step -> rest * 128 / dy - fine { dy <> 0 };\n"
                "short -> (exact - step) * rows + (slope * above / 2 - down(slope * above / 2)) +\n"
                "         (fine * above / %d - down(fine * above / %d));\n",
                subpixel_one, subpixel_one, most, most, most, rows, rows, subpixel_one, subpixel_one);
}

/// A plane of 64 bits at any pixel of the guard band, in units of its vertices' 30 bits. Each of its three
/// numbers is rounded to the guard bits.
void interpolant() {
    using namespace spangle::raster;
    const int most = 2 * guard_band / subpixel_one;
    std::printf("@guard = fixed<-%d, ne>;\n"
                "@whole = fixed<0, ne>;\n"
                "c = whole(C); r = whole(R);\n"
                "at = guard(V) + c * guard(DX) + r * guard(DY);\n"
                "exact = V + c * DX + r * DY;\n"
                "{ |V| <= 1b31 /\\ |DX| <= 1b31 /\\ |DY| <= 1b31 /\\ |c| <= %d /\\ |r| <= %d\n"
                "  -> |at - exact| <= 0.26 /\\ |at * 1b%d| <= 9223372036854775807 }\n"
                "at - exact -> (guard(V) - V) + c * (guard(DX) - DX) + r * (guard(DY) - DY);\n",
                guard_bits, most, most, guard_bits);
}

/// Planes of 24-bit depth: gradients times the area, and the step to the centre of a pixel, fit 64 bits.
void depth_24() {
    using namespace spangle::raster;
    const long long extent = 2LL * guard_band;
    std::printf(
        "@whole = fixed<0, ne>;\n"
        "x1 = whole(X1); y1 = whole(Y1); x2 = whole(X2); y2 = whole(Y2); z1 = whole(Z1); z2 = whole(Z2);\n"
        "ox = whole(OX); oy = whole(OY);\n"
        "area = x1 * y2 - x2 * y1; along_x = z1 * y2 - z2 * y1; along_y = z2 * x1 - z1 * x2;\n"
        "step = along_x * ox + along_y * oy;\n"
        "{ |x1| <= %lld /\\ |y1| <= %lld /\\ |x2| <= %lld /\\ |y2| <= %lld /\\ |z1| <= 1b30\n"
        "  /\\ |z2| <= 1b30 /\\ |ox| <= %d /\\ |oy| <= %d\n"
        "  -> |along_x| <= 1b53 /\\ |along_y| <= 1b53 /\\ |step| <= 1b61 /\\ |area| <= 1b45 }\n",
        extent, extent, extent, extent, subpixel_one / 2, subpixel_one / 2);
}

} // namespace

const std::vector<Obligation>& primitive_obligations() {
    static const std::vector<Obligation> all = {
        {"edge_wide", edge_wide},         {"edge_small", edge_small},   {"edge_low", edge_low},
        {"diamond_first", diamond_first}, {"interpolant", interpolant}, {"depth_24", depth_24},
    };
    return all;
}

} // namespace spangle::gappa
