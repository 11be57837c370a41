#include "host_sim/trade/targets.hpp"

#include <cctype>
#include <numeric>
#include <sstream>

#include <fmt/format.h>

#include "host_sim/process/process.hpp"
#include "host_sim/trade/cost.hpp"

namespace spangle::trade {

namespace {

constexpr const char* most_seconds = "600"; ///< s that an image may run

std::vector<std::string> command_of(const Target& target, const std::string& image, const Setting& s) {
    // The program's arguments come by semihosting; the first one stands for the program's name.
    std::string arguments;
    for (const std::string& word :
         {std::string("spangle"), std::to_string(s.width), std::to_string(s.height),
          std::to_string(first_counted), std::to_string(counted_frames), std::to_string(s.dither ? 1 : 0)})
        arguments += ",arg=" + word;
    std::vector<std::string> words = {"timeout", most_seconds};
    words.insert(words.end(), target.machine.begin(), target.machine.end());
    words.insert(words.end(),
                 {"-icount", "shift=0", "-display", "none", "-serial", "null", "-monitor", "none",
                  "-semihosting-config", "enable=on,target=native" + arguments, "-kernel", image});
    return words;
}

} // namespace

const std::vector<Target>& targets() {
    // No emulated board with a Cortex-M0+ has enough memory. Its code runs on the Cortex-M3, whose
    // instructions contain those of the M0+.
    static const std::vector<Target> all = {
        {"m0plus", "Cortex-M0+", {"qemu-system-arm", "-M", "mps2-an385"}},
        {"m3", "Cortex-M3", {"qemu-system-arm", "-M", "mps2-an385"}},
        {"m4", "Cortex-M4", {"qemu-system-arm", "-M", "mps2-an386"}},
        {"rv32", "RV32IMAC", {"qemu-system-riscv32", "-M", "virt", "-bios", "none"}}};
    return all;
}

std::vector<std::string> target_names() {
    std::vector<std::string> out = {host_target};
    for (const Target& target : targets())
        out.emplace_back(target.name);
    return out;
}

std::string image_path(const std::string& folder, const Target& target, const std::string& program,
                       const Tier& tier) {
    std::string name = program;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.')
            c = '_';
    return fmt::format("{}/{}/{}-{}.elf", folder, target.name, name, tier.name);
}

std::string read_firmware_report(std::string_view text, FirmwareReport& out) {
    std::istringstream lines{std::string(text)};
    std::string rest;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t number = 0;
        if (!(words >> name >> number)) {
            rest += rest.empty() ? line : "";
            continue;
        }
        if (name == "frame" && words >> std::hex >> out.hash)
            out.frames.push_back(number);
        else if (name == "own")
            out.own = number;
        else if (name == "surface")
            out.surface = number;
        else if (name == "peak")
            out.peak = number;
        else if (name == "stack")
            out.stack = number;
    }
    if (out.frames.empty() || out.stack == 0)
        return rest.empty() ? "it does not say what it counted" : "it says '" + rest + "'";
    return "";
}

std::string count_on(const Target& target, const std::string& image, const Setting& setting,
                     std::uint32_t hash, BoardCost& out) {
    ImageSizes sizes;
    if (std::string problem = read_sizes(image, sizes); !problem.empty())
        return problem;
    const process::TemporaryFile out_file, error_file;
    const process::ExitStatus ended =
        process::run(command_of(target, image, setting),
                     {process::nowhere, out_file.descriptor(), error_file.descriptor()});
    if (ended.status == process::no_program)
        return fmt::format("{} is not installed (./dev setup --all installs it)", target.machine[0]);
    FirmwareReport said;
    if (std::string problem = read_firmware_report(out_file.text() + error_file.text(), said);
        !problem.empty() || ended.status != 0)
        return fmt::format("{} ended with status {}: {}", image, ended.status,
                           problem.empty() ? "it failed after its frames" : problem);
    if (said.hash != hash)
        return image + " draws another picture than this program; build it anew";
    out.instructions =
        std::accumulate(said.frames.begin(), said.frames.end(), std::uint64_t{0}) / said.frames.size();
    out.flash = sizes.flash;
    out.ram = sizes.variables - said.own + said.peak - said.surface + said.stack;
    return "";
}

} // namespace spangle::trade
