// Makes the chain of a key: the stages in GL's order (Red Book, appendix E), one line each. All numeric
// policies use these functions.
#pragma once

#include "raster/chain/chain.hpp"
#include "raster/chain/shared_rows.hpp"
#include "raster/chain/stage_choice.hpp"
#include "raster/ops/stage_antialias.hpp"
#include "raster/ops/stage_blend_packet.hpp"
#include "raster/ops/stage_color.hpp"
#include "raster/ops/stage_color_packet.hpp"
#include "raster/ops/stage_combine.hpp"
#include "raster/ops/stage_coord.hpp"
#include "raster/ops/stage_coord_packet.hpp"
#include "raster/ops/stage_depth.hpp"
#include "raster/ops/stage_divided_packet.hpp"
#include "raster/ops/stage_fog.hpp"
#include "raster/ops/stage_index.hpp"
#include "raster/ops/stage_lod_packet.hpp"
#include "raster/ops/stage_narrow.hpp"
#include "raster/ops/stage_pixels.hpp"
#include "raster/ops/stage_runs_packet.hpp"
#include "raster/ops/stage_samples.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/ops/stage_tests.hpp"
#include "raster/ops/stage_texture_lod.hpp"
#include "raster/ops/stage_texture_packet.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/key.hpp"
#include <spangle/raster/features.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Appends stages to a chain. This part is the same for all number systems.
class ChainEnd {
  protected:
    explicit ChainEnd(Variant& variant) : variant_(variant) {}
    void append(AnyFunction stage) {
        variant_.chain[stage_count_++] = stage;
        variant_.chain[stage_count_] = nullptr;
    }
    Variant& variant_;

  private:
    int stage_count_ = 0;
};

/// Appends stages of number system N to a chain.
template <class N> class ChainBuilder : ChainEnd {
  public:
    explicit ChainBuilder(Variant& variant) : ChainEnd(variant) {
        variant.run = reinterpret_cast<AnyFunction>(&chain_rows<N>);
        if constexpr (N::lanes > 1)
            variant.shares = true;
    }
    /// Makes `run` draw the rows of this chain, in place of chain_rows().
    void runs(RowsFunction<typename N::Policy> run) {
        variant_.run = reinterpret_cast<AnyFunction>(run);
        not_shared();
    }
    template <class S> void add() {
        add(&chain_stage<std::conditional_t<uses_color<S>, N, Colorless<N>>, S>, inner::is_shared<S>);
    }
    /// `shared` says that the stage can draw packets that several rows share.
    SPANGLE_INLINE void add(ChainStage<N> stage, bool shared) {
        append(reinterpret_cast<AnyFunction>(stage));
        if (!shared)
            not_shared();
    }
    template <bool there, class S> void add_if() {
        if constexpr (there)
            add<S>();
    }
    /// Adds the first of two stages where the condition holds, otherwise the second.
    template <class WhenTrue, class WhenFalse> void choose(bool condition) {
        condition ? add<WhenTrue>() : add<WhenFalse>();
    }

  private:
    void not_shared() {
        if constexpr (N::lanes > 1) // chains of one lane never share packets
            variant_.shares = false;
    }
};

/// True where the depth test may go first, because no stage after it can drop the fragment, or because the
/// test has no effect on fragments that are dropped later. The bytes are the same, and dropped fragments cost
/// less.
constexpr bool early_tests(const Key& key) {
    const bool has_effect = key.depth_write || key.stencil || key.count;
    return (key.alpha == Compare::always || !has_effect) && !key.samples;
}

/// Adds the depth stage of the format that the key names.
template <class N, class When16, class When24> void add_depth(ChainBuilder<N>& chain, const Key& key) {
    if constexpr (has_format(DepthFormat::z16))
        if (key.depth_format == DepthFormat::z16)
            return chain.template add<When16>();
    if constexpr (has_format(DepthFormat::z24s8))
        chain.template add<When24>();
}

template <class N> void add_tests(ChainBuilder<N>& chain, const Key& key) {
    using System = Colorless<N>;
    using SingleLane = OneLane<System>;
    using Offset16 = OffsetDepthValue<System>;
    using Offset24 = OffsetDepthValue<System, DepthValueOf<System, DepthFormat::z24s8>>;
    if (SPANGLE_FEATURE_STIPPLE && key.polygon_stipple)
        chain.template add<PolygonStipple<SingleLane>>();
    const bool offset = SPANGLE_FEATURE_POLYGON_OFFSET && offsets_depth(key);
    bool depth = key.depth_offset || key.depth != Compare::always || key.depth_write;
    if constexpr (has_format(DepthFormat::z24s8)) {
        if (key.stencil) {
            chain.template choose<StencilDepth<System, Offset24>, StencilDepth<System>>(offset);
            depth = false; // StencilDepth tests stencil and depth
        }
    }
    if (depth && offset)
        add_depth<N, DepthGeneral<System, DepthFormat::z16, Offset16>,
                  DepthGeneral<System, DepthFormat::z24s8, Offset24>>(chain, key);
    else if (depth)
        add_depth<N, DepthGeneral<System, DepthFormat::z16>, DepthGeneral<System, DepthFormat::z24s8>>(chain,
                                                                                                       key);
    if (key.count)
        chain.template add<Count<SingleLane>>();
}

/// Adds a depth test that only drops fragments, before stages that may drop others. add_tests() adds the test
/// that writes after these stages. No fragment of a packet hides another one of it, so both tests agree.
/// Where stipples or samples take stages too, a chain may have no room for this one (max_stages).
template <class N> void add_hidden_test(ChainBuilder<N>& chain, const Key& key) {
    using System = Colorless<N>;
    if (key.depth != Compare::always && !key.stencil && !key.depth_offset && !key.polygon_stipple &&
        !key.samples)
        add_depth<N, DepthGeneral<System, DepthFormat::z16, DepthValueOf<System, DepthFormat::z16>, false>,
                  DepthGeneral<System, DepthFormat::z24s8, DepthValueOf<System, DepthFormat::z24s8>, false>>(
            chain, key);
}

/// True where PacketTexture samples textures a packet at a time. Otherwise Texture2D samples single
/// fragments, with the same bytes.
template <class N> inline constexpr bool by_packets = is_fixed<N>;

/// Whether texture coordinates have the runs of another tier than the one whose number system this is: cubic
/// runs with balanced numbers, or straight runs with exact numbers.
template <class N> constexpr bool has_other_runs([[maybe_unused]] const Key& key) {
#if SPANGLE_MIXES_RUNS
    return has_mixed_runs && is_fixed<N> && key.other_runs;
#else
    return false;
#endif
}
template <class N> void add_inverses(ChainBuilder<N>& chain, const Key& key) {
    if constexpr (by_lanes<N>) {
        const bool colors = key.kind == Kind::full && (key.color || key.color_sum) && !key.pixels,
                   others =
                       key.kind >= Kind::textured && (key.fog || (is_exact<N> && divides(key.kind, key.fog)));
        if (colors || others)
            chain.add(&PacketDivided<N>::inverses, true);
    }
}

/// Adds the stage of straight runs of coordinates. `SingleLane` is this stage for one lane.
template <class N, int Unit, class SingleLane> void add_straight_runs(ChainBuilder<N>& chain) {
    if constexpr (by_lanes<N> && divides_in_lanes)
        chain.add(&PacketRuns<PlacesOf<N>>::template run<Unit>, true);
    else
        chain.template add<SingleLane>();
}
template <class N, class SingleLane, int Unit> void add_other_runs([[maybe_unused]] ChainBuilder<N>& chain) {
#if SPANGLE_MIXES_RUNS
    if constexpr (has_mixed_runs && is_fixed<N>) {
        if constexpr (is_exact<N>)
            add_straight_runs<N, Unit, CoordAlong<SingleLane, Unit, CoordRuns>>(chain);
        else
            chain.template add<CoordAlong<SingleLane, Unit, CubicRuns>>();
    }
#endif
}

/// Whether the texture function of a unit finds its own coordinates, and can do so only along a row. Packets
/// of such a unit cannot be shared.
template <class N, int Unit> bool has_volume([[maybe_unused]] const FragmentState& state) {
    if constexpr (N::lanes > 1 && !divides_in_lanes && has_third_coordinates && Unit < max_texture_units)
        return state.unit[Unit].texture != nullptr && wants_r(*state.unit[Unit].texture);
    return false;
}

/// Adds the coordinates of the exact tier in builds that divide attributes over w in lanes.
template <class N, int Unit> void add_exact_coordinates(ChainBuilder<N>& chain, const Key& key) {
    if (divides(key.kind, key.fog))
        chain.add(&PacketDivided<N>::template coordinates<Unit>, true);
    else if constexpr (divides_in_lanes)
        chain.add(&PacketDivided<N>::template along_cubics<Unit>, true);
    else
        chain.template add<Coord<Exact, Unit, true>>();
}

/// Adds the stages that find a unit's coordinates and its level of detail.
template <class N, int Unit>
void add_coordinates(ChainBuilder<N>& chain, const Key& key, const FragmentState& state) {
    using SingleLane =
        std::conditional_t<is_exact<N>, Exact, OneLane<Colorless<N>>>; // runs of the exact tier are cubics
    if (has_third_coordinates && wants_r(*state.unit[Unit].texture))
        return; // the texture function finds its coordinates itself
    if constexpr (is_balanced<N> && !by_stages<N>)
        return chain.add(&PacketCoordinates<PlacesOf<N>>::template run<Unit>, false);
    if (key.kind < Kind::textured)
        chain.template add<Coord<Colorless<N>, Unit, false>>();
    else if (has_other_runs<N>(key))
        add_other_runs<N, SingleLane, Unit>(chain);
    else if constexpr (is_exact<N> && by_lanes<N>)
        add_exact_coordinates<N, Unit>(chain, key);
    else if constexpr (is_exact<N>)
        chain.template choose<CoordAlong<SingleLane, Unit, DividedCoords>, Coord<SingleLane, Unit, true>>(
            divides(key.kind, key.fog));
    else
        add_straight_runs<N, Unit, Coord<SingleLane, Unit, true>>(chain);
    if (!wants_lod(*state.unit[Unit].texture))
        return;
    if constexpr (by_lanes<N> && divides_in_lanes)
        chain.add(&PacketLevels<PlacesOf<N>>::template run<Unit>, true);
    else if constexpr (is_fixed<N> && N::lanes == 1)
        chain.add(&RowLevels<PlacesOf<N>>::template run<Unit>, false);
    else
        chain.template add<Lod<SingleLane, Unit>>();
}

template <class N, int Unit>
void add_unit(ChainBuilder<N>& chain, const Key& key, const FragmentState& state) {
    if (!key.unit[Unit].on)
        return;
    add_coordinates<N, Unit>(chain, key, state);
    using SingleLane = OneLane<N>;
    if (has_combine && key.combine)
        return; // CombineUnits or PacketTexture::combined() combines all units in one stage
    if constexpr (by_packets<N>)
        chain.add(&PacketTexture<N>::template run<Unit>, !has_volume<N, Unit>(state));
    else
        chain.template choose<Texture2D<SingleLane, Unit, true>, Texture2D<SingleLane, Unit, false>>(
            wants_lod(*state.unit[Unit].texture));
}
/// Adds unit 0, whose texels are counted in steps here (counts_steps()) and which has no levels of detail.
template <class N>
void add_unit_in_steps(ChainBuilder<N>& chain, const Key& key, const FragmentState& state) {
    add_coordinates<N, 0>(chain, key, state);
    if constexpr (by_packets<N>)
        chain.add(&PacketTexture<N>::run_steps, !has_volume<N, 0>(state));
    else
        chain.template add<Texture2D<OneLane<N>, 0, false, true>>();
}

template <class N> void add_units(ChainBuilder<N>& chain, const Key& key, const FragmentState& state) {
    add_unit<N, 0>(chain, key, state);
    if constexpr (max_texture_units > 1)
        add_unit<N, 1>(chain, key, state);
    if constexpr (has_combine) {
        if (!key.combine)
            return;
        if constexpr (by_packets<N>)
            chain.add(&PacketTexture<N>::combined, !has_volume<N, 0>(state) && !has_volume<N, 1>(state));
        else
            chain.template add<CombineUnits<OneLane<N>>>();
    }
}

template <class N, PixelFormat Format, class Chain> void add_coarse(Chain& chain, bool dither) {
    if constexpr (has_tier(Tier::fast) && is_balanced<N> && is_565(Format))
        chain.template choose<BlendCoarse<N, Format, true>, BlendCoarse<N, Format, false>>(dither);
}

template <class N, PixelFormat Format> void add_output(ChainBuilder<N>& chain, const Key& key) {
    if (key.coarse)
        add_coarse<N, Format>(chain, key.dither);
    else if (key.blend && !key.blend_general && key.blending == blend_over)
        chain.template add<BlendAlpha<N, Format>>();
    else if (key.blend)
        add_any_blending<N, Format>(chain);
    if constexpr (is_balanced<N> && has_textures && has_fog && is_565(Format))
        if (counts_steps(key))
            return chain.template add<StoreSteps<N, Format>>();
    constexpr bool only_merged = stores_merged<N>;
    if (only_merged || key.masked || key.logic)
        chain.template add<StoreMerged<N, Format>>();
    if constexpr (!only_merged)
        if (!key.masked && !key.logic)
            chain.template choose<StoreDithered<N, Format>, Store<N, Format>>(key.dither && !key.coarse);
}

/// Adds the output stages for the format that the key names, which is one of `Format`.
template <class N, PixelFormat... Format> void add_wide_output(ChainBuilder<N>& chain, const Key& key) {
    const auto add = [&]<PixelFormat F>() {
        if constexpr (has_format(F))
            if (drawn(key.format) == F)
                add_output<N, F>(chain, key);
    };
    (add.template operator()<Format>(), ...);
}

/// Whether fragments are affected by nothing but an affine colour.
constexpr bool only_color(const Key& key) {
    return key.kind == Kind::affine && key.color && !key.unit[0].on && !key.second_unit() && !key.color_sum &&
           !key.fog && key.alpha == Compare::always && !key.stencil && key.depth == Compare::always &&
           !key.depth_write && !key.blend && !key.masked && !key.logic && !key.count && !key.pixels &&
           !key.coverage && !key.polygon_stipple && !key.samples;
}

template <class N> void add_narrow_output(ChainBuilder<N>& chain, const Key& key) {
    using SingleLane = OneLane<N>;
    if (key.blend)
        chain.template add<Blend<SingleLane, StoredNarrow<SingleLane>>>();
    chain.template add<StoreNarrow<SingleLane>>();
    chain.runs(&by_narrow_row<typename N::Policy, &chain_span<N>>);
    if constexpr (is_fixed<N>)
        if (only_color(key))
            chain.runs(&narrow_rows<SingleLane, &chain_span<N>>);
}

template <class N> void add_divided_primary(ChainBuilder<N>& chain, bool alpha) {
    using SingleLane = OneLane<N>;
    if constexpr (Span<typename N::Policy>::colors_over_w == 1)
        return; // this build divides no colours by w
    else if constexpr (by_lanes<N>)
        chain.add(alpha ? &PacketDivided<N>::template primary<true>
                        : &PacketDivided<N>::template primary<false>,
                  true);
    else
        chain.template choose<GouraudQ<SingleLane, true>, GouraudQ<SingleLane, false>>(alpha);
}

/// Adds the primary colour, which comes from vertices or from an image. On a surface of indices the red
/// component is the index.
template <class N> void add_primary(ChainBuilder<N>& chain, const Key& key) {
    using SingleLane = OneLane<N>;
    if (has_pixel_colors && key.pixels)
        chain.template add<PixelColor<SingleLane>>();
    else if (!key.color)
        chain.template add<White<N>>();
    else if constexpr (!by_stages<N>)
        chain.add(&PacketColors<N>::primary, false);
    else if (key.kind == Kind::full)
        add_divided_primary(chain, key.color_alpha);
    else
        chain.template choose<Gouraud<N, true>, Gouraud<N, false>>(key.color_alpha);
}

template <class N> void add_color_sum(ChainBuilder<N>& chain, const Key& key) {
    using SingleLane = OneLane<N>;
    if constexpr (!by_stages<N>)
        chain.add(&PacketColors<N>::sum, false);
    else if constexpr (by_lanes<N>)
        key.kind == Kind::full ? chain.add(&PacketDivided<N>::sum, true)
                               : chain.template add<ColorSumLanes<N>>();
    else
        chain.template choose<ColorSum<SingleLane, true>, ColorSum<SingleLane, false>>(key.kind ==
                                                                                       Kind::full);
}

template <class N> void add_fog_coordinate(ChainBuilder<N>& chain, const Key& key) {
    if constexpr (by_lanes<N>)
        key.kind >= Kind::textured ? chain.add(&PacketDivided<N>::fog, true)
                                   : chain.template add<FogCoord<N, false>>();
    else
        chain.template choose<FogCoord<OneLane<N>, true>, FogCoord<N, false>>(key.kind >= Kind::textured);
}

/// Adds fog in two parts, one before and one after the texture unit (fogs_light()).
template <class N> void add_fogged_unit(ChainBuilder<N>& chain, const Key& key, const FragmentState& state) {
    add_fog_coordinate(chain, key);
    chain.template add<FogLight<N>>();
    const bool steps = counts_steps(key);
    steps ? add_unit_in_steps<N>(chain, key, state) : add_unit<N, 0>(chain, key, state);
    chain.template choose<FogShare<N, true>, FogShare<N>>(steps);
}

/// Assembles the chain for a surface of indices.
template <class N> void assemble_index(ChainBuilder<N>& chain, const Key& key) {
    using SingleLane = OneLane<N>;
    add_tests(chain, key);
    add_inverses(chain, key);
    add_primary(chain, key);
    if (has_fog && key.fog) {
        add_fog_coordinate(chain, key);
        chain.template add<FogIndex<SingleLane>>();
    }
    if (SPANGLE_FEATURE_ANTIALIASING && key.coverage)
        chain.template add<IndexCoverage<SingleLane>>();
    chain.template add<StoreIndex<SingleLane>>();
}

/// Assembles every stage that the key asks for. Modes that the key leaves open are read from the state while
/// drawing.
template <class N> void assemble(Variant& variant, const Key& key, const FragmentState& state) {
    using SingleLane = OneLane<N>;
    ChainBuilder<N> chain(variant);
    if constexpr (has_format(PixelFormat::index8) &&
                  !is_balanced<N>) // balanced numbers never draw indices (key.cpp)
        if (drawn_indexed(key.format))
            return assemble_index(chain, key);
    const bool early = early_tests(key);
    if (early)
        add_tests(chain, key);
    else if constexpr (by_lanes<N>)
        add_hidden_test(chain, key);
    add_inverses(chain, key);
    add_primary(chain, key);
    const bool around = is_balanced<N> && has_textures && has_fog && fogs_light(key);
    if constexpr (is_balanced<N> && has_textures && has_fog)
        if (around)
            add_fogged_unit(chain, key, state);
    if constexpr (has_textures)
        if (!around)
            add_units(chain, key, state);
    if constexpr (has_color_sum)
        if (key.color_sum)
            add_color_sum(chain, key);
    if (has_fog && key.fog && !around) {
        add_fog_coordinate(chain, key);
        if constexpr (is_fixed<N>)
            chain.template choose<FogLinear<N>, Fog<std::conditional_t<by_lanes<N>, N, SingleLane>>>(
                by_stages<N> && key.fog_mode == FogMode::linear);
        else
            chain.template add<Fog<N>>();
    }
    if (SPANGLE_FEATURE_ANTIALIASING && key.coverage)
        chain.template add<Coverage<SingleLane>>();
    if (has_samples && key.samples)
        chain.template add<SampleCoverage<SingleLane>>();
    if (key.alpha != Compare::always)
        chain.template add<AlphaTest<N>>();
    if (!early)
        add_tests(chain, key);
    if (state.color_mask == 0 && !drawn_narrow(key.format))
        return; // no colour is stored
    if constexpr (!std::is_same_v<N, Balanced<host_lanes>> &&
                  has_narrow_formats) // balanced numbers never draw narrow formats (key.cpp)
        if (drawn_narrow(key.format))
            return add_narrow_output<N>(chain, key);
    add_wide_output<N, PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                    PixelFormat::rgba8888>(chain, key);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
