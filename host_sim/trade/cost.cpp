#include "host_sim/trade/cost.hpp"

#include <algorithm>
#include <ctime>
#include <deque>

#include <fmt/format.h>

#include <spangle/GL/gl.h>

#include "host_sim/trade/offscreen.hpp"
#include "host_sim/trade/recording.hpp"

namespace spangle::trade {

namespace {

constexpr int rounds = 15;
constexpr double round_time = 4000; ///< microseconds

/// Of this thread on a processor, in microseconds: what others do on the machine is no cost of ours.
double worked() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Of whole frames, for at least the time of a round.
double microseconds_of_frame(const Program& program, int frames) {
    const double start = worked();
    int drawn = 0;
    double spent = 0;
    for (; spent < round_time; spent = worked() - start)
        program.draw(drawn++ % frames);
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
    for (const Tier& tier : chosen)
        drawn.push_back(screens.emplace_back()
                            .open(program, s.width, s.height, format.format, tier.precision, s.dither)
                            .empty());
    for (int round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (drawn[i]) {
                screens[i].make_current();
                const double time = microseconds_of_frame(program, s.frames);
                if (round != 0) // the first one warms up
                    times[i].push_back(time);
            }
    std::vector<double> out;
    for (const auto& all : times)
        out.push_back(all.empty() ? -1 : *std::min_element(all.begin(), all.end()));
    return out;
}

Table::Row cost_columns() {
    return {"job", "jobs", "scene", "tier", "format", "microseconds", "relative", "instructions"};
}

Table::Row cost_row(const Job& job, const Tier& tier, double microseconds, double first,
                    std::uint64_t instructions) {
    const bool timed = microseconds > 0 && first > 0;
    return {std::to_string(job.number),
            std::to_string(job.of),
            job.scene,
            tier.name,
            job.format.name,
            timed ? fmt::format("{:.1f}", microseconds) : "",
            timed ? fmt::format("{:.3f}", microseconds / first) : "",
            instructions != 0 ? std::to_string(instructions) : ""};
}

} // namespace spangle::trade
