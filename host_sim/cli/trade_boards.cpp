#include "host_sim/cli/trade_boards.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "host_sim/cli/say.hpp"
#include "host_sim/trade/targets.hpp"

namespace spangle::cli {

namespace {

constexpr const char* how_to_build = "`./dev firmware --out DIR` builds images; then --firmware DIR";

} // namespace

bool is_asked(const TradeOptions& options, const std::string& target) {
    return std::find(options.targets.begin(), options.targets.end(), target) != options.targets.end();
}

std::string read_targets(const TradeOptions& options, trade::Sweep& out) {
    for (const trade::Target& target : trade::targets())
        if (is_asked(options, target.name))
            out.targets.push_back(target);
    if (out.targets.empty())
        return options.firmware.empty() ? "" : "--firmware is for --targets m0plus, m3, m4 or rv32";
    if (options.firmware.empty())
        return fmt::format("--targets {} needs firmware: {}", out.targets.front().name, how_to_build);
    for (const trade::Target& target : out.targets)
        if (!std::filesystem::is_directory(options.firmware + "/" + target.name))
            return fmt::format("'{}' has no images for {}: {}", options.firmware, target.name, how_to_build);
    return "";
}

std::function<std::optional<trade::BoardCost>(const trade::Target&, const trade::Program&, const trade::Tier&,
                                              const trade::Format&, const trade::Work&)>
board_counter(const TradeOptions& options, const trade::Setting& setting) {
    return
        [&options, setting, told = std::set<std::string>()](
            const trade::Target& target, const trade::Program& program, const trade::Tier& tier,
            const trade::Format& format, const trade::Work& work) mutable -> std::optional<trade::BoardCost> {
            if (format.format != PixelFormat::rgb565_be)
                return {};
            const std::string image = trade::image_path(options.firmware, target, program.name, tier);
            trade::BoardCost cost;
            const bool there = std::filesystem::exists(image);
            const std::string problem = there ? trade::count_on(target, image, setting, work.hash, cost)
                                              : fmt::format("there is no {}; {}", image, how_to_build);
            if (problem.empty())
                return cost;
            if (told.insert(there ? target.name : program.name).second)
                tell(fmt::format("{} is not counted: {}\n", target.name, problem));
            return {};
        };
}

} // namespace spangle::cli
