#include "tests/gl/vertex/window_recorder.hpp"

#include <algorithm>

#include "raster/primitive/draw.hpp"

using spangle::raster::DrawState;
using spangle::raster::FixedVertex;
using spangle::raster::Surface;

// The linker's option --wrap makes GL call "__wrap_f" in place of f; "__real_f" is the rasterizer's f.
void real_point(const DrawState&, const Surface&, const FixedVertex&,
                std::int32_t) __asm__("__real_" DRAW_POINT);
void real_line(const DrawState&, const Surface&, const FixedVertex&, const FixedVertex&, const FixedVertex&,
               std::int32_t) __asm__("__real_" DRAW_LINE);
void real_lines(const DrawState&, const Surface&, const FixedVertex* const*, int, int, const FixedVertex*,
                std::int32_t) __asm__("__real_" DRAW_LINES);
void real_triangle(const DrawState&, const Surface&, const FixedVertex&, const FixedVertex&,
                   const FixedVertex&, const FixedVertex&, std::int64_t) __asm__("__real_" DRAW_TRIANGLE);
void wrap_point(const DrawState&, const Surface&, const FixedVertex&,
                std::int32_t) __asm__("__wrap_" DRAW_POINT);
void wrap_line(const DrawState&, const Surface&, const FixedVertex&, const FixedVertex&, const FixedVertex&,
               std::int32_t) __asm__("__wrap_" DRAW_LINE);
void wrap_lines(const DrawState&, const Surface&, const FixedVertex* const*, int, int, const FixedVertex*,
                std::int32_t) __asm__("__wrap_" DRAW_LINES);
void wrap_triangle(const DrawState&, const Surface&, const FixedVertex&, const FixedVertex&,
                   const FixedVertex&, const FixedVertex&, std::int64_t) __asm__("__wrap_" DRAW_TRIANGLE);

namespace {
spangle::test::WindowRecorder* active = nullptr;
} // namespace

void wrap_point(const DrawState& state, const Surface& target, const FixedVertex& v, std::int32_t size) {
    if (active == nullptr)
        return real_point(state, target, v, size);
    active->primitives.push_back({1, {v, {}, {}}, v, size, 0});
}

void wrap_line(const DrawState& state, const Surface& target, const FixedVertex& a, const FixedVertex& b,
               const FixedVertex& provoking, std::int32_t width) {
    if (active == nullptr)
        return real_line(state, target, a, b, provoking, width);
    active->primitives.push_back({2, {a, b, {}}, provoking, width, 0});
}

void wrap_lines(const DrawState& state, const Surface& target, const FixedVertex* const* vertex, int n,
                int step, const FixedVertex* painted, std::int32_t width) {
    if (active == nullptr)
        return real_lines(state, target, vertex, n, step, painted, width);
    const auto at = [&](int i) {
        FixedVertex v = *vertex[i];
        if (painted != nullptr)
            std::copy_n(painted->color, 4, v.color);
        return v;
    };
    for (int i = 0; i + 1 < n; i += step)
        active->primitives.push_back({2, {at(i), at(i + 1), {}}, at(i + 1), width, 0});
}

void wrap_triangle(const DrawState& state, const Surface& target, const FixedVertex& a, const FixedVertex& b,
                   const FixedVertex& c, const FixedVertex& provoking, std::int64_t area2) {
    if (active == nullptr)
        return real_triangle(state, target, a, b, c, provoking, area2);
    active->primitives.push_back({3, {a, b, c}, provoking, 0, area2});
}

namespace spangle::test {

WindowRecorder::WindowRecorder() {
    active = this;
}
WindowRecorder::~WindowRecorder() {
    active = nullptr;
}

} // namespace spangle::test
