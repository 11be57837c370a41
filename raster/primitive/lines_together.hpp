// Lines several at a time, in vectors: none waits for another.
#pragma once

#include "raster/primitive/line_path.hpp"

namespace spangle::raster {

template <class L> class LinesTogether {
  public:
    /// Ends from vertex 0 to 1, from `step` to step + 1, ... True: all lie in the area.
    SPANGLE_INLINE bool take(const FixedVertex* const* vertex, int n, int step, const DrawState::Area& area) {
        return step == 1 ? take_strip(vertex, n, area) : take_apart(vertex, n, area);
    }

    /// All that the paths of one colour need but that. The interval of the first.
    SPANGLE_INLINE PathInterval<std::int32_t> set_up(Paths& paths, std::int32_t row, bool depth) {
        PathInterval<std::int32_t> of_first{};
        for (int i = 0; i < count_; i += L::count) {
            const PathInterval<Int> at = trace(paths, i, row);
            if (i == 0)
                of_first = {L::first(at.begin), L::first(at.end), L::first(at.from_begin)};
            if (depth)
                prepare_depths(i, at);
        }
        if (depth)
            set_depths(paths);
        return of_first;
    }

  private:
    using Int = typename L::Int;

    /// The vertex at a place of its own.
    SPANGLE_INLINE bool take(const FixedVertex& v, int at, const DrawState::Area& area) {
        x_[at] = v.x;
        y_[at] = v.y;
        z_[at] = static_cast<std::int32_t>(v.z);
        return area.holds(v.x, v.y);
    }
    SPANGLE_INLINE bool take_strip(const FixedVertex* const* vertex, int n, const DrawState::Area& given) {
        const DrawState::Area area = given; // in registers
        bool inside = true;
        for (int i = 0; i < n; ++i)
            inside = take(*vertex[i], i, area) & inside;
        b_ = 1;
        count_ = n - 1;
        for (int k = 0; k < L::count - 1; ++k) // lanes without a line
            x_[n + k] = y_[n + k] = z_[n + k] = 0;
        return inside;
    }
    [[gnu::noinline]] bool take_apart(const FixedVertex* const* vertex, int n, const DrawState::Area& area) {
        bool inside = true;
        for (int i = 0; i < n; ++i)
            inside = take(*vertex[i], (i >> 1) + (i & 1) * room, area) & inside;
        b_ = room;
        count_ = n / 2;
        for (int k = count_; k < count_ + L::count - 1; ++k) {
            x_[k] = y_[k] = z_[k] = 0;
            x_[room + k] = y_[room + k] = z_[room + k] = 0;
        }
        return inside;
    }

    /// The fragments of line i and those beside it.
    SPANGLE_INLINE PathInterval<Int> trace(Paths& paths, int i, std::int32_t row) const {
        const Diamond<L> line(L::load(x_ + i), L::load(y_ + i), L::load(x_ + i + b_), L::load(y_ + i + b_),
                              0);
        L::store(&paths.at(Paths::count, i), line.count);
        if (L::any(L::less(Int{}, line.count)))
            return set_path<L>(paths, i, line, row);
        return {Int{}, Int{}, Int{}};
    }

    SPANGLE_INLINE void prepare_depths(int i, const PathInterval<Int>& at) {
        const Int along = at.end - at.begin, back = along >> 31;
        const auto code = [&](int vertex) {
            return depth_code(std::bit_cast<typename L::Word>(L::load(z_ + vertex)), 16);
        };
        const auto from = code(i), to = code(i + b_);
        L::store(from_ + i, std::bit_cast<Int>(from));
        L::store(difference_ + i, std::bit_cast<Int>(to >> 1) - std::bit_cast<Int>(from >> 1));
        L::store(length_ + i, (along ^ back) - back);
        L::store(back_ + i, back);
        L::store(begin_ + i, at.begin);
        L::store(from_begin_ + i, at.from_begin);
    }

    SPANGLE_INLINE void set_depths(Paths& paths) const {
        numeric::Reciprocals<Paths::size> of_length(numeric::each_is_set);
        for (int i = 0; i < count_; ++i) {
            const auto length = static_cast<std::uint32_t>(length_[i]);
            of_length.set(i, length << numeric::clz32(length | 1));
        }
        for (int i = count_; i < Paths::size; ++i)
            of_length.set(i, 0);
        of_length.finish();
        for (int i = 0; i < count_; ++i) { // lines without fragments, too
            const int zeros = numeric::clz32(static_cast<std::uint32_t>(length_[i]) | 1);
            PerPixel per_pixel(of_length.at(i), zeros, false);
            per_pixel.coefficient = (per_pixel.coefficient ^ back_[i]) - back_[i];
            set_path_depth(paths, i, static_cast<std::uint32_t>(from_[i]), difference_[i], per_pixel,
                           begin_[i], from_begin_[i]);
        }
    }

    /// First ends, and from b_ on second ones. The last lines may share a vector with lanes that have none.
    static constexpr int room = Paths::size + L::count - 1;
    std::int32_t x_[2 * room], y_[2 * room], z_[2 * room];
    alignas(16) std::int32_t from_[Paths::size], difference_[Paths::size], length_[Paths::size],
        back_[Paths::size], begin_[Paths::size], from_begin_[Paths::size];
    int b_ = 1, count_ = 0;
};

} // namespace spangle::raster
