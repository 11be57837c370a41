#include "tests/tools/bench/states/timed.hpp"

#include <cstdio>
#include <ctime>

#include "tests/tools/bench/states/apply.hpp"
#include "tests/tools/bench/states/grammar.hpp"
#include "tests/tools/bench/states/shapes.hpp"
#include "tests/tools/bench/states/textures.hpp"

namespace spangle::bench::states {

namespace {

constexpr double least_total = 2000; ///< the least time in microseconds that is measured at once
constexpr int least_frames = 2, most_frames = 40;

double cpu_us() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
}

double frame(const State& state, int amount) {
    prepare(state, amount);
    glFinish();
    const double before = cpu_us();
    draw(state, amount);
    glFinish();
    return cpu_us() - before;
}

/// Returns the time of the fastest of some frames, because other work disturbs the others.
double fastest(const State& state) {
    const int amount = amount_to_time(state);
    apply(state);
    set_vertices(state, amount);
    frame(state, amount); // compiles shaders
    double best = frame(state, amount), total = 0;
    for (int n = 0; n < least_frames || (n < most_frames && total < least_total); ++n) {
        const double time = frame(state, amount);
        total += time;
        best = time < best ? time : best;
    }
    return best;
}

} // namespace

int time_all(std::uint32_t seed, bool (*select)(const State&)) {
    unsigned number = 0;
    while (std::scanf("%u", &number) == 1) {
        const State of = state(seed, number);
        double time = -1; // negative: there is no such context
        if (select(of)) {
            glPushAttrib(GL_ALL_ATTRIB_BITS);
            glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
            time = fastest(of);
            forget_textures();
            glPopClientAttrib();
            glPopAttrib();
        }
        std::printf("%u %.2f\n", number, time);
        std::fflush(stdout);
        if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
            std::fprintf(stderr, "state %u: GL error %#x\n", number, error);
            return 1;
        }
    }
    return 0;
}

} // namespace spangle::bench::states
