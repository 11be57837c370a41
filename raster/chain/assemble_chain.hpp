// Assembles the chain of any state for one instruction set. Both draw_state.cpp and chain_avx2.cpp include
// this file.
#pragma once

#include "raster/chain/assemble.hpp"
#include "raster/ops/stage_dithered.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

using Raw = Raw565<host_lanes>;
using OneRaw = Raw565<1>;

template <PixelFormat Format> void assemble_raw(Variant& variant, const Key& key) {
    using Store = StoreRaw<host_lanes, Format>;
    ChainBuilder<Raw> chain(variant);
    add_tests(chain, key);
    const UnitKey& unit = key.unit[0];
    if (has_pixel_colors && key.pixels) {
        chain.add<PixelWord<host_lanes>>();
        return chain.add<Store>();
    }
    const auto fill = [&]<class Fill> { add_fill<Raw, Fill, Store>(chain); };
    if (!unit.on && key.dither)
        return key.kind == Kind::flat ? fill.template operator()<FlatDithered<host_lanes>>()
                                      : fill.template operator()<GouraudDithered<host_lanes>>();
    if (!unit.on)
        return key.kind == Kind::flat ? fill.template operator()<FlatWord<host_lanes>>()
                                      : fill.template operator()<Gouraud<Raw, false>>();
    if (has_exact && key.cubic)
        chain.add_if<has_exact, CoordAlong<OneRaw, 0, CubicRuns>>();
    else if constexpr (!by_stages<Raw>)
        chain.add(&PacketCoordinates<PlacesOf<Raw>>::run<0>, false);
    else if (key.kind == Kind::textured)
        add_straight_runs<Raw, 0, Coord<OneRaw, 0, true>>(chain);
    else
        chain.add<Coord<Raw, 0, false>>();
    chain.choose<
        TextureFixed<OneRaw, 0, TexelFormat::rgb565, BaseFormat::rgb, Filter::nearest, TexEnv::replace>,
        TextureFixed<OneRaw, 0, TexelFormat::rgb888, BaseFormat::rgb, Filter::nearest, TexEnv::replace>>(
        unit.texels == TexelFormat::rgb565);
    chain.add<Store>();
}

/// Assembles the chain of a key, stage after stage. Only builds with a chain call this.
SPANGLE_INLINE void assemble_any(Variant& variant, const Key& key, const FragmentState& state) {
    switch (key.number) {
    case Number::raw565:
        if (has_format(PixelFormat::rgb565_be) && drawn(key.format) == PixelFormat::rgb565_be)
            assemble_raw<PixelFormat::rgb565_be>(variant, key);
        else if constexpr (has_format(PixelFormat::rgb565_le))
            assemble_raw<PixelFormat::rgb565_le>(variant, key);
        break;
    case Number::balanced:
        if constexpr (has_balanced)
            assemble<Balanced<host_lanes>>(variant, key, state);
        break;
    default:
        if constexpr (has_exact)
            assemble<ExactChain>(variant, key, state);
        break;
    }
}

/// Returns the RowsFunction that runs a chain's stages along rows.
SPANGLE_INLINE AnyFunction runner_of(Number number, [[maybe_unused]] bool narrow) {
    if constexpr (has_narrow_formats)
        if (narrow) // narrow surfaces have exact colours (key.cpp)
            return reinterpret_cast<AnyFunction>(&by_narrow_row<Fixed, &chain_span<ExactChain>>);
    switch (number) {
    case Number::raw565:
        return reinterpret_cast<AnyFunction>(&chain_rows<Raw>);
    case Number::balanced:
        return reinterpret_cast<AnyFunction>(&chain_rows<Balanced<host_lanes>>);
    default:
        return reinterpret_cast<AnyFunction>(&chain_rows<ExactChain>);
    }
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
