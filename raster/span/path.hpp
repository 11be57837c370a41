// Paths are what lines of width 1 hand to a loop of their own, one fragment per step along the major axis.
// Paths come several at a time, so that neither the code that finds them nor the code that draws them waits
// for the other.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// True where some fused loop draws paths, and paths are worth their code size.
inline constexpr bool has_paths = has_fused_spans && has_shortcuts;

/// The number of a pixel, counted from that of window (0, 0). Where a dithered colour asks for it, the two
/// bits above hold row & 3: adding per_row() mod 2^32 steps to the next row.
struct PathPixels {
    static constexpr std::uint32_t row = 1u << 30;
    static std::int32_t per_row(const Surface& target, bool dithers) {
        return target.color_stride / 2 + static_cast<std::int32_t>(dithers ? row : 0);
    }
    /// What is added to pixel numbers so that none is negative where rows go down in memory from that of
    /// window (0, 0): whole groups of four columns.
    static std::uint32_t before(const Surface& target) {
        const std::int32_t back = target.color_stride < 0 ? -target.color_stride / 2 * target.height : 0;
        return static_cast<std::uint32_t>(back + 3) & ~3u;
    }
    /// The cell of DitherCells at this place.
    SPANGLE_INLINE static std::uint32_t cell(std::uint32_t at) { return std::rotl(at, 2) & 15; }
    SPANGLE_INLINE static std::uint32_t pixel(std::uint32_t at) { return at & (row - 1); }
};

/// Several paths. Each fragment lies `along` pixels from the one before it, and `aside` further whenever
/// `rest`, grown by `rise`, is no longer negative; then `denominator` is taken off `rest`. The rows of both
/// planes have the same stride, so that one pixel number serves both.
class Paths {
  public:
    /// The most paths at once; where there are vectors, whole vectors of their words are stored.
    static constexpr int size = !numeric::cheap_branches ? 16 : line_batch > 2 ? line_batch : 1;
    enum Word {
        /// The number of fragments; none are drawn if it is not positive.
        count,
        /// The PathPixels of the first fragment; `along` and `aside` are differences of PathPixels.
        first,
        along,
        aside,
        /// The walk aside: -denominator <= rest < 0 <= rise <= denominator.
        rest,
        rise,
        denominator,
        /// The colour as the word of Kind::flat.
        flat,
        /// Depth at the first fragment, and its difference from one fragment to the next.
        depth,
        depth_step,
        words
    };
    /// The word of path i. Where there are vectors, the same words of the paths after it follow.
    SPANGLE_INLINE std::int32_t& at(Word word, int i) { return words_[place_of(word, i)]; }
    SPANGLE_INLINE std::int32_t at(Word word, int i) const { return words_[place_of(word, i)]; }
    SPANGLE_INLINE const std::int32_t* lanes(Word word, int i) const { return words_ + place_of(word, i); }
    bool one_color = false; ///< all paths have the same colour
    /// The colour of the only path whose colour varies, and its difference per fragment, in the form of its
    /// depth.
    Fixed::Affine color[3], color_step[3];

  private:
    /// Without vectors the words of a path lie together, so that they are loaded in pairs.
    static constexpr std::ptrdiff_t place_of(Word word, std::ptrdiff_t i) {
        return numeric::cheap_branches ? i * words + word : static_cast<std::ptrdiff_t>(word) * size + i;
    }
    alignas(16) std::int32_t words_[words * size];
};

/// Draws the first `count` paths.
using PathFunction = void (*)(const DrawState&, const Surface&, const Paths&, int count);

} // namespace spangle::raster
