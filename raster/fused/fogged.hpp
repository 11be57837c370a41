// Draws rows of affine texels in light and fog of the balanced tier, with one lane. The loop needs twice as
// many words as there are registers. Words that do not change lie in memory in pairs, in the order in which
// the loop reads them.
#pragma once

#include "raster/ops/stage_depth.hpp"
#include "raster/ops/stage_fogged_light.hpp"
#include "raster/ops/stage_nearest.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <class Case> class FoggedRows {
  public:
    SPANGLE_INLINE explicit FoggedRows(const Span<Fixed>& span) : combine_(span) {
        const auto& fragment = span.state->fragment;
        const int log2_width = span.state->log2_width[0], log2_height = span.state->log2_height[0];
        image_size_ = {1u << log2_width, 1u << log2_height};
        factor_tables_ = {fragment.unit[0].texture->level[0].texels,
                          numeric::kept_in_register(Combine::sixths)};
        end_step_z_ = {nullptr, span.z.dx};
        step_coord_ = {span.s[0].dx, span.t[0].dx};
        z_ = origin(span, span.z);
        s_ = origin(span, span.s[0], 0 - NearestPosition::origin(log2_width));
        t_ = origin(span, span.t[0], 0 - NearestPosition::origin(log2_height));
        fog_ = origin(span, span.fog);
        for (int i = 0; i < lights; ++i) {
            step_light_[i] = {span.color_value[i].dx, span.fog.dx};
            light_[i] = origin(span, span.color_value[i]);
        }
        color_ = {span.target->color, span.target->color_stride};
        depth_ = {span.target->depth, span.target->depth_stride};
    }

    SPANGLE_INLINE void draw(const Row& row) {
        numeric::kept_in_memory(*this);
        const auto y = static_cast<std::uint32_t>(row.y);
        const std::int32_t last = row.last, first = row.first;
        const auto x = static_cast<std::uint32_t>(first);
        std::uint32_t z = at(z_, x, y, end_step_z_.b);
        const auto [ds, dt] = numeric::load_two(step_coord_);
        std::uint32_t s = at(s_, x, y, ds), t = at(t_, x, y, dt), light[lights], fog;
        for (int k = 0; k < lights; ++k) {
            const auto [dlight, dfog] = numeric::load_two(step_light_[k]);
            light[k] = at(light_[k], x, y, dlight);
            if (k == 0)
                fog = at(fog_, x, y, dfog);
        }
        if constexpr (dithers)
            thresholds_ = inner::dither_numbered<Combine::threshold_bits>.from(last, row.y);
        end_step_z_.a = place(color_, row.y, last);
        std::uint8_t* const depth = place(depth_, row.y, last);
        // The index counts bytes up to 0, so that the last index needs no register.
        std::int32_t i = 2 * (first - last);
        do {
            numeric::kept_in_memory(*this);
            const std::uint32_t z16 = z >> 16;
            if (test(depth + i, z16)) {
                std::uint32_t word;
                if constexpr (dithers) { // this order takes the fewest registers
                    std::uint32_t at = texel(s, t);
                    const std::uint32_t f = numeric::evaluate_after(N::clamped_fraction(fog), at);
                    typename Combine::Shares shares = combine_.shares(f, thresholds_[i >> 1 & 3]);
                    at = numeric::evaluate_after(at, shares.g);
                    at = numeric::evaluate_after(at, shares.r);
                    const auto [texels, sixths] = numeric::load_two_after(shares.b, factor_tables_);
                    word = combine_.word(lit(light, f, N::L::load(texels + 2 * at)), shares, sixths,
                                         fifths_table_);
                } else {
                    const auto [texels, sixths] = numeric::load_two(factor_tables_);
                    const std::uint32_t at = texel(s, t);
                    const std::uint32_t word565 = N::L::load(texels + 2 * at), f = N::clamped_fraction(fog);
                    word = combine_.word(lit(light, f, word565), f, sixths, combine_.fifths);
                }
                const auto [end, by_z] = numeric::load_two_after(word, end_step_z_);
                N::L::store(end + i, word);
                z += by_z;
            } else {
                z += end_step_z_.b;
            }
            const auto [by_s, by_t] = numeric::load_two(step_coord_);
            s += by_s;
            t += by_t;
            for (int k = 0; k < lights; ++k) {
                const auto [by_light, by_fog] = numeric::load_two(step_light_[k]);
                light[k] += by_light;
                if (k == 0)
                    fog += by_fog;
            }
        } while ((i += 2) != 0);
    }

  private:
    using N = BalancedLit;
    static constexpr int lights = Case::gray ? 1 : 3;
    static constexpr bool dithers = Case::key.dither;
    using Combine = FoggedTexel<Case::key.format, true, dithers>;
    /// The value of a plane at window position (0, 0), and its difference from row to row.
    using Origin = numeric::WordPair<std::uint32_t, std::uint32_t>;
    using Plane = numeric::WordPair<std::uint8_t*, std::int32_t>;

    SPANGLE_INLINE static Origin origin(const Span<Fixed>& span, const Span<Fixed>::Affine& plane,
                                        std::uint32_t more = 0) {
        return {numeric::factor32(plane.value + more - static_cast<std::uint32_t>(span.anchor_x) * plane.dx) -
                    static_cast<std::uint32_t>(span.anchor_y) * plane.dy,
                plane.dy};
    }
    SPANGLE_INLINE static std::uint32_t at(const Origin& plane, std::uint32_t x, std::uint32_t y,
                                           std::uint32_t dx) {
        const auto [value, dy] = numeric::load_two(plane);
        return numeric::factor32(value + y * dy) + x * dx;
    }
    SPANGLE_INLINE static std::uint8_t* place(const Plane& plane, std::int32_t y, std::int32_t x) {
        const auto [first, stride] = numeric::load_two(plane);
        return numeric::factor32(first + std::ptrdiff_t{y} * stride) + std::ptrdiff_t{2} * x;
    }
    SPANGLE_INLINE static bool test(std::uint8_t* at, std::uint32_t z) {
        if constexpr (Case::tested) {
            if (!compare<Case::key.depth>(z, N::L::load(at)))
                return false;
            if constexpr (Case::key.depth_write)
                N::L::store(at, z);
        }
        return true;
    }
    /// The number of the texel at s and t, counted from the first texel of the image.
    SPANGLE_INLINE std::uint32_t texel(std::uint32_t s, std::uint32_t t) const {
        const auto [width, height] = numeric::load_two(image_size_);
        const auto column = static_cast<std::uint32_t>(std::uint64_t{s} * width >> 32),
                   row = static_cast<std::uint32_t>(std::uint64_t{t} * height >> 32);
        return row * width + column;
    }
    SPANGLE_INLINE static N::Color lit(const std::uint32_t (&light)[lights], std::uint32_t f,
                                       std::uint32_t texel) {
        N::Color color;
        color.texel = texel;
        color.r = color.g = color.b = N::scaled(N::from_affine(light[0]), f);
        if constexpr (!Case::gray) {
            color.g = N::scaled(N::from_affine(light[1]), f);
            color.b = N::scaled(N::from_affine(light[2]), f);
        }
        return color;
    }

    numeric::WordPair<std::uint32_t, std::uint32_t> image_size_; ///< width and height in texels
    /// The texels, and the table of the factors by which texels multiply green.
    numeric::WordPair<const std::uint8_t*, typename Combine::Factors> factor_tables_;
    typename Combine::Factors fifths_table_ = Combine::fifths;
    const std::uint32_t* thresholds_ = nullptr;
    Combine combine_;
    /// The end of the row in the colour plane, and the step of the depth from pixel to pixel.
    numeric::WordPair<std::uint8_t*, std::uint32_t> end_step_z_;
    numeric::WordPair<std::uint32_t, std::uint32_t> step_coord_, step_light_[lights];
    Origin z_, s_, t_, fog_, light_[lights];
    Plane color_, depth_;
};

template <class Case>
SPANGLE_INLINE void fused_fogged_rows(const Span<Fixed>& span, const Row* row, const Row* end) {
    FoggedRows<Case> rows(span);
    do
        rows.draw(*row);
    while (++row != end);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
