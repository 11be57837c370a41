// Draws the scenes on Mesa's llvmpipe, as Google Benchmark cases with the names of bench_spangle. Surfaces
// have RGB565 colour and 16-bit depth, without dithering; run with LP_NUM_THREADS=0.
#include <string>
#include <vector>

#include <GL/osmesa.h>
#include <benchmark/benchmark.h>

#include "boards/scenes/scene.hpp"
#include "host_sim/cli/process_memory.hpp"

namespace {

void run(benchmark::State& state, const spangle::scenes::Scene* scene, int width, int height) {
    const int attributes[] = {OSMESA_FORMAT, OSMESA_RGB_565, OSMESA_DEPTH_BITS, 16, 0};
    const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    std::vector<GLushort> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (context == nullptr ||
        OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_SHORT_5_6_5, width, height) == 0) {
        state.SkipWithError("OSMesa gives no RGB565 context");
        return;
    }
    glDisable(GL_DITHER);
    scene->setup(width, height);
    int frame = 0;
    for (; frame < 4; ++frame)
        scene->draw(frame); // llvmpipe compiles its shaders
    glFinish();
    for (auto _ : state) {
        scene->draw(frame++);
        glFinish();
    }
    state.counters["process"] = static_cast<double>(spangle::cli::process_peak());
    OSMesaDestroyContext(context);
}

} // namespace

int main(int argc, char** argv) {
    for (const spangle::scenes::Scene& scene : spangle::scenes::all())
        for (const auto& [width, height] : {std::pair{320, 240}, std::pair{800, 480}}) {
            const std::string name =
                std::string(scene.id) + "/" + std::to_string(width) + "x" + std::to_string(height);
            benchmark::RegisterBenchmark(name.c_str(), run, &scene, width, height)
                ->Unit(benchmark::kMicrosecond);
        }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
