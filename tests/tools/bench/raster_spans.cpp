// Times the rasterizer alone, with window-space versions of the benchmark scenes at 320x240.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "raster/primitive/draw.hpp"

namespace {

using namespace spangle::raster;
using spangle::DepthFormat;
using spangle::PixelFormat;

constexpr int width = 320, height = 240;

struct Frame {
    std::vector<std::uint16_t> color = std::vector<std::uint16_t>(width * height), depth = color;
    std::vector<std::uint8_t> texels;
    Texture texture;
    Surface surface;
    FragmentState state;
    Frame() {
        surface.color = reinterpret_cast<std::uint8_t*>(color.data());
        surface.depth = reinterpret_cast<std::uint8_t*>(depth.data());
        surface.color_stride = surface.depth_stride = 2 * width;
        surface.width = width;
        surface.height = height;
        surface.depth_format = DepthFormat::z16;
        state.scissor = {0, 0, width, height};
        state.tier = Tier::balanced;
        state.dither = false;
    }
    void use_texture(TexelFormat format, BaseFormat base, int size, Filter filter, TexEnv env) {
        texels.resize(static_cast<std::size_t>(size * size) * 4);
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = static_cast<std::uint8_t>(i * 37 >> 3);
        const int bytes = format == TexelFormat::rgb565 ? 2 : format == TexelFormat::rgb888 ? 3 : 4;
        texture.level[0] = {texels.data(), static_cast<std::uint16_t>(size), static_cast<std::uint16_t>(size),
                            static_cast<std::uint32_t>(size * bytes)};
        texture.level_count = 1;
        texture.format = format;
        texture.base = base;
        texture.mag = texture.min = filter;
        state.unit[0].texture = &texture;
        state.unit[0].env = env;
    }
    void clear_depth() { depth.assign(depth.size(), 0xFFFF); }
};

FixedVertex vertex(double x, double y, double z, double w, double s, double t, double r, double g, double b,
                   double a = 1) {
    FixedVertex v{};
    v.x = static_cast<std::int32_t>(std::lround(x * 256));
    v.y = static_cast<std::int32_t>(std::lround(y * 256));
    v.z = static_cast<std::uint32_t>(z * depth_one);
    int e;
    const double m = std::frexp(1 / w, &e);
    v.w_mantissa = static_cast<std::uint32_t>(m * 4294967295.0);
    v.w_exponent = static_cast<std::int16_t>(e - 32);
    const double c[4] = {r, g, b, a};
    for (int i = 0; i < 4; ++i)
        v.color[i] = static_cast<std::uint32_t>(c[i] * color_one);
    v.fog_mantissa = static_cast<std::int32_t>(w * 268435456.0);
    v.fog_exponent = -28;
    v.tex[0].s = static_cast<std::int32_t>(s * (1 << 20));
    v.tex[0].t = static_cast<std::int32_t>(t * (1 << 20));
    v.tex[0].exponent = -20;
    v.tex[0].q_is_one = 1;
    return v;
}

void triangle(const DrawState& d, const Surface& s, const FixedVertex& a, const FixedVertex& b,
              const FixedVertex& c) {
    draw_triangle<FixedVertex>(d, s, a, b, c, c, signed_area(a.x, a.y, b.x, b.y, c.x, c.y));
}
void quad(const DrawState& d, const Surface& s, const FixedVertex* v) {
    triangle(d, s, v[0], v[1], v[2]);
    triangle(d, s, v[0], v[2], v[3]);
}

void full_screen(benchmark::State& run, Frame& f, const FixedVertex* v, int layers = 1) {
    const DrawState d = compile<FixedVertex>(f.state, f.surface);
    for (auto _ : run) {
        if (f.state.depth_test)
            f.clear_depth();
        for (int i = 0; i < layers; ++i)
            quad(d, f.surface, v + 4 * i);
        benchmark::ClobberMemory();
    }
    run.SetItemsProcessed(run.iterations() * layers * width * height);
}

void S2_flat(benchmark::State& run) {
    Frame f;
    const FixedVertex v[4] = {vertex(0, 0, .5, 4, 0, 0, .9, .5, .3), vertex(320, 0, .5, 4, 0, 0, .9, .5, .3),
                              vertex(320, 240, .5, 4, 0, 0, .9, .5, .3),
                              vertex(0, 240, .5, 4, 0, 0, .9, .5, .3)};
    full_screen(run, f, v);
}
BENCHMARK(S2_flat);

void S3_gouraud(benchmark::State& run) {
    Frame f;
    f.state.depth_test = true;
    f.state.dither = run.range(0) != 0;
    std::vector<FixedVertex> v;
    for (int i = 0; i < 4; ++i) {
        const double z = .9 - .2 * i, w = 8 - 2 * i;
        v.push_back(vertex(0, 0, z, w, 0, 0, 1, 0, 0));
        v.push_back(vertex(320, 0, z, w, 0, 0, 0, 1, 0));
        v.push_back(vertex(320, 240, z, w, 0, 0, 0, 0, 1));
        v.push_back(vertex(0, 240, z, w, 0, 0, 1, 1, 0));
    }
    full_screen(run, f, v.data(), 4);
}
BENCHMARK(S3_gouraud)->Arg(0)->Arg(1);

/// Draws tilted planes, also rolled ones, with texels of 565 or 888.
void plane(benchmark::State& run, bool rolled, Filter filter, TexelFormat format) {
    Frame f;
    f.use_texture(format, BaseFormat::rgb, 64, filter, TexEnv::replace);
    const double w[4] = {1.5, rolled ? 2.2 : 1.5, 4, rolled ? 2.9 : 4};
    const double x[4] = {0, 320, 320, 0}, y[4] = {0, 0, 240, 240};
    FixedVertex v[4];
    for (int i = 0; i < 4; ++i)
        v[i] = vertex(x[i], y[i], .5, w[i], (x[i] / 160 - 1) * w[i] / 2 + 2, (y[i] / 120 - 1) * w[i] / 2 + 2,
                      1, 1, 1);
    full_screen(run, f, v);
}
void S4_nearest_888(benchmark::State& run) {
    plane(run, false, Filter::nearest, TexelFormat::rgb888);
}
void S4_nearest_565(benchmark::State& run) {
    plane(run, false, Filter::nearest, TexelFormat::rgb565);
}
void S4r_nearest_888(benchmark::State& run) {
    plane(run, true, Filter::nearest, TexelFormat::rgb888);
}
void S4r_nearest_565(benchmark::State& run) {
    plane(run, true, Filter::nearest, TexelFormat::rgb565);
}
void S4b_linear_888(benchmark::State& run) {
    plane(run, false, Filter::linear, TexelFormat::rgb888);
}
BENCHMARK(S4_nearest_888);
BENCHMARK(S4_nearest_565);
BENCHMARK(S4r_nearest_888);
BENCHMARK(S4r_nearest_565);
BENCHMARK(S4b_linear_888);

void S7_sprites(benchmark::State& run) {
    Frame f;
    f.use_texture(TexelFormat::rgba8888, BaseFormat::rgba, 32, Filter::nearest, TexEnv::replace);
    f.state.blend = true;
    f.state.blend_rgb = f.state.blend_alpha = blend_over;
    const DrawState d = compile<FixedVertex>(f.state, f.surface);
    for (auto _ : run) {
        std::uint32_t s = 12345;
        for (int i = 0; i < 200; ++i) {
            s = s * 1664525 + 1013904223;
            const int x = static_cast<int>((s >> 8) % (width - 32));
            s = s * 1664525 + 1013904223;
            const int y = static_cast<int>((s >> 8) % (height - 32));
            const FixedVertex v[4] = {
                vertex(x, y, .5, 1, 0, 0, 1, 1, 1), vertex(x + 32, y, .5, 1, 1, 0, 1, 1, 1),
                vertex(x + 32, y + 32, .5, 1, 1, 1, 1, 1, 1), vertex(x, y + 32, .5, 1, 0, 1, 1, 1, 1)};
            quad(d, f.surface, v);
        }
    }
    run.SetItemsProcessed(run.iterations() * 204800);
}
BENCHMARK(S7_sprites);

/// Draws a grid of small triangles over a disc. It has half of S6's triangles, as many as culling leaves of a
/// torus.
void mesh(benchmark::State& run, Frame& f, int cells) {
    f.state.depth_test = true;
    const DrawState d = compile<FixedVertex>(f.state, f.surface);
    std::vector<FixedVertex> v;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const double x = 60 + 200. * i / cells + 3 * std::sin(j),
                         y = 20 + 200. * j / cells + 3 * std::cos(i * 1.3);
            const double shade = .5 + .5 * std::sin(i * .2) * std::cos(j * .15);
            v.push_back(vertex(x, y, .5 + .001 * i, 3 + .01 * i, .25 * i, .25 * j, .85 * shade, .55 * shade,
                               .25 * shade));
        }
    for (auto _ : run) {
        f.clear_depth();
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const FixedVertex* a = &v[static_cast<std::size_t>(j * (cells + 1) + i)];
                const FixedVertex* b = a + cells + 1;
                triangle(d, f.surface, a[0], a[1], b[0]);
                triangle(d, f.surface, a[1], b[1], b[0]);
            }
    }
    run.SetItemsProcessed(run.iterations() * cells * cells * 2);
}
void S6_mesh(benchmark::State& run) {
    Frame f;
    mesh(run, f, 50);
}
BENCHMARK(S6_mesh);
void S9_mesh(benchmark::State& run) {
    Frame f;
    f.use_texture(TexelFormat::rgb888, BaseFormat::rgb, 64, Filter::nearest, TexEnv::modulate);
    f.state.fog = true;
    f.state.fog_mode = FogMode::linear;
    f.state.fog_start = 0x40266666;
    f.state.fog_end = 0x40A66666;
    mesh(run, f, 19);
}
BENCHMARK(S9_mesh);

void S8_lines(benchmark::State& run) {
    Frame f;
    f.state.depth_test = true;
    const DrawState d = compile<FixedVertex>(f.state, f.surface);
    std::vector<FixedVertex> v;
    for (int j = 0; j <= 71; ++j)
        for (int i = 0; i <= 71; ++i)
            v.push_back(vertex(60 + 2.8 * i + 3 * std::sin(j), 20 + 2.8 * j + 3 * std::cos(i * 1.3), .5, 3, 0,
                               0, 1, .8, .2));
    for (auto _ : run) {
        f.clear_depth();
        for (std::size_t j = 0; j < 71; ++j)
            for (std::size_t i = 0; i < 71; ++i) {
                const FixedVertex* a = &v[j * 72 + i];
                draw_line<FixedVertex>(d, f.surface, a[0], a[1], a[1], 1);
                draw_line<FixedVertex>(d, f.surface, a[0], a[72], a[72], 1);
            }
    }
    run.SetItemsProcessed(run.iterations() * 71 * 71 * 2);
}
BENCHMARK(S8_lines);

} // namespace

BENCHMARK_MAIN();
