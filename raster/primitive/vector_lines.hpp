// Sets up several lines at a time in vectors. No line waits for the results of another.
#pragma once

#include <cstddef>
#include <type_traits>

#include "raster/primitive/line_path.hpp"

namespace spangle::raster {

namespace detail {

/// PerPixel::coefficient of each length below 16 pixels. `lift` is 32 minus the shift of set_path_depth(),
/// which is PerPixel::exponent - 1.
struct CoefficientTable {
    static constexpr std::uint32_t size = 16 * subpixel_one;
    std::int32_t at[size];
    std::uint8_t lift[size];
    constexpr CoefficientTable() : at{}, lift{} {
        for (std::uint32_t length = 1; length < size; ++length) {
            const int zeros = numeric::clz32(length); // 20 or more: the longest length has 12 bits
            at[length] = static_cast<std::int32_t>(numeric::reciprocal(length << zeros) >> 1);
            lift[length] = static_cast<std::uint8_t>(zeros - 20);
        }
    }
};
inline constexpr CoefficientTable coefficient_table;

} // namespace detail

template <class L> class VectorLines {
  public:
    /// Takes lines from vertex 0 to 1, from vertex `step` to step + 1, and so on. Returns true where all
    /// vertices lie in the area.
    SPANGLE_INLINE bool take(const FixedVertex* const* vertex, int n, int step, const DrawState::Area& area) {
        vertex_ = vertex;
        vertex_step_ = step;
        line_count_ = step == 1 ? n - 1 : n / 2;
        // Lanes 2 and 3 hold arbitrary words. All lanes are therefore counted as unsigned words, which may
        // wrap.
        const Word low = {static_cast<std::uint32_t>(area.x), static_cast<std::uint32_t>(area.y), 0, 0};
        const Word last = {area.w - 1, area.h - 1, 0, 0};
        Word outside{};
        for (int i = 0; i < n; ++i) {
            const Word from_low = std::bit_cast<Word>(row(*vertex[i])) - low;
            outside |= from_low | (last - from_low);
        }
        return (outside[0] | outside[1]) >> 31 == 0;
    }

    /// The first or second end of line i, after take().
    Position end(int i, int second) const {
        return position(*vertex_[i * vertex_step_ + second]); // NOLINT(clang-analyzer-core.NullDereference)
    }

    /// Sets up all parts of the paths except their colour. Returns the interval of the first line.
    SPANGLE_INLINE PathInterval<std::int32_t> set_up(Paths& paths, std::int32_t pixels_per_row, bool depth) {
        PathInterval<std::int32_t> of_first{};
        for (int i = 0; i < line_count_; i += L::count) {
            Int x[2], y[2], z[2];
            ends(i, 0, x[0], y[0], z[0]);
            ends(i, 1, x[1], y[1], z[1]);
            const PathInterval<Int> at = trace(paths, i, x, y, pixels_per_row);
            if (i == 0)
                of_first = {L::first(at.begin), L::first(at.end), L::first(at.from_begin)};
            if (depth)
                set_depths(paths, i, z, at);
        }
        return of_first;
    }

  private:
    using Int = typename L::Int;
    using Word = typename L::Word;

    static_assert(offsetof(FixedVertex, x) == 0 && offsetof(FixedVertex, y) == 4 &&
                  offsetof(FixedVertex, z) == 8);
    /// Loads x, y, z of a vertex and the word after them.
    SPANGLE_INLINE static Int row(const FixedVertex& v) {
        Int r;
        __builtin_memcpy(&r, &v, sizeof r);
        return r;
    }

    /// Loads the first or the second ends of lines i to i + 3. Lanes beyond the last line get a line of no
    /// length.
    SPANGLE_INLINE void ends(int i, int second, Int& x, Int& y, Int& z) const {
        static_assert(L::count == 4);
        Int r[4];
        const FixedVertex* const* const at = vertex_ + i * vertex_step_ + second;
        if (i + 4 <= line_count_) [[likely]] {
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k)
                r[k] = row(*at[k * vertex_step_]);
        } else {
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k)
                r[k] = row(*(i + k < line_count_ ? at[k * vertex_step_] : vertex_[0]));
        }
        const Int a = __builtin_shufflevector(r[0], r[1], 0, 4, 1, 5),
                  b = __builtin_shufflevector(r[2], r[3], 0, 4, 1, 5);
        x = __builtin_shufflevector(a, b, 0, 1, 4, 5);
        y = __builtin_shufflevector(a, b, 2, 3, 6, 7);
        z = __builtin_shufflevector(__builtin_shufflevector(r[0], r[1], 2, 6, 3, 7),
                                    __builtin_shufflevector(r[2], r[3], 2, 6, 3, 7), 0, 1, 4, 5);
    }

    /// Finds the fragments of lines i to i + 3. Most often all four lines have one direction, and no value
    /// has to be selected by masks.
    SPANGLE_INLINE static PathInterval<Int> trace(Paths& paths, int i, const Int (&x)[2], const Int (&y)[2],
                                                  std::int32_t pixels_per_row) {
        const auto draw = [&](const auto& line) __attribute__((always_inline)) {
            L::store(&paths.at(Paths::count, i), line.count);
            return set_path<L>(paths, i, line, pixels_per_row);
        };
        const auto one_way = [&](auto along_x, auto ascends) __attribute__((always_inline)) {
            using Line = Diamond<L, decltype(along_x), decltype(ascends)>;
            const Int(&major)[2] = along_x ? x : y;
            const Int(&minor)[2] = along_x ? y : x;
            return draw(Line(along_x, ascends, major[0], minor[0],
                             Line::first_past(along_x, ascends, major[0], minor[0]), major[1], minor[1]));
        };
        constexpr std::true_type yes;
        constexpr std::false_type no;
        const Int along_x = Diamond<L>::is_along_x(x[0], y[0], x[1], y[1]);
        const Int descends = L::select(along_x, L::less(x[1], x[0]), L::less(y[1], y[0]));
        switch (L::alike(along_x, descends)) {
        case 0:
            return one_way(no, yes);
        case 1:
            return one_way(yes, yes);
        case 2:
            return one_way(no, no);
        case 3:
            return one_way(yes, no);
        default:
            return draw(Diamond<L>(x[0], y[0], x[1], y[1], 0));
        }
    }

    /// Sets the depths of lines i to i + 3, including lines without fragments.
    SPANGLE_INLINE static void set_depths(Paths& paths, int i, const Int (&z)[2],
                                          const PathInterval<Int>& at) {
        const Int along = at.end - at.begin, back = along >> 31, length = (along ^ back) - back;
        const Word from = depth_code(std::bit_cast<Word>(z[0]), 16),
                   to = depth_code(std::bit_cast<Word>(z[1]), 16);
        const Int difference = std::bit_cast<Int>(to >> 1) - std::bit_cast<Int>(from >> 1);
        if (L::any(L::less(Int{} + (detail::CoefficientTable::size - 1), length))) [[unlikely]]
            return set_long_depths(paths, i, std::bit_cast<Int>(from), difference, at);
        alignas(16) Of4 of;
        L::store(of.difference, difference);
        L::store(of.length, length);
        L::store(of.back, back);
        L::store(of.to_center, Int{} + subpixel_one / 2 - (at.begin & (subpixel_one - 1)));
        // The asm statement makes the compiler read scalars from memory; it would take them out of vectors
        // one by one.
        asm("" : "+m"(of)); // NOLINT(hicpp-no-assembler): no instruction
        const ShortDepth path[4] = {{of, 0}, {of, 1}, {of, 2}, {of, 3}};
        // Whole vectors are stored, so that later loads do not wait for four stores.
        const Word step = {path[0].step, path[1].step, path[2].step, path[3].step},
                   start = {path[0].start, path[1].start, path[2].start, path[3].start};
        L::store(&paths.at(Paths::depth_step, i), std::bit_cast<Int>(step));
        L::store(&paths.at(Paths::depth, i),
                 std::bit_cast<Int>(from + (1u << 15) + start + std::bit_cast<Word>(at.from_begin) * step));
    }

    struct Of4 {
        std::int32_t difference[4], length[4], back[4], to_center[4];
    };

    /// Depth as set_path_depth() computes it, with v 2^(32 - n) / 2^32 in place of v / 2^n, modulo 2^32.
    /// `step` is per pixel, and `start` leads from the beginning to the centre of its pixel.
    struct ShortDepth {
        std::uint32_t step, start;
        SPANGLE_INLINE ShortDepth(const Of4& of, int k) {
            const auto length = static_cast<std::uint32_t>(of.length[k]);
            const auto lifted = static_cast<std::uint64_t>(std::int64_t{of.difference[k]})
                                << detail::coefficient_table.lift[length];
            const std::int32_t per_pixel = (detail::coefficient_table.at[length] ^ of.back[k]) - of.back[k];
            const auto part = [&](std::int64_t coefficient) {
                return static_cast<std::uint32_t>((lifted * static_cast<std::uint64_t>(coefficient)) >> 32);
            };
            step = part(per_pixel);
            start = part(numeric::mul_s32(per_pixel, of.to_center[k]) >> subpixel_bits);
        }
    };
    [[gnu::noinline]] static void set_long_depths(Paths& paths, int i, Int from, Int difference,
                                                  const PathInterval<Int>& at) {
        for (int k = 0; k < L::count; ++k)
            set_path_depth(paths, i + k, static_cast<std::uint32_t>(from[k]), difference[k],
                           PerPixel(at.begin[k], at.end[k]), at.begin[k], at.from_begin[k]);
    }

    const FixedVertex* const* vertex_ = nullptr;
    int vertex_step_ = 1, line_count_ = 0;
};

} // namespace spangle::raster
