#include "host_sim/trade/cost.hpp"

#include <algorithm>
#include <deque>

#include <fmt/format.h>

#include <spangle/GL/gl.h>
#include <spangle/reference.hpp>

#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/capture/thread_time.hpp"
#include "host_sim/trade/offscreen.hpp"
#include "host_sim/trade/recording.hpp"

namespace spangle::trade {

namespace {

constexpr int rounds = 15;
constexpr double round_time = 4000; ///< microseconds

/// The mean time of whole frames, in microseconds, over at least the time of a round.
double microseconds_of_frame(const Program& program, int frames) {
    const double start = thread_microseconds();
    int drawn = 0;
    double spent = 0;
    while (spent < round_time) {
        program.draw(drawn++ % frames);
        spent = thread_microseconds() - start;
    }
    return spent / drawn;
}

} // namespace

std::vector<double> frame_times(const Program& program, const std::vector<Tier>& chosen, const Format& format,
                                const Setting& s) {
    if (program.recording != nullptr)
        return program.recording->times(chosen, format, s);
    std::deque<Offscreen> screens;
    std::vector<std::vector<double>> times(chosen.size());
    std::vector<bool> drawn;
    drawn.reserve(chosen.size());
    for (const Tier& tier : chosen)
        drawn.push_back(
            screens.emplace_back()
                .open(program, s.width, s.height, format.format, tier.precision, s.dither, own_knobs(tier))
                .empty());
    for (int round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (drawn[i]) {
                screens[i].make_current();
                const double time = microseconds_of_frame(program, s.frames);
                if (round != 0) // the first round warms up
                    times[i].push_back(time);
            }
    std::vector<double> out;
    out.reserve(times.size());
    for (const auto& all : times)
        out.push_back(all.empty() ? -1 : *std::min_element(all.begin(), all.end()));
    return out;
}

Work work_of_frames(const Program& program, const Tier& tier, const Format& format, const Setting& s) {
    Offscreen screen;
    Work out;
    if (program.recording != nullptr || // another process draws a recorded program
        !screen.open(program, s.width, s.height, format.format, tier.precision, s.dither, own_knobs(tier))
             .empty())
        return out;
    raster::Counters counters;
    gl::observe(*gl::current_context(), &counters, false);
    program.draw(0);
    counters.triangles = counters.fragments = 0;
    for (int f = first_counted; f < first_counted + counted_frames; ++f)
        program.draw(f);
    out.triangles = static_cast<double>(counters.triangles) / counted_frames;
    out.fragments = static_cast<double>(counters.fragments) / counted_frames;
    out.hash = 2166136261u;
    for (const std::uint8_t byte : read_picture().rgba)
        out.hash = (out.hash ^ byte) * 16777619u;
    gl::observe(*gl::current_context(), nullptr, false);
    return out;
}

std::string target_column(const std::string& target, const std::string& figure) {
    return target + "_" + figure;
}

namespace {

/// Appends the instructions, in all and for each pixel and triangle. Missing figures are empty cells.
void append_instructions(Table::Row& out, std::uint64_t instructions, const Work& work) {
    const auto per = [&](double n) {
        return instructions != 0 && n > 0 ? fmt::format("{:.1f}", static_cast<double>(instructions) / n) : "";
    };
    out.push_back(instructions != 0 ? std::to_string(instructions) : "");
    out.push_back(per(work.fragments));
    out.push_back(per(work.triangles));
}

} // namespace

Table::Row cost_columns() {
    Table::Row out = {"job",          "jobs",     "scene",     "tier",     "format",
                      "microseconds", "relative", "triangles", "fragments"};
    for (const std::string& target : target_names())
        for (const char* figure : {"instructions", "per_pixel", "per_triangle", "flash", "ram"})
            if (target != host_target || figure[0] == 'i' || figure[0] == 'p') // the host has no image
                out.push_back(target_column(target, figure));
    return out;
}

Table::Row cost_row(const Job& job, const Tier& tier, const Cost& cost) {
    const bool timed = cost.microseconds > 0 && cost.first > 0;
    Table::Row out = {std::to_string(job.number),
                      std::to_string(job.of),
                      job.scene,
                      tier.name,
                      job.format.name,
                      timed ? fmt::format("{:.1f}", cost.microseconds) : "",
                      timed ? fmt::format("{:.3f}", cost.microseconds / cost.first) : "",
                      fmt::format("{:.6g}", cost.work.triangles),
                      fmt::format("{:.10g}", cost.work.fragments)};
    append_instructions(out, cost.instructions, cost.work);
    for (const Target& target : targets()) {
        const auto found = cost.boards.find(target.name);
        const bool counted = found != cost.boards.end();
        append_instructions(out, counted ? found->second.instructions : 0, cost.board_work);
        out.push_back(counted ? std::to_string(found->second.flash) : "");
        out.push_back(counted ? std::to_string(found->second.ram) : "");
    }
    return out;
}

} // namespace spangle::trade
