#include "host_sim/trade/plot.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_sim/trade/advice.hpp"
#include "host_sim/trade/cost.hpp"

namespace spangle::trade {

namespace {

/// What gnuplot makes of a script: read from one unnamed file, written to another.
Plot drawn(const std::string& script) {
    std::FILE* const in = std::tmpfile();
    std::FILE* const out = std::tmpfile();
    Plot plot;
    if (in == nullptr || out == nullptr) {
        plot.problem = "no temporary file can be made";
    } else {
        std::fwrite(script.data(), 1, script.size(), in);
        std::rewind(in);
        const pid_t child = fork();
        if (child == 0) {
            dup2(fileno(in), STDIN_FILENO);
            dup2(fileno(out), STDOUT_FILENO);
            if (std::freopen("/dev/null", "w", stderr) != nullptr)
                execlp("gnuplot", "gnuplot", "-", nullptr);
            _exit(127);
        }
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
            plot.problem = "gnuplot did not end";
        else if (WEXITSTATUS(status) != 0)
            plot.problem = WEXITSTATUS(status) == 127
                               ? "gnuplot is not installed (Debian: gnuplot-nox)"
                               : fmt::format("gnuplot ended with status {}", WEXITSTATUS(status));
        std::rewind(out);
        char piece[4096];
        for (std::size_t n; plot.problem.empty() && (n = std::fread(piece, 1, sizeof piece, out)) > 0;)
            plot.svg.append(piece, n);
    }
    if (in != nullptr)
        std::fclose(in);
    if (out != nullptr)
        std::fclose(out);
    if (const std::size_t start = plot.svg.find("<svg"); start != std::string::npos)
        plot.svg.erase(0, start); // a page has a head of its own
    else if (plot.problem.empty())
        plot.problem = "gnuplot drew nothing";
    return plot;
}

/// A word that gnuplot reads as it is.
std::string word(const std::string& text) {
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' ' ? '_' : c;
    return out + '"';
}

constexpr const char* look =
    "set terminal svg size 760,420 font 'sans,12' background '#ffffff'\n"
    "set grid lc rgb '#dddddd'\nset key outside right\nset border 3\nset tics nomirror\n";

/// Points with names, by series.
using Series = std::map<std::string, std::string>;

std::string plotted(const Series& series, const std::vector<std::string>& order) {
    constexpr const char* colors[] = {"#1b6ca8", "#e08e0b", "#c0392b", "#2e8b57", "#7d3c98", "#555555"};
    std::string data, plot;
    int i = 0;
    for (const std::string& name : order) {
        const auto found = series.find(name);
        if (found == series.end())
            continue;
        data += fmt::format("$d{} << EOD\n{}EOD\n", i, found->second);
        plot += fmt::format("{}$d{} using 1:2 with points pt 7 ps 0.8 lc rgb '{}' title {}, "
                            "$d{} using 1:2:3 with labels left offset 0.7,0.3 font ',9' notitle",
                            i == 0 ? "" : ", ", i, colors[static_cast<std::size_t>(i) % std::size(colors)],
                            word(name), i);
        ++i;
    }
    return data + "plot " + plot + "\n";
}

/// In the order of their rows.
std::vector<std::string> tier_names(const Table& accuracy) {
    std::vector<std::string> names;
    for (const Table::Row& row : accuracy.rows)
        if (const std::string& tier = accuracy.text(row, "tier");
            std::find(names.begin(), names.end(), tier) == names.end())
            names.push_back(tier);
    return names;
}

/// Where all that is the same as the reference and costs the same lies: there names would cover each other.
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
    std::vector<Axis> out;
    for (const Axis& axis : all)
        if (std::any_of(cost.rows.begin(), cost.rows.end(),
                        [&](const Table::Row& row) { return cost.number(row, axis.column).has_value(); }))
            out.push_back(axis);
    return out;
}

Plot plot_tiers(const Table& accuracy, const Table& cost, const Axis& axis) {
    Series series;
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
        series[accuracy.text(row, "tier")] +=
            fmt::format("{} {} {}\n", 100 * relative, *psnr,
                        is_crowded(relative, *psnr) ? word("") : word(accuracy.text(row, "scene")));
    }
    if (series.empty())
        return {"", "nothing was measured"};
    return drawn(std::string(look) +
                 fmt::format("set xlabel '{} for a frame, % of the first tier'\n", axis.name) +
                 "set ylabel 'PSNR in RGB565, dB (99: identical)'\nset yrange [*:102]\n" +
                 plotted(series, tier_names(accuracy)));
}

Plot plot_formats(const Table& accuracy) {
    Series series;
    std::string last;
    for (const Table::Row& row : accuracy.rows) {
        const bool first = accuracy.text(row, "job") != last;
        last = accuracy.text(row, "job");
        if (first)
            series[accuracy.text(row, "tier")] +=
                fmt::format("{} {} {}\n", accuracy.text(row, "frame_bytes"), accuracy.text(row, "perceived"),
                            word(accuracy.text(row, "scene") + " " + accuracy.text(row, "format")));
    }
    return drawn(std::string(look) +
                 "set xlabel 'bytes of a whole frame'\nset logscale x 2\n"
                 "set ylabel 'looks different, FLIP-like mean'\nset yrange [0:*]\n" +
                 plotted(series, tier_names(accuracy)));
}

} // namespace spangle::trade
