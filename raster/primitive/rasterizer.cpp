#include <spangle/raster/rasterizer.hpp>

#include <new>
#include <type_traits>

#include "raster/numeric/bits.hpp"
#include "raster/primitive/draw.hpp"
#include "raster/primitive/edge.hpp"

namespace spangle::raster {

namespace {

constexpr std::int32_t largest_width = 64;

std::int32_t whole_width(std::int32_t v) {
    return numeric::clamp<std::int32_t>(v, 1, largest_width);
}

bool in_range(std::int32_t coordinate) {
    return coordinate > -guard_band && coordinate < guard_band;
}

/// Whether a vertex is within the ranges of vertex.hpp, which set-up relies on.
bool valid(const FixedVertex& v) {
    bool good = in_range(v.x) && in_range(v.y) && v.z <= depth_one && v.w_mantissa >> 31 != 0;
    for (const std::uint32_t c : v.color)
        good = good && c <= color_one;
    for (const std::uint32_t c : v.secondary)
        good = good && c <= color_one;
    return good;
}

/// The part of a rectangle inside the surface.
Rect cut(const Rect& r, const Surface& surface) {
    const auto inside = [](std::int64_t v, std::int32_t low, std::int32_t high) {
        return static_cast<std::int32_t>(numeric::clamp<std::int64_t>(v, low, high));
    };
    const Rect all = surface.area();
    const std::int32_t top = all.y + all.h;
    const std::int32_t x0 = inside(r.x, 0, all.w), x1 = inside(std::int64_t{r.x} + r.w, 0, all.w);
    const std::int32_t y0 = inside(r.y, all.y, top), y1 = inside(std::int64_t{r.y} + r.h, all.y, top);
    return {x0, y0, x1 - x0, y1 - y0};
}

const DrawState& compiled(const std::byte* memory) {
    return *std::launder(reinterpret_cast<const DrawState*>(memory));
}

} // namespace

Rasterizer::Rasterizer(const FragmentState& state, const Surface& surface) : surface_(surface) {
    static_assert(sizeof state_ >= sizeof(DrawState) && alignof(DrawState) <= 8);
    static_assert(std::is_trivially_copyable_v<DrawState>);
    FragmentState bounded = state;
    bounded.scissor = surface.color == nullptr ? Rect{} : cut(state.scissor, surface);
    // A Rasterizer keeps no counters, coverage, offsets or samples, so the modes that need them are off.
    bounded.count = bounded.coverage = bounded.depth_offset = false;
    bounded.alpha_to_coverage = bounded.alpha_to_one = bounded.sample_coverage = false;
    bounded.polygon_stipple = nullptr;
    new (state_) DrawState(compile<FixedVertex>(bounded, surface));
}

void Rasterizer::triangle(const FixedVertex& a, const FixedVertex& b, const FixedVertex& c,
                          const FixedVertex& provoking) const {
    if (!valid(a) || !valid(b) || !valid(c) || !valid(provoking))
        return;
    const std::int64_t area2 = signed_area(a.x, a.y, b.x, b.y, c.x, c.y);
    if (area2 != 0)
        draw_triangle(compiled(state_), surface_, a, b, c, provoking, area2);
}

void Rasterizer::line(const FixedVertex& a, const FixedVertex& b, std::int32_t width) const {
    if (valid(a) && valid(b))
        draw_line(compiled(state_), surface_, a, b, b, whole_width(width));
}

void Rasterizer::point(const FixedVertex& v, std::int32_t size) const {
    if (valid(v))
        draw_point(compiled(state_), surface_, v, whole_width(size));
}

} // namespace spangle::raster
