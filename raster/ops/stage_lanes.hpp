// NEAREST of one REPEAT image in eight lanes, each of which may read any texel. Only fused spans use it.
#pragma once

#include "raster/ops/stage_texture.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Finds the texels of eight fragments from their coordinates; T is a TextureFixed.
template <class T> class TexelLanes : public T {
  public:
    using N = typename T::System;
    using L = typename N::L;
    static constexpr unsigned in = T::in & field_color, out = T::out;
    template <class S>
    SPANGLE_INLINE TexelLanes(const S& span, std::int32_t x)
        : T(span, x), width_(size(this->log2_width)), height_(size(this->log2_height)) {}

    /// True for images of at most 2^16 texels: the high 16 bits of the coordinates are enough to tell all
    /// texels apart.
    SPANGLE_INLINE bool is_small() const {
        return this->log2_width < 16 && this->log2_height < 16 && this->log2_width + this->log2_height <= 16;
    }
    /// The words of the texels with these numbers, which count from the first texel of the image.
    SPANGLE_INLINE auto words_of(const std::uint16_t* index) const {
        return T::words([&](std::uint32_t k)
                            __attribute__((always_inline)) { return T::texel(this->texels, index[k]); });
    }

    /// The numbers of the texels at s and t, which are the high halves of coordinates. Images are those of
    /// is_small().
    SPANGLE_INLINE typename L::U16 index_at(const typename L::U16& s, const typename L::U16& t) const {
        return L::mul_high(t, height_) * width_ + L::mul_high(s, width_);
    }
    /// The plane of s with nearest_bias() added; t_plane() does the same for t.
    template <class S> SPANGLE_INLINE Span<Fixed>::Affine s_plane(const S& span, int unit) const {
        return {span.s[unit].value + nearest_bias(this->log2_width), span.s[unit].dx, span.s[unit].dy};
    }
    template <class S> SPANGLE_INLINE Span<Fixed>::Affine t_plane(const S& span, int unit) const {
        return {span.t[unit].value + nearest_bias(this->log2_height), span.t[unit].dx, span.t[unit].dy};
    }

  protected:
    /// The words of the texels with these numbers, which count from the first texel of the image.
    SPANGLE_INLINE auto words_of(const typename L::U32& index) const {
        // Each address is computed from a scalar, so the vectors of numbers are stored and read back word by
        // word.
        alignas(16) std::uint32_t at[2][4];
        __builtin_memcpy(at[0], &index.even, 16);
        __builtin_memcpy(at[1], &index.odd, 16);
        return T::words([&](std::uint32_t k) __attribute__((always_inline)) {
            return T::texel(this->texels, at[k & 1][k >> 1]);
        });
    }
    /// The words of the texels with these numbers, in images of at most 2^16 texels.
    SPANGLE_INLINE auto words_of(const typename L::U16& index) const {
        return T::words([&](std::uint32_t k)
                            __attribute__((always_inline)) { return T::texel(this->texels, index[k]); });
    }
    /// The words of the texels at s and t, which include nearest_bias(). A coordinate is in units of 2^-32 of
    /// the repeat, so every value lies inside of the image.
    SPANGLE_INLINE auto words_at(const typename L::U32& s, const typename L::U32& t) const {
        return words_of((texel(t, this->log2_height) << this->log2_width) | texel(s, this->log2_width));
    }

  private:
    typename L::U16 width_, height_;
    /// The number of texels along an axis. A size of 2^16 does not fit 16 bits; the product with it is not
    /// used then.
    SPANGLE_INLINE static typename L::U16 size(int log2_size) { return L::splat(1u << (log2_size & 15)); }
    /// The number of the texel along an axis. The shift stays below 32 even where the axis has one texel.
    SPANGLE_INLINE static typename L::U32 texel(const typename L::U32& v, int log2_size) {
        return v >> 1 >> (31 - log2_size);
    }
};

/// The NEAREST filter for coordinates that are affine over the primitive.
template <class T, int Unit> class NearestLanes : public TexelLanes<T> {
  public:
    using N = typename T::System;
    using L = typename N::L;
    template <class S>
    SPANGLE_INLINE NearestLanes(const S& span, std::int32_t x)
        : TexelLanes<T>(span, x), s_(span, x, span.s[Unit], nearest_bias(this->log2_width)),
          t_(span, x, span.t[Unit], nearest_bias(this->log2_height)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        return this->combine_words(p, this->words_at(s_.at, t_.at));
    }
    SPANGLE_INLINE void step() {
        s_.step();
        t_.step();
    }
    template <class S> SPANGLE_INLINE void start(const S& span, std::int32_t x) {
        s_.start(span, x, span.s[Unit], nearest_bias(this->log2_width));
        t_.start(span, x, span.t[Unit], nearest_bias(this->log2_height));
    }

  private:
    Ramp<L> s_, t_;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
