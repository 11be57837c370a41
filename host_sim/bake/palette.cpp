#include "host_sim/bake/palette.hpp"

#include <algorithm>
#include <map>
#include <span>

namespace spangle::bake {

namespace {

struct Weighted {
    Rgba color;
    std::uint64_t pixels;
};

std::vector<Weighted> histogram(const std::vector<std::uint8_t>& rgba) {
    std::map<Rgba, std::uint64_t> count;
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
        ++count[{rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]}];
    std::vector<Weighted> colors;
    colors.reserve(count.size());
    for (const auto& [color, pixels] : count)
        colors.push_back({color, pixels});
    return colors;
}

int square_distance(const Rgba& a, const Rgba& b) {
    int sum = 0;
    for (std::size_t c = 0; c < 4; ++c)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

struct Box {
    std::span<Weighted> colors;
    std::size_t axis = 0;
    double spread = 0.0; ///< squared deviations along the widest axis, weighted by pixels

    explicit Box(std::span<Weighted> of) : colors(of) {
        for (std::size_t c = 0; c < 4; ++c) {
            double sum = 0.0, squares = 0.0, n = 0.0;
            for (const Weighted& w : colors) {
                const double v = w.color[c], p = static_cast<double>(w.pixels);
                sum += v * p;
                squares += v * v * p;
                n += p;
            }
            const double variance = squares - sum * sum / n;
            if (variance > spread) {
                spread = variance;
                axis = c;
            }
        }
    }

    /// Sorts the colours along the widest axis, and returns the index of the median, where the box is cut.
    /// Both halves have colours.
    std::size_t median() const {
        std::sort(colors.begin(), colors.end(), [this](const Weighted& a, const Weighted& b) {
            return a.color[axis] != b.color[axis] ? a.color[axis] < b.color[axis] : a.color < b.color;
        });
        std::uint64_t all = 0, below = 0;
        for (const Weighted& w : colors)
            all += w.pixels;
        std::size_t at = 0;
        while (at + 2 < colors.size() && below + colors[at].pixels <= all / 2)
            below += colors[at++].pixels;
        return at + 1;
    }
};

/// The sum of colours, weighted by pixels, and the number of pixels.
struct Mean {
    std::uint64_t sum[4] = {}, pixels = 0;
    void add(const Weighted& w) {
        for (std::size_t c = 0; c < 4; ++c)
            sum[c] += w.color[c] * w.pixels;
        pixels += w.pixels;
    }
    Rgba color() const {
        Rgba out{};
        for (std::size_t c = 0; c < 4; ++c)
            out[c] = static_cast<std::uint8_t>((sum[c] + pixels / 2) / pixels);
        return out;
    }
};

std::vector<Rgba> median_cut(std::vector<Weighted>& colors, std::size_t most) {
    std::vector<Box> boxes{Box(std::span(colors))};
    while (boxes.size() < most) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.spread < b.spread; });
        if (widest->colors.size() < 2)
            break;
        const std::span<Weighted> all = widest->colors;
        const std::size_t at = widest->median();
        *widest = Box(all.first(at));
        boxes.emplace_back(all.subspan(at));
    }
    std::vector<Rgba> palette;
    for (const Box& box : boxes) {
        Mean mean;
        for (const Weighted& w : box.colors)
            mean.add(w);
        palette.push_back(mean.color());
    }
    return palette;
}

void move_to_means(std::vector<Rgba>& palette, const std::vector<Weighted>& colors) {
    std::vector<Mean> means(palette.size());
    for (const Weighted& w : colors)
        means[nearest_entry(palette, w.color)].add(w);
    for (std::size_t i = 0; i < palette.size(); ++i)
        if (means[i].pixels != 0)
            palette[i] = means[i].color();
}

void round_all(std::vector<Rgba>& colors, const std::uint8_t (&bits)[4]) {
    for (Rgba& color : colors)
        color = rounded(color, bits);
    std::sort(colors.begin(), colors.end());
    colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
}

} // namespace

Rgba rounded(const Rgba& color, const std::uint8_t (&bits)[4]) {
    Rgba out{};
    for (std::size_t c = 0; c < 4; ++c) {
        const int most = (1 << bits[c]) - 1;
        const int code = most == 0 ? 0 : (color[c] * most + 127) / 255;
        out[c] = most == 0 ? std::uint8_t{255} : static_cast<std::uint8_t>((code * 255 + most / 2) / most);
    }
    return out;
}

std::size_t nearest_entry(const std::vector<Rgba>& palette, const Rgba& color) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < palette.size(); ++i)
        if (square_distance(palette[i], color) < square_distance(palette[best], color))
            best = i;
    return best;
}

std::vector<Rgba> choose_palette(const std::vector<std::uint8_t>& rgba, std::size_t most,
                                 const std::uint8_t (&bits)[4]) {
    std::vector<Weighted> colors = histogram(rgba);
    std::vector<Rgba> exact;
    exact.reserve(colors.size());
    for (const Weighted& w : colors)
        exact.push_back(w.color);
    round_all(exact, bits);
    if (exact.size() <= most)
        return exact;
    std::vector<Rgba> palette = median_cut(colors, most);
    for (int step = 0; step < 8; ++step)
        move_to_means(palette, colors);
    round_all(palette, bits);
    return palette;
}

} // namespace spangle::bake
