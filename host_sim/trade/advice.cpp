#include "host_sim/trade/advice.hpp"

#include <cmath>

#include <fmt/format.h>

namespace spangle::trade {

namespace {

/// A tier pays where it takes so much less, in parts of the time; less than that is noise of the measurement.
constexpr double worth = 0.05;
/// Decibels in 565, above which a picture passes for the reference; the balanced tier's own promise.
constexpr double passes = 33;

/// The name of a tier at the beginning of a sentence.
std::string capital(std::string tier) {
    tier[0] = static_cast<char>(tier[0] - 'a' + 'A');
    return tier;
}

std::string difference(const Table& table, const Table::Row& row) {
    const double identical = table.number(row, "identical").value_or(100);
    if (identical >= 100)
        return "no pixel differs";
    const double psnr = table.number(row, "psnr_565").value_or(99);
    return fmt::format("{:.3g} % of the pixels differ, by {} step{} of 565 at most ({:.1f} dB)",
                       100 - identical, table.text(row, "max_lsb"),
                       table.text(row, "max_lsb") == "1" ? "" : "s", psnr);
}

/// How a job's tiers are compared: by instructions where all were counted, else by time, or not at all.
struct Measure {
    const char* column;
    const char* noun;
};
constexpr Measure measures[] = {{"instructions", "instructions"}, {"microseconds", "time"}};

std::string gain(double relative, const Measure& by) {
    const int less = static_cast<int>(std::lround(100 * (1 - relative)));
    if (less == 0)
        return fmt::format("as {} {}", by.noun[0] == 't' ? "much" : "many", by.noun);
    return less > 0 ? fmt::format("{} % {} {}", less, by.noun[0] == 't' ? "less" : "fewer", by.noun)
                    : fmt::format("{} % more {}", -less, by.noun);
}

/// A tier that was measured, with what it takes relative to the first.
struct Candidate {
    std::string tier;
    const Table::Row* row;
    double relative;
};

/// What each tier takes, relative to the first; false where a figure is missing.
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

Advice advise_job(const Table& accuracy, const std::vector<Candidate>& all, const Measure* by) {
    const Candidate& first = all.front();
    Advice out{accuracy.text(*first.row, "scene"), accuracy.text(*first.row, "format"), first.tier, ""};
    const Candidate* best = &first;
    for (const Candidate& c : all)
        if (by != nullptr && accuracy.number(*c.row, "psnr_565").value_or(0) >= passes &&
            c.relative < best->relative - worth)
            best = &c;
    out.take = best->tier;
    if (best == &first)
        out.why = fmt::format("{}: {}.", capital(first.tier), difference(accuracy, *first.row));
    for (const Candidate& c : all) {
        if (&c == &first)
            continue;
        const bool seen = accuracy.number(*c.row, "psnr_565").value_or(0) < passes;
        const bool pays = c.relative < 1 - worth;
        const std::string off = difference(accuracy, *c.row);
        if (by == nullptr)
            out.why += fmt::format(" {}: {}.", capital(c.tier), off);
        else if (seen)
            out.why += fmt::format(" {} shows: {}, for {}.", capital(c.tier), off, gain(c.relative, *by));
        else if (!pays)
            out.why += fmt::format(" {} hardly pays: {}; {}.", capital(c.tier), gain(c.relative, *by), off);
        else
            out.why += fmt::format(" {} pays: {}; {}.", capital(c.tier), gain(c.relative, *by), off);
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
    for (std::size_t i = 0; i < accuracy.rows.size();) {
        const std::string& job = accuracy.text(accuracy.rows[i], "job");
        std::vector<Candidate> all;
        for (; i < accuracy.rows.size() && accuracy.text(accuracy.rows[i], "job") == job; ++i)
            all.push_back({accuracy.text(accuracy.rows[i], "tier"), &accuracy.rows[i], 1});
        const Measure* by = nullptr;
        for (const Measure& measure : measures)
            if (by == nullptr && fill_in(cost, job, measure.column, all))
                by = &measure;
        out.push_back(advise_job(accuracy, all, by));
    }
    return out;
}

} // namespace spangle::trade
