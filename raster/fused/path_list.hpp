// Draws paths of flat colours as one list of fragments, on hosts with vectors. Four paths are walked side by
// side. No branch of the loop over the list depends on the picture.
#pragma once

#include "raster/ops/lanes.hpp"
#include "raster/ops/line_lanes.hpp"
#include "raster/ops/stage_depth.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/span/path.hpp"

namespace spangle::raster {

/// The fragments of short paths, in the order of the paths. Case is a case of fused_paths().
template <class Case> class PathList {
  public:
    static constexpr bool dithers = Case::key.dither;
    /// The largest number of fragments of a path in the list.
    static constexpr int longest = 16;

    PathList(const Surface& target, const Paths& paths, int count)
        : target_(target), paths_(paths), count_(count),
          pixels_before_(dithers ? PathPixels::before(target) : 0) {
        const int colors = !dithers ? 0 : paths.one_color ? 1 : count;
        for (int i = 0; i < colors; ++i)
            dither_cells_[i].make(static_cast<std::uint32_t>(paths.at(Paths::flat, i)),
                                  target.color_stride / 2);
    }

    /// Adds paths i to i + 3. Returns false, and adds nothing, where one of them is too long.
    SPANGLE_INLINE bool add(int i) {
        const Int count = L::load(paths_.lanes(Paths::count, i));
        const Int n = count & ~(count >> 31) & L::less(lane, Int{} + (count_ - i));
        if (L::any(L::less(Int{} + longest, n))) [[unlikely]]
            return false;
        alignas(16) std::int32_t own[4];
        L::store(own, n);
        if (!L::any(L::less(Int{} + 4, n)))
            walk<1>(i, own);
        else if (!L::any(L::less(Int{} + 8, n)))
            walk<2>(i, own);
        else
            walk<longest / 4>(i, own);
        return true;
    }

    /// The dithered words of the colour of path i.
    const inner::Half* cells([[maybe_unused]] int i) const {
        return dither_cells_[dithers && !paths_.one_color ? i : 0].words();
    }

    /// Draws the fragments that were added, and empties the list.
    SPANGLE_INLINE void draw() {
        const auto back = static_cast<std::ptrdiff_t>(pixels_before_) * 2;
        std::uint8_t* const color = target_.color - back;
        // A surface without a depth plane has a null pointer, from which nothing may be subtracted.
        std::uint8_t* const depth = Case::tested ? target_.depth - back : nullptr;
        using SingleLane = Lanes<1>;
        for (const std::int32_t *f = fragment_, *const end = next_fragment_; f != end; f += 2) {
            const std::ptrdiff_t offset = f[0];
            const auto* const half = reinterpret_cast<const std::uint8_t*>(f + 1);
            std::uint32_t color_word = SingleLane::load(half + (little ? 0 : 2));
            if constexpr (dithers)
                color_word = dither_cells_[color_word / 16].words()[color_word & 15];
            bool live = true;
            if constexpr (Case::tested) {
                const std::uint32_t incoming = SingleLane::load(half + (little ? 2 : 0)),
                                    stored = SingleLane::load(depth + offset);
                live = compare<Case::key.depth>(incoming, stored);
                if constexpr (Case::key.depth_write)
                    SingleLane::store(depth + offset, SingleLane::select(live, incoming, stored));
            }
            SingleLane::store(color + offset,
                              SingleLane::select(live, color_word, SingleLane::load(color + offset)));
        }
        next_fragment_ = fragment_;
    }

  private:
    using L = LineLanes<4>;
    using Int = L::Int;
    using Word = L::Word;
    static constexpr Int lane = {0, 1, 2, 3};
    static constexpr bool little = std::endian::native == std::endian::little;
    /// Bytes per unit of `at`. With dithering its two highest bits hold the row, so it counts pixels.
    static constexpr std::int32_t scale = dithers ? 1 : 2;
    /// The part of a fragment's word that comes from the colour, for paths i to i + 3.
    SPANGLE_INLINE Word colors(int i) const {
        if constexpr (dithers)
            return paths_.one_color ? Word{} : std::bit_cast<Word>((lane + i) * 16);
        const auto word = std::bit_cast<Word>(L::load(paths_.lanes(Paths::flat, i)));
        return Case::swaps ? (word << 8 & 0xFF00) | (word >> 8 & 0xFF) : word;
    }

    /// Writes Blocks times four fragments for each of four paths. Fragments behind the end of a path are
    /// overwritten by the next path.
    template <int Blocks> SPANGLE_INLINE void walk(int i, const std::int32_t (&own)[4]) {
        const auto load = [&](Paths::Word word) { return L::load(paths_.lanes(word, i)); };
        const auto load_word = [&](Paths::Word word) { return std::bit_cast<Word>(load(word)); };
        const Int rise = load(Paths::rise), denominator = load(Paths::denominator),
                  along = load(Paths::along) * scale, aside = load(Paths::aside) * scale;
        Int at = (load(Paths::first) + static_cast<std::int32_t>(pixels_before_)) * scale,
            // rest >= 0 is tested by the sign of ~rest.
            left = ~load(Paths::rest);
        Word depth{}, depth_step{};
        if constexpr (Case::tested)
            depth = load_word(Paths::depth), depth_step = load_word(Paths::depth_step);
        const Word color = colors(i);
        Int low[4 * Blocks], high[4 * Blocks];
#pragma GCC unroll 16
        for (int k = 0; k < 4 * Blocks; ++k) {
            Word word = (depth & ~0xFFFFu) | color;
            Int offset = at;
            if constexpr (dithers) {
                const auto place = std::bit_cast<Word>(at);
                word |= (place << 2 & 12) | place >> 30;
                offset = std::bit_cast<Int>(place << 2 >> 1);
            }
            const Int code = std::bit_cast<Int>(word);
            low[k] = __builtin_shufflevector(offset, code, 0, 4, 1, 5);
            high[k] = __builtin_shufflevector(offset, code, 2, 6, 3, 7);
            left -= rise;
            const Int over = left >> 31;
            left += denominator & over;
            at += along + (aside & over);
            depth += depth_step;
        }
        std::int32_t* out = next_fragment_; // a copy, which stays in a register
#pragma GCC unroll 4
        for (int path = 0; path < 4; ++path) {
            const Int* const from = path < 2 ? low : high;
#pragma GCC unroll 8
            for (int k = 0; k < 4 * Blocks; k += 2)
                L::store(out + 2 * k, (path & 1) == 0
                                          ? __builtin_shufflevector(from[k], from[k + 1], 0, 1, 4, 5)
                                          : __builtin_shufflevector(from[k], from[k + 1], 2, 3, 6, 7));
            out += 2 * own[path];
        }
        next_fragment_ = out;
    }

    const Surface& target_;
    const Paths& paths_;
    const int count_;
    const std::uint32_t pixels_before_;
    /// Two words per fragment. The first word is its offset in bytes. The second word has the depth code
    /// above the colour, or above the number of the dithered colour.
    alignas(16) std::int32_t fragment_[2 * (Paths::size + 1) * longest];
    std::int32_t* next_fragment_ = fragment_;
    DitherCells<Case::swaps> dither_cells_[dithers ? Paths::size : 1];
};

} // namespace spangle::raster
