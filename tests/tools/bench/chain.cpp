// Draws triangles in the state of every fused span: by that span, with one lane of it, and in the chain.
// Under callgrind with --dump-before=mark, the dump between two marks has the cost of one of them.
//
// usage: chain    prints the name of each state
#include <cstdio>
#include <string>

#include "tests/unit/span/state_of_key.hpp"

/// Callgrind writes a dump before each call of this function.
extern "C" [[gnu::noinline]] void mark() {
    asm volatile("");
}

namespace {

using namespace spangle::raster;
using namespace spangle::raster::test;
using spangle::DepthFormat;

constexpr int width = 160, height = 120, triangles = 40;

std::string name_of(const Key& key) {
    constexpr const char* numbers[] = {"raw", "balanced", "exact", "reference"};
    constexpr const char* kinds[] = {"flat", "affine", "textured", "full"};
    constexpr const char* texels[] = {"a8", "l8", "i8", "la88", "rgb565", "rgb888", "rgba8888"};
    std::string name =
        std::string(numbers[static_cast<int>(key.number)]) + " " + kinds[static_cast<int>(key.kind)];
    if (key.unit[0].on) {
        name += std::string(" ") + texels[static_cast<int>(key.unit[0].texels)];
        name += key.unit[0].filter == Filter::nearest ? " nearest" : " linear";
        name += key.unit[0].env == TexEnv::replace ? " replace" : " modulate";
    }
    if (key.fog)
        name += " fog";
    if (key.depth != Compare::always)
        name += key.depth == Compare::less ? " less" : " lequal";
    name += std::string(key.blend ? " blend" : "") + (key.dither ? " dither" : "") +
            (key.cubic ? " cubic" : "") + (key.coarse ? " coarse" : "");
    return name;
}

/// Draws nothing, so that set-up can be counted alone.
void draw_nothing(Span<Fixed>&, const Row*, const Row*) {}

/// Draws all triangles of a kind between two marks.
void draw_all(const DrawState& state, Kind kind, const Surface& surface) {
    RandomVertices source(7);
    mark();
    for (int i = 0; i < triangles; ++i)
        draw(state, surface, random_triangle(source, width, height, kind));
    mark();
}

} // namespace

int main() {
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& span = fused_span(i);
        const StateOfKey of(span.key, width, height);
        Canvas canvas(width, height, span.key.format, DepthFormat::z16);
        const DrawState fused = compile<FixedVertex>(of.state, canvas.surface);
        DrawState alone = fused, narrow = fused;
        for (int kind = 0; kind < kind_count; ++kind) {
            alone.variant[kind].run = reinterpret_cast<AnyFunction>(&draw_nothing);
            narrow.variant[kind].run = reinterpret_cast<AnyFunction>(span.narrow);
        }
        const DrawState states[] = {alone, fused, narrow, in_chain(fused, span.key)};
        for (const DrawState& state : states) {
            std::fill(canvas.depth.begin(), canvas.depth.end(), std::uint8_t{0xFF});
            draw_all(state, span.key.kind, canvas.surface);
        }
        std::puts(name_of(span.key).c_str());
    }
    return 0;
}
