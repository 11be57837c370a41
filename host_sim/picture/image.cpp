#include <spangle/sim/image.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace spangle::sim {

std::string hash(const Image& image) {
    std::uint64_t h = 0xCBF29CE484222325u; // hash FNV-1a over size and pixels
    const auto mix = [&h](std::uint64_t byte) { h = (h ^ (byte & 255)) * 0x100000001B3u; };
    for (const int size : {image.width, image.height})
        for (int shift = 0; shift < 32; shift += 8)
            mix(static_cast<unsigned>(size) >> shift);
    for (const std::uint8_t byte : image.rgba)
        mix(byte);
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(h));
    return text;
}

Difference compare_565(const Image& a, const Image& b, const std::vector<bool>* mask) {
    Difference d;
    double squares = 0.0;
    const std::size_t pixels = std::min(a.rgba.size(), b.rgba.size()) / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (mask != nullptr && !(*mask)[i])
            continue;
        ++d.pixels;
        bool same = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const int drop = c == 1 ? 2 : 3;
            const int difference = std::abs((a.rgba[4 * i + c] >> drop) - (b.rgba[4 * i + c] >> drop));
            same = same && difference == 0;
            d.max_lsb = std::max(d.max_lsb, difference);
            const double scaled = difference * 255.0 / (c == 1 ? 63.0 : 31.0);
            squares += scaled * scaled;
        }
        d.identical += same ? 1 : 0;
    }
    if (squares > 0.0)
        d.psnr_db = 10.0 * std::log10(255.0 * 255.0 * 3.0 * static_cast<double>(d.pixels) / squares);
    return d;
}

Image difference_picture(const Image& a, const Image& b) {
    Image out(std::max(a.width, b.width), std::max(a.height, b.height));
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            std::uint8_t* const to = out.at(x, y);
            const bool in_a = x < a.width && y < a.height, in_b = x < b.width && y < b.height;
            if (!in_a || !in_b) {
                to[0] = to[2] = 255;
                to[1] = 0;
                continue;
            }
            const std::uint8_t *p = a.at(x, y), *q = b.at(x, y);
            int worst = 0;
            for (int c = 0; c < 4; ++c)
                worst = std::max(worst, std::abs(p[c] - q[c]));
            const auto grey = static_cast<std::uint8_t>((p[0] + 2 * p[1] + p[2]) / 12);
            to[0] = worst == 0 ? grey : static_cast<std::uint8_t>(std::min(255, 96 + 8 * worst));
            to[1] = to[2] = worst == 0 ? grey : 0;
        }
    return out;
}

Image crop(const Image& image, int x, int y, int width, int height) {
    const int left = std::clamp(x, 0, image.width), top = std::clamp(y, 0, image.height);
    const auto end = [](int from, int size, int bound) { // x + width may be larger than an int holds
        return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{from} + size, 0, bound));
    };
    Image out(std::max(end(x, width, image.width) - left, 0),
              std::max(end(y, height, image.height) - top, 0));
    for (int row = 0; row < out.height; ++row)
        std::copy_n(image.at(left, top + row), std::size_t{4} * static_cast<std::size_t>(out.width),
                    out.at(0, row));
    return out;
}

const Legend& pure_colors() {
    static const Legend legend = {{' ', 0x000000}, {'r', 0xFF0000}, {'g', 0x00FF00}, {'y', 0xFFFF00},
                                  {'b', 0x0000FF}, {'m', 0xFF00FF}, {'c', 0x00FFFF}, {'#', 0xFFFFFF}};
    return legend;
}

std::string to_ascii(const Image& image, const Legend& legend) {
    const auto word = [](unsigned r, unsigned g, unsigned b) { return r >> 3 << 11 | g >> 2 << 5 | b >> 3; };
    std::map<unsigned, char> names;
    for (const auto& [name, color] : legend)
        names.emplace(word(color >> 16 & 255, color >> 8 & 255, color & 255), name);
    std::string out;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* const p = image.at(x, y);
            const auto known = names.find(word(p[0], p[1], p[2]));
            out += known == names.end() ? '?' : known->second;
        }
        out += '\n';
    }
    return out;
}

} // namespace spangle::sim
