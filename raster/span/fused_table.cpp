// The table of fused spans: one line per key. A key that is not here draws with the chain, the same bytes at
// most three times slower.
#include "raster/span/fused_table.hpp"

#include "raster/span/fused_cases.hpp"

namespace spangle::raster {

namespace {

constexpr auto be = PixelFormat::rgb565_be;
constexpr auto off = Compare::always;
constexpr auto rgb565 = TexelFormat::rgb565;
constexpr auto rgb888 = TexelFormat::rgb888;

template <class Case> constexpr FusedSpan entry() {
#ifdef SPANGLE_FIRMWARE
    return {Case::key, &Case::run, nullptr};
#else
    return {Case::key, &Case::run, &fused<Case, 1>};
#endif
}

constexpr FusedSpan table[] = {
    // One colour; with depth: gears (S5), lines (S8).
    entry<FlatFill<be>>(),
    entry<FlatDepth<be, Compare::less>>(),
    entry<FlatDepth<be, Compare::lequal>>(),
    // Smooth shading without dither (S3, S5, S6).
    entry<Smooth<be, off>>(),
    entry<Smooth<be, Compare::less>>(),
    entry<Smooth<be, Compare::lequal>>(),
    // Nearest texels as they are (S4, S4r).
    entry<Replaced<be, off, rgb565, Kind::affine>>(),
    entry<Replaced<be, off, rgb565, Kind::textured>>(),
    entry<Replaced<be, off, rgb888, Kind::affine>>(),
    entry<Replaced<be, off, rgb888, Kind::textured>>(),
    entry<Replaced<be, Compare::less, rgb565, Kind::affine>>(),
    entry<Replaced<be, Compare::less, rgb565, Kind::textured>>(),
    entry<Replaced<be, Compare::less, rgb888, Kind::affine>>(),
    entry<Replaced<be, Compare::less, rgb888, Kind::textured>>(),
};

} // namespace

SpanFunction find_fused(const Key& key) {
    for (const FusedSpan& span : table)
        if (span.key == key)
            return span.run;
    return nullptr;
}

const FusedSpan* fused_spans() {
    return table;
}

std::size_t fused_span_count() {
    return sizeof table / sizeof table[0];
}

} // namespace spangle::raster
