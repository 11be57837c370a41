// Makes a fused loop from a key. It has the stages of the chain, with modes that the compiler knows.
#pragma once

#include "raster/fused/fused.hpp"
#include "raster/fused/table.hpp"
#include "raster/fused/tile.hpp"
#include "raster/fused/trapezoids.hpp"
#include "raster/ops/number_packed.hpp"
#include "raster/ops/stage_blend.hpp"
#include "raster/ops/stage_color.hpp"
#include "raster/ops/stage_coord.hpp"
#include "raster/ops/stage_depth.hpp"
#include "raster/ops/stage_dithered.hpp"
#include "raster/ops/stage_divided.hpp"
#include "raster/ops/stage_fog.hpp"
#include "raster/ops/stage_fogged.hpp"
#include "raster/ops/stage_fogged_light.hpp"
#include "raster/ops/stage_guess.hpp"
#include "raster/ops/stage_lanes.hpp"
#include "raster/ops/stage_linear.hpp"
#include "raster/ops/stage_lit_store.hpp"
#include "raster/ops/stage_nearest.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/ops/stage_texture.hpp"
#include "raster/span/fill.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/key.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Takes the place of a stage that a key does not need. I keeps the bases of a Seq distinct.
template <class N, int I> struct NoStage : StageBase {
    template <class S> SPANGLE_INLINE NoStage(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>&) const { return true; }
};

/// Whether fused lists can draw a key. The chain draws all other keys.
constexpr bool is_fusible_key(const Key& key) {
    return !key.second_unit() && !key.unit[0].general && !key.color_sum && !key.stencil && !key.masked &&
           !key.logic && !key.count && key.alpha == Compare::always &&
           (!key.fog || key.fog_mode == FogMode::linear) &&
           (!key.blend || (!key.blend_general && key.blending == blend_over)) &&
           key.depth_format != DepthFormat::z24s8;
}

/// Whether colours are perspective-correct and are stored without any stage in between.
constexpr bool is_guessed(const Key& key) {
    return key.number == Number::exact && key.kind == Kind::full && !key.unit[0].on && !key.fog &&
           !key.blend && is_565(key.format);
}

/// Whether four words of a texture are filtered into one word (filter_words.hpp). With one lane this needs
/// colours in steps. Dithered colours are in steps already. Other colours are converted only where branches
/// and tables are cheap.
constexpr bool filters_words(const Key& key) {
    return (numeric::cheap_branches || key.dither || host_lanes == 8) && key.number == Number::exact &&
           !key.fog && !key.blend && is_565(key.format) &&
           key.unit[0] ==
               UnitKey{true, false, TexelFormat::rgb565, BaseFormat::rgb, Filter::linear, TexEnv::replace};
}

/// The functions that draw the tiles and trapezoids of a case. trapezoids_of holds a function for trapezoids
/// alone.
template <class Case> inline constexpr Shapes shapes_of = {&fused_tile<Case>, &fused_trapezoids<Case>};
template <void (*Draw)(Span<Fixed>&, const Trapezoids&)>
inline constexpr Shapes trapezoids_of = {nullptr, Draw};

/// The fused loops of a key. Gray: they draw only primitives whose colours are gray. Apart: every attribute
/// over w divides for itself, as in the chain. This serves primitives that the stages of stage_divided.hpp
/// cannot draw.
template <Key K, bool Gray = false, bool Apart = false> class FusedCase {
    static_assert(is_fusible_key(K));
    static constexpr bool textured = K.unit[0].on;
    template <class N>
    using Image = TextureFixed<N, 0, K.unit[0].texels, K.unit[0].base, K.unit[0].filter, K.unit[0].env,
                               counts_steps(K)>;
    /// How texels are loaded that light is multiplied by (MODULATE): as words R5 G6 B5, or as any kind of
    /// RGB.
    static constexpr bool words_565 = K.unit[0].texels == TexelFormat::rgb565,
                          loads_rgb = words_565 || K.unit[0].texels == TexelFormat::rgb888;
    static constexpr bool raw = K.number == Number::raw565 || is_guessed(K) || filters_words(K),
                          exact = K.number == Number::exact && !raw;
    /// Whether the texel is the fragment's colour until it is blended.
    static constexpr bool packed =
        K.unit[0] ==
            UnitKey{true, false, TexelFormat::rgba8888, BaseFormat::rgba, Filter::nearest, TexEnv::replace} &&
        K.blend && !K.fog && is_565(K.format);
    /// Whether colours are projective (`full`), and whether texture coordinates and fog are (`projective`).
    static constexpr bool full = K.kind == Kind::full, projective = full || K.kind == Kind::textured;
    static constexpr bool divided = divides(K.kind, K.fog) && !is_guessed(K);
    /// Whether the store includes fog (`stores_fogged`), or fog and MODULATE (`stores_light`).
    template <int L>
    static constexpr bool stores_fogged = L == 1 && exact&& K.fog && !K.blend && is_565(K.format);
    template <int L>
    static constexpr bool stores_light = L == 1 && fogs_light(K) && !K.blend &&
                                         is_565(K.format) && K.unit[0].filter == Filter::nearest && loads_rgb;
    /// Whether the one 1/w of the fragment divides texture coordinates, too.
    static constexpr bool shares_division =
        textured && divides(K.kind, K.fog) && exact && K.unit[0].filter == Filter::nearest;

  public:
    /// Whether divided attributes are drawn in patches, over which 16 bits are enough.
    static constexpr bool lit = exact && divided && textured && K.unit[0].filter == Filter::nearest &&
                                K.unit[0].env == TexEnv::modulate && loads_rgb && K.color && !K.color_alpha &&
                                !K.blend && is_565(K.format) && !Apart;
    /// Whether lit fragments are drawn by products of half-words in the loop of one lane, because the
    /// processor has no long products.
    static constexpr bool halved = lit && !numeric::long_products;

    static constexpr bool tested = K.depth != Compare::always || K.depth_write;
    /// Whether the key has depths and colours only. Rows are PlaneRows then.
    static constexpr bool plain = raw && !textured;
    static constexpr bool patterned = plain && K.kind == Kind::flat && K.dither;

  private:
    /// Whether lanes can draw the key. Lanes have neither the 64 bits that Exact needs nor a division for
    /// each fragment.
    static constexpr bool laned = (!exact || packed) && !divided && is_565(K.format);
    using Runs = std::conditional_t<
        !projective, NoRuns,
        std::conditional_t<exact && divided, DividedCoords,
                           std::conditional_t<K.number == Number::exact || K.cubic, CubicRuns, CoordRuns>>>;
    template <int L>
    using ExactSystem = std::conditional_t<packed, std::conditional_t<L == 1, PackedExact, ExactBytes<L>>,
                                           std::conditional_t<halved, ExactLit, Exact>>;
    template <int L>
    using CoarseSystem =
        std::conditional_t<packed, std::conditional_t<L == 1, PackedCoarse, CoarseBytes<L>>, Balanced<L>>;
    /// Whether one stage blends and dithers, as it does for packed colours.
    template <class N>
    static constexpr bool bytes_dithered = packed&& K.dither && (std::is_same_v<N, ExactBytes<8>> ||
                                                                 std::is_same_v<N, CoarseBytes<8>>);
    template <class N>
    using Test =
        std::conditional_t<tested, Depth<N, DepthFormat::z16, K.depth, K.depth_write>, NoStage<N, 0>>;
    enum class Walk { rows, few, paths, tiles };
    /// Whether colours come from a pattern of words in the byte order of the surface.
    template <int L, Walk By>
    static constexpr bool in_pattern = patterned &&
                                       ((L == 1 && By != Walk::few) || (L == 8 && By == Walk::rows));
    template <int L, Walk By = Walk::rows> struct Stages {
        using N = std::conditional_t<
            raw, Raw565<L>,
            std::conditional_t<
                exact, ExactSystem<L>,
                std::conditional_t<
                    K.coarse, CoarseSystem<L>,
                    std::conditional_t<packed && L == 1, Packed,
                                       std::conditional_t<stores_light<L>, BalancedLit, Balanced<L>>>>>>;
        static auto divide() {
            if constexpr (divided && !Apart)
                return std::type_identity<Divide<N>>{};
            else
                return std::type_identity<NoStage<N, 5>>{};
        }
        static auto color() {
            if constexpr ((raw && textured) || is_packed<N>)
                return std::type_identity<NoStage<N, 1>>{};
            else if constexpr (raw && K.kind == Kind::flat)
                return std::type_identity<std::conditional_t<
                    !K.dither, FlatWord<L>,
                    std::conditional_t<
                        By == Walk::paths, PathPattern,
                        std::conditional_t<!in_pattern<L, By>, FlatDithered<L>,
                                           std::conditional_t<L == 1, RowPattern, FlatDitheredRows>>>>>{};
            else if constexpr (is_guessed(K))
                return std::type_identity<GouraudGuessed<L, K.dither>>{};
            else if constexpr (raw && K.dither)
                return std::type_identity<std::conditional_t<L == 8 && By == Walk::rows, GouraudDitheredRow,
                                                             GouraudDithered<L, RowFractions<L>>>>{};
            else if constexpr (Gray)
                return std::type_identity<std::conditional_t<full, GouraudGrayDivided<N>, GouraudGray<N>>>{};
            else if constexpr (K.color && full && Apart)
                return std::type_identity<GouraudQ<N, K.color_alpha>>{};
            else if constexpr (K.color && full)
                return std::type_identity<GouraudDivided<N, K.color_alpha>>{};
            else if constexpr (K.color)
                return std::type_identity<Gouraud<N, K.color_alpha>>{};
            else
                return std::type_identity<White<N>>{};
        }
        static auto texture() {
            if constexpr (textured) {
                using Texture = Image<N>;
                if constexpr (K.unit[0].filter == Filter::nearest && L == 8 && K.kind == Kind::affine &&
                              !Texture::loads_words)
                    return std::type_identity<NearestLanes<Texture, 0>>{};
                else if constexpr (shares_division && Apart)
                    return std::type_identity<Seq<N, CoordAlong<N, 0, DividedCoords>, Texture>>{};
                else if constexpr (shares_division)
                    return std::type_identity<NearestDivided<Texture, 0>>{};
                else if constexpr (K.unit[0].filter == Filter::nearest)
                    return std::type_identity<NearestWalk<Texture, 0, Runs>>{};
                else
                    return std::type_identity<LinearWalk<Texture, 0, Runs, raw && K.dither>>{};
            } else {
                return std::type_identity<NoStage<N, 2>>{};
            }
        }
        using FogCoordinate =
            std::conditional_t<!divided, FogCoord<N, false>,
                               std::conditional_t<Apart, FogCoord<N, true>, FogCoordDivided<N>>>;
        static auto fog_light() {
            if constexpr (!fogs_light(K))
                return std::type_identity<NoStage<N, 6>>{};
            else if constexpr (L > 1)
                return std::type_identity<FogLightLanes<N>>{};
            else
                return std::type_identity<Seq<N, FogCoordinate, FogLight<N>>>{};
        }
        static auto fog() {
            if constexpr (!K.fog || stores_light<L>)
                return std::type_identity<NoStage<N, 3>>{};
            else if constexpr (fogs_light(K))
                return std::type_identity<std::conditional_t<(L > 1), FogShareLanes<N, counts_steps(K)>,
                                                             FogShare<N, counts_steps(K)>>>{};
            else if constexpr (stores_fogged<L>)
                return std::type_identity<FogCoordinate>{};
            else
                return std::type_identity<Seq<N, FogCoordinate, FogLinear<N>>>{};
        }
        static auto blend() {
            if constexpr (K.coarse && is_balanced<N>)
                return std::type_identity<BlendCoarse<N, K.format, K.dither>>{};
            else if constexpr (K.blend && !is_packed<N> && !bytes_dithered<N>)
                return std::type_identity<BlendAlpha<N, K.format>>{};
            else
                return std::type_identity<NoStage<N, 4>>{};
        }
        static auto store() {
            if constexpr (in_pattern<L, By>)
                return std::type_identity<StoreRaw<L, K.format, false>>{};
            else if constexpr (raw)
                return std::type_identity<StoreRaw<L, K.format>>{};
            else if constexpr (halved)
                return std::type_identity<LitStore<K.format, words_565, K.fog, K.dither>>{};
            else if constexpr (is_packed<N>)
                return std::type_identity<BlendPacked<N, K.format, K.dither>>{};
            else if constexpr (bytes_dithered<N>)
                return std::type_identity<BlendBytesDithered<N, K.format>>{};
            else if constexpr (stores_fogged<L>)
                return std::type_identity<FoggedStore<K.format, K.dither>>{};
            else if constexpr (stores_light<L>)
                return std::type_identity<FoggedLightStore<K.format, words_565, K.dither>>{};
            else if constexpr (counts_steps(K))
                return std::type_identity<StoreSteps<N, K.format>>{};
            else if constexpr (K.dither && !K.coarse)
                return std::type_identity<StoreDithered<N, K.format>>{};
            else
                return std::type_identity<Store<N, K.format>>{};
        }
        using List = Seq<N, Test<N>, typename decltype(divide())::type, typename decltype(color())::type,
                         typename decltype(fog_light())::type, typename decltype(texture())::type,
                         typename decltype(fog())::type, typename decltype(blend())::type,
                         typename decltype(store())::type>;
    };

  public:
    /// Whether the stages of this case can draw the primitive.
    static bool serves(const Span<Fixed>& span) {
        if constexpr (shares_division) {
            return NearestDivided<Image<Exact>, 0>::serves(span) &&
                   (!K.fog || FogCoordDivided<Exact>::serves(span));
        }
        return true;
    }

    /// fogged: raster/fused/fogged.hpp draws the case by a loop of its own.
    static constexpr bool fogged = numeric::long_products && stores_light<1> && K.kind == Kind::affine &&
                                   !K.color_alpha && K.unit[0].texels == TexelFormat::rgb565,
                          gray = Gray;

    static constexpr Key key = K;
    static constexpr bool apart = Apart, numbered = divided && !Apart;
    static constexpr bool guessed = is_guessed(K);
    static constexpr bool swaps = Words565<Lanes<1>, K.format>::swaps;
    /// The patterns of stored words: for rows (`Pattern`), and for rows in lanes (`LanePattern`).
    using Pattern = std::conditional_t<patterned, DitherRows<swaps>, NoPattern>;
    using LanePattern = std::conditional_t<patterned, DitherLaneRows<K.format>, NoPattern>;
    /// The case for primitives with so few fragments that a pattern costs more than their words.
    struct FewFragments {
        static constexpr Key key = K;
        static constexpr bool tested = FusedCase::tested, patterned = false;
        static constexpr std::int32_t most = 4;
        using Pattern = NoPattern;
        template <int> using System = Raw565<1>;
        template <int> using List = typename Stages<1, Walk::few>::List;
    };
    /// Whether few fragments cost more one by one than in eight lanes with copies of the stored pixels.
    static constexpr bool heavy = laned && (!raw || filters_words(K)) && (textured || K.blend || K.fog);
    /// Whether a loop for gray colours pays. It saves two ramps or two divisions.
    static constexpr bool splits_gray =
        K.fog && K.color && !K.color_alpha && textured && K.unit[0].env == TexEnv::modulate && words_565;
    /// Whether lanes pay. Lanes do not speed up fetches of texels, but the arithmetic on texels.
    static constexpr bool wide = heavy || (laned && !(raw && textured));
    template <int L> using System = typename Stages<L>::N;
    template <int L> using List = typename Stages<L>::List;
    /// The parts of a `lit` case in eight lanes.
    struct Lit {
        static constexpr Key key = K;
        static constexpr bool plain = false, tested = FusedCase::tested;
        using N = Raw565<8>;
        using GuessedStage = LitGuessed<Test<N>, Image<Balanced<8>>, full, Gray, K.fog, K.dither>;
        using Patch = typename GuessedStage::Patch;
        using LanePattern = NoPattern;
        template <int> using System = N;
        template <int> using List = Seq<N, GuessedStage, StoreRaw<8, K.format>>;
        static constexpr Key untested() {
            Key key = K;
            key.depth = Compare::always;
            key.depth_write = false;
            return key;
        }
        [[gnu::noinline]] static void redraw_fragment(Span<Fixed>& span, const Row& fragment) {
            using Case = FusedCase<untested(), Gray>;
            enter_fused<Case>(span, fragment);
            fused_narrow_row<Case>(span, fragment);
        }
        [[gnu::noinline]] static void redo_open(Span<Fixed>& span, const OpenGroup* open,
                                                const OpenGroup* end) {
            fused_open<FusedCase<untested(), Gray>>(span, open, end);
        }
    };
    /// The parts of a `lit` case with one lane.
    template <class Products> struct SingleLane {
        using N = ExactLit;
        using Test = FusedCase::Test<N>;
        using Draw = LitOne<Products, Image<N>, full, Gray, K.fog, K.format, K.dither>;
        using Patch = typename Draw::Patch;
    };
    /// Whether fragments are gathered in a GatheredPacket, whose parts Gathered has.
    static constexpr bool gathered =
        heavy && !exact && tested && textured && !projective && K.unit[0].filter == Filter::nearest &&
        K.unit[0].env == TexEnv::modulate && K.unit[0].base == BaseFormat::rgb && !K.color_alpha && !K.blend;
    struct Gathered {
        static constexpr Key key = K;
        static constexpr bool fogged = K.fog, gray = Gray, tested = true;
        using N = Balanced<8>;
        using Test = FusedCase::Test<N>;
        using Texture = TexelLanes<Image<N>>;
        using Fog = std::conditional_t<fogged, FogFactorLanes<N>, NoStage<N, 0>>;
        using FogColor = std::conditional_t<fogged, FogShare<N, counts_steps(K)>, NoStage<N, 0>>;
    };
    using PathStages = typename Stages<1, Walk::paths>::List;
    template <int L> using TileList = typename Stages<L, Walk::tiles>::List;
    /// Whether paths are drawn through a list of pixels (PathList).
    static constexpr bool listed =
        plain && K.kind == Kind::flat && host_lanes == 8 && !numeric::cheap_branches;

    /// The function that draws paths, which are lines; null where a stage asks for the columns of the window.
    static constexpr PathFunction walk() {
        if constexpr (has_paths && plain && !guessed && !(K.dither && K.kind == Kind::affine))
            return &fused_paths<FusedCase>;
        else
            return nullptr;
    }

    static constexpr const Shapes* shapes() {
        if constexpr (plain && wide && host_lanes == 8)
            return &shapes_of<FusedCase>;
        else if constexpr (gathered && splits_gray)
            return &trapezoids_of<&fused_trapezoids_by_gray<FusedCase, FusedCase<K, true>>>;
        else if constexpr (gathered)
            return &trapezoids_of<&fused_trapezoids<FusedCase>>;
        else
            return nullptr;
    }

    /// Chained: where a primitive cannot share one division, the chain draws it.
    template <int Wide, bool Chained = false>
    static void run_lanes(Span<Fixed>& span, const Row* row, const Row* end) {
        if constexpr (shares_division)
            if (!serves(span)) [[unlikely]]
                return run_apart<Chained>(span, row, end);
        if constexpr (splits_gray) {
            if (span.gray)
                return fused<FusedCase<K, true>, Wide>(span, row, end);
        }
        fused<FusedCase, Wide>(span, row, end);
    }

    static void run(Span<Fixed>& span, const Row* row, const Row* end) {
        if constexpr (plain && K.kind == Kind::flat && !tested) {
            const Pattern pattern(span.flat_word);
            do {
                point_at(span.color, span.depth, *span.target, row->first, row->y,
                         format_info(K.format).bytes_per_pixel, 1);
                fill(span, *row, pattern);
            } while (++row != end);
        } else {
            run_lanes<host_lanes, has_chain>(span, row, end);
        }
    }

  private:
    template <bool Chained> static void run_apart(Span<Fixed>& span, const Row* row, const Row* end) {
        if (splits_gray && span.gray) { // all three components take the one plane that exists
            const auto copy = [](auto& planes) { planes[1] = planes[2] = planes[0]; };
            copy(span.color_value);
            copy(span.color_q);
        }
        if constexpr (Chained)
            reinterpret_cast<RowsFunction<Fixed>>(chain_runner(K.number))(span, row, end);
        else
            fused<FusedCase<K, false, true>, 1>(span, row, end);
    }
    /// Fills a row with one colour. The span points to the first pixel.
    SPANGLE_INLINE static void fill(const Span<Fixed>& span, const Row& row,
                                    [[maybe_unused]] const Pattern& pattern) {
        using Words = Words565<Lanes<1>, K.format>;
        const std::int32_t count = row.last - row.first;
        if constexpr (K.dither)
            fill_columns(span.color, pattern.row(row.y) + (row.first & 3), count);
        else
            fill16(span.color, Words::swaps ? Lanes<1>::swap_bytes(span.flat_word) : span.flat_word, count);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
