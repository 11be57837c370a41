#include "host_sim/trade/sweep.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "host_sim/output/output.hpp"
#include "host_sim/trade/cost.hpp"
#include "host_sim/trade/page.hpp"
#include "host_sim/trade/recording.hpp"

namespace spangle::trade {

namespace {

namespace fs = std::filesystem;

std::string make_folder(const std::string& folder) {
    std::error_code problem;
    fs::create_directories(folder + picture_folder, problem);
    return problem ? "cannot make folder '" + folder + "': " + problem.message() : "";
}

std::string write_tables(const std::string& folder, const SweepResult& swept) {
    std::string problem = sim::write_file(folder + accuracy_file, to_csv(swept.accuracy));
    return problem.empty() ? sim::write_file(folder + cost_file, to_csv(swept.cost)) : problem;
}

std::string write_pictures(const std::string& folder, const Job& job, const Tier& tier, const Measured& m) {
    const std::string number = std::to_string(job.number), name = tier.name;
    const struct {
        std::string what;
        const sim::Image& image;
    } pictures[] = {{name, m.picture},
                    {name + "-off", sim::difference_picture(m.picture, m.reference)},
                    {"double", m.reference}};
    for (const auto& picture : pictures)
        if (std::string problem = sim::write_png(picture.image, folder + picture_name(number, picture.what));
            !problem.empty())
            return problem;
    return "";
}

std::string run_job(const Sweep& what, const Program& program, const Job& job, const std::string& folder,
                    SweepResult& out) {
    what.progress(job);
    Setting setting = what.setting;
    if (program.recording != nullptr)
        if (std::string problem = program.recording->settle(setting); !problem.empty())
            return fmt::format("{}: {}", program.name, problem);
    for (const Tier& tier : what.tiers) {
        const Measured m = measure(program, tier, job.format, setting);
        if (!m.problem.empty())
            return fmt::format("{} in {}, {}: {}", program.name, job.format.name, tier.name, m.problem);
        out.accuracy.rows.push_back(accuracy_row(job, tier, setting, m));
        if (std::string problem = write_pictures(folder, job, tier, m); !problem.empty())
            return problem;
    }
    std::vector<double> times(what.tiers.size(), -1);
    if (what.times)
        times = frame_times(program, what.tiers, job.format, setting);
    for (std::size_t i = 0; i < what.tiers.size(); ++i) {
        const Tier& tier = what.tiers[i];
        Cost cost{times[i],
                  times[0],
                  work_of_frames(program, tier, job.format, setting),
                  what.count ? what.count(program, tier, job.format) : 0,
                  {},
                  {}};
        cost.board_work = program.on_board != nullptr
                              ? work_of_frames(*program.on_board, tier, job.format, setting)
                              : cost.work;
        for (const Target& target : what.targets)
            if (const auto counted = what.count_board(target, program, tier, job.format, cost.board_work))
                cost.boards[target.name] = *counted;
        out.cost.rows.push_back(cost_row(job, tier, cost));
    }
    return "";
}

std::string read_table(const std::string& path, Table& out) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file)
        return "cannot read '" + path + "'";
    const std::string problem = from_csv(text.str(), out);
    return problem.empty() ? "" : path + ": " + problem;
}

std::string merge_files(const std::vector<std::string>& parts, const char* file, Table& out) {
    std::vector<Table> tables;
    for (const std::string& part : parts)
        if (std::string problem = read_table(part + file, tables.emplace_back()); !problem.empty())
            return problem;
    return merge(tables, out);
}

} // namespace

SweepResult sweep(const Sweep& what, const std::string& folder) {
    SweepResult out;
    out.accuracy.columns = accuracy_columns();
    out.cost.columns = cost_columns();
    out.problem = make_folder(folder);
    const int jobs = static_cast<int>(what.programs.size() * what.formats.size());
    int number = 0;
    for (const Program& program : what.programs)
        for (const Format& format : what.formats) {
            const Job job{number++, jobs, program.name, format};
            if (out.problem.empty() && job.number % what.shards == what.shard - 1)
                out.problem = run_job(what, program, job, folder, out);
        }
    if (out.problem.empty())
        out.problem = write_tables(folder, out);
    return out;
}

SweepResult merge_folders(const std::vector<std::string>& parts, const std::string& folder) {
    SweepResult out;
    out.problem = merge_files(parts, accuracy_file, out.accuracy);
    if (out.problem.empty())
        out.problem = merge_files(parts, cost_file, out.cost);
    if (out.problem.empty())
        out.problem = make_folder(folder);
    for (const std::string& part : parts) {
        std::error_code problem;
        if (!out.problem.empty() || fs::equivalent(part, folder, problem))
            continue;
        fs::copy(part + picture_folder, folder + picture_folder,
                 fs::copy_options::overwrite_existing | fs::copy_options::recursive, problem);
        if (problem)
            out.problem = "cannot copy the pictures of '" + part + "': " + problem.message();
    }
    if (out.problem.empty())
        out.problem = write_tables(folder, out);
    return out;
}

} // namespace spangle::trade
