#include "host_sim/profile/record_text.hpp"

#include <sstream>
#include <type_traits>

namespace spangle::profile {

namespace {

constexpr const char *first_line = "spangle record 2", *last_line = "end";

/// Calls f with every field of a key, in the same order for writing and reading.
template <class K, class F> void each_field(K& key, F f) {
    f(key.number), f(key.kind), f(key.format), f(key.depth_format);
    for (auto& unit : key.unit)
        f(unit.on), f(unit.general), f(unit.texels), f(unit.base), f(unit.filter), f(unit.env);
    f(key.combine), f(key.pixels), f(key.color), f(key.color_alpha), f(key.color_sum);
    f(key.fog), f(key.fog_mode), f(key.alpha), f(key.stencil), f(key.depth), f(key.depth_write);
    f(key.blend), f(key.cubic), f(key.coarse), f(key.blend_general);
    f(key.blending.src), f(key.blending.dst), f(key.blending.equation);
    f(key.dither), f(key.masked), f(key.logic), f(key.count), f(key.coverage);
    f(key.polygon_stipple), f(key.depth_offset), f(key.samples);
#if SPANGLE_OWN_TIERS
    f(key.other_runs);
#endif
}

/// Calls f with the name and the value of every limit and range.
template <class R, class F> void each_number(R& record, F f) {
    f("modelview_stack", record.modelview_stack);
    f("projection_stack", record.projection_stack);
    f("texture_stack", record.texture_stack);
    f("list_nesting", record.list_nesting);
    f("lights", record.lights);
    f("texture_units", record.texture_units);
    f("texture_levels", record.texture_levels);
    f("light_kinds", record.light_kinds);
    f("array_types", record.array_types);
    f("primitives", record.primitives);
    f("tiers", record.tiers);
    f("color_formats", record.color_formats);
    f("depth_formats", record.depth_formats);
    f("texture_formats", record.texture_formats);
    f("full_lighting", record.full_lighting);
    f("arena_peak", record.arena_peak);
    auto* reached = record.reached;
#define RANGE(name, counted) f(#name, *reached++);
#include "gl/context/ranges.inc"
#undef RANGE
}

} // namespace

std::string to_text(const Record& record) {
    std::ostringstream out;
    out << first_line << '\n';
    for (const auto& [name, count] : record.commands)
        out << "command " << name << ' ' << count << '\n';
    for (const std::string& feature : record.features)
        out << "feature " << feature << '\n';
    each_number(record,
                [&](const char* name, auto value) { out << "limit " << name << ' ' << +value << '\n'; });
    for (const KeyUse& use : record.keys) {
        out << "key " << use.pixels << ' ' << use.fused << ' ' << use.needed;
        each_field(use.key, [&](auto value) { out << ' ' << static_cast<unsigned>(value); });
        out << '\n';
    }
    out << last_line << '\n';
    return out.str();
}

std::string from_text(const std::string& text, Record& out) {
    std::istringstream lines(text);
    std::string line;
    if (!std::getline(lines, line) || line != first_line)
        return "no record of this version of Spangle";
    out = {};
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string kind, name;
        words >> kind;
        if (kind == last_line)
            return "";
        if (kind == "command") {
            std::uint64_t count = 0;
            words >> name >> count;
            out.commands[name] = count;
        } else if (kind == "feature") {
            words >> name;
            out.features.insert(name);
        } else if (kind == "limit") {
            std::uint64_t value = 0;
            bool known = false;
            words >> name >> value;
            each_number(out, [&](const char* limit, auto& to) {
                if (name == limit) {
                    to = static_cast<std::remove_reference_t<decltype(to)>>(value);
                    known = true;
                }
            });
            if (!known)
                words.setstate(std::ios::failbit);
        } else if (kind == "key") {
            KeyUse use;
            words >> use.pixels >> use.fused >> use.needed;
            each_field(use.key, [&](auto& to) {
                unsigned value = 0;
                words >> value;
                to = static_cast<std::remove_reference_t<decltype(to)>>(value);
            });
            out.keys.push_back(use);
        } else {
            words.setstate(std::ios::failbit);
        }
        if (words.fail())
            return "a line that is no part of a record: " + line;
    }
    return "a record without its end";
}

} // namespace spangle::profile
