// Lit textures of the exact tier, eight fragments at a time: everything is guessed in 16 bits, as far as
// these decide the texel and the bits that are stored. The others, one in thirty, are left open (Px::open)
// and redone with one lane. Fused spans only.
#pragma once

#include "raster/span/near_division.hpp"
#include "raster/span/rows.hpp"
#include "raster/span/stage_lanes.hpp"
#include "raster/span/stage_store.hpp"

namespace spangle::raster {

/// What is guessed of a component, and by how much that may be wrong, where its colour and fog are not.
///
/// In 256ths of 255ths: the colour, rounded to these, is off by 1/2; a factor F of 16 bits stands for (F + e)
/// / 2^16, 0 <= e <= 1, and products are rounded down, so the modulated colour is up to 1/2 less than the
/// guess and up to 5/2 more. Fog adds two products, again with factors whose sum is one less than 2^16: up to
/// 3 more. What the exact tier rounds away is less than 2^-10. 1/2 is added to round to 255ths.
template <bool Fog> struct LitGuess { static constexpr std::uint32_t under = 1, over = Fog ? 5 : 2; };

/// The attributes of a lit texture near a place. Full: colours are projective; Gray: red stands for all
/// three.
template <bool Full, bool Gray, bool Fog, class Products = NearHalves> struct LitPatch {
    static constexpr int unit = 0, colors = Gray ? 1 : 3;
    Interpolant<std::uint32_t> u;
    NearQuotient s, t, color[3], fog;
    /// How much less or more than guessed a component may be but for what its products leave out: 256ths of
    /// 255ths, with the fraction bits of these.
    std::uint32_t under, over;

    /// False where 16 bits do not do.
    [[gnu::noinline]] bool set(const Span<Fixed>& span, const Patch& patch) {
        const NearDivisionOf<Products> by(span, patch);
        const DrawState& state = *span.state;
        const auto& at = span.unit[unit];
        const int width = state.log2_width[unit], height = state.log2_height[unit];
        if (!by.serves || width > most_log2_size || height > most_log2_size ||
            !by.quotient(s, at.s, at.exponent, nearest_bias(width)) ||
            !by.quotient(t, at.t, at.exponent, nearest_bias(height)))
            return false;
        std::uint32_t color_window = 1, fog_off = 0;
        for (int i = 0; Full && i < colors; ++i) {
            if (!by.quotient(color[i], span.color_q[i], 0))
                return false;
            color[i].base = limited(color[i].base);
            color_window = color[i].window > color_window ? color[i].window : color_window;
        }
        if (Fog) {
            if (!by.quotient(fog, span.fog_q, usual_fog))
                return false;
            const auto half = static_cast<std::int32_t>((fog.window - 1) >> Products::fraction_bits) / 2;
            fog.base = limited(fog.base + half);
            fog_off = fog.window - 1 - (static_cast<std::uint32_t>(half) << Products::fraction_bits);
        }
        u = by.u;
        // A colour is off by `window`. Where the factor of fog is off by -f .. f + 1, so is the sum.
        under = fog_off;
        over = color_window - 1 + fog_off;
        return true;
    }

  private:
    static constexpr int usual_fog = 6, most_log2_size = 10; ///< more has few bits within a texel

    /// Where even the least or the largest of() leaves it beyond 0 and 1, so does the next base.
    SPANGLE_INLINE static std::int32_t limited(std::int32_t base) {
        return numeric::clamp<std::int32_t>(base, -INT16_MAX, 0xFFFF - INT16_MIN);
    }
};

/// A row of a patch.
template <class Patch> struct LitRow : PlaneRow { const Patch& patch; };

/// A texel's number along one axis.
class LitAxis {
  public:
    using L = Lanes<8>;
    SPANGLE_INLINE LitAxis(const PlaneRow& row, std::int32_t x, const NearQuotient& of, int log2_size)
        : d_(row, x, of.d), base_(L::splat(static_cast<std::uint32_t>(of.base))),
          window_(L::splat(of.window)), whole_(L::splat(0xFFFF0000u >> log2_size)),
          down_(static_cast<std::uint16_t>(16 - log2_size)) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    SPANGLE_INLINE void step() { d_.step(); }
    SPANGLE_INLINE L::U16 texel(L::U16& open, const NearInverse& inverse) const {
        const L::U16 v = inverse.of(d_.whole()) + base_;
        open |= ((v + window_) ^ v) & whole_;
        return v >> down_;
    }

  private:
    NearRamp d_;
    L::U16 base_, window_, whole_;
    std::uint16_t down_;
};

/// A quotient, limited to what it can be.
class LitRatio {
  public:
    using L = Lanes<8>;
    SPANGLE_INLINE LitRatio(const PlaneRow& row, std::int32_t x, const NearQuotient& of, std::int32_t most)
        : d_(row, x, of.d), base_(L::splat(static_cast<std::uint32_t>(of.base))),
          least_(L::splat(of.least())), largest_(L::splat(of.largest(most))) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    SPANGLE_INLINE void step() { d_.step(); }
    SPANGLE_INLINE L::U16 at(const NearInverse& inverse) const {
        return base_ + L::clamped_signed(inverse.of(d_.whole()), least_, largest_);
    }

  private:
    NearRamp d_;
    L::U16 base_, least_, largest_;
};

/// A colour, affine or not, in 256ths of 255ths. Half of one was added to affine ones in set-up.
template <bool Full> class LitColor {
  public:
    using L = Lanes<8>;
    template <class Patch>
    SPANGLE_INLINE LitColor(const PlaneRow& row, std::int32_t x, const Patch& patch, int i)
        : v_(make(row, x, patch, i)) {}
    template <class Patch>
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const Patch& patch, int i) {
        if constexpr (Full)
            v_.start(row, x, patch.color[i]);
        else
            v_.start(row, x, row.color_value[i]);
    }
    SPANGLE_INLINE void step() { v_.step(); }
    SPANGLE_INLINE L::U16 at(const NearInverse& inverse) const {
        if constexpr (Full)
            return v_.at(inverse);
        else
            return L::high_half(v_.at);
    }

  private:
    using V = std::conditional_t<Full, LitRatio, Ramp<L>>;
    template <class Patch>
    SPANGLE_INLINE static V make(const PlaneRow& row, std::int32_t x, const Patch& patch, int i) {
        if constexpr (Full)
            return V(row, x, patch.color[i], 255 << 8);
        else
            return V(row, x, row.color_value[i]);
    }
    V v_;
};

/// MODULATE, fog and truncation, T a TextureFixed. A component is rounded to 255ths: 1/2 is added.
template <class T, bool Full, bool Gray, bool HasFog> class LitGuessed : public TexelLanes<T> {
  public:
    using N = Raw565<8>;
    using L = N::L;
    using Patch = LitPatch<Full, Gray, HasFog>;
    static constexpr unsigned in = 0, out = field_color;

    SPANGLE_INLINE LitGuessed(const LitRow<Patch>& row, std::int32_t x)
        : TexelLanes<T>(row, x), patch_(row.patch), u_(row, x, patch_.u),
          s_(row, x, patch_.s, this->log2_width), t_(row, x, patch_.t, this->log2_height), fog_(fog(row, x)),
          r_(row, x, patch_, 0), g_(other(row, x, 1)), b_(other(row, x, 2)),
          from_(L::splat(128 - Guess::under - patch_.under)),
          range_(L::splat(Guess::under + Guess::over + patch_.under + patch_.over)) {
        for (int i = 0; i < 3; ++i)
            fog_color_[i] = L::splat((row.state->fragment.fog_color[i] + (1u << 11)) >> 12);
    }
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x) {
        u_.start(row, x, patch_.u);
        s_.start(row, x, patch_.s);
        t_.start(row, x, patch_.t);
        if constexpr (HasFog)
            fog_.start(row, x, patch_.fog);
        r_.start(row, x, patch_, 0);
        if constexpr (!Gray) {
            g_.start(row, x, patch_, 1);
            b_.start(row, x, patch_, 2);
        }
    }
    SPANGLE_INLINE void step() {
        u_.step();
        s_.step();
        t_.step();
        fog_.step();
        r_.step();
        g_.step();
        b_.step();
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const NearInverse inverse(u_.whole());
        L::U16 open{};
        const L::U16 s = s_.texel(open, inverse), t = t_.texel(open, inverse);
        const Factors factor = factors_of(texels_at(s, t));
        L::U16 f{};
        if constexpr (HasFog)
            f = fog_.at(inverse);
        const auto share = [&](const Color& c) __attribute__((always_inline)) {
            const L::U16 v = c.at(inverse);
            return HasFog ? L::mul_high(v, f) : v;
        };
        const L::U16 r = share(r_);
        L::U16 g = r, b = r;
        if constexpr (!Gray) {
            g = share(g_);
            b = share(b_);
        }
        const L::U16 rest = ~f;
        p.color.word = (bits(open, lit(r, factor.r, rest, 0), 0xF800) & 0xF800) |
                       ((bits(open, lit(g, factor.g, rest, 1), 0xFC00) >> 5) & 0x07E0) |
                       (bits(open, lit(b, factor.b, rest, 2), 0xF800) >> 11);
        p.open = open;
        return true;
    }

  private:
    static constexpr bool is_565 = T::texel_format == TexelFormat::rgb565;
    using Color = LitColor<Full>;
    using Guess = LitGuess<HasFog>;

    SPANGLE_INLINE static auto other(const LitRow<Patch>& row, std::int32_t x, int i) {
        if constexpr (Gray)
            return StageBase{};
        else
            return Color(row, x, row.patch, i);
    }
    SPANGLE_INLINE static auto fog(const LitRow<Patch>& row, std::int32_t x) {
        if constexpr (HasFog)
            return LitRatio(row, x, row.patch.fog, 0xFFFF);
        else
            return StageBase{};
    }
    struct Factors {
        L::U16 r, g, b;
    };
    SPANGLE_INLINE auto texels_at(const L::U16& s, const L::U16& t) const {
        const int width = this->log2_width;
        if (width + this->log2_height <= 16) [[likely]]
            return this->words_of(static_cast<L::U16>((t << static_cast<std::uint16_t>(width)) | s));
        return this->words_of((L::widened(t) << width) | L::widened(s));
    }
    /// k / (2^bits - 1), to be multiplied by in 16 bits (LitPatch::set): their bits over and over.
    SPANGLE_INLINE static Factors factors_of(const auto& texels) {
        if constexpr (is_565)
            return {repeated<5>(texels & 0xF800), repeated<6>((texels << 5) & 0xFC00),
                    repeated<5>(texels << 11)};
        else
            return {repeated8(L::byte(texels, 0)), repeated8(L::byte(texels, 1)),
                    repeated8(L::byte(texels, 2))};
    }
    template <unsigned Bits> SPANGLE_INLINE static L::U16 repeated(const L::U16& top) {
        constexpr std::uint32_t again = (1u << (16 - Bits)) + (1u << (16 - 2 * Bits)) + (Bits == 5 ? 2 : 0);
        return top + L::mul_high(top, L::splat(again));
    }
    SPANGLE_INLINE static L::U16 repeated8(const L::U16& k) { return k | k << 8; }
    SPANGLE_INLINE L::U16 lit(L::U16 c, L::U16 factor, L::U16 rest, int i) const {
        const L::U16 v = L::mul_high(c, factor);
        return HasFog ? v + L::mul_high(fog_color_[i], rest) : v;
    }
    /// Top bits of a component, and whether an error could change any.
    SPANGLE_INLINE L::U16 bits(L::U16& open, L::U16 v, std::uint32_t mask) const {
        const L::U16 least = v + from_;
        open |= ((least + range_) ^ least) & L::splat(mask);
        return least;
    }

    const Patch& patch_;
    NearRamp u_;
    LitAxis s_, t_;
    [[no_unique_address]] std::conditional_t<HasFog, LitRatio, StageBase> fog_;
    Color r_;
    [[no_unique_address]] std::conditional_t<Gray, StageBase, Color> g_, b_;
    L::U16 from_, range_, fog_color_[3];
};

} // namespace spangle::raster
