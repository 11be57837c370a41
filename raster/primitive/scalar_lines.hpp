// Sets up lines one after the other, in words of 32 bits. No value is selected by masks. A line of a strip
// reuses the results of the line before it for their common vertex.
#pragma once

#include <type_traits>

#include "raster/primitive/line_end.hpp"
#include "raster/primitive/line_path.hpp"

namespace spangle::raster {

class ScalarLines {
  public:
    /// Takes lines from vertex 0 to 1, from vertex `step` to step + 1, and so on. Returns true where all
    /// vertices lie in the area.
    SPANGLE_INLINE bool take(const FixedVertex* const* vertex, int n, int step, const DrawState::Area& area) {
        end_ = own_ends_;
        vertex_step_ = step;
        line_count_ = step == 1 ? n - 1 : n / 2;
        const DrawState::Area where = area; // a copy stays in registers
        LineEnd* own = own_ends_;
        for (const FixedVertex* const* const end = vertex + n; vertex != end; ++vertex, ++own) {
            *own = line_end(**vertex);
            if (!where.holds(own->x, own->y))
                return false;
        }
        return true;
    }
    /// Takes a strip of `count` lines. `ends` are not copied.
    void take(const LineEnd* ends, int count) {
        end_ = ends;
        vertex_step_ = 1;
        line_count_ = count;
    }
    /// The first or second end of line i.
    Position end(int i, int second) const { return position(end_[i * vertex_step_ + second]); }

    /// Sets up all parts of the paths except their colour. Without depth it returns the interval of the last
    /// line that has fragments.
    [[gnu::noinline]] PathInterval<std::int32_t> set_up(Paths& paths, std::int32_t row, bool depth) const {
        constexpr std::true_type yes;
        constexpr std::false_type no;
        PathInterval<std::int32_t> at{};
        numeric::LeadingZeros<> zeros; // counts the leading zeros of lengths
        for (int i = 0; i < line_count_;) {
            const LineEnd &a = end_[i * vertex_step_], &b = end_[i * vertex_step_ + 1];
            const auto follow = [&](auto along_x, auto ascends) __attribute__((always_inline)) {
                return this->follow(along_x, ascends, i, paths, row, depth, at, zeros);
            };
            if (Diamond<L>::is_along_x(a.x, a.y, b.x, b.y))
                i = a.x <= b.x ? follow(yes, yes) : follow(yes, no);
            else
                i = a.y <= b.y ? follow(no, yes) : follow(no, no);
        }
        return at;
    }

  private:
    using L = LineLanes<1>;

    /// Sets up line i, whose major axis and direction are given, and the next lines of its strip that have
    /// the same. Returns the index of the line after them.
    template <class X, class Up>
    SPANGLE_INLINE int follow(X x, Up up, int i, Paths& paths, std::int32_t row, bool depth,
                              PathInterval<std::int32_t>& at, numeric::LeadingZeros<>& zeros) const {
        using Line = Diamond<L, X, Up>;
        const LineEnd* const first = end_ + i * vertex_step_;
        const LineEnd* const last = vertex_step_ == 1 ? end_ + (line_count_ - 1) : first;
        std::int32_t a = major<X>(*first), a_minor = minor<X>(*first);
        std::int32_t past = Line::first_past(x, up, a, a_minor);
        const LineEnd* ends = first;
        for (int path = i;; ++path, ++ends) {
            const std::int32_t b = major<X>(ends[1]), b_minor = minor<X>(ends[1]);
            const Line line(x, up, a, a_minor, past, b, b_minor);
            paths.at(Paths::count, path) = line.count;
            if (line.count > 0) {
                const PathInterval<std::int32_t> interval = set_path<L>(paths, path, line, row);
                if (depth)
                    set_depth<Up>(paths, path, ends, interval, zeros);
                else
                    at.begin = interval.begin, at.end = interval.end, at.from_begin = interval.from_begin;
            }
            if (ends == last)
                break;
            a = b, a_minor = b_minor, past = line.second_past();
            if (!Line::has_direction(x, up, major<X>(ends[2]) - a, minor<X>(ends[2]) - a_minor))
                break;
        }
        return i + 1 + static_cast<int>(ends - first);
    }
    template <class X> SPANGLE_INLINE static std::int32_t major(const LineEnd& v) {
        return X::value ? v.x : v.y;
    }
    template <class X> SPANGLE_INLINE static std::int32_t minor(const LineEnd& v) {
        return X::value ? v.y : v.x;
    }

    /// Does what set_path_depth() does, with high words of products. That works where 32 bits hold the
    /// difference of the ends' depths times 2^lift: always for lines of 8 to 16 pixels, never for longer
    /// ones, and for shorter ones unless depth is too steep.
    template <class Up>
    SPANGLE_INLINE void set_depth(Paths& paths, int i, const LineEnd* ends,
                                  const PathInterval<std::int32_t>& at,
                                  numeric::LeadingZeros<>& count) const {
        const std::uint32_t from = ends[0].depth;
        const std::int32_t difference = half_difference(ends);
        const auto length = static_cast<std::uint32_t>(Up::value ? at.end - at.begin : at.begin - at.end);
        const int zeros = count.of(length);
        const auto lift = static_cast<std::uint32_t>(zeros) - 20; // 32 less the shift of set_path_depth()
        if (numeric::loses_bits(difference, lift)) [[unlikely]]
            return set_any_depth(paths, ends, at.begin, at.end, at.from_begin);
        const auto per_pixel = static_cast<std::int32_t>(numeric::half_reciprocal(length, zeros));
        const std::int32_t coefficient = Up::value ? per_pixel : -per_pixel;
        const std::int32_t high = shift_by_lift(difference, lift);
        // (128 - f) coefficient / 256 is (f - 128) 2^24 (-coefficient) / 2^32, where f is the fraction of
        // at.begin.
        const auto to_center =
            static_cast<std::int32_t>((static_cast<std::uint32_t>(at.begin) << 24) ^ 0x80000000u);
        const std::int32_t step = numeric::mul_high_s32(high, coefficient);
        paths.at(Paths::depth_step, i) = step;
        paths.at(Paths::depth, i) = static_cast<std::int32_t>(
            from + (1u << 15) +
            static_cast<std::uint32_t>(
                numeric::mul_high_s32(high, numeric::mul_high_byte(-coefficient, to_center))) +
            static_cast<std::uint32_t>(at.from_begin) * static_cast<std::uint32_t>(step));
    }
    [[gnu::noinline]] void set_any_depth(Paths& paths, const LineEnd* ends, std::int32_t begin,
                                         std::int32_t end, std::int32_t from_begin) const {
        const auto from_first = static_cast<int>(ends - end_);
        set_path_depth(paths, vertex_step_ == 1 ? from_first : from_first / 2, ends[0].depth,
                       half_difference(ends), PerPixel(begin, end), begin, from_begin);
    }
    /// Half the difference between the depth codes of two ends.
    SPANGLE_INLINE static std::int32_t half_difference(const LineEnd* ends) {
        return static_cast<std::int32_t>(ends[1].depth >> 1) - static_cast<std::int32_t>(ends[0].depth >> 1);
    }

    const LineEnd* end_ = nullptr;
    int vertex_step_ = 1, line_count_ = 0;
    LineEnd own_ends_[2 * Paths::size]; ///< ends of the vertices that take() was given
};

} // namespace spangle::raster
