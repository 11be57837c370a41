#include "host_sim/cli/profile_page.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace spangle::cli {

namespace {

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Spangle: a profile</title>
<meta name="viewport" content="width=device-width">
<link rel="icon" href="data:,">
<style>
body{font:15px/1.45 system-ui,sans-serif;margin:2em auto;max-width:960px;padding:0 1em;color:#222}
h1{font-size:1.6em}h2{margin-top:2em}table{border-collapse:collapse;margin:1em 0}
th,td{padding:.25em .6em;border-bottom:1px solid #ddd;text-align:right;white-space:nowrap}
th:first-child,td:first-child,.words{text-align:left}td.words{white-space:normal}
th{background:#f4f4f4}.chain{background:#fdf3d8}.taken{font-weight:bold}
.bar{display:inline-block;height:.7em;background:#4a7fb5;vertical-align:middle}
</style></head><body>
)";

std::string escape_html(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '<'   ? std::string("&lt;")
               : c == '>' ? std::string("&gt;")
               : c == '&' ? std::string("&amp;")
                          : std::string(1, c);
    return out;
}

/// Writes a number in groups of three digits: 1234567 as 1,234,567.
std::string with_thousands(std::int64_t number) {
    std::string digits = std::to_string(number);
    for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > (number < 0 ? 1 : 0);
         at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

std::string bar(double share) {
    return fmt::format("<span class=bar style=\"width:{:.1f}em\"></span> {:.1f} %", share * 12.0,
                       share * 100.0);
}

std::string tiers(const ProfileReport& report) {
    std::string out =
        "<h2>Accuracy</h2>\n<table><tr><th>tier</th><th>pixels that differ</th><th>at most, steps of "
        "RGB565</th><th>PSNR</th></tr>\n";
    for (const TierRecord& r : *report.all)
        out += fmt::format("<tr{}><td>{}</td><td>{:.4f} %</td><td>{}</td><td>{:.1f} dB</td></tr>\n",
                           &r == report.chosen ? " class=taken" : "", r.tier, r.error, r.max_lsb, r.psnr_db);
    return out +
           "</table>\n<p>Held against the same frames drawn in double. The profile's tier is bold.</p>\n";
}

/// One row of a table that compares the whole library with the profile.
std::string versus(const char* what, const nlohmann::json& whole, const nlohmann::json& profiled) {
    const auto a = whole.get<std::int64_t>(), b = profiled.get<std::int64_t>();
    return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{:+.1f} %</td></tr>\n", what,
                       with_thousands(a), with_thousands(b),
                       a != 0 ? 100.0 * static_cast<double>(b - a) / static_cast<double>(a) : 0.0);
}

std::string list_builds(const nlohmann::json& firmware) {
    const nlohmann::json &whole = firmware["whole"], &profiled = firmware["profiled"];
    std::string out =
        "<h2>Whole library and profile</h2>\n<table><tr><th>on a Cortex-M4</th><th>whole</th><th>profile</th>"
        "<th>difference</th></tr>\n";
    out += versus("flash, bytes", whole["flash"], profiled["flash"]);
    if (profiled.contains("instructions")) {
        out += versus("RAM beside the buffers, bytes", whole["ram"], profiled["ram"]);
        for (const char* const part : {"variables", "arena", "stack"})
            out += versus(fmt::format("of it {}", part).c_str(), whole["ram_of"][part],
                          profiled["ram_of"][part]);
        out += versus("instructions of a frame", whole["instructions"], profiled["instructions"]);
    }
    out += "</table>\n";
    if (firmware.contains("unmeasured"))
        out += "<p>It was not run: " + escape_html(firmware["unmeasured"].get<std::string>()) + "</p>\n";
    if (profiled.contains("frames"))
        out += firmware.value("same_bytes", false)
                   ? "<p>Both draw the same bytes.</p>\n"
                   : "<p class=chain>The two draw different bytes: a fault of Spangle, please "
                     "report it.</p>\n";
    std::set<std::string> rooms;
    for (const nlohmann::json* build : {&whole, &profiled})
        for (const auto& [room, bytes] : (*build)["flash_of"].items())
            rooms.insert(room);
    out += "<h2>Flash by "
           "folder</h2>\n<table><tr><th>folder</th><th>whole</th><th>profile</th><th>difference</th></tr>\n";
    for (const std::string& room : rooms)
        out += versus(escape_html(room).c_str(), whole["flash_of"].value(room, nlohmann::json(0)),
                      profiled["flash_of"].value(room, nlohmann::json(0)));
    return out + "</table>\n";
}

/// A measured figure of a key, or a dash where there is none.
std::string cost(const nlohmann::json& key, const char* name) {
    return key.contains(name) ? fmt::format("{:.1f}", key[name].get<double>()) : "-";
}

std::string list_state_keys(const nlohmann::json& told) {
    std::string out = "<h2>State keys</h2>\n<table><tr><th>state</th><th>pixels</th><th>share</th><th>drawn "
                      "by</th><th>instructions a pixel</th><th>in the whole library</th></tr>\n";
    double all = 0.0;
    for (const nlohmann::json& key : told["keys"])
        all += key["pixels"].get<double>();
    for (const nlohmann::json& key : told["keys"])
        if (key["pixels"] != 0 || key["fused"] == true)
            out += fmt::format(
                "<tr{}><td class=words>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                key["fused"] == true ? "" : " class=chain", escape_html(key["key"].get<std::string>()),
                with_thousands(key["pixels"].get<std::int64_t>()),
                bar(all > 0.0 ? key["pixels"].get<double>() / all : 0.0),
                key["fused"] == true ? "a loop of its own" : "the chain", cost(key, "instructions_a_pixel"),
                cost(key, "instructions_a_pixel_whole"));
    return out + "</table>\n";
}

std::string lines(const nlohmann::json& firmware) {
    const double frame = firmware["profiled"]["instructions"].get<double>();
    std::string out = "<h2>Which line costs what</h2>\n<table><tr><th>line</th><th "
                      "class=words>command</th><th>calls</th><th>"
                      "instructions</th><th>of the frame</th></tr>\n";
    for (const nlohmann::json& line : firmware["lines"])
        out +=
            fmt::format("<tr><td>{}</td><td class=words>{}</td><td>{:g}</td><td>{}</td><td>{}</td></tr>\n",
                        escape_html(line["line"].get<std::string>()), line["command"].get<std::string>(),
                        line["calls"].get<double>(), with_thousands(line["instructions"].get<std::int64_t>()),
                        bar(line["instructions"].get<double>() / frame));
    return out + "</table>\n<p>Of a frame of the profiled build. A command that draws pays for what was "
                 "asked before it.</p>\n";
}

} // namespace

std::string to_page(const ProfileReport& report) {
    const nlohmann::json told = to_json(report);
    std::string out =
        head + fmt::format("<h1>What {} takes</h1>\n<p>In the tier {}, {} frames recorded.</p>\n",
                           escape_html(report.title), report.chosen->tier, report.chosen->frames);
    if (report.firmware.is_object())
        out += list_builds(report.firmware);
    out += tiers(report) + list_state_keys(told);
    if (report.firmware.is_object() && !report.firmware["lines"].empty())
        out += lines(report.firmware);
    out += "<h2>Systems and limits</h2>\n<p>";
    for (const std::string& feature : report.made->features)
        out += feature + " ";
    out += "</p>\n<table><tr><th>limit</th><th>value</th></tr>\n";
    for (const auto& [limit, value] : report.made->limits)
        out += fmt::format("<tr><td>SPANGLE_{}</td><td>{}</td></tr>\n", limit, value);
    out +=
        "</table>\n<h2>Ranges</h2>\n<p>How far the program went. A debug build of the profile stops a "
        "program "
        "that goes farther.</p>\n<table><tr><th>range</th><th>most</th><th class=words>of what</th></tr>\n";
    for (unsigned i = 0; i < gl::range_count; ++i) {
        const profile::RangeText range = profile::text_of(gl::Range{static_cast<std::uint8_t>(i)});
        out += fmt::format("<tr><td>{}</td><td>{}</td><td class=words>{}</td></tr>\n", range.name,
                           report.chosen->record.reached[i], range.counted);
    }
    return out + "</table>\n</body></html>\n";
}

} // namespace spangle::cli
