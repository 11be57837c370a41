#include "host_sim/trade/plot.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "host_sim/process/process.hpp"
#include "host_sim/trade/advice.hpp"
#include "host_sim/trade/cost.hpp"
#include "host_sim/trade/plot_names.hpp"

namespace spangle::trade {

namespace {

/// Lets gnuplot draw a script.
Plot drawn(const std::string& script) {
    process::TemporaryFile in;
    const process::TemporaryFile out;
    Plot plot;
    if (!in.put(script) || out.descriptor() < 0)
        return {"", "no temporary file can be made"};
    const process::ExitStatus ended =
        process::run({"gnuplot", "-"}, {in.descriptor(), out.descriptor(), process::nowhere});
    if (ended.status == process::no_program)
        plot.problem = "gnuplot is not installed (Debian: gnuplot-nox)";
    else if (ended.status != 0)
        plot.problem = fmt::format("gnuplot ended with status {}", ended.status);
    else
        plot.svg = out.text();
    if (const std::size_t start = plot.svg.find("<svg"); start != std::string::npos)
        plot.svg.erase(0, start); // drops gnuplot's head, because pages have their own
    else if (plot.problem.empty())
        plot.problem = "gnuplot drew nothing";
    return plot;
}

/// The text as a string that gnuplot reads as it is; characters that it would interpret become '_'.
std::string word(const std::string& text) {
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' ' ? '_' : c;
    return out + '"';
}

/// The place of the plot's area in a picture of 760x420 pixels. The places of names depend on it.
constexpr double picture_width = 760, picture_height = 420;
constexpr double area_left = 68, area_right = 650, area_bottom = 60, area_top = 410;
constexpr double area_width = area_right - area_left, area_height = area_top - area_bottom;

struct Dot {
    std::string tier;
    double x, y;
    std::string name; ///< name beside the point; empty: none
};

/// The range of an axis, from the least to the most of its values and a little beyond.
struct Scale {
    double least, most;
    bool by_octaves; ///< true: the axis is logarithmic, to the base of 2

    double place(double v) const {
        const auto at = [&](double x) { return by_octaves ? std::log2(x) : x; };
        return (at(v) - at(least)) / (at(most) - at(least));
    }
    double value(double place) const {
        return by_octaves ? least * std::pow(most / least, place) : least + place * (most - least);
    }
};

template <class Get> Scale scale_of(const std::vector<Dot>& dots, bool by_octaves, Get get) {
    const auto [low, high] = std::minmax_element(dots.begin(), dots.end(),
                                                 [&](const Dot& a, const Dot& b) { return get(a) < get(b); });
    const double least = get(*low), most = get(*high);
    if (by_octaves)
        return {least / 1.3, most * 1.6, true};
    const double beyond = std::max(0.06 * (most - least), 0.02 * std::abs(most) + 1e-3);
    return {least - beyond, most + beyond, false};
}

/// The plot of the dots. Each tier has its own colour, for its points and their names.
std::string plot_dots(const std::vector<Dot>& dots, const std::vector<std::string>& tiers, bool by_octaves) {
    constexpr const char* colors[] = {"#1b6ca8", "#e08e0b", "#c0392b", "#2e8b57", "#7d3c98", "#555555"};
    const Scale across = scale_of(dots, by_octaves, [](const Dot&dot) { return dot.x; }),
                up = scale_of(dots, false, [](const Dot&dot) { return dot.y; });
    std::vector<NamedPoint> points;
    points.reserve(dots.size());
    for (const Dot& dot : dots)
        points.push_back({area_width * across.place(dot.x), area_height * up.place(dot.y), dot.name});
    const auto places = place_names(points, area_width, area_height);
    std::string data, plot;
    int i = 0;
    for (const std::string& tier : tiers) {
        std::string at, names;
        for (std::size_t k = 0; k < dots.size(); ++k) {
            if (dots[k].tier != tier)
                continue;
            at += fmt::format("{} {}\n", dots[k].x, dots[k].y);
            if (places[k])
                names += fmt::format("{} {} {}\n", across.value(places[k]->x / area_width),
                                     up.value(places[k]->y / area_height), word(dots[k].name));
        }
        if (at.empty())
            continue;
        const char* const color = colors[static_cast<std::size_t>(i) % std::size(colors)];
        data += fmt::format("$d{} << EOD\n{}EOD\n$n{} << EOD\n{}EOD\n", i, at, i, names);
        plot += fmt::format("{}$d{} using 1:2 with points pt 7 ps 0.8 lc rgb '{}' title {}",
                            i == 0 ? "" : ", ", i, color, word(tier));
        if (!names.empty())
            plot += fmt::format(", $n{} using 1:2:3 with labels left font ',9' textcolor rgb '{}' notitle", i,
                                color);
        ++i;
    }
    return fmt::format("{}set xrange [{}:{}]\nset yrange [{}:{}]\nplot {}\n", data, across.least, across.most,
                       up.least, up.most, plot);
}

std::string look() {
    return fmt::format(
        "set terminal svg size {},{} font 'sans,12' background '#ffffff'\n"
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
        "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
        "set grid lc rgb '#dddddd'\nset key outside right Left reverse samplen 1\nset border 3\n"
        "set tics nomirror\n",
        picture_width, picture_height, area_left / picture_width, area_right / picture_width,
        area_bottom / picture_height, area_top / picture_height);
}

/// The names of the tiers, in the order of their rows.
std::vector<std::string> tier_names(const Table& accuracy) {
    std::vector<std::string> names;
    for (const Table::Row& row : accuracy.rows)
        if (const std::string& tier = accuracy.text(row, "tier");
            std::find(names.begin(), names.end(), tier) == names.end())
            names.push_back(tier);
    return names;
}

/// Whether a point lies where all tiers meet that equal the reference and cost the same. Names would cover
/// each other there.
bool is_crowded(double relative, double psnr) {
    return psnr == PictureError::alike && relative > 0.9 && relative < 1.1;
}

} // namespace

std::vector<Axis> axes_of(const Table& cost) {
    std::vector<Axis> all;
    for (const Target& target : targets())
        all.push_back(
            {target_column(target.name, "instructions"), fmt::format("instructions on {}", target.name)});
    all.push_back({target_column(host_target, "instructions"), "instructions on this machine"});
    all.push_back({"microseconds", "time"});
    for (const Target& target : targets()) {
        all.push_back({target_column(target.name, "flash"), fmt::format("flash on {}", target.name), false});
        all.push_back({target_column(target.name, "ram"), fmt::format("RAM on {}", target.name), false});
    }
    std::vector<Axis> out;
    for (const Axis& axis : all)
        if (std::any_of(cost.rows.begin(), cost.rows.end(),
                        [&](const Table::Row& row) { return cost.number(row, axis.column).has_value(); }))
            out.push_back(axis);
    return out;
}

Plot plot_tiers(const Table& accuracy, const Table& cost, const Axis& axis) {
    std::vector<Dot> dots;
    std::string job;
    std::optional<double> first;
    for (const Table::Row& row : accuracy.rows) {
        const Table::Row* const taken = find_row(cost, accuracy.text(row, "job"), accuracy.text(row, "tier"));
        const auto psnr = accuracy.number(row, "psnr_565");
        const auto figure = taken != nullptr ? cost.number(*taken, axis.column) : std::nullopt;
        if (accuracy.text(row, "job") != job)
            first = figure;
        job = accuracy.text(row, "job");
        if (!psnr || !figure || !first || *first <= 0)
            continue;
        const double relative = *figure / *first;
        dots.push_back({accuracy.text(row, "tier"), 100 * relative, *psnr,
                        is_crowded(relative, *psnr) ? "" : accuracy.text(row, "scene")});
    }
    if (dots.empty())
        return {"", "nothing was measured"};
    return drawn(look() +
                 fmt::format("set xlabel '{}{}, % of the first tier'\n", axis.name,
                             axis.of_frame ? " for a frame" : "") +
                 "set ylabel 'PSNR in RGB565, dB (99: identical)'\n" +
                 plot_dots(dots, tier_names(accuracy), false));
}

Plot plot_formats(const Table& accuracy) {
    std::vector<Dot> dots;
    std::string last;
    for (const Table::Row& row : accuracy.rows) {
        const bool first = accuracy.text(row, "job") != last;
        last = accuracy.text(row, "job");
        const auto bytes = accuracy.number(row, "frame_bytes"), perceived = accuracy.number(row, "perceived");
        if (first && bytes && perceived && *bytes > 0)
            dots.push_back({accuracy.text(row, "tier"), *bytes, *perceived,
                            accuracy.text(row, "scene") + " " + accuracy.text(row, "format")});
    }
    if (dots.empty())
        return {"", "nothing was measured"};
    return drawn(look() +
                 "set xlabel 'bytes of a whole frame'\nset logscale x 2\n"
                 "set ylabel 'looks different, FLIP-like mean'\n" +
                 plot_dots(dots, tier_names(accuracy), true));
}

} // namespace spangle::trade
