#include "host_sim/trade/knobs.hpp"

#include <algorithm>
#include <charconv>
#include <type_traits>

#include <fmt/format.h>

namespace spangle::trade {

namespace {

using raster::Knobs;

template <auto Field>
Knob knob(const char* name, int least, int most, std::vector<Knob::Word> words, const char* trades) {
    return {name,
            least,
            most,
            std::move(words),
            trades,
            [](const Knobs& k) { return static_cast<std::uint8_t>(k.*Field); },
            [](Knobs& k, std::uint8_t v) {
                k.*Field = static_cast<std::remove_reference_t<decltype(k.*Field)>>(v);
            }};
}

const std::vector<Knob::Word> on_off = {{"off", 0}, {"on", 1}}, or_never = {{"never", Knobs::never}},
                              or_always = {{"always", 0}};

bool is_name(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    });
}

/// Reads the value of a knob. Returns false if the knob has no such value.
bool read_value(const Knob& knob, std::string_view text, std::uint8_t& out) {
    for (const Knob::Word& word : knob.words)
        if (text == word.text) {
            out = word.value;
            return true;
        }
    int number = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size() || number < knob.least ||
        number > knob.most)
        return false;
    out = static_cast<std::uint8_t>(number);
    return true;
}

std::string set_knob(std::string_view assignment, Knobs& out) {
    const std::size_t equals = assignment.find('=');
    const std::string_view name = assignment.substr(0, equals);
    for (const Knob& knob : knobs()) {
        if (name != knob.name || equals == std::string_view::npos)
            continue;
        std::uint8_t value = 0;
        if (!read_value(knob, assignment.substr(equals + 1), value))
            return fmt::format("{} takes {}, not '{}'", name, knob.range(), assignment.substr(equals + 1));
        knob.set(out, value);
        return "";
    }
    return fmt::format("'{}' is no KNOB=VALUE; `spangle trade --knobs` lists the knobs", assignment);
}

} // namespace

std::string Knob::text(const Knobs& knobs) const {
    const std::uint8_t value = get(knobs);
    for (const Word& word : words)
        if (word.value == value)
            return word.text;
    return std::to_string(value);
}

std::string Knob::range() const {
    std::string out = least <= most ? fmt::format("{} to {}", least, most) : "";
    for (const Word& word : words)
        out += fmt::format("{}{}", out.empty() ? "" : " or ", word.text);
    return out;
}

const std::vector<Knob>& knobs() {
    static const std::vector<Knob> all = {
        knob<&Knobs::color_bits>("color_bits", 1, 0, {{"8", 8}, {"20", 20}},
                                 "Fraction bits that colours are combined in: 8 are words of 16 bits."),
        knob<&Knobs::coarse_blend>("coarse_blend", 1, 0, on_off,
                                   "Blends over 565 in 5 and 6 bits, where colours have 8 bits."),
        knob<&Knobs::exact_steps>("exact_steps", 1, 0, on_off,
                                  "Dithered colours count exact steps; off, a step may be a 290th off."),
        knob<&Knobs::unsnapped>("unsnapped", 1, 0, on_off,
                                "Attributes go through vertices as they were before snapping."),
        knob<&Knobs::runs>("runs", 1, 0, {{"straight", 0}, {"cubic", 1}},
                           "How coordinates go from one division to the next."),
        knob<&Knobs::texel_bits>("texel_bits", 0, 13, {},
                                 "Between divisions coordinates are off by 2^-n texel at most."),
        knob<&Knobs::shortest_run>("shortest_run", 0, 6, {},
                                   "Straight runs have 2^n pixels at least, however far off they are."),
        knob<&Knobs::longest_run>("longest_run", 0, 16, {},
                                  "Runs have 2^n pixels at most: cubic ones 4, without REPEAT 6."),
        knob<&Knobs::affine_texel_bits>("affine_texel_bits", 2, 13, or_never,
                                        "Primitives divide nothing where coordinates are off by 2^-n texel."),
        knob<&Knobs::affine_color_bits>("affine_color_bits", 2, 24, {{"always", 0}, {"never", Knobs::never}},
                                        "Colours divide nothing where they are off by 2^-n of full scale,"),
        knob<&Knobs::affine_step_bits>("affine_step_bits", 0, 20, or_never,
                                       "or where they are off by 2^-n step of the target."),
        knob<&Knobs::affine_fog_bits>("affine_fog_bits", 2, 24, or_always,
                                      "Fog divides nothing where its factor is off by 2^-n."),
    };
    return all;
}

std::string read_knobs(std::string_view words, Tier& out) {
    std::size_t comma = words.find(',');
    const std::string_view name = words.substr(0, comma);
    const Tier* const base = find(tiers, name);
    if (base == nullptr)
        return fmt::format("an own tier begins with exact, balanced or fast, not with '{}'", name);
    out = *base;
    out.words = words;
    Knobs made = base->name == "exact"  ? raster::exact_knobs
                 : base->name == "fast" ? raster::fast_knobs
                                        : raster::balanced_knobs;
    while (comma != std::string_view::npos) {
        words.remove_prefix(comma + 1);
        comma = words.find(',');
        if (std::string problem = set_knob(words.substr(0, comma), made); !problem.empty())
            return problem;
    }
    out.knobs = made;
    return raster::are_valid(made) ? "" : "longest_run is below shortest_run";
}

std::string read_tier(std::string_view words, const std::vector<Tier>& taken, Tier& out) {
    const std::size_t equals = words.find('=');
    const std::string_view name = words.substr(0, equals);
    if (equals == std::string_view::npos || !is_name(name))
        return fmt::format(
            "--tier takes NAME=BASE,KNOB=VALUE,..., its name of letters, digits and -, not '{}'", words);
    const auto has_name = [name](const Tier& tier) { return tier.name == name; };
    if (find(tiers, name) != nullptr || std::any_of(taken.begin(), taken.end(), has_name))
        return fmt::format("--tier: there is a tier '{}' already; choose another name", name);
    const std::string problem = read_knobs(words.substr(equals + 1), out);
    out.name = name;
    return problem.empty() ? "" : "--tier: " + problem;
}

std::string knob_table(const std::vector<Tier>& own) {
    std::vector<std::pair<std::string, Knobs>> columns = {
        {"exact", raster::exact_knobs}, {"balanced", raster::balanced_knobs}, {"fast", raster::fast_knobs}};
    for (const Tier& tier : own)
        columns.emplace_back(tier.name, tier.knobs.value());
    std::string out = fmt::format("{:<19}{:<28}", "knob", "values");
    const auto add = [&](const std::string& column, const std::string& text) {
        out += fmt::format("{:<{}}", text, std::max<std::size_t>(10, column.size() + 2));
    };
    for (const auto& [name, knobs] : columns)
        add(name, name);
    out += "what it trades\n";
    for (const Knob& k : knobs()) {
        out += fmt::format("{:<19}{:<28}", k.name, k.range());
        for (const auto& [name, values] : columns)
            add(name, k.text(values));
        out += k.trades + std::string("\n");
    }
    return out;
}

} // namespace spangle::trade
