// The table of fused spans: one line per key. A key that is not here draws with the chain: the same bytes,
// slower. A scene profile has a table of its own (SPANGLE_FUSED, a file of such lines).
#include "raster/span/fused_table.hpp"

#include "raster/span/fused_cases.hpp"
#include "raster/span/fused_keys.hpp"

namespace spangle::raster {

namespace {

template <Say S> constexpr FusedSpan entry() {
    using Case = FusedCase<S.key>;
#ifdef SPANGLE_FIRMWARE
    return {Case::key, &Case::run, Case::splits_gray, Case::walk(), nullptr, Case::guessed, nullptr};
#else
    return {Case::key,      &Case::run,    Case::splits_gray,           Case::walk(),
            Case::shapes(), Case::guessed, &Case::template run_lanes<1>};
#endif
}

using namespace table_words;

constexpr FusedSpan table[] = {
#ifdef SPANGLE_FUSED
#include SPANGLE_FUSED
#else
    // One colour (S2); with depth: faces of gears (S5), lines (S8).
    entry<flat>(),
    entry<flat.depth(less)>(),
    entry<flat.depth(lequal)>(),
    entry<flat.dither()>(),
    entry<flat.depth(less).dither()>(),
    entry<flat.depth(lequal).dither()>(),
    // Smooth shading (S3, S5, S6).
    entry<smooth>(),
    entry<smooth.depth(less)>(),
    entry<smooth.depth(lequal)>(),
    entry<smooth.dither()>(),
    entry<smooth.depth(less).dither()>(),
    entry<smooth.depth(lequal).dither()>(),
    // Texels as they are (S4, S4r).
    entry<straight.texture(t565, rgb, nearest, replace)>(),
    entry<bent.texture(t565, rgb, nearest, replace)>(),
    entry<straight.texture(t888, rgb, nearest, replace)>(),
    entry<bent.texture(t888, rgb, nearest, replace)>(),
    entry<straight.texture(t565, rgb, nearest, replace).depth(less)>(),
    entry<bent.texture(t565, rgb, nearest, replace).depth(less)>(),
    entry<straight.texture(t888, rgb, nearest, replace).depth(less)>(),
    entry<bent.texture(t888, rgb, nearest, replace).depth(less)>(),
    entry<fine_bent.texture(t565, rgb, nearest, replace)>(),
    entry<fine_bent.texture(t888, rgb, nearest, replace)>(),
    entry<fine_bent.texture(t565, rgb, nearest, replace).depth(less)>(),
    entry<fine_bent.texture(t888, rgb, nearest, replace).depth(less)>(),
    // The same filtered (S4b), and dithered.
    entry<affine.texture(t888, rgb, linear, replace)>(),
    entry<affine.texture(t565, rgb, linear, replace)>(),
    entry<textured.texture(t888, rgb, linear, replace)>(),
    entry<textured.texture(t565, rgb, linear, replace)>(),
    entry<affine.texture(t888, rgb, linear, replace).dither()>(),
    entry<affine.texture(t565, rgb, linear, replace).dither()>(),
    entry<textured.texture(t888, rgb, linear, replace).dither()>(),
    entry<textured.texture(t565, rgb, linear, replace).dither()>(),
    entry<affine.texture(t888, rgb, nearest, replace).dither()>(),
    entry<textured.texture(t888, rgb, nearest, replace).dither()>(),
    // Sprites, text, gauges (S7, HUD).
    entry<affine.texture(t8888, rgba, nearest, replace).blend()>(),
    entry<affine.texture(t8888, rgba, nearest, replace).blend().dither()>(),
    entry<affine.texture(t8888, rgba, nearest, modulate).alpha().blend()>(),
    entry<affine.texture(t8888, rgba, nearest, modulate).alpha().blend().dither()>(),
    entry<affine.alpha().blend()>(),
    entry<affine.alpha().blend().dither()>(),
    // The same of the fast tier.
    entry<affine.texture(t8888, rgba, nearest, replace).coarse()>(),
    entry<affine.texture(t8888, rgba, nearest, modulate).alpha().coarse()>(),
    entry<affine.alpha().coarse()>(),
    entry<affine.texture(t8888, rgba, nearest, replace).coarse().dither()>(),
    entry<affine.texture(t8888, rgba, nearest, modulate).alpha().coarse().dither()>(),
    entry<affine.alpha().coarse().dither()>(),
    // Lit textures, with and without fog (S9).
    entry<affine.texture(t888, rgb, nearest, modulate).depth(less)>(),
    entry<affine.texture(t565, rgb, nearest, modulate).depth(less)>(),
    entry<textured.texture(t888, rgb, nearest, modulate).depth(less)>(),
    entry<textured.texture(t565, rgb, nearest, modulate).depth(less)>(),
    entry<affine.texture(t888, rgb, nearest, modulate).depth(less).fog()>(),
    entry<affine.texture(t565, rgb, nearest, modulate).depth(less).fog()>(),
    entry<textured.texture(t888, rgb, nearest, modulate).depth(less).fog()>(),
    entry<textured.texture(t565, rgb, nearest, modulate).depth(less).fog()>(),
    entry<full.texture(t888, rgb, nearest, modulate).depth(less).fog()>(),
    entry<full.texture(t565, rgb, nearest, modulate).depth(less).fog()>(),
    entry<affine.texture(t888, rgb, nearest, modulate).depth(less).dither()>(),
    entry<affine.texture(t565, rgb, nearest, modulate).depth(less).dither()>(),
    entry<affine.texture(t888, rgb, nearest, modulate).depth(less).fog().dither()>(),
    entry<affine.texture(t565, rgb, nearest, modulate).depth(less).fog().dither()>(),
    entry<textured.texture(t565, rgb, nearest, modulate).depth(less).fog().dither()>(),
    entry<full.texture(t565, rgb, nearest, modulate).depth(less).fog().dither()>(),
    // The exact tier: smooth shading under perspective (S6), filtered, sprites, lit textures with and without
    // fog.
    entry<fine_full.depth(less)>(),
    entry<fine_full.depth(lequal)>(),
    entry<fine.texture(t888, rgb, linear, replace)>(),
    entry<fine.texture(t565, rgb, linear, replace)>(),
    entry<fine_affine.texture(t8888, rgba, nearest, replace).blend()>(),
    entry<fine.texture(t888, rgb, nearest, modulate).depth(less).fog()>(),
    entry<fine.texture(t565, rgb, nearest, modulate).depth(less).fog()>(),
    entry<fine_full.texture(t888, rgb, nearest, modulate).depth(less)>(),
    entry<fine_full.texture(t565, rgb, nearest, modulate).depth(less)>(),
    entry<fine_full.texture(t888, rgb, nearest, modulate).depth(less).fog()>(),
    entry<fine_full.texture(t565, rgb, nearest, modulate).depth(less).fog()>(),
    // The same dithered.
    entry<fine_full.depth(less).dither()>(),
    entry<fine_full.depth(lequal).dither()>(),
    entry<fine.texture(t888, rgb, linear, replace).dither()>(),
    entry<fine.texture(t565, rgb, linear, replace).dither()>(),
    entry<fine_affine.texture(t8888, rgba, nearest, replace).blend().dither()>(),
    entry<fine.texture(t565, rgb, nearest, modulate).depth(less).fog().dither()>(),
    entry<fine_full.texture(t565, rgb, nearest, modulate).depth(less).fog().dither()>(),
    // Models: filtered, lit.
    entry<affine.texture(t888, rgb, linear, modulate).depth(less)>(),
    entry<affine.texture(t565, rgb, linear, modulate).depth(less)>(),
    entry<textured.texture(t888, rgb, linear, modulate).depth(less)>(),
    entry<textured.texture(t565, rgb, linear, modulate).depth(less)>(),
    entry<affine.texture(t888, rgb, linear, modulate).depth(less).dither()>(),
    entry<affine.texture(t565, rgb, linear, modulate).depth(less).dither()>(),
    entry<textured.texture(t888, rgb, linear, modulate).depth(less).dither()>(),
    entry<textured.texture(t565, rgb, linear, modulate).depth(less).dither()>(),
#endif
};

} // namespace

const FusedSpan* fused_spans() {
    return table;
}

std::size_t fused_span_count() {
    return sizeof table / sizeof table[0];
}

} // namespace spangle::raster
