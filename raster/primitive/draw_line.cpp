// Lines of width 1 as paths, where nothing is cut off: one loop draws all fragments. Others as rows.
#include <type_traits>

#include "raster/primitive/line.hpp"
#include "raster/primitive/setup_math.hpp"
#include "raster/span/path.hpp"

namespace spangle::raster {

namespace {

/// Somebody asks for rows.
bool observed([[maybe_unused]] const Counters* counters) {
#ifndef SPANGLE_FIRMWARE
    return counters != nullptr && counters->observer != nullptr;
#else
    return false;
#endif
}

/// As far as a path may show.
SPANGLE_INLINE bool same_color(const FixedVertex& a, const FixedVertex& b) {
    return ((a.color[0] ^ b.color[0]) | (a.color[1] ^ b.color[1]) | (a.color[2] ^ b.color[2])) == 0;
}

/// Widens the touched columns by those of a line, if they are not all among them: rows between the ends', and
/// one more pixel, hold it.
void touch_line(const Surface& target, const FixedVertex& a, const FixedVertex& b) {
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
                touch(target, walk.along_x ? walk.minor : walk.major, x, x + 1);
            }
            return;
        }
}

/// Ends of lines, as many as a set of paths holds: from vertex 0 to 1, from `step` to step + 1, ...
template <class L> class LineEnds {
  public:
    /// f(Diamond) of line i and those beside it.
    template <class F> SPANGLE_INLINE auto with_line(int i, const F& f) const {
        return f(Diamond<L>(L::load(x_ + i), L::load(y_ + i), L::load(x_ + i + b_), L::load(y_ + i + b_), 0));
    }
    SPANGLE_INLINE std::uint32_t depth(int i, int end) const { return depth_[i + end * b_]; }

    /// True: all lie in the area.
    SPANGLE_INLINE bool take(const FixedVertex* const* vertex, int n, int step, const DrawState::Area& area) {
        bool inside = true;
        b_ = step == 1 ? 1 : room;
        for (int i = 0; i < n; ++i) {
            const FixedVertex& v = *vertex[i];
            const int at = step == 1 ? i : (i >> 1) + (i & 1) * b_;
            inside = inside & area.holds(v.x, v.y);
            x_[at] = v.x;
            y_[at] = v.y;
            depth_[at] = depth_code(v.z, 16);
        }
        for (int k = 0, count = step == 1 ? n - 1 : n / 2; k < L::count - 1; ++k) { // lanes without a line
            if (step != 1)
                x_[count + k] = y_[count + k] = 0;
            x_[count + b_ + k] = y_[count + b_ + k] = 0;
        }
        return inside;
    }

  private:
    /// First ends, and from b_ on second ones. The last lines may share a vector with lanes that have none.
    static constexpr int room = Paths::size + L::count - 1;
    std::int32_t x_[2 * room], y_[2 * room];
    std::uint32_t depth_[2 * room];
    int b_ = 1;
};

/// One by one they are best left where they are.
template <> class LineEnds<LineLanes<1>> {
  public:
    /// f has a copy for each of the four directions, in which nothing is selected.
    template <class F> SPANGLE_INLINE auto with_line(int i, const F& f) const {
        const std::int32_t ax = vertex(i, 0).x, ay = vertex(i, 0).y, bx = vertex(i, 1).x, by = vertex(i, 1).y;
        const auto directed = [&](auto along_x, auto ascends, auto... ends) __attribute__((always_inline)) {
            return f(Diamond<LineLanes<1>, decltype(along_x), decltype(ascends)>(along_x, ascends, ends...));
        };
        constexpr std::true_type yes;
        constexpr std::false_type no;
        if (Diamond<LineLanes<1>>::is_along_x(ax, ay, bx, by))
            return ax <= bx ? directed(yes, yes, ax, ay, bx, by) : directed(yes, no, ax, ay, bx, by);
        return ay <= by ? directed(no, yes, ay, ax, by, bx) : directed(no, no, ay, ax, by, bx);
    }
    SPANGLE_INLINE std::uint32_t depth(int i, int end) const { return depth_code(vertex(i, end).z, 16); }

    SPANGLE_INLINE bool take(const FixedVertex* const* vertex, int n, int step, const DrawState::Area& area) {
        vertex_ = vertex;
        step_ = step;
        for (int i = 0; i < n; ++i)
            if (!area.holds(vertex[i]->x, vertex[i]->y))
                return false;
        return true;
    }

  private:
    SPANGLE_INLINE const FixedVertex& vertex(int i, int end) const { return *vertex_[i * step_ + end]; }
    const FixedVertex* const* vertex_ = nullptr;
    int step_ = 1;
};

/// Lines on their way to one loop: as many as a set of paths holds.
class LineBatch {
  public:
    LineBatch(const DrawState& state, const Surface& target, std::int32_t width)
        : state_(state), target_(target), width_(width),
          area_(width == 1 && !observed(state.counters) ? state.paths : DrawState::Area{}),
          row_(target.color_stride / 2) {}

    /// From vertices i to i + 1, i = 0, step, ... Their colours are those of `painted`, or where that is null
    /// of the latter when state.flat. The only line may have another provoking vertex.
    void draw(const FixedVertex* const* v, int n, int step, const FixedVertex* painted,
              const FixedVertex* provoking) {
        vertex_ = v;
        step_ = step;
        provoking_ = provoking;
        count_ = step == 1 ? n - 1 : n / 2;
        const bool inside = ends_.take(v, n, step, area_);
        if (!inside || walk_of(Kind::flat) == nullptr || (painted == nullptr && !one_color_each())) {
            if (count_ != 1)
                return one_by_one(v, n, step, painted);
            if (!inside)
                return rows();
            return walk(set_up_colored(trace(0)));
        }
        if (painted != nullptr)
            paint(flat_word(state_, painted->color));
        else
            paint();
        set_up();
        walk(Kind::flat);
    }

  private:
    using L = HostLines;
    /// Along the major axis: of attributes, and from the pixel of `begin` to the first fragment.
    struct Interval {
        L::Int begin, end, from_begin;
    };

    AnyFunction walk_of(Kind kind) const { return state_.variant[static_cast<unsigned>(kind)].walk; }

    const FixedVertex& first(int i) const { return *vertex_[i * step_]; }
    const FixedVertex& second(int i) const { return *vertex_[i * step_ + 1]; }

    bool one_color_each() const {
        bool one = true;
        for (int i = 0; i < count_ && !state_.fragment.flat; ++i)
            one = one & same_color(first(i), second(i));
        return one;
    }
    SPANGLE_INLINE void paint(std::uint32_t word) {
        for (int i = 0; i < count_; ++i)
            paths_.word[i] = word;
    }
    void paint() {
        for (int i = 0; i < count_; ++i)
            paths_.word[i] = flat_word(state_, (count_ == 1 ? provoking() : second(i)).color);
    }

    [[gnu::noinline]] void one_by_one(const FixedVertex* const* v, int n, int step,
                                      const FixedVertex* painted) {
        for (int i = 0; i + 1 < n; i += step)
            draw(v + i, 2, 1, painted, nullptr);
    }

    /// The fragments of line i and those beside it.
    SPANGLE_INLINE Interval trace(int i) {
        return ends_.with_line(
            i, [&](const auto& line) __attribute__((always_inline)) {
                L::store(paths_.count.at + i, line.count);
                if (L::any(L::less(L::Int{}, line.count)))
                    return follow(line, i);
                return Interval{L::Int{}, L::Int{}, L::Int{}};
            });
    }

    /// Where they lie; and where attributes start from. These run from one end of the line to the other;
    /// where the centre of the first or last fragment lies beyond the end, the end is moved there
    /// (LineInterval).
    template <class Line> SPANGLE_INLINE Interval follow(const Line& line, int i) {
        using Int = L::Int;
        Int remainder;
        const Int minor = line.first(remainder), denominator = line.length() * subpixel_one;
        const auto falls = L::less(line.rise, Int{});
        const Int row = Int{} + row_, one = Int{} + 1;
        const Int along = L::select(line.along_x, one, row), across = L::select(line.along_x, row, one);
        const Int x = L::select(line.along_x, line.major, minor),
                  y = L::select(line.along_x, minor, line.major);
        L::store(paths_.first.at + i, y * row + x);
        L::store(paths_.along.at + i, along);
        L::store(paths_.aside.at + i, L::select(falls, Int(-across), across));
        L::store(paths_.rest.at + i, L::select(falls, Int(-1 - remainder), Int(remainder - denominator)));
        L::store(paths_.rise.at + i, L::select(falls, Int(-line.rise), line.rise) * subpixel_one);
        L::store(paths_.denominator.at + i, denominator);
        const Int first = line.center(line.major), last = line.center(line.major + line.count - 1);
        const Int low = L::select(L::less(first, line.low), first, line.low),
                  high = L::select(L::less(line.high, last), last, line.high);
        const Int begin = L::select(line.ascends, low, high);
        return {begin, L::select(line.ascends, high, low), line.major - (begin >> subpixel_bits)};
    }

    /// One colour leaves one plane, and that has one direction: what Setup finds, in a few steps.
    SPANGLE_INLINE void set_up() {
        if constexpr (L::count > 1)
            set_up_together();
        else
            for (int i = 0; i < count_; ++i) {
                const Interval at = trace(i);
                const std::int32_t begin = L::first(at.begin), end = L::first(at.end);
                if (state_.needs.z && paths_.count.at[i] > 0)
                    set_up_depth(i, PerPixel(begin, end), begin, L::first(at.from_begin));
            }
    }
    void set_up_together() {
        Paths::Word begin, end, from_begin;
        for (int i = 0; i < count_; i += L::count) {
            const Interval at = trace(i);
            L::store(begin.at + i, at.begin);
            L::store(end.at + i, at.end);
            L::store(from_begin.at + i, at.from_begin);
        }
        if (!state_.needs.z)
            return;
        numeric::Reciprocals<Paths::size> of_length;
        for (int i = 0; i < count_; ++i) {
            const std::uint32_t length = numeric::abs_u32(end.at[i] - begin.at[i]);
            of_length.set(i, length << numeric::clz32(length | 1));
        }
        of_length.finish();
        for (int i = 0; i < count_; ++i) { // lines without fragments, too
            const std::int32_t along = end.at[i] - begin.at[i];
            const int zeros = numeric::clz32(numeric::abs_u32(along) | 1);
            set_up_depth(i, PerPixel(of_length.at(i), zeros, along < 0), begin.at[i], from_begin.at[i]);
        }
    }

    SPANGLE_INLINE void set_up_depth(int i, const PerPixel& per_pixel, std::int32_t begin,
                                     std::int32_t from_begin) {
        const std::uint32_t from = ends_.depth(i, 0);
        const auto difference =
            static_cast<std::int32_t>(ends_.depth(i, 1) >> 1) - static_cast<std::int32_t>(from >> 1);
        const auto part = [&](std::int32_t coefficient) {
            return scaled_word(numeric::mul_s32(difference, coefficient), per_pixel.exponent - 1);
        };
        const std::uint32_t step = part(per_pixel.coefficient);
        paths_.z.step[i] = step;
        paths_.z.value[i] = from + (1u << 15) + part(per_pixel.to_center(begin)) +
                            static_cast<std::uint32_t>(from_begin) * step;
    }

    const FixedVertex& provoking() const { return provoking_ != nullptr ? *provoking_ : *vertex_[1]; }

    /// The only line, of several colours.
    [[gnu::noinline]] Kind set_up_colored(const Interval& at) {
        Span<Fixed> span;
        span.state = &state_;
        span.target = &target_;
        Setup<Fixed>(span, *vertex_[0], *vertex_[1], provoking(), true, L::first(at.begin), L::first(at.end));
        const auto ramp = [&](const Span<Fixed>::Affine& plane, Paths::Ramp& to) {
            to.value[0] = plane.at(L::first(at.from_begin), 0);
            to.step[0] = plane.dx;
        };
        if (state_.needs.z)
            ramp(span.z, paths_.z);
        if (span.kind == Kind::flat)
            paths_.word[0] = span.flat_word;
        else if (state_.needs.rgb)
            for (int c = 0; c < 3; ++c)
                ramp(span.color_value[c], paths_.color[c]);
        return span.kind;
    }

    /// Draws what was set up.
    void walk(Kind kind) {
        const AnyFunction draw = walk_of(kind);
        if (draw == nullptr)
            return rows();
        if (target_.touched != nullptr)
            for (int i = 0; i < count_; ++i)
                touch_line(target_, first(i), second(i));
        if (Counters* const counters = state_.counters; counters != nullptr)
            for (int i = 0; i < count_; ++i)
                if (paths_.count.at[i] > 0) {
                    ++counters->triangles;
                    counters->fragments += static_cast<std::uint32_t>(paths_.count.at[i]);
                }
        reinterpret_cast<PathFunction>(draw)(state_, target_, paths_, count_);
    }

    /// The only line.
    [[gnu::noinline]] void rows() const {
        draw_line_of<Fixed>(state_, target_, *vertex_[0], *vertex_[1], provoking(), width_);
    }

    const DrawState& state_;
    const Surface& target_;
    const std::int32_t width_;
    const DrawState::Area area_;
    const std::int32_t row_; ///< pixels from row to row, of 16 bits
    const FixedVertex* const* vertex_ = nullptr;
    const FixedVertex* provoking_ = nullptr; ///< of the only line; or null
    int step_ = 1, count_ = 0;
    LineEnds<L> ends_;
    Paths paths_;
};

} // namespace

template <>
void draw_lines<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex* const* vertex,
                             int n, int step, const FixedVertex* painted, std::int32_t width) {
    if constexpr (!has_shortcuts) {
        for (int i = 0; i + 1 < n; i += step)
            draw_line_of<Fixed>(state, target, *vertex[i], *vertex[i + 1], *vertex[i + 1], width);
        return;
    }
    LineBatch batch(state, target, width);
    const int most = step == 1 ? Paths::size + 1 : 2 * Paths::size;
    while (n > 1) {
        const int now = n < most ? n : most, left = step == 1 ? 1 : 0;
        batch.draw(vertex, now, step, painted, nullptr);
        vertex += now - left;
        n -= now - left;
    }
}

template <>
void draw_line<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                            const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    if constexpr (!has_shortcuts)
        return draw_line_of<Fixed>(state, target, a, b, provoking, width);
    const FixedVertex* const ends[2] = {&a, &b};
    LineBatch(state, target, width).draw(ends, 2, 1, nullptr, &provoking);
}

} // namespace spangle::raster
