#include "host_sim/cli/profile_report.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spangle::cli {

namespace {

bool is_fused(const profile::Profile& made, const profile::KeyUse& use) {
    return std::find(made.fused.begin(), made.fused.end(), use.key) != made.fused.end();
}

double percent(std::uint64_t part, std::uint64_t all) {
    return all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

/// Percent of the pixels that no fused span draws.
double chain_percent(const ProfileReport& report) {
    std::uint64_t chain = 0;
    for (const profile::KeyUse& use : report.chosen->record.keys)
        chain += is_fused(*report.made, use) ? 0 : use.pixels;
    return percent(chain, report.chosen->record.pixels());
}

/// Instructions that a build needs for a pixel of a key; 0: not measured.
double cost_of(const nlohmann::json& firmware, const char* build, const std::string& key) {
    if (!firmware.is_object() || !firmware[build].contains("keys") || !firmware[build]["keys"].contains(key))
        return 0.0;
    return firmware[build]["keys"][key]["instructions_a_pixel"].get<double>();
}

/// Compares the whole library with the profile, and lists the lines that cost most.
std::string firmware_text(const nlohmann::json& firmware) {
    constexpr std::size_t most_lines = 20;
    const nlohmann::json &whole = firmware["whole"], &profiled = firmware["profiled"];
    std::string out = "\n  on a Cortex-M4        whole library      the profile\n";
    const auto row = [&](const char* what, const char* name) {
        if (profiled.contains(name))
            out += fmt::format("  {:<18}{:>17}{:>17}\n", what, whole[name].get<std::int64_t>(),
                               profiled[name].get<std::int64_t>());
    };
    row("bytes of flash", "flash");
    row("bytes of RAM", "ram");
    row("instructions", "instructions");
    if (profiled.contains("frames"))
        out += firmware.value("same_bytes", false) ? "  Both draw the same bytes.\n"
                                                   : "  THE TWO DRAW DIFFERENT BYTES.\n";
    if (firmware.contains("unmeasured"))
        out += "  It was not run: " + firmware["unmeasured"].get<std::string>() + "\n";
    if (firmware["lines"].empty())
        return out;
    out += "\n  instructions  calls     line and command, of a frame\n";
    for (std::size_t i = 0; i < std::min(most_lines, firmware["lines"].size()); ++i) {
        const nlohmann::json& line = firmware["lines"][i];
        out += fmt::format("  {:>12}  {:<8g}  {} {}\n", line["instructions"].get<std::int64_t>(),
                           line["calls"].get<double>(), line["line"].get<std::string>(),
                           line["command"].get<std::string>());
    }
    return out;
}

std::string cost(const nlohmann::json& firmware, const std::string& key) {
    const double instructions = cost_of(firmware, "profiled", key);
    return instructions > 0.0 ? fmt::format("{:.1f}", instructions) : "-";
}

} // namespace

nlohmann::json to_json(const ProfileReport& report) {
    nlohmann::json out;
    for (const TierRecord& r : *report.all)
        out["tiers"][r.tier] = {{"different_percent", r.error},
                                {"max_lsb", r.max_lsb},
                                {"psnr_565_db", r.psnr_db},
                                {"picture_hash", r.picture_hash}};
    out["scene"] = report.title;
    out["tier"] = report.chosen->tier;
    out["frames"] = report.chosen->frames;
    out["features"] = report.made->features;
    for (const auto& [limit, value] : report.made->limits)
        if (value.find_first_not_of("0123456789") == std::string::npos)
            out["limits"][limit] = std::stol(value);
        else
            out["limits"][limit] = value;
    out["chain"] = report.made->chain;
    out["chain_percent"] = chain_percent(report);
    out["keys"] = nlohmann::json::array();
    for (const profile::KeyUse& use : report.chosen->record.keys) {
        out["keys"].push_back({{"key", profile::words(use.key)},
                               {"pixels", use.pixels},
                               {"fused", is_fused(*report.made, use)},
                               {"needed", use.needed}});
        for (const auto& [build, name] : {std::pair{"profiled", "instructions_a_pixel"},
                                          std::pair{"whole", "instructions_a_pixel_whole"}})
            if (const double cost = cost_of(report.firmware, build, profile::words(use.key)); cost > 0.0)
                out["keys"].back()[name] = cost;
    }
    for (unsigned i = 0; i < gl::range_count; ++i)
        out["ranges"][profile::text_of(gl::Range{static_cast<std::uint8_t>(i)}).name] =
            report.chosen->record.reached[i];
    out["commands"] = report.chosen->record.commands;
    out["arena_bytes_of_host"] = report.chosen->record.arena_peak;
    if (report.firmware.is_object())
        out["firmware"] = report.firmware;
    return out;
}

std::string to_text(const ProfileReport& report) {
    std::string out;
    for (const TierRecord& r : *report.all)
        out += fmt::format("  {:<10}{:9.4f} % of pixels differ, at most {} steps of RGB565, {:.1f} dB{}\n",
                           r.tier, r.error, r.max_lsb, r.psnr_db,
                           &r == report.chosen ? "   <- the profile's" : "");
    out += "\n  systems     ";
    for (const std::string& feature : report.made->features)
        out += " " + feature;
    out += report.made->chain ? fmt::format("\n  the chain    is needed, and draws {:.1f} % of the pixels",
                                            chain_percent(report))
                              : "\n  the chain    is left out";
    if (report.made->chain && report.firmware.is_object())
        out += fmt::format(", in {} bytes of flash",
                           report.firmware["profiled"]["flash_of"].value("raster/compile", std::int64_t{0}));
    out += "\n\n  pixels      share    drawn by   each*  state key\n";
    std::vector<profile::KeyUse> keys = report.chosen->record.keys;
    std::stable_sort(keys.begin(), keys.end(),
                     [](const auto& a, const auto& b) { return a.pixels > b.pixels; });
    for (const profile::KeyUse& use : keys) {
        const bool fused = is_fused(*report.made, use);
        if (fused || use.pixels != 0)
            out += fmt::format("  {:>9}  {:>5.1f} %  {:<9} {:>6}  {}\n", use.pixels,
                               percent(use.pixels, report.chosen->record.pixels()),
                               fused ? "a loop" : "the chain", cost(report.firmware, profile::words(use.key)),
                               profile::words(use.key));
    }
    out += "  * instructions of one pixel on a Cortex-M4, where --report measures them\n";
    out += "\n  reached    at most\n";
    for (unsigned i = 0; i < gl::range_count; ++i)
        out += fmt::format("  {:>9}  {}\n", report.chosen->record.reached[i],
                           profile::text_of(gl::Range{static_cast<std::uint8_t>(i)}).counted);
    out += "\n  calls      command\n";
    std::vector<std::pair<std::string, std::uint64_t>> commands(report.chosen->record.commands.begin(),
                                                                report.chosen->record.commands.end());
    std::stable_sort(commands.begin(), commands.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    for (const auto& [name, count] : commands)
        out += fmt::format("  {:>9}  {}\n", count, name);
    if (report.firmware.is_object())
        out += firmware_text(report.firmware);
    return out;
}

} // namespace spangle::cli
