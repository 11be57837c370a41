#include "host_sim/cli/bench.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include <nlohmann/json.hpp>
#include <spangle/GL/gl.h>

#include "boards/scenes/scene.hpp"
#include "host_sim/cli/say.hpp"
#include "host_sim/cli/session.hpp"

namespace spangle::cli {
namespace {

constexpr int width = 320, height = 240, batches = 15;
constexpr std::chrono::milliseconds batch_time(10);

/// Microseconds a frame, of all batches. Half of the batches lie between the quartiles.
struct Spread {
    double lower, median, upper;
};

Spread spread_of(std::array<double, batches> times) {
    std::sort(times.begin(), times.end());
    return {times[batches / 4], times[batches / 2], times[batches - 1 - batches / 4]};
}

/// Times the scene, after a few frames that warm it up. Returns nothing where this build lacks the precision,
/// or a part of GL that the scene uses.
std::optional<Spread> time_of(const scenes::Scene& scene, Precision precision) {
    using Clock = std::chrono::steady_clock;
    Session session;
    if (!session.open_picture(width, height, precision).empty())
        return {};
    scene.setup(session.width(), session.height());
    int frame = 0;
    while (frame < 3)
        scene.draw(frame++);
    if (glGetError() != GL_NO_ERROR) // this build leaves out parts of what the scene draws
        return {};
    std::array<double, batches> times{};
    for (double& time : times) {
        const auto start = Clock::now();
        int frames = 0;
        do {
            scene.draw(frame++);
            ++frames;
        } while (Clock::now() - start < batch_time);
        time = std::chrono::duration<double, std::micro>(Clock::now() - start).count() / frames;
    }
    return spread_of(times);
}

struct Timed {
    const char* name;
    Precision precision;
};
constexpr Timed timed[] = {
    {"exact", Precision::exact}, {"balanced", Precision::balanced}, {"fast", Precision::fast}};

std::string cell(const std::optional<Spread>& s) {
    return s ? fmt::format("{:>10.1f} ({:.1f} .. {:.1f})", s->median, s->lower, s->upper) : "         -";
}

} // namespace

int bench(bool json) {
    nlohmann::ordered_json out = {{"width", width}, {"height", height}, {"batches", batches}};
    if (!json) {
        print("Microseconds a frame of {}x{} off screen, dithered, in this run: the median of {} batches, "
              "and its "
              "quartiles.\n`./dev bench` holds them against Mesa and counts instructions.\n",
              width, height, batches);
        print("{:<6}{:<34}{:<34}{:<34}\n", "scene", "     exact", "  balanced", "      fast");
    }
    for (const scenes::Scene& scene : scenes::all()) {
        std::string line = fmt::format("{:<6}", scene.id);
        for (const Timed& t : timed) {
            const std::optional<Spread> spread = time_of(scene, t.precision);
            line += fmt::format("{:<34}", cell(spread));
            if (spread)
                out["scenes"][scene.id][t.name] = {
                    {"lower_us", spread->lower}, {"median_us", spread->median}, {"upper_us", spread->upper}};
        }
        line.resize(line.find_last_not_of(' ') + 1);
        if (!json)
            print("{}\n", line);
        sim::standard_output().flush();
    }
    if (json)
        print("{}\n", out.dump(2));
    return 0;
}

} // namespace spangle::cli
