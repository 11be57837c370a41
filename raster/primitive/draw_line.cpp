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

/// Widens the touched columns by those of a line, if they are not all among them: rows between the ends', and
/// one more pixel, hold it.
SPANGLE_INLINE void touch_line(const Surface& target, DiamondWalk walk, const Position& a,
                               const Position& b) {
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
            for (; walk.count > 0; walk.step()) {
                const std::int32_t x = walk.along_x ? walk.major : walk.minor;
                touch(target, walk.along_x ? walk.minor : walk.major, x, x + 1);
            }
            return;
        }
}

/// Lines on their way to one loop.
class Paths {
  public:
    Paths(const DrawState& state, const Surface& target, std::int32_t width)
        : state_(state), target_(target), width_(width), walks_(width == 1 && !observed(state.counters)),
          row_(target.color_stride / format_info(target.format).bytes_per_pixel) {}

    SPANGLE_INLINE void draw(const FixedVertex& a, const FixedVertex& b, const FixedVertex& provoking) {
        if (walks_ && add(a, b, provoking)) [[likely]]
            return;
        flush(); // in the order they came
        draw_rows(state_, target_, a, b, provoking, width_);
    }

    void flush() {
        if (count_ == 0)
            return;
        if (Counters* const counters = state_.counters; counters != nullptr) {
            counters->triangles += static_cast<std::uint32_t>(count_);
            for (int i = 0; i < count_; ++i)
                counters->fragments += static_cast<std::uint32_t>(path_[i].count);
        }
        reinterpret_cast<PathFunction>(walk_of(kind_))(state_, target_, path_, path_ + count_);
        count_ = 0;
    }

  private:
    static constexpr int size = numeric::cheap_branches ? 8 : 16;

    AnyFunction walk_of(Kind kind) const { return state_.variant[static_cast<unsigned>(kind)].walk; }

    /// False: it takes rows.
    SPANGLE_INLINE bool add(const FixedVertex& a, const FixedVertex& b, const FixedVertex& provoking) {
        if (!state_.paths.holds(a.x, a.y) || !state_.paths.holds(b.x, b.y))
            return false;
        const DiamondWalk walk(a.x, a.y, b.x, b.y, 0);
        if (walk.count == 0)
            return true;
        const detail::LineInterval interval(walk, walk.along_x ? a.x : a.y, walk.along_x ? b.x : b.y);
        Path& path = path_[count_];
        walk.follow(row_, path);
        Kind kind = Kind::flat;
        if (walk_of(kind) != nullptr && (state_.fragment.flat || same_color(a, b)))
            set_up(path, walk.major, a, b, state_.fragment.flat ? provoking : a, interval);
        else
            kind = set_up_any(path, walk.major, a, b, provoking, interval);
        if (walk_of(kind) == nullptr)
            return false;
        if (target_.touched != nullptr)
            touch_line(target_, walk, {a.x, a.y}, {b.x, b.y});
        if (kind != kind_) {
            flush();
            kind_ = kind;
            path_[0] = path;
        }
        if (++count_ == size)
            flush();
        return true;
    }

    /// One colour leaves one plane, and that has one direction: what Setup finds, in a few steps. `at` is the
    /// first fragment.
    SPANGLE_INLINE void set_up(Path& path, std::int32_t at, const FixedVertex& a, const FixedVertex& b,
                               const FixedVertex& painted, const detail::LineInterval& interval) const {
        path.word = word565(painted.color);
        if (!state_.needs.z)
            return;
        const PerPixel per_pixel(interval.begin, interval.end);
        const std::uint32_t from = depth_code(a.z, 16), to = depth_code(b.z, 16);
        const auto difference = static_cast<std::int32_t>(to >> 1) - static_cast<std::int32_t>(from >> 1);
        const auto part = [&](std::int32_t coefficient) {
            return scaled_word(numeric::mul_s32(difference, coefficient), per_pixel.exponent - 1);
        };
        const auto columns = static_cast<std::uint32_t>(at - (interval.begin >> subpixel_bits));
        path.z.step = part(per_pixel.coefficient);
        path.z.value = from + (1u << 15) + part(per_pixel.to_center(interval.begin)) + columns * path.z.step;
    }

    /// Any colours.
    [[gnu::noinline]] Kind set_up_any(Path& path, std::int32_t at, const FixedVertex& a, const FixedVertex& b,
                                      const FixedVertex& provoking,
                                      const detail::LineInterval& interval) const {
        Span<Fixed> span;
        span.state = &state_;
        span.target = &target_;
        Setup<Fixed>(span, a, b, provoking, true, interval.begin, interval.end);
        const auto along = [&](const Span<Fixed>::Affine& plane) {
            return Path::Ramp{plane.at(at - span.anchor_x, 0), plane.dx};
        };
        if (state_.needs.z)
            path.z = along(span.z);
        if (span.kind == Kind::flat)
            path.word = span.flat_word;
        else if (state_.needs.rgb)
            for (int c = 0; c < 3; ++c)
                path.color[c] = along(span.color_value[c]);
        return span.kind;
    }

    const DrawState& state_;
    const Surface& target_;
    const std::int32_t width_;
    const bool walks_;
    const std::int32_t row_; ///< pixels from row to row
    int count_ = 0;
    Kind kind_ = Kind::flat;
    Path path_[size];
};

} // namespace

template <>
void draw_lines<FixedVertex>(const DrawState& state, const Surface& target, const LineEnds<FixedVertex>* line,
                             const LineEnds<FixedVertex>* end, std::int32_t width) {
    Paths paths(state, target, width);
    for (; line != end; ++line)
        paths.draw(*line->a, *line->b, *line->b);
    paths.flush();
}

template <>
void draw_line<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                            const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    Paths paths(state, target, width);
    paths.draw(a, b, provoking);
    paths.flush();
}

} // namespace spangle::raster
