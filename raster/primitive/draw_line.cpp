// Lines of width 1 as paths, where nothing is cut off: one loop draws all fragments. Others as rows.
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

/// Lines on their way to one loop: as many as a set of paths holds.
class LineBatch {
  public:
    LineBatch(const DrawState& state, const Surface& target, std::int32_t width)
        : state_(state), target_(target), width_(width),
          area_(width == 1 && !observed(state.counters) ? state.paths : DrawState::Area{}),
          row_(target.color_stride / 2) {}

    /// From vertices i to i + 1, i = 0, step, ... The latter give the colours when state.flat, or
    /// `provoking`.
    void draw(const FixedVertex* const* v, int n, int step, const FixedVertex* provoking) {
        vertex_ = v;
        step_ = step;
        provoking_ = provoking;
        count_ = step == 1 ? n - 1 : n / 2;
        b_ = step == 1 ? 1 : room;
        if (!load(n)) {
            if (count_ != 1)
                return one_by_one(v, n, step);
            if (!inside_)
                return rows();
            find();
            return walk(set_up_colored());
        }
        find();
        set_up();
        walk(Kind::flat);
    }

  private:
    using L = HostLines;
    /// Of vertices: the first ends of all lines, and from b_ on their second ends. The last lines may share a
    /// vector with lanes that have none.
    static constexpr int room = Paths::size + L::count - 1;
    template <class T> struct Ends { T at[2 * room]; };

    AnyFunction walk_of(Kind kind) const { return state_.variant[static_cast<unsigned>(kind)].walk; }

    /// Takes what is needed of the vertices. True: each line has one colour, and may be drawn as a path.
    SPANGLE_INLINE bool load(int n) {
        const DrawState::Area area = area_;
        const FixedVertex* const* const vertex = vertex_;
        const int b = b_, apart = step_ - 1;
        const bool flat = state_.fragment.flat;
        bool one_color = walk_of(Kind::flat) != nullptr, inside = true;
        const FixedVertex* last = vertex[0];
        std::uint32_t word = flat_word(state_, last->color);
        for (int i = 0; i < n; ++i) {
            const FixedVertex& v = *vertex[i];
            const int at = apart == 0 ? i : (i >> 1) + (i & 1) * b;
            inside = inside & area.holds(v.x, v.y);
            x_.at[at] = v.x;
            y_.at[at] = v.y;
            depth_.at[at] = depth_code(v.z, 16);
            if (!same_color(*last, v)) {
                one_color = one_color & (flat || at < b); // else within a line
                word = flat_word(state_, v.color);
            }
            word_.at[at] = word;
            last = &v;
        }
        for (int k = 0; k < L::count - 1; ++k) { // lanes without a line
            if (apart != 0)
                x_.at[count_ + k] = y_.at[count_ + k] = 0;
            x_.at[count_ + b + k] = y_.at[count_ + b + k] = 0;
        }
        if (provoking_ != nullptr && flat)
            word_.at[b] = flat_word(state_, provoking_->color);
        inside_ = inside;
        return one_color & inside;
    }

    [[gnu::noinline]] void one_by_one(const FixedVertex* const* v, int n, int step) {
        for (int i = 0; i + 1 < n; i += step)
            draw(v + i, 2, 1, nullptr);
    }

    /// The fragments of the lines.
    void find() {
        for (int i = 0; i < count_; i += L::count) {
            const Diamond<L> line(L::load(x_.at + i), L::load(y_.at + i), L::load(x_.at + i + b_),
                                  L::load(y_.at + i + b_), 0);
            L::store(paths_.count.at + i, line.count);
            if (L::any(L::less(L::Int{}, line.count)))
                follow(line, i);
            else
                interval(i, L::Int{}, L::Int{}, L::Int{}); // set-up looks at lines without fragments, too
        }
    }

    SPANGLE_INLINE void interval(int i, L::Int begin, L::Int end, L::Int from_begin) {
        L::store(begin_.at + i, begin);
        L::store(end_.at + i, end);
        L::store(from_begin_.at + i, from_begin);
    }

    /// Where they lie; and where attributes start from. These run from one end of the line to the other;
    /// where the centre of the first or last fragment lies beyond the end, the end is moved there
    /// (LineInterval).
    SPANGLE_INLINE void follow(const Diamond<L>& line, int i) {
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
        interval(i, begin, L::select(line.ascends, high, low), line.major - (begin >> subpixel_bits));
    }

    /// One colour leaves one plane, and that has one direction: what Setup finds, in a few steps.
    SPANGLE_INLINE void set_up() {
        for (int i = 0; i < count_; ++i)
            paths_.word[i] = word_.at[i + b_];
        if (!state_.needs.z)
            return;
        numeric::Reciprocals<Paths::size> of_length;
        for (int i = 0; i < count_; ++i) {
            const std::uint32_t length = numeric::abs_u32(end_.at[i] - begin_.at[i]);
            of_length.set(i, length << numeric::clz32(length | 1));
        }
        of_length.finish();
        for (int i = 0; i < count_; ++i)
            set_up_depth(i, of_length.at(i));
    }

    SPANGLE_INLINE void set_up_depth(int i, std::uint32_t reciprocal) {
        const std::int32_t begin = begin_.at[i], along = end_.at[i] - begin;
        const PerPixel per_pixel(reciprocal, numeric::clz32(numeric::abs_u32(along) | 1), along < 0);
        const std::uint32_t from = depth_.at[i];
        const auto difference =
            static_cast<std::int32_t>(depth_.at[i + b_] >> 1) - static_cast<std::int32_t>(from >> 1);
        const auto part = [&](std::int32_t coefficient) {
            return scaled_word(numeric::mul_s32(difference, coefficient), per_pixel.exponent - 1);
        };
        const std::uint32_t step = part(per_pixel.coefficient);
        paths_.z.step[i] = step;
        paths_.z.value[i] = from + (1u << 15) + part(per_pixel.to_center(begin)) +
                            static_cast<std::uint32_t>(from_begin_.at[i]) * step;
    }

    const FixedVertex& provoking() const { return provoking_ != nullptr ? *provoking_ : *vertex_[1]; }

    /// The only line, of several colours.
    [[gnu::noinline]] Kind set_up_colored() {
        Span<Fixed> span;
        span.state = &state_;
        span.target = &target_;
        Setup<Fixed>(span, *vertex_[0], *vertex_[1], provoking(), true, begin_.at[0], end_.at[0]);
        const auto ramp = [&](const Span<Fixed>::Affine& plane, Paths::Ramp& to) {
            to.value[0] = plane.at(from_begin_.at[0], 0);
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
                touch_line(target_, *vertex_[i * step_], *vertex_[i * step_ + 1]);
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
    int step_ = 1, count_ = 0, b_ = 1;
    bool inside_ = false; ///< of area_, all vertices
    Ends<std::int32_t> x_, y_;
    Ends<std::uint32_t> depth_, word_;
    Paths::Word begin_, end_; ///< of attributes, along the major axis
    Paths::Word from_begin_;  ///< from the pixel of that to the first fragment
    Paths paths_;
};

} // namespace

template <>
void draw_lines<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex* const* vertex,
                             int n, int step, std::int32_t width) {
    LineBatch batch(state, target, width);
    const int most = step == 1 ? Paths::size + 1 : 2 * Paths::size;
    while (n > 1) {
        const int now = n < most ? n : most, left = step == 1 ? 1 : 0;
        batch.draw(vertex, now, step, nullptr);
        vertex += now - left;
        n -= now - left;
    }
}

template <>
void draw_line<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                            const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    const FixedVertex* const ends[2] = {&a, &b};
    LineBatch(state, target, width).draw(ends, 2, 1, &provoking);
}

} // namespace spangle::raster
