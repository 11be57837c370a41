// Draws the scenes on Spangle, as Google Benchmark cases SCENE/SIZE/TIER[/dither]. Surfaces have RGB565
// colour in the wire's byte order and 16-bit depth. The counter "hash" is the picture of frame 2 after the
// timed frames, so that a fast wrong picture is noticed.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "boards/scenes/scene.hpp"
#include "host_sim/cli/process_memory.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"

namespace {

struct Case {
    const spangle::scenes::Scene* scene;
    int width, height;
    EGLint precision;
    bool dither;
};

void run(benchmark::State& state, const Case& c) {
    spangle::bench::Headless gl;
    if (!gl.open(c.width, c.height, c.precision)) {
        state.SkipWithError("no context");
        return;
    }
    if (!c.dither)
        glDisable(GL_DITHER);
    c.scene->setup(c.width, c.height);
    int frame = 0;
    for (auto _ : state)
        c.scene->draw(frame++);
    c.scene->draw(2);
    state.counters["hash"] = spangle::bench::picture_hash(c.width, c.height);
    state.counters["context"] = static_cast<double>(gl.context_bytes);
    state.counters["surface"] = static_cast<double>(gl.surface_bytes);
    state.counters["peak"] = static_cast<double>(spangle::memory_use().peak);
    state.counters["process"] = static_cast<double>(spangle::cli::process_peak());
    if (glGetError() != GL_NO_ERROR)
        state.SkipWithError("GL error");
    gl.close();
}

} // namespace

int main(int argc, char** argv) {
    constexpr std::pair<const char*, EGLint> tiers[] = {{"exact", EGL_PRECISION_EXACT_SPANGLE},
                                                        {"balanced", EGL_PRECISION_BALANCED_SPANGLE},
                                                        {"fast", EGL_PRECISION_FAST_SPANGLE}};
    for (const spangle::scenes::Scene& scene : spangle::scenes::all())
        for (const auto& [width, height] : {std::pair{320, 240}, std::pair{800, 480}})
            for (const auto& [tier, precision] : tiers)
                for (const bool dither : {false, true}) {
                    const std::string name = std::string(scene.id) + "/" + std::to_string(width) + "x" +
                                             std::to_string(height) + "/" + tier + (dither ? "/dither" : "");
                    benchmark::RegisterBenchmark(name.c_str(), run,
                                                 Case{&scene, width, height, precision, dither})
                        ->Unit(benchmark::kMicrosecond);
                }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
