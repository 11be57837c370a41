// Lit textures of the exact tier, eight fragments at a time. All attributes are guessed in 16 bits. The guess
// counts where it decides the texel and the bits that are stored. Every other fragment, about one in thirty,
// is left open (Px::open) and drawn again with one lane. Only fused spans use this file.
#pragma once

#include "raster/ops/near_division.hpp"
#include "raster/ops/stage_lanes.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// By how much a guessed component may be wrong where its colour and its fog factor are exact. The unit is a
/// 256th of a 255th.
/// - A colour that is rounded to this unit is off by up to 1/2.
/// - A factor F of 16 bits stands for (F + e) / 2^16 with 0 <= e <= 1, and products are rounded down.
/// - So the modulated colour is at most 1/2 less than the guess and at most 5/2 more.
/// - Fog adds two products whose factors sum to 2^16 - 1, which makes up to 3 more.
/// - The rounding of the exact tier is less than 2^-10.
/// - To round to 255ths, 1/2 is added.
/// - Where colours are dithered, a product that is rounded down makes steps of 5 or 6 bits. It makes no error
///   larger.
template <bool Fog> struct LitGuess { static constexpr std::uint32_t under = 1, over = Fog ? 5 : 2; };

/// The attributes of a lit texture near a place. Full: colours are projective. Gray: red stands for all three
/// components.
template <bool Full, bool Gray, bool Fog, class Products = NearHalves> struct LitPatch {
    static constexpr int unit = 0, colors = Gray ? 1 : 3;
    Interpolant<std::uint32_t> u;
    NearQuotient s, t, color[3], fog;
    /// How much less (`under`) or more (`over`) than the guess a component may be, beyond the errors of
    /// LitGuess. The unit is a 256th of a 255th, with the fraction bits of the products.
    std::uint32_t under, over;

    /// Prepares the attributes around a patch. Returns false where 16 bits are not enough.
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
            color[i].base = limit_base(color[i].base);
            color_window = color[i].window > color_window ? color[i].window : color_window;
        }
        if (Fog) {
            if (!by.quotient(fog, span.fog_q, usual_fog))
                return false;
            const auto half = static_cast<std::int32_t>((fog.window - 1) >> Products::fraction_bits) / 2;
            fog.base = limit_base(fog.base + half);
            fog_off = fog.window - 1 - (static_cast<std::uint32_t>(half) << Products::fraction_bits);
        }
        u = by.u;
        // A colour is off by less than its window. Where the fog factor is off by -f .. f + 1, so is the sum
        // of the fogged colour.
        under = fog_off;
        over = color_window - 1 + fog_off;
        return true;
    }

  private:
    /// An image larger than 2^most_log2_size leaves too few bits within a texel.
    static constexpr int usual_fog = 6, most_log2_size = 10;

    /// Limits the base of a quotient. With a base beyond the limits the sum lies outside of 0 and 1 whatever
    /// NearInverse::of() adds. The limit leads to the same clamped result.
    SPANGLE_INLINE static std::int32_t limit_base(std::int32_t base) {
        return numeric::clamp<std::int32_t>(base, -INT16_MAX, 0xFFFF - INT16_MIN);
    }
};

/// A row of fragments inside of a patch.
template <class Patch> struct LitRow : PlaneRow { const Patch& patch; };

/// A coordinate in 2^-16 of the image, for NEAREST. Lanes whose texel is in doubt become open.
class LitAxis {
  public:
    using L = Lanes<8>;
    SPANGLE_INLINE LitAxis(const NearQuotient& of, int log2_size)
        : base_(L::splat(static_cast<std::uint32_t>(of.base))), window_(L::splat(of.window)),
          whole_texels_(L::splat(0xFFFF0000u >> log2_size)) {}
    SPANGLE_INLINE L::U16 at(L::U16& open, const L::U16& d, const NearInverse& inverse) const {
        const L::U16 v = inverse.of(d) + base_;
        open |= ((v + window_) ^ v) & whole_texels_;
        return v;
    }

  private:
    L::U16 base_, window_, whole_texels_;
};

/// A quotient that is limited to the range of its attribute.
class LitRatio {
  public:
    using L = Lanes<8>;
    SPANGLE_INLINE LitRatio(const NearQuotient& of, std::int32_t most)
        : base_(L::splat(static_cast<std::uint32_t>(of.base))), least_(L::splat(of.least())),
          largest_(L::splat(of.largest_error(most))) {}
    SPANGLE_INLINE L::U16 at(const L::U16& d, const NearInverse& inverse) const {
        return base_ + L::clamped_signed(inverse.of(d), least_, largest_);
    }

  private:
    L::U16 base_, least_, largest_;
};

/// The depth test, MODULATE, fog, and truncation or dithering. T is a TextureFixed. A component that is not
/// dithered is rounded to 255ths: 1/2 is added.
template <class Test, class T, bool Full, bool Gray, bool HasFog, bool Dither>
class LitGuessed : public TexelLanes<T> {
  public:
    using N = Raw565<8>;
    using L = N::L;
    using Patch = LitPatch<Full, Gray, HasFog>;
    static constexpr unsigned in = 0, out = field_color;
    static constexpr bool kill = Test::kill, effect = Test::effect;

    SPANGLE_INLINE LitGuessed(const LitRow<Patch>& row, std::int32_t x)
        : TexelLanes<T>(row, x), test_(row, x), patch_(row.patch), is_small_(this->is_small()),
          planes_(planes(row, x)), values_(values(row, x)), s_(patch_.s, this->log2_width),
          t_(patch_.t, this->log2_height), fog_(fog(patch_)), r_(color(row, x, 0)), g_(other(row, x, 1)),
          b_(other(row, x, 2)), thresholds_(row.x + x, row.y),
          from_(L::splat((Dither ? 0 : 128) - Guess::under - patch_.under)),
          range_(L::splat(Guess::under + Guess::over + Dither + patch_.under + patch_.over)) {
        for (int i = 0; i < 3; ++i)
            fog_color_[i] = L::splat((row.state->fragment.fog_color[i] + (1u << 11)) >> 12);
    }
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x) {
        thresholds_ = Thresholds(row.x + x, row.y);
        planes_.start(row.x + x, row.y);
        values_.start(row.x + x, row.y);
        if constexpr (Test::kill)
            test_.z.start(values_.template first<0>());
        if constexpr (!Full)
            r_.start(values_.template first<1>());
        if constexpr (!Full && !Gray) {
            g_.start(values_.template first<2>());
            b_.start(values_.template first<3>());
        }
    }
    SPANGLE_INLINE void step() {
        test_.step();
        planes_.step();
        if constexpr (Full) {
            values_.step();
        } else {
            r_.step();
            g_.step();
            b_.step();
        }
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if (!test_(p))
            return false;
        const NearInverse inverse(planes_.template whole<0>());
        L::U16 open{};
        const L::U16 s = s_.at(open, planes_.template whole<1>(), inverse),
                     t = t_.at(open, planes_.template whole<2>(), inverse);
        const Factors factor = factors_of(texels_at(s, t));
        L::U16 f{};
        if constexpr (HasFog)
            f = fog_.at(planes_.template whole<3>(), inverse);
        const L::U16 r = share<0>(r_, f, inverse);
        L::U16 g = r, b = r;
        if constexpr (!Gray) {
            g = share<1>(g_, f, inverse);
            b = share<2>(b_, f, inverse);
        }
        const L::U16 rest = ~f;
        p.color.word = (bits<5>(open, lit(r, factor.r, rest, 0)) & 0xF800) |
                       ((bits<6>(open, lit(g, factor.g, rest, 1)) >> 5) & 0x07E0) |
                       (bits<5>(open, lit(b, factor.b, rest, 2)) >> 11);
        p.open = open;
        return true;
    }

  private:
    static constexpr bool is_565 = T::texel_format == TexelFormat::rgb565;
    /// The type of a colour, divided or affine, in 256ths of 255ths. Set-up has added half of this unit to
    /// affine colours.
    using Color = std::conditional_t<Full, LitRatio, Ramp<L>>;
    using Guess = LitGuess<HasFog>;
    using Thresholds = std::conditional_t<Dither, inner::DitherRow<L>, inner::NoThreshold>;

    /// The plane of u, and the planes of the attributes other than colours that are divided by it.
    SPANGLE_INLINE static auto planes(const LitRow<Patch>& row, std::int32_t x) {
        const Patch& of = row.patch;
        if constexpr (HasFog)
            return NearPlanes<4>(row, x, of.u, of.s.d, of.t.d, of.fog.d);
        else
            return NearPlanes<3>(row, x, of.u, of.s.d, of.t.d);
    }
    /// The plane of depth, where depth is tested, and the planes of colours.
    SPANGLE_INLINE static auto values(const LitRow<Patch>& row, std::int32_t x) {
        const auto depth = Test::kill ? row.z : Interpolant<std::uint32_t>{};
        const auto value = [&](int i) __attribute__((always_inline)) {
            return Full ? row.patch.color[i].d : row.color_value[i];
        };
        if constexpr (Gray)
            return NearPlanes<2>(row, x, depth, value(0));
        else
            return NearPlanes<4>(row, x, depth, value(0), value(1), value(2));
    }

    SPANGLE_INLINE static Color color(const LitRow<Patch>& row, std::int32_t x, int i) {
        if constexpr (Full)
            return LitRatio(row.patch.color[i], 255 << 8);
        else
            return Ramp<L>(row, x, row.color_value[i]);
    }
    /// Component I of the light, times the fog factor where there is fog.
    template <int I>
    SPANGLE_INLINE L::U16 share(const Color& c, const L::U16& f, const NearInverse& inverse) const {
        L::U16 v;
        if constexpr (Full)
            v = c.at(values_.template whole<1 + I>(), inverse);
        else
            v = L::high_half(c.at);
        return HasFog ? L::mul_high(v, f) : v;
    }
    SPANGLE_INLINE static auto other(const LitRow<Patch>& row, std::int32_t x, int i) {
        if constexpr (Gray)
            return StageBase{};
        else
            return color(row, x, i);
    }
    SPANGLE_INLINE static auto fog(const Patch& patch) {
        if constexpr (HasFog)
            return LitRatio(patch.fog, 0xFFFF);
        else
            return StageBase{};
    }
    struct Factors {
        L::U16 r, g, b;
    };
    SPANGLE_INLINE auto texels_at(const L::U16& s, const L::U16& t) const {
        if (is_small_) [[likely]]
            return this->words_of(this->index_at(s, t));
        return this->words_at(L::widened(s) << 16, L::widened(t) << 16);
    }
    /// Factors of 16 bits that stand for k / (2^bits - 1), as LitGuess assumes. The bits of k are repeated.
    SPANGLE_INLINE static Factors factors_of(const auto& texels) {
        if constexpr (is_565)
            return {repeated<5>(texels & 0xF800), repeated<6>((texels << 5) & 0xFC00),
                    repeated<5>(texels << 11)};
        else
            return {replicate_bits(L::byte(texels, 0)), replicate_bits(L::byte(texels, 1)),
                    replicate_bits(L::byte(texels, 2))};
    }
    template <unsigned Bits> SPANGLE_INLINE static L::U16 repeated(const L::U16& top) {
        constexpr std::uint32_t again = (1u << (16 - Bits)) + (1u << (16 - 2 * Bits)) + (Bits == 5 ? 2 : 0);
        return top + L::mul_high(top, L::splat(again));
    }
    SPANGLE_INLINE static L::U16 replicate_bits(const L::U16& k) { return k | k << 8; }
    SPANGLE_INLINE L::U16 lit(L::U16 c, L::U16 factor, L::U16 rest, int i) const {
        const L::U16 v = L::mul_high(c, factor);
        return HasFog ? v + L::mul_high(fog_color_[i], rest) : v;
    }
    /// The least value that a component, of which the top bits are stored, may have. Lanes in which an error
    /// could change the stored bits become open.
    template <unsigned Bits> SPANGLE_INLINE L::U16 bits(L::U16& open, L::U16 v) const {
        L::U16 least = v + from_;
        if constexpr (Dither)
            least = Balanced<8>::steps<Bits>(v) + from_ + (thresholds_.threshold() << (11 - Bits));
        open |= ((least + range_) ^ least) & L::splat(0x10000 - (1u << (16 - Bits)));
        return least;
    }

    [[no_unique_address]] Test test_;
    const Patch& patch_;
    const bool is_small_;
    NearPlanes<HasFog ? 4 : 3> planes_;
    NearPlanes<1 + Patch::colors> values_;
    LitAxis s_, t_;
    [[no_unique_address]] std::conditional_t<HasFog, LitRatio, StageBase> fog_;
    Color r_;
    [[no_unique_address]] std::conditional_t<Gray, StageBase, Color> g_, b_;
    [[no_unique_address]] Thresholds thresholds_;
    L::U16 from_, range_, fog_color_[3];
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
