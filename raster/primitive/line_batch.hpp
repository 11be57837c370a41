// Draws lines of width 1 that are not clipped as paths, by one loop over all their fragments. Other lines are
// drawn as rows.
#pragma once

#include <type_traits>

#include "raster/primitive/line.hpp"
#include "raster/primitive/scalar_lines.hpp"
#include "raster/primitive/vector_lines.hpp"

namespace spangle::raster {

namespace detail {

/// Whether the draw has an observer, which is told of rows and not of paths.
inline bool has_observer([[maybe_unused]] const Counters* counters) {
#ifndef SPANGLE_FIRMWARE
    return counters != nullptr && counters->observer != nullptr;
#else
    return false;
#endif
}

/// Whether two vertices have the same colour, in the components that a path may show.
SPANGLE_INLINE bool same_color(const FixedVertex& a, const FixedVertex& b) {
    return ((a.color[0] ^ b.color[0]) | (a.color[1] ^ b.color[1]) | (a.color[2] ^ b.color[2])) == 0;
}

/// Widens the touched columns by the columns of a line, if they do not contain them already. The line lies in
/// the rows between its ends, widened by half a pixel on both sides.
inline void touch_line(const Surface& target, const Position& a, const Position& b) {
    const auto low = [](std::int32_t v, std::int32_t w) {
        return ((v < w ? v : w) - subpixel_one / 2 - 1) >> subpixel_bits;
    };
    const auto high = [](std::int32_t v, std::int32_t w) {
        return ((v < w ? w : v) + subpixel_one / 2) >> subpixel_bits;
    };
    const std::int32_t left = low(a.x, b.x), right = high(a.x, b.x) + 1, bottom = low(a.y, b.y),
                       top = high(a.y, b.y);
    const RowSpan* row = target.touched + std::ptrdiff_t{bottom} * target.touched_step;
    for (std::int32_t y = bottom; y <= top; ++y, row += target.touched_step)
        if (left < row->begin || right > row->end) {
            for (DiamondWalk walk(a.x, a.y, b.x, b.y, 0); walk.count > 0; walk.step()) {
                const std::int32_t x = walk.along_x ? walk.major : walk.minor;
                mark_damage(target, walk.along_x ? walk.minor : walk.major, x, x + 1);
            }
            return;
        }
}

} // namespace detail

/// Collects lines for one loop, as many as a set of paths holds. L is the type of lanes that sets lines up,
/// side by side or one at a time.
template <class L> class LineBatch {
  public:
    LineBatch(const DrawState& state, const Surface& target, std::int32_t width)
        : state_(state), target_(target), width_(width),
          area_(width == 1 && !detail::has_observer(state.counters) ? state.paths : DrawState::Area{}) {}

    /// Draws lines from vertices i to i + 1, i = 0, step, and so on. They have the colour of
    /// `flat_shaded_vertex`; where it is null, each has the colour of its second vertex. The only line of a
    /// batch may have another provoking vertex.
    void draw(const FixedVertex* const* v, int n, int step, const FixedVertex* flat_shaded_vertex,
              const FixedVertex* provoking) {
        vertex_ = v;
        vertex_step_ = step;
        provoking_ = provoking;
        line_count_ = step == 1 ? n - 1 : n / 2;
        const bool inside = set_up_.take(v, n, step, area_);
        if (!inside || walk_of(Kind::flat) == nullptr ||
            (flat_shaded_vertex == nullptr && !have_one_color_each())) {
            if (line_count_ != 1)
                return draw_one_by_one(v, n, step, flat_shaded_vertex);
            if (!inside)
                return rows();
            return walk(set_up_colored());
        }
        if (flat_shaded_vertex != nullptr)
            set_flat_words(flat_word(state_, flat_shaded_vertex->color));
        else
            set_flat_words();
        set_up(state_.needs.z);
        walk(Kind::flat);
    }
    /// Draws a strip, as draw_strip() does.
    void draw(const LineEnd* ends, int n, const FixedVertex& flat_shaded_vertex) {
        line_count_ = n - 1;
        set_up_.take(ends, line_count_);
        set_flat_words(flat_word(state_, flat_shaded_vertex.color));
        set_up(state_.needs.z);
        walk(Kind::flat);
    }

  private:
    AnyFunction walk_of(Kind kind) const { return state_.variant[static_cast<unsigned>(kind)].walk; }

    const FixedVertex& first(int i) const { return *vertex_[i * vertex_step_]; }
    const FixedVertex& second(int i) const { return *vertex_[i * vertex_step_ + 1]; }

    bool have_one_color_each() const {
        bool one = true;
        for (int i = 0; i < line_count_ && !state_.fragment.flat; ++i)
            one = one & detail::same_color(first(i), second(i));
        return one;
    }
    SPANGLE_INLINE void set_flat_words(std::uint32_t word) {
        paths_.one_color = true;
#pragma GCC unroll 4
        for (int i = 0; i < line_count_; i += L::count)
            L::store(&paths_.at(Paths::flat, i), typename L::Int{} + static_cast<std::int32_t>(word));
    }
    void set_flat_words() {
        paths_.one_color = false;
        for (int i = 0; i < line_count_; ++i)
            paths_.at(Paths::flat, i) = static_cast<std::int32_t>(
                flat_word(state_, (line_count_ == 1 ? provoking() : second(i)).color));
    }

    [[gnu::noinline]] void draw_one_by_one(const FixedVertex* const* v, int n, int step,
                                           const FixedVertex* flat_shaded_vertex) {
        for (int i = 0; i + 1 < n; i += step)
            draw(v + i, 2, 1, flat_shaded_vertex, nullptr);
    }

    /// Sets up all lines. Each has one colour, so only depth has a plane, which varies along one axis.
    SPANGLE_INLINE PathInterval<std::int32_t> set_up(bool depth) {
        return set_up_.set_up(paths_, PathPixels::per_row(target_, state_.fragment.dither), depth);
    }

    const FixedVertex& provoking() const {
        return provoking_ != nullptr ? *provoking_ : *vertex_[1];
    }

    /// Sets up the only line of the batch, whose colour varies.
    [[gnu::noinline]] Kind set_up_colored() {
        const PathInterval<std::int32_t> at = set_up(false);
        Span<Fixed> span;
        span.state = &state_;
        span.target = &target_;
        const FixedVertex &a = *vertex_[0], &b = *vertex_[1];
        Setup<Fixed>(span, a, b, provoking(), true, at.begin, at.end,
                     Diamond<LineLanes<1>>::is_along_x(a.x, a.y, b.x, b.y));
        if (state_.needs.z) {
            paths_.at(Paths::depth, 0) = static_cast<std::int32_t>(span.z.at(at.from_begin, 0));
            paths_.at(Paths::depth_step, 0) = static_cast<std::int32_t>(span.z.dx);
        }
        if (span.kind == Kind::flat)
            set_flat_words(span.flat_word);
        else if (state_.needs.rgb)
            for (int c = 0; c < 3; ++c) {
                paths_.color[c] = span.color_value[c].at(at.from_begin, 0);
                paths_.color_step[c] = span.color_value[c].dx;
            }
        return span.kind;
    }

    /// Draws the paths that were set up. Where the kind of the only line draws no paths, it is drawn as rows.
    void walk(Kind kind) {
        const AnyFunction draw = walk_of(kind);
        if (draw == nullptr)
            return rows();
        if (target_.touched != nullptr)
            for (int i = 0; i < line_count_; ++i)
                detail::touch_line(target_, set_up_.end(i, 0), set_up_.end(i, 1));
        if (Counters* const counters = state_.counters; counters != nullptr)
            for (int i = 0; i < line_count_; ++i)
                if (paths_.at(Paths::count, i) > 0) { // NOLINT(clang-analyzer-*): set_up() stored each
                    ++counters->triangles;
                    counters->fragments += static_cast<std::uint32_t>(paths_.at(Paths::count, i));
                }
        reinterpret_cast<PathFunction>(draw)(state_, target_, paths_, line_count_);
    }

    /// Draws the only line of the batch as rows.
    [[gnu::noinline]] void rows() const {
        draw_line_of<Fixed>(state_, target_, *vertex_[0], *vertex_[1], provoking(), width_);
    }

    const DrawState& state_;
    const Surface& target_;
    const std::int32_t width_;
    const DrawState::Area area_;
    const FixedVertex* const* vertex_ = nullptr;
    const FixedVertex* provoking_ = nullptr; ///< provoking vertex of the only line, or null
    int vertex_step_ = 1, line_count_ = 0;
    std::conditional_t<L::count == 1, ScalarLines, VectorLines<L>> set_up_;
    Paths paths_;
};

/// Does what draw_lines() and draw_line() do, in batches of this kind.
template <class L>
void draw_lines_by(const DrawState& state, const Surface& target, const FixedVertex* const* vertex, int n,
                   int step, const FixedVertex* flat_shaded_vertex, std::int32_t width) {
    LineBatch<L> batch(state, target, width);
    const int most = step == 1 ? Paths::size + 1 : 2 * Paths::size;
    while (n > 1) {
        const int now = n < most ? n : most, left = step == 1 ? 1 : 0;
        batch.draw(vertex, now, step, flat_shaded_vertex, nullptr);
        vertex += now - left;
        n -= now - left;
    }
}
template <class L>
void draw_line_by(const DrawState& state, const Surface& target, const FixedVertex& a, const FixedVertex& b,
                  const FixedVertex& provoking, std::int32_t width) {
    const FixedVertex* const ends[2] = {&a, &b};
    LineBatch<L>(state, target, width).draw(ends, 2, 1, nullptr, &provoking);
}

} // namespace spangle::raster
