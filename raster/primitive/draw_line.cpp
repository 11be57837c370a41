#include "raster/primitive/draw_solid_line.hpp"

namespace spangle::raster {

template <>
void draw_line<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                            const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    draw_solid_line(state, target, a, b, provoking, width);
}

template <>
void draw_lines<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex* const* vertex,
                             int n, int step, const FixedVertex* painted, std::int32_t width) {
    if constexpr (has_paths)
        return draw_lines_by<HostLines>(state, target, vertex, n, step, painted, width);
    for (int i = 0; i + 1 < n; i += step)
        draw_line(state, target, *vertex[i], *vertex[i + 1], *vertex[i + 1], width);
}

DrawState::Area strip_area(const DrawState& state, std::int32_t width) {
    if (!has_paths || width != 1 || detail::has_observer(state.counters) ||
        state.variant[static_cast<unsigned>(Kind::flat)].walk == nullptr)
        return {};
    return state.paths;
}

/// Draws a strip line by line. Builds without room for the vertices of strips have no vectors either.
void draw_strip(const DrawState& state, const Surface& target, const LineEnd* ends, int n,
                const FixedVertex& painted) {
    if constexpr (has_paths) {
        LineBatch<LineLanes<1>> batch(state, target, 1);
        if constexpr (line_batch > Paths::size)
            for (; n > Paths::size + 1; ends += Paths::size, n -= Paths::size)
                batch.draw(ends, Paths::size + 1, painted);
        batch.draw(ends, n, painted);
    }
}

} // namespace spangle::raster
