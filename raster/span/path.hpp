// Paths are lines of width 1, as a separate loop draws them: one fragment per step along the major axis.
// Several paths come at a time, so that neither the code that finds paths nor the code that draws them waits
// for the other.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/has_paths.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// The number of a pixel, counted from the pixel of window position (0, 0). Where a dithered colour needs it,
/// the two highest bits hold row & 3. Adding per_row() modulo 2^32 leads to the next row.
struct PathPixels {
    static constexpr std::uint32_t row = 1u << 30;
    static std::int32_t per_row(const Surface& target, bool dithers) {
        return target.color_stride / 2 + static_cast<std::int32_t>(dithers ? row : 0);
    }
    /// A number that is added to pixel numbers, so that none is negative. Where rows go down in memory,
    /// numbers below that of window position (0, 0) occur. The number is a multiple of four columns.
    static std::uint32_t before(const Surface& target) {
        const std::int32_t back = target.color_stride < 0 ? -target.color_stride / 2 * target.height : 0;
        return static_cast<std::uint32_t>(back + 3) & ~3u;
    }
    /// The cell of DitherCells for the fragment at this place.
    SPANGLE_INLINE static std::uint32_t cell(std::uint32_t at) { return std::rotl(at, 2) & 15; }
    SPANGLE_INLINE static std::uint32_t pixel(std::uint32_t at) { return at & (row - 1); }
};

/// Several paths. Each fragment lies `along` pixels from the fragment before it. `rest` grows by `rise` at
/// each step. Where it is then no longer negative, the fragment lies `aside` further, and `denominator` is
/// subtracted from `rest`. The rows of both planes have the same stride, so one pixel number serves both.
class Paths {
  public:
    /// The largest number of paths at once. Where there are vectors, whole vectors of path words are stored.
    static constexpr int size = !numeric::cheap_branches ? 16 : line_batch > 2 ? line_batch : 1;
    enum Word {
        /// The number of fragments. No fragment is drawn where it is not positive.
        count,
        /// The PathPixels of the first fragment. `along` and `aside` are differences of PathPixels.
        first,
        along,
        aside,
        /// The steps aside: -denominator <= rest < 0 <= rise <= denominator.
        rest,
        rise,
        denominator,
        /// The colour, as the word of Kind::flat (Span::flat_word).
        flat,
        /// The depth at the first fragment, and its difference from fragment to fragment.
        depth,
        depth_step,
        words
    };
    /// The word of path i. In builds with vectors, the same words of the next paths follow it in memory.
    SPANGLE_INLINE std::int32_t& at(Word word, int i) { return words_[place_of(word, i)]; }
    SPANGLE_INLINE std::int32_t at(Word word, int i) const { return words_[place_of(word, i)]; }
    SPANGLE_INLINE const std::int32_t* lanes(Word word, int i) const { return words_ + place_of(word, i); }
    bool one_color = false; ///< all paths have the same colour
    /// A colour that varies, and its difference from fragment to fragment, in the form of the depth. It
    /// belongs to the only path of the batch.
    Fixed::Affine color[3], color_step[3];

  private:
    /// Without vectors the words of one path lie together, so that they can be loaded in pairs.
    static constexpr std::ptrdiff_t place_of(Word word, std::ptrdiff_t i) {
        return numeric::cheap_branches ? i * words + word : static_cast<std::ptrdiff_t>(word) * size + i;
    }
    alignas(16) std::int32_t words_[words * size];
};

/// Draws the first `count` paths.
using PathFunction = void (*)(const DrawState&, const Surface&, const Paths&, int count);

} // namespace spangle::raster
