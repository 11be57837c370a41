// The NEAREST filter of one REPEAT image, whose coordinates are walked along a span.
#pragma once

#include "raster/ops/number_packed.hpp"
#include "raster/ops/texel_walk.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

struct NearestPosition {
    static constexpr int fraction_bits = 0;
    static constexpr std::uint32_t origin(int log2_size) { return 0 - nearest_bias(log2_size); }
};

/// The filter at the place of each fragment. T is a TextureFixed with Filter::nearest.
template <class T, int Unit, class Runs>
class NearestWalk : public TexelWalk<T, Unit, Runs, NearestPosition> {
    using Base = TexelWalk<T, Unit, Runs, NearestPosition>;
    using Base::s, Base::t;
    /// True where consecutive fragments of a row read consecutive texels, as sprites do. Fragments count up
    /// to 0 (fused.hpp), and texels are addressed by the same count.
    static constexpr bool in_order = is_packed<typename Base::N> && !Base::runs;

  public:
    using N = typename Base::N;
    /// Whether the stage has row(). With several lanes, only rows whose texels are loaded as whole words gain
    /// from it. With one lane it pays where little else is done with texels.
    static constexpr bool rows = N::lanes == 1 ? T::stores_texels : T::loads_words;

    SPANGLE_INLINE NearestWalk(const Span<Fixed>& span, std::int32_t x)
        : Base(span, x), width_(this->log2_width) {}

    SPANGLE_INLINE bool row(std::int32_t n) {
        if (!this->in_row(n))
            return false;
        texel_row_ = this->row_of(t.texel());
        if constexpr (in_order) {
            texel_row_ =
                numeric::factor32(this->texel(texel_row_, s.texel() + static_cast<std::uint32_t>(n)));
            return s.one_to_one(static_cast<std::uint32_t>(n)) && inside(n);
        }
        if constexpr (N::lanes > 1)
            is_one_to_one_ = s.one_to_one(static_cast<std::uint32_t>(n));
        return true;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if (p.row) {
            if constexpr (in_order)
                return this->combine(
                    p, [&](std::uint32_t) { return texel_row_ + p.template bytes<T::bytes>(); });
            if constexpr (N::lanes > 1 && T::loads_words) {
                if (is_one_to_one_ && inside(N::lanes))
                    return this->combine_words(p, N::L::load32(this->texel(texel_row_, s.texel())));
            }
            return this->combine(
                p, [&](std::uint32_t k)
                       __attribute__((always_inline)) { return this->texel(texel_row_, s.texel(k)); });
        }
        return this->combine(
            p, [&](std::uint32_t k) __attribute__((always_inline)) {
                if constexpr (by_product)
                    return this->texel(this->texels, t.texel() * width_.v + s.texel_of(width_.v));
                else if constexpr (Base::aside)
                    return this->texel(this->texels, t.place(s));
                else
                    return this->texel(this->row_of(t.texel(k)), s.texel(k));
            });
    }
    SPANGLE_INLINE void step_row() {
        if constexpr (!in_order)
            Base::step_row();
    }

  private:
    /// True where the texel's number is made by products. The high word of coordinate * width is the column,
    /// and the same factor serves rows.
    static constexpr bool by_product = N::lanes == 1 && !rows && numeric::long_products;
    struct Width {
        std::uint32_t v;
        SPANGLE_INLINE explicit Width(int log2_width) : v(numeric::factor32(1u << log2_width)) {}
    };
    struct NoWidth {
        SPANGLE_INLINE explicit NoWidth(int) {}
    };
    [[no_unique_address]] std::conditional_t<by_product, Width, NoWidth> width_;
    const std::uint8_t* texel_row_;
    bool is_one_to_one_;

    /// True where at least n texels are left in the row.
    SPANGLE_INLINE bool inside(std::int32_t n) const {
        return static_cast<std::int32_t>(s.texel()) + n <= 1 << this->log2_width;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
