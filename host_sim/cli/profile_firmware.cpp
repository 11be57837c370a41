#include "host_sim/cli/profile_firmware.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "host_sim/cli/model_baked.hpp"
#include "host_sim/cli/pair.hpp"
#include "host_sim/process/process.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* tool = "host_sim/profile/firmware/measure.py";
constexpr const char* model_header = "host_sim/profile/firmware/model.hpp";
constexpr int most_frames = 3; ///< an emulated board needs seconds for each frame

/// The measuring tool, in the source folder that SPANGLE_SOURCES names or that this program was built in.
/// Empty if neither has it.
fs::path find_tool() {
    std::error_code ignored;
    if (const char* const named = std::getenv("SPANGLE_SOURCES"); named != nullptr && *named != '\0')
        return fs::exists(fs::path(named) / tool, ignored) ? fs::path(named) / tool : fs::path();
    for (fs::path at = fs::read_symlink("/proc/self/exe", ignored).parent_path(); at.has_relative_path();
         at = at.parent_path())
        if (fs::exists(at / tool, ignored))
            return at / tool;
    return {};
}

/// What the tool printed, without the line break at its end.
std::string last_words(const fs::path& path) {
    std::ifstream file(path);
    std::string said{std::istreambuf_iterator<char>(file), {}};
    said.erase(said.find_last_not_of('\n') + 1);
    return said;
}

/// The size of the picture as WIDTHxHEIGHT. The windows of a trace have sizes of their own, of which the
/// largest counts.
std::string size_of(const ProfileOptions& options, const TierRecord& chosen) {
    const bool drawn = options.trace.empty();
    return drawn ? options.size
                 : fmt::format("{}x{}", chosen.record.reach(gl::Range::SURFACE_WIDTH),
                               chosen.record.reach(gl::Range::SURFACE_HEIGHT));
}

/// Writes the recorded model as constants. Returns what went wrong, or an empty string.
std::string write_model(const std::string& model, const fs::path& path) {
    const ModelResult loaded = load_model(model);
    if (!loaded.error.empty())
        return loaded.error;
    std::ofstream file(path);
    file << "#include \"" << model_header << "\"\n"
         << BakedModel(loaded.model).header("measured")
         << "const spangle::baked::Mesh& spangle::measure::model_mesh = spangle::baked::measured::mesh;\n";
    return file.flush() ? "" : "--report cannot write " + path.string();
}

} // namespace

std::string measure_firmware(const ProfileOptions& options, const TierRecord& chosen, const fs::path& folder,
                             nlohmann::json& out) {
    const fs::path script = find_tool();
    if (script.empty())
        return "--report builds firmware from Spangle's sources; SPANGLE_SOURCES names their folder";
    const fs::path result = folder / "result.json", words = folder / "words";
    std::vector<std::string> command = {
        "python3", script.string(),          options.out, "--tier",       chosen.tier,
        "--size",  size_of(options, chosen), "--out",     result.string()};
    if (!options.trace.empty()) {
        std::string names;
        for (const auto& [name, count] : chosen.record.commands)
            names += (names.empty() ? "" : ",") + name;
        // Work that only the first frame does is not counted.
        command.insert(command.end(), {"--trace", options.trace, "--commands", names, "--first", "1", "--end",
                                       std::to_string(most_frames + 1)});
    } else {
        command.insert(command.end(), {"--end", std::to_string(std::min(options.run.frames, most_frames))});
        if (!options.run.scene.empty()) {
            command.insert(command.end(), {"--scene", options.run.scene});
        } else {
            const fs::path source = folder / "model.cpp";
            if (std::string problem = write_model(options.run.model, source); !problem.empty())
                return problem;
            command.insert(command.end(),
                           {"--program", "spangle::measure::model", "--header", model_header, "--source",
                            source.string(), fs::path(script).replace_filename("model.cpp").string()});
        }
    }
    const int status = pair::run(command, words);
    if (status == process::no_program)
        return "--report needs python3";
    constexpr int missing = 3; // the exit status of measure.py for a tool that is missing
    if (status != 0)
        return fmt::format("--report {}: {}", status == missing ? "builds firmware" : "failed",
                           last_words(words));
    std::ifstream file(result);
    out = nlohmann::json::parse(file, nullptr, false);
    return out.is_object() ? "" : "--report: the measurements cannot be read";
}

} // namespace spangle::cli
