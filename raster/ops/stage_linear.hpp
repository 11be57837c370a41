// The LINEAR filter of one REPEAT image, whose coordinates are walked along a span.
#pragma once

#include "raster/ops/stage_thresholds.hpp"
#include "raster/ops/texel_walk.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The position of LINEAR. The weight of the next texel has 8 bits, to the nearest. It is 0 at the centre of
/// a texel.
struct LinearPosition {
    static constexpr int fraction_bits = 8;
    static constexpr std::uint32_t origin(int log2_size) { return linear_origin(log2_size); }
};

/// The filter at the place of each fragment. T is a TextureFixed with Filter::linear. Dither: FilterWords
/// dithers its words.
template <class T, int Unit, class Runs, bool Dither = false>
class LinearWalk : public TexelWalk<T, Unit, Runs, LinearPosition> {
    using Base = TexelWalk<T, Unit, Runs, LinearPosition>;
    using Base::s, Base::t;

  public:
    using N = typename Base::N;
    static constexpr bool rows = true;

    SPANGLE_INLINE LinearWalk(const Span<Fixed>& span, std::int32_t x)
        : Base(span, x), dither_(span.x + x, span.y) {}
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x) {
        Base::start(span, x);
        dither_ = Thresholds(span.x + x, span.y);
    }
    SPANGLE_INLINE void step() {
        Base::step();
        dither_.step();
    }
    SPANGLE_INLINE void step_row() {
        Base::step_row();
        dither_.step();
    }
    SPANGLE_INLINE void jump(std::int32_t pixels) {
        Base::jump(pixels);
        if constexpr (Dither) // only a jump changes the column: eight lanes are whole periods of the pattern
            dither_ = Thresholds(dither_.x + pixels, dither_.y);
    }

    SPANGLE_INLINE bool row(std::int32_t n) {
        if (!this->in_row(n))
            return false;
        near_row_ = this->row_of(t.texel());
        far_row_ = this->row_of(t.next_texel());
        column_weights_ = Weights(N::L::splat(t.position() & 255));
        return true;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if (p.row)
            return filter(
                p, s.line(),
                column_weights_, [&](std::uint32_t) __attribute__((always_inline)) { return near_row_; },
                [&](std::uint32_t) __attribute__((always_inline)) { return far_row_; });
        return filter(
            p, s, Weights(t.template fractions<typename N::L>()),
            [&](std::uint32_t k) __attribute__((always_inline)) { return this->row_of(t.texel(k)); },
            [&](std::uint32_t k) __attribute__((always_inline)) { return this->row_of(t.next_texel(k)); });
    }

  private:
    using Weights = typename T::Colors::Weights;
    using Thresholds = std::conditional_t<!Dither, inner::NoThreshold,
                                          std::conditional_t<N::lanes == 1, inner::DitherRow<typename N::L>,
                                                             inner::DitherPlace<typename N::L>>>;
    [[no_unique_address]] Thresholds dither_;
    const std::uint8_t *near_row_, *far_row_; ///< addresses of the two rows of texels
    Weights column_weights_{N::L::splat(0)};

    /// Filters the texels of one group. `near` and `far` give, for each lane, the addresses of both rows of
    /// texels.
    template <class Along, class Near, class Far>
    SPANGLE_INLINE bool filter(Px<N>& p, const Along& along, const Weights& weights, Near near,
                               Far far) const {
        const auto i = [&](std::uint32_t k) __attribute__((always_inline)) {
            return along.texel(k);
        };
        const auto next = [&](std::uint32_t k) __attribute__((always_inline)) {
            return along.next_texel(k);
        };
        const auto texels = [&](auto row, auto column) __attribute__((always_inline)) {
            return T::words([&](std::uint32_t k)
                                __attribute__((always_inline)) { return this->texel(row(k), column(k)); });
        };
        // Texels are passed as arguments. If they were variables, the compiler would spill lanes.
        if constexpr (Dither)
            return this->apply_texture_function(
                p, {weights(texels(near, i), texels(near, next), texels(far, i), texels(far, next),
                            along.template fractions<typename N::L>(), dither_.threshold())});
        else
            return this->apply_texture_function(
                p, T::Colors::mix(weights, texels(near, i), texels(near, next), texels(far, i),
                                  texels(far, next), along.template fractions<typename N::L>()));
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
