#include "host_sim/trade/advice.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "host_sim/trade/cost.hpp"
#include "host_sim/trade/plot.hpp"

namespace spangle::trade {

namespace {

/// The part of the time by which a tier must be cheaper to pay; smaller differences are noise of the
/// measurement.
constexpr double worth = 0.05;
/// The PSNR in decibels in 565 above which a picture passes for the reference; the balanced tier promises it.
constexpr double passes = 33;

/// The name of a tier, as the first word of a sentence.
std::string capitalized(std::string tier) {
    if (tier[0] >= 'a' && tier[0] <= 'z')
        tier[0] = static_cast<char>(tier[0] - 'a' + 'A');
    return tier;
}

std::string difference_text(const Table& table, const Table::Row& row) {
    const double identical = table.number(row, "identical").value_or(100);
    if (identical >= 100)
        return "no pixel differs";
    const double psnr = table.number(row, "psnr_565").value_or(99);
    return fmt::format("{:.3g} % of the pixels differ, by {} step{} of 565 at most ({:.1f} dB)",
                       100 - identical, table.text(row, "max_lsb"),
                       table.text(row, "max_lsb") == "1" ? "" : "s", psnr);
}

std::string gain_text(double relative, const Axis& by) {
    const int less = static_cast<int>(std::lround(100 * (1 - relative)));
    const bool is_time = by.name[0] == 't';
    if (less == 0)
        return fmt::format("as {} {}", is_time ? "much" : "many", by.name);
    return less > 0 ? fmt::format("{} % {} {}", less, is_time ? "less" : "fewer", by.name)
                    : fmt::format("{} % more {}", -less, by.name);
}

/// A tier that was measured, and its cost relative to the first tier.
struct Candidate {
    std::string tier;
    const Table::Row* row;
    double relative;
    std::string also; ///< other figures that differ, in words
};

/// Sets the cost of each tier relative to the first. Returns false where a figure is missing.
bool fill_in(const Table& cost, const std::string& job, const char* column, std::vector<Candidate>& all) {
    std::vector<double> figures;
    for (const Candidate& c : all)
        if (const Table::Row* const row = find_row(cost, job, c.tier); row != nullptr)
            if (const auto v = cost.number(*row, column); v && *v > 0)
                figures.push_back(*v);
    if (figures.size() != all.size())
        return false;
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].relative = figures[i] / figures[0];
    return true;
}

/// A figure of two rows, where both rows have it.
struct Pair {
    double first, other;
};
std::optional<Pair> pair_of(const Table& table, const Table::Row* first, const Table::Row* other,
                            const std::string& column) {
    if (first == nullptr || other == nullptr)
        return {};
    const auto a = table.number(*first, column), b = table.number(*other, column);
    return a && b && *a > 0 ? std::optional<Pair>({*a, *b}) : std::nullopt;
}

/// Tells of other targets that gain clearly more or less, of flash and RAM, and of bytes on the bus.
/// Differences below `worth` are not told.
std::string other_figures(const Table& accuracy, const Table& cost, const Candidate& first,
                          const Candidate& other, const std::string& job, const Axis* by) {
    const Table::Row *const a = find_row(cost, job, first.tier), *const b = find_row(cost, job, other.tier);
    std::string out;
    const auto say = [&out](const std::string& words) { out += (out.empty() ? "" : ", ") + words; };
    for (const Target& target : targets()) {
        const std::string column = target_column(target.name, "instructions");
        if (const auto p = pair_of(cost, a, b, column);
            p && by != nullptr && column != by->column &&
            std::fabs(p->other / p->first - other.relative) > worth)
            say(fmt::format("{}: {:+.0f} %", target.name, 100 * (p->other / p->first - 1)));
    }
    for (const Target& target : targets())
        for (const char* kind : {"flash", "ram"})
            if (const auto p = pair_of(cost, a, b, target_column(target.name, kind));
                p && std::fabs(p->other / p->first - 1) > worth) {
                const double kb = (p->first - p->other) / 1024;
                say(fmt::format("{:.1f} KB {} {} on {}", std::fabs(kb), kb > 0 ? "less" : "more",
                                kind[0] == 'f' ? "flash" : "RAM", target.name));
            }
    if (const auto p = pair_of(accuracy, first.row, other.row, "bus_bytes");
        p && std::fabs(p->other / p->first - 1) > worth)
        say(fmt::format("{:.0f} % {} bytes on the bus", 100 * std::fabs(p->other / p->first - 1),
                        p->other < p->first ? "fewer" : "more"));
    return out.empty() ? "" : " (" + out + ")";
}

Advice advise_job(const Table& accuracy, const std::vector<Candidate>& all, const Axis* by) {
    const Candidate& first = all.front();
    Advice out{accuracy.text(*first.row, "scene"), accuracy.text(*first.row, "format"), first.tier, ""};
    const Candidate* best = &first;
    for (const Candidate& c : all)
        if (by != nullptr && accuracy.number(*c.row, "psnr_565").value_or(0) >= passes &&
            c.relative < best->relative - worth)
            best = &c;
    out.take = best->tier;
    if (best == &first)
        out.why = fmt::format("{}: {}.", capitalized(first.tier), difference_text(accuracy, *first.row));
    for (const Candidate& c : all) {
        if (&c == &first)
            continue;
        const bool seen = accuracy.number(*c.row, "psnr_565").value_or(0) < passes;
        const bool pays = c.relative < 1 - worth;
        const std::string off = difference_text(accuracy, *c.row);
        if (by == nullptr)
            out.why += fmt::format(" {}: {}{}.", capitalized(c.tier), off, c.also);
        else if (seen)
            out.why += fmt::format(" {} shows: {}, for {}{}.", capitalized(c.tier), off,
                                   gain_text(c.relative, *by), c.also);
        else
            out.why += fmt::format(" {} {}: {}{}; {}.", capitalized(c.tier), pays ? "pays" : "hardly pays",
                                   gain_text(c.relative, *by), c.also, off);
    }
    if (!out.why.empty() && out.why.front() == ' ')
        out.why.erase(0, 1);
    return out;
}

} // namespace

const Table::Row* find_row(const Table& table, const std::string& job, const std::string& tier) {
    for (const Table::Row& row : table.rows)
        if (table.text(row, "job") == job && table.text(row, "tier") == tier)
            return &row;
    return nullptr;
}

std::vector<Advice> advise(const Table& accuracy, const Table& cost) {
    std::vector<Advice> out;
    const std::vector<Axis> axes = axes_of(cost);
    for (std::size_t i = 0; i < accuracy.rows.size();) {
        const std::string& job = accuracy.text(accuracy.rows[i], "job");
        std::vector<Candidate> all;
        for (; i < accuracy.rows.size() && accuracy.text(accuracy.rows[i], "job") == job; ++i)
            all.push_back({accuracy.text(accuracy.rows[i], "tier"), &accuracy.rows[i], 1, ""});
        const Axis* by = nullptr; // the first axis for which all tiers have figures
        for (const Axis& axis : axes)
            if (by == nullptr && axis.of_frame && fill_in(cost, job, axis.column.c_str(), all))
                by = &axis;
        for (Candidate& c : all)
            c.also = other_figures(accuracy, cost, all.front(), c, job, by);
        out.push_back(advise_job(accuracy, all, by));
    }
    return out;
}

} // namespace spangle::trade
