// Lists worth a loop of their own, as types: the key they draw, and their stages for any number of lanes.
#pragma once

#include "raster/span/fill.hpp"
#include "raster/span/fused.hpp"
#include "raster/span/key.hpp"
#include "raster/span/stage_color.hpp"
#include "raster/span/stage_coord.hpp"
#include "raster/span/stage_depth.hpp"
#include "raster/span/stage_raw.hpp"
#include "raster/span/stage_texture.hpp"

namespace spangle::raster {

/// The depth test of a fused list: 16 bits, written; `always` stands for none.
template <class N, Compare Func> struct FusedDepth : Depth<N, DepthFormat::z16, Func, true> {
    using Depth<N, DepthFormat::z16, Func, true>::Depth;
};
template <class N> struct FusedDepth<N, Compare::always> : StageBase {
    SPANGLE_INLINE FusedDepth(const Span<Fixed>&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>&) const { return true; }
};

constexpr Key fused_key(Number number, Kind kind, PixelFormat format, Compare depth) {
    Key key;
    key.number = number;
    key.kind = kind;
    key.format = format;
    if (depth != Compare::always) {
        key.depth = depth;
        key.depth_write = true;
        key.depth_format = DepthFormat::z16;
    }
    return key;
}

constexpr UnitKey fused_unit(TexelFormat texels, BaseFormat base, Filter filter, TexEnv env) {
    UnitKey unit;
    unit.on = true;
    unit.texels = texels;
    unit.base = base;
    unit.filter = filter;
    unit.env = env;
    return unit;
}

/// What all cases of one number system share.
template <class Case, template <int> class NumberOf> struct FusedCase {
    template <int Lanes> using Number = NumberOf<Lanes>;
    static constexpr bool wide = true;
    static void run(const Span<Fixed>& span) { fused<Case>(span); }
};

template <PixelFormat Format> struct FlatFill : FusedCase<FlatFill<Format>, Raw565> {
    static constexpr Key key = fused_key(Number::raw565, Kind::flat, Format, Compare::always);
    template <int L> using List = Seq<Raw565<L>, FlatWord<L>, StoreRaw<L, Format>>;
    static void run(const Span<Fixed>& span) {
        const std::uint32_t word = span.flat_word;
        fill16(span.color, StoreRaw<1, Format>::swaps ? Lanes<1>::swap_bytes(word) : word,
               span.end - span.begin);
    }
};

template <PixelFormat Format, Compare Func> struct FlatDepth : FusedCase<FlatDepth<Format, Func>, Raw565> {
    static constexpr Key key = fused_key(Number::raw565, Kind::flat, Format, Func);
    template <int L>
    using List = Seq<Raw565<L>, FusedDepth<Raw565<L>, Func>, FlatWord<L>, StoreRaw<L, Format>>;
};

template <PixelFormat Format, Compare Func> struct Smooth : FusedCase<Smooth<Format, Func>, Raw565> {
    static constexpr Key key = fused_key(Number::raw565, Kind::affine, Format, Func);
    template <int L>
    using List = Seq<Raw565<L>, FusedDepth<Raw565<L>, Func>, Gouraud<Raw565<L>, false>, StoreRaw<L, Format>>;
};

/// REPLACE by the nearest texel of an RGB image: texture fetches gain nothing from lanes.
template <PixelFormat Format, Compare Func, TexelFormat Texels, Kind K>
struct Replaced : FusedCase<Replaced<Format, Func, Texels, K>, Raw565> {
    static constexpr bool wide = false;
    static constexpr Key key = [] {
        Key k = fused_key(Number::raw565, K, Format, Func);
        k.unit[0] = fused_unit(Texels, BaseFormat::rgb, Filter::nearest, TexEnv::replace);
        k.color = false;
        return k;
    }();
    template <int L>
    using List = Seq<Raw565<L>, FusedDepth<Raw565<L>, Func>, Coord<Raw565<L>, 0, K == Kind::textured>,
                     TextureFixed<Raw565<L>, 0, Texels, BaseFormat::rgb, Filter::nearest, TexEnv::replace>,
                     StoreRaw<L, Format>>;
};

} // namespace spangle::raster
