// Paths: what lines of width 1 hand to a loop of their own, one fragment per step along the major axis.
// Several at a time, so that what finds them and what draws them each run without waiting for the other.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// Each fragment is `along` from the one before it, and `aside` further whenever `rest`, grown by `rise`, is
/// no longer negative; then `denominator` is taken off. Pixels, in planes whose rows have the same stride.
class Paths {
  public:
    /// Vectors of them are stored whole.
    static constexpr int size = !numeric::cheap_branches ? 16 : line_batch > 2 ? line_batch : 1;
    enum Word {
        /// Of fragments; none if not positive.
        count,
        /// From the pixel of window (0, 0).
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
        words_in_turn,
        /// DitheredWord::place of the first fragment; without vectors it is found when it is needed.
        place = words_in_turn,
        words_of_lanes
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
    static constexpr int words = numeric::cheap_branches ? words_in_turn : words_of_lanes;
    static constexpr std::ptrdiff_t place_of(Word word, std::ptrdiff_t i) {
        return numeric::cheap_branches ? i * words + word : std::ptrdiff_t{word} * size + i;
    }
    alignas(16) std::int32_t words_[words * size];
};

/// Draws the first `count` paths.
using PathFunction = void (*)(const DrawState&, const Surface&, const Paths&, int count);

} // namespace spangle::raster
