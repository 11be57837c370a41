// Paths: what lines of width 1 hand to a loop of their own, one fragment per step along the major axis.
// Several at a time, so that what finds them and what draws them each run without waiting for the other.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// A loop draws paths, and they are worth their code.
inline constexpr bool has_paths = has_fused_spans && has_shortcuts;

/// Pixels counted from that of window (0, 0), and where a dithered colour asks for it, row & 3 in the two
/// bits above: mod 2^32 it grows with every step to another row.
struct PathPixels {
    static constexpr std::uint32_t row = 1u << 30;
    static std::int32_t per_row(const Surface& target, bool dithers) {
        return target.color_stride / 2 + static_cast<std::int32_t>(dithers ? row : 0);
    }
    /// What rows below that of window (0, 0) in memory take for the pixels not to be negative: whole groups
    /// of four columns.
    static std::uint32_t before(const Surface& target) {
        const std::int32_t back = target.color_stride < 0 ? -target.color_stride / 2 * target.height : 0;
        return static_cast<std::uint32_t>(back + 3) & ~3u;
    }
    /// Of DitherCells.
    SPANGLE_INLINE static std::uint32_t cell(std::uint32_t at) { return std::rotl(at, 2) & 15; }
    SPANGLE_INLINE static std::uint32_t pixel(std::uint32_t at) { return at & (row - 1); }
};

/// Each fragment is `along` from the one before it, and `aside` further whenever `rest`, grown by `rise`, is
/// no longer negative; then `denominator` is taken off. Pixels, in planes whose rows have the same stride.
class Paths {
  public:
    /// Vectors of them are stored whole.
    static constexpr int size = !numeric::cheap_branches ? 16 : line_batch > 2 ? line_batch : 1;
    enum Word {
        /// Of fragments; none if not positive.
        count,
        /// PathPixels, as `along` and `aside`.
        first,
        along,
        aside,
        /// -denominator <= rest < 0 <= rise <= denominator
        rest,
        rise,
        denominator,
        /// The word of Kind::flat.
        flat,
        /// At the first fragment, and from one to the next.
        depth,
        depth_step,
        words
    };
    /// The word of path i; where there are vectors, those of the paths after it follow.
    SPANGLE_INLINE std::int32_t& at(Word word, int i) { return words_[place_of(word, i)]; }
    SPANGLE_INLINE std::int32_t at(Word word, int i) const { return words_[place_of(word, i)]; }
    SPANGLE_INLINE const std::int32_t* lanes(Word word, int i) const { return words_ + place_of(word, i); }
    bool one_color = false; ///< of all paths
    /// Of the only path whose colour varies, as its depth is given.
    Fixed::Affine color[3], color_step[3];

  private:
    /// Without vectors the words of a path lie together, and are loaded by two.
    static constexpr std::ptrdiff_t place_of(Word word, std::ptrdiff_t i) {
        return numeric::cheap_branches ? i * words + word : static_cast<std::ptrdiff_t>(word) * size + i;
    }
    alignas(16) std::int32_t words_[words * size];
};

/// Draws the first `count` paths.
using PathFunction = void (*)(const DrawState&, const Surface&, const Paths&, int count);

} // namespace spangle::raster
