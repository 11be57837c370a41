#include "host_sim/trade/boxes.hpp"

#include <fmt/format.h>

namespace spangle::trade {

std::vector<std::string> missed_boxes(const Table& table, const Table::Row& row) {
    std::vector<std::string> out;
    const auto most = [&](const char* column, double bound, const char* what) {
        if (const auto v = table.number(row, column); v && *v > bound)
            out.push_back(fmt::format("{} is {:g}, not {:g} at most", what, *v, bound));
    };
    const auto least = [&](const char* column, double bound, const char* what) {
        if (const auto v = table.number(row, column); v && *v < bound)
            out.push_back(fmt::format("{} is {:g}, not {:g} at least", what, *v, bound));
    };
    most("off_own", 0, "coverage off brute force");
    // The grid of n.8 costs some coverage against vertices in double by itself; the bound is for the whole
    // difference.
    const double covered = table.number(row, "covered").value_or(0);
    if (const auto off = table.number(row, "off_unsnapped"); off && *off > 5e-5 * covered)
        out.push_back(fmt::format("coverage off unsnapped is {:.4f} %, not 0.005 at most (n.8 costs {})",
                                  100 * *off / covered, table.text(row, "off_ideal")));
    most("depth_worst", 1.0 / 65535, "depth, against the plane through its vertices,");
    if (table.text(row, "dither") == "on")
        return out;
    const std::string& tier = table.text(row, "tier");
    if (tier == "exact") {
        least("identical", 99.99, "identical %");
        most("wrong_texels", 0.02, "wrong texels %");
        most("texel_worst", 1.0 / 64, "worst texel error");
        if (table.number(row, "wrong_texels").value_or(0) == 0 &&
            table.number(row, "lod_0_worst").value_or(0) == 0)
            most("max_lsb", 1, "largest difference in 565 steps");
    } else if (tier == "balanced") {
        least("identical", 95, "identical %");
        least("psnr_565", 33, "PSNR in 565");
        most("texel_worst", 0.25, "worst texel error");
    } else if (tier == "fast") {
        least("psnr_565", 22, "PSNR in 565");
        most("texel_worst", 0.5, "worst texel error");
    }
    return out;
}

} // namespace spangle::trade
