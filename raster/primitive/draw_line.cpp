// Lines of width 1 as paths, where nothing is cut off: one loop draws all fragments. Others as rows.
#include "raster/primitive/line.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/span/path.hpp"

namespace spangle::raster {

namespace {

[[gnu::noinline]] void draw_rows(const DrawState& state, const Surface& target, const FixedVertex& a,
                                 const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    draw_line_of<Fixed>(state, target, a, b, provoking, width);
}

/// Somebody asks for rows.
bool observed([[maybe_unused]] const Counters* counters) {
#ifndef SPANGLE_FIRMWARE
    return counters != nullptr && counters->observer != nullptr;
#else
    return false;
#endif
}

/// As far as a path of this state may show.
SPANGLE_INLINE bool same_color(const FixedVertex& a, const FixedVertex& b) {
    return ((a.color[0] ^ b.color[0]) | (a.color[1] ^ b.color[1]) | (a.color[2] ^ b.color[2])) == 0;
}

/// One colour leaves one plane, and that has one direction: what Setup finds, in a few steps.
SPANGLE_INLINE void set_up(Span<Fixed>& span, const FixedVertex& a, const FixedVertex& b,
                           const FixedVertex& painted, const detail::LineInterval& interval) {
    span.kind = Kind::flat;
    span.flat_word = word565(painted.color);
    span.anchor_x = interval.begin >> subpixel_bits;
    span.anchor_y = 0;
    if (!span.state->needs.z)
        return;
    const PerPixel per_pixel(interval.begin, interval.end);
    const std::uint32_t from = depth_code(a.z, 16), to = depth_code(b.z, 16);
    const auto difference = static_cast<std::int32_t>(to >> 1) - static_cast<std::int32_t>(from >> 1);
    const auto part = [&](std::int32_t coefficient) {
        return scaled_word(numeric::mul_s32(difference, coefficient), per_pixel.exponent - 1);
    };
    span.z = {from + (1u << 15) + part(per_pixel.to_center(interval.begin)), part(per_pixel.coefficient), 0};
}

/// Widens the touched columns by those of the path, if they are not all among them: rows between the ends',
/// and one more pixel, hold it.
SPANGLE_INLINE void touch_path(const Surface& target, const Path& path, const Position& a,
                               const Position& b) {
    const auto low = [](std::int32_t v, std::int32_t w) {
        return ((v < w ? v : w) - subpixel_one / 2 - 1) >> subpixel_bits;
    };
    const auto high = [](std::int32_t v, std::int32_t w) {
        return ((v < w ? w : v) + subpixel_one / 2) >> subpixel_bits;
    };
    const std::int32_t left = path.along_x ? path.x : low(a.x, b.x),
                       right = path.along_x ? path.x + path.count : high(a.x, b.x) + 1,
                       bottom = path.along_x ? low(a.y, b.y) : path.y,
                       top = path.along_x ? high(a.y, b.y) + 1 : path.y + path.count;
    const RowSpan* row = target.touched + std::ptrdiff_t{bottom} * target.touched_step;
    for (std::int32_t y = bottom; y < top; ++y, row += target.touched_step)
        if (left < row->begin || right > row->end)
            return path.each([&](std::int32_t px, std::int32_t py) { touch(target, py, px, px + 1); });
}

} // namespace

template <>
void draw_line<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                            const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    if (width != 1 || !state.paths.holds(a.x, a.y) || !state.paths.holds(b.x, b.y) ||
        observed(state.counters)) [[unlikely]]
        return draw_rows(state, target, a, b, provoking, width);
    const DiamondWalk walk(a.x, a.y, b.x, b.y, 0);
    if (walk.count == 0)
        return;
    const detail::LineInterval interval(walk, walk.along_x ? a.x : a.y, walk.along_x ? b.x : b.y);
    Span<Fixed> span;
    span.state = &state;
    span.target = &target;
    const bool one_color = state.fragment.flat || same_color(a, b);
    if (one_color && state.variant[static_cast<unsigned>(Kind::flat)].walk != nullptr)
        set_up(span, a, b, state.fragment.flat ? provoking : a, interval);
    else
        Setup<Fixed>(span, a, b, provoking, true, interval.begin, interval.end);
    const AnyFunction draw = state.variant[static_cast<unsigned>(span.kind)].walk;
    if (draw == nullptr)
        return draw_rows(state, target, a, b, provoking, width);
    const Path path = walk.path();
    if (Counters* const counters = state.counters; counters != nullptr) {
        ++counters->triangles;
        counters->fragments += static_cast<std::uint32_t>(path.count);
    }
    if (target.touched != nullptr)
        touch_path(target, path, {a.x, a.y}, {b.x, b.y});
    reinterpret_cast<PathFunction<Fixed>>(draw)(span, path);
}

} // namespace spangle::raster
