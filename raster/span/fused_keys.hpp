// The words in which a table of fused spans is written. In builds without a chain the table also tells the
// compiler which features all of their spans use, and which features none of them uses.
#pragma once

#include <type_traits>

#include "raster/span/key.hpp"

namespace spangle::raster {

/// A key under construction. Each function returns a copy in which some members differ from the defaults.
struct KeyBuilder {
    Key key;
    constexpr KeyBuilder(Number number, Kind kind) {
        key.number = number;
        key.kind = kind;
    }
    constexpr KeyBuilder depth(Compare func) const {
        KeyBuilder s = *this;
        s.key.depth = func;
        s.key.depth_write = true;
        s.key.depth_format = DepthFormat::z16;
        return s;
    }
    constexpr KeyBuilder texture(TexelFormat texels, BaseFormat base, Filter filter, TexEnv env) const {
        KeyBuilder s = *this;
        s.key.unit[0] = {true, false, texels, base, filter, env};
        s.key.color = env != TexEnv::replace;
        return s;
    }
    constexpr KeyBuilder alpha() const {
        KeyBuilder s = *this;
        s.key.color_alpha = true;
        return s;
    }
    constexpr KeyBuilder blend() const {
        KeyBuilder s = *this;
        s.key.blend = true;
        s.key.blending = blend_over;
        return s;
    }
    constexpr KeyBuilder fog() const {
        KeyBuilder s = *this;
        s.key.fog = true;
        s.key.fog_mode = FogMode::linear;
        return s;
    }
    constexpr KeyBuilder cubic() const {
        KeyBuilder s = *this;
        s.key.cubic = true;
        return s;
    }
    constexpr KeyBuilder coarse() const {
        KeyBuilder s = blend();
        s.key.coarse = true;
        return s;
    }
    constexpr KeyBuilder dither() const {
        KeyBuilder s = *this;
        s.key.dither = true;
        return s;
    }
};

namespace table_words {

constexpr auto less = Compare::less, lequal = Compare::lequal;
constexpr auto rgb = BaseFormat::rgb, rgba = BaseFormat::rgba;
constexpr auto nearest = Filter::nearest, linear = Filter::linear;
constexpr auto replace = TexEnv::replace, modulate = TexEnv::modulate;
constexpr auto t565 = TexelFormat::rgb565, t888 = TexelFormat::rgb888, t8888 = TexelFormat::rgba8888;

constexpr KeyBuilder flat(Number::raw565, Kind::flat), smooth(Number::raw565, Kind::affine);
constexpr KeyBuilder straight(Number::raw565, Kind::affine),
    bent(Number::raw565, Kind::textured); // keys of texels that are stored unchanged
constexpr KeyBuilder affine(Number::balanced, Kind::affine), textured(Number::balanced, Kind::textured),
    full(Number::balanced, Kind::full);
constexpr KeyBuilder fine_affine(Number::exact, Kind::affine), fine(Number::exact, Kind::textured),
    fine_full(Number::exact, Kind::full); // keys of the exact tier
constexpr KeyBuilder fine_bent = bent.cubic();

} // namespace table_words

/// The keys of this build, in the order of the table.
namespace fused_list {

#ifdef SPANGLE_FUSED
inline constexpr bool is_all = !has_chain; // true: this build draws no key that is not in the table
#else
inline constexpr bool is_all = false;
#define SPANGLE_FUSED "raster/span/fused_list.inc"
#endif
using namespace table_words;
template <KeyBuilder S> constexpr Key entry() {
    return S.key;
}
inline constexpr Key keys[] = {
#include SPANGLE_FUSED
};

} // namespace fused_list

/// Whether some, and whether all, of a build's spans have a property. Where the chain draws other keys, the
/// answer is: perhaps some, not all.
struct Among {
    bool some = true, all = false;
};
template <class Property> constexpr Among among_spans(Property has) {
    if (!fused_list::is_all)
        return {};
    Among among{false, true};
    for (const Key& key : fused_list::keys) {
        among.some = among.some || has(key);
        among.all = among.all && has(key);
    }
    return among;
}

inline constexpr Among spans_with_depth = among_spans([](const Key&k) { return needs_depth(k); }),
                       spans_with_color = among_spans([](const Key&k) { return k.color; }),
                       spans_with_alpha = among_spans([](const Key&k) { return k.color_alpha; }),
                       spans_with_sum = among_spans([](const Key&k) { return k.color_sum; }),
                       spans_of_full = among_spans([](const Key&k) { return k.kind == Kind::full; }),
                       spans_with_coordinates =
                           among_spans([](const Key&k) { return k.unit[0].on || k.second_unit() || k.fog; });
/// Whether `run` reads Span::gray: fused spans with fog have separate loops for gray colours.
inline constexpr Among spans_by_gray = {has_fog, false};
inline constexpr bool spans_are_raw =
                          among_spans([](const Key&k) { return k.number == Number::raw565; }).some,
                      spans_test_alpha =
                          among_spans([](const Key&k) { return k.alpha != Compare::always; }).some,
                      spans_blend = among_spans([](const Key&k) { return k.blend; }).some,
                      spans_with_env_color = among_spans([](const Key&k) {
                                                 return k.unit[0].env == TexEnv::blend || k.unit[0].general;
                                             }).some,
                      spans_only_modulate = among_spans([](const Key&k) {
                                                bool only = !k.combine;
                                                for (const UnitKey& unit : k.unit)
                                                    only =
                                                        only && unit.env == TexEnv::modulate && !unit.general;
                                                return only;
                                            }).all,
                      spans_dither = among_spans([](const Key&k) { return k.dither; }).some,
                      spans_sample_any =
                          among_spans([](const Key&k) { return k.unit[0].general || k.combine; }).some;

/// A fact about a draw that is the same for all spans of the build. States with the other value are not
/// drawn. Flag is a plain bool where spans differ.
template <bool Value> struct Known {
    constexpr Known(bool = Value) {}
    constexpr operator bool() const { return Value; }
};
template <Among A> using Flag = std::conditional_t<A.some && !A.all, bool, Known<A.all>>;

} // namespace spangle::raster
