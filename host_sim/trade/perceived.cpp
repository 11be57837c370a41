#include "host_sim/trade/perceived.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spangle::trade {

namespace {

/// Three planes of numbers, a number for each pixel.
using Planes = std::array<std::vector<double>, 3>;

/// The reference white of sRGB, D65, as X, Y, Z.
constexpr double white[3] = {0.950428545, 1.0, 1.088900371};

double linear(std::uint8_t v) {
    const double c = v / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

void to_xyz(const double rgb[3], double xyz[3]) {
    constexpr double m[3][3] = {{0.4124564, 0.3575761, 0.1804375},
                                {0.2126729, 0.7151522, 0.0721750},
                                {0.0193339, 0.1191920, 0.9503041}};
    for (int i = 0; i < 3; ++i)
        xyz[i] = (m[i][0] * rgb[0] + m[i][1] * rgb[1] + m[i][2] * rgb[2]) / white[i];
}

/// The CIELab colour of X, Y, Z, each relative to that of white.
std::array<double, 3> to_lab(const double v[3]) {
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(v[0]), y = f(v[1]), z = f(v[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Luminance and two opponent colours, linear in light (YyCxCz).
Planes to_opponent_colors(const sim::Image& image) {
    Planes out;
    const std::size_t pixels = image.rgba.size() / 4;
    for (auto& plane : out)
        plane.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* const p = image.rgba.data() + 4 * i;
        const double rgb[3] = {linear(p[0]), linear(p[1]), linear(p[2])};
        double v[3];
        to_xyz(rgb, v);
        out[0][i] = 116 * v[1] - 16;
        out[1][i] = 500 * (v[0] - v[1]);
        out[2][i] = 200 * (v[1] - v[2]);
    }
    return out;
}

/// A Gaussian along one axis, of that deviation in pixels. Beyond the border the last value continues.
std::vector<double> blur(const std::vector<double>& from, int width, int height, int step_x, int step_y,
                         double deviation) {
    const int reach = static_cast<int>(std::ceil(3 * deviation));
    std::vector<double> weight(static_cast<std::size_t>(reach) + 1), out(from.size());
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        sum += weight[static_cast<std::size_t>(std::abs(i))] = std::exp(-i * i / (2 * deviation * deviation));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double total = 0;
            for (int i = -reach; i <= reach; ++i) {
                const int u = std::clamp(x + i * step_x, 0, width - 1),
                          v = std::clamp(y + i * step_y, 0, height - 1);
                total += weight[static_cast<std::size_t>(std::abs(i))] *
                         from[static_cast<std::size_t>(v * width + u)];
            }
            out[static_cast<std::size_t>(y * width + x)] = total / sum;
        }
    return out;
}

/// The picture as the eye sees it: FLIP's contrast sensitivity, as one Gaussian for each channel.
Planes seen(const sim::Image& image) {
    constexpr double deviation[3] = {0.72, 1.1, 1.9}; // pixels, for luminance, red-green, blue-yellow
    Planes planes = to_opponent_colors(image);
    for (std::size_t c = 0; c < 3; ++c) {
        planes[c] = blur(planes[c], image.width, image.height, 1, 0, deviation[c]);
        planes[c] = blur(planes[c], image.width, image.height, 0, 1, deviation[c]);
    }
    return planes;
}

std::array<double, 3> lab_at(const Planes& planes, std::size_t i) {
    const double y = (planes[0][i] + 16) / 116;
    const double v[3] = {std::clamp(y + planes[1][i] / 500, 0.0, 1.0), std::clamp(y, 0.0, 1.0),
                         std::clamp(y - planes[2][i] / 200, 0.0, 1.0)};
    std::array<double, 3> out = to_lab(v);
    out[1] *= 0.01 * out[0]; // Hunt effect: colours of dark places are seen less
    out[2] *= 0.01 * out[0];
    return out;
}

double hyab(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// FLIP's exponent, and its map of errors into 0 .. 1, which gives most of the range to errors that are not
/// extreme.
double compress_distance(double distance, double largest) {
    constexpr double exponent = 0.7, knee = 0.4, at_knee = 0.95;
    const double error = std::pow(distance, exponent), most = std::pow(largest, exponent), bend = knee * most;
    return error < bend ? error * at_knee / bend : at_knee + (error - bend) / (most - bend) * (1 - at_knee);
}

double largest_distance() {
    sim::Image green(1, 1), blue(1, 1);
    green.rgba = {0, 255, 0, 255};
    blue.rgba = {0, 0, 255, 255};
    return hyab(lab_at(to_opponent_colors(green), 0), lab_at(to_opponent_colors(blue), 0));
}

} // namespace

double perceived_difference(const sim::Image& a, const sim::Image& b) {
    if (a.rgba == b.rgba)
        return 0;
    const Planes one = seen(a), other = seen(b);
    const double most = largest_distance();
    double sum = 0;
    for (std::size_t i = 0; i < one[0].size(); ++i)
        sum += compress_distance(hyab(lab_at(one, i), lab_at(other, i)), most);
    return sum / static_cast<double>(one[0].size());
}

} // namespace spangle::trade
