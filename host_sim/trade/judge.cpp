#include "host_sim/trade/judge.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/trade/perceived.hpp"

namespace spangle::trade {

sim::Image image_of(const DrawnPicture& drawn) {
    sim::Image out(drawn.width, drawn.height);
    const std::size_t row = 4 * static_cast<std::size_t>(drawn.width);
    for (int y = 0; y < drawn.height; ++y)
        std::copy_n(drawn.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (drawn.height - 1 - y), row,
                    out.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y);
    for (std::size_t i = 3; i < out.rgba.size(); i += 4)
        out.rgba[i] = 255; // alpha is not seen
    return out;
}

void judge(const DrawnFrame& ours, const DrawnFrame& twin, Measured& out) {
    out.off_snapped += count_differences(ours.coverage.snapped, twin.coverage.snapped);
    out.off_unsnapped += count_differences(ours.coverage.snapped, twin.coverage.exact);
    out.off_ideal += count_differences(twin.coverage.snapped, twin.coverage.exact);
    out.error.add(compare(ours.picture, twin.picture, &twin.mask));
}

void judge_plain(Measured& out) {
    double squares = 0;
    for (std::size_t i = 0; i < out.plain.rgba.size(); ++i) {
        const double d = out.plain.rgba[i] - out.picture.rgba[i];
        squares += d * d;
    }
    const double values = 3.0 * static_cast<double>(out.plain.rgba.size()) / 4;
    out.psnr_to_888 = squares > 0 ? 10 * std::log10(255.0 * 255.0 * values / squares) : PictureError::alike;
    out.perceived = perceived_difference(out.picture, out.plain);
}

} // namespace spangle::trade
