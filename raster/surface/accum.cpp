#include "raster/surface/accum.hpp"

#include "raster/numeric/reciprocal.hpp"
#include "raster/surface/pixel.hpp"
#include "raster/surface/quantize.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::raster {

namespace {

std::int16_t saturated(std::int64_t v) {
    return static_cast<std::int16_t>(v < -accum_one ? -accum_one : v > accum_one ? accum_one : v);
}

/// v / 2^bits, rounded to nearest.
std::int64_t rounded(std::int64_t v, int bits) {
    return (v + (std::int64_t{1} << (bits - 1))) >> bits;
}

/// Calls change(x, y, the four values there) for each pixel.
template <class Change> void each(const Surface& s, Rect area, Change change) {
    for (std::int32_t y = area.y; y < area.y + area.h; ++y) {
        std::int16_t* at = s.accum + 4 * (static_cast<std::intptr_t>(y) * s.width + area.x);
        for (std::int32_t x = area.x; x < area.x + area.w; ++x, at += 4)
            change(x, y, at);
    }
}

/// The largest value of a component with `bits` bits. With 0 bits it is 1, because formats without alpha have
/// alpha 1.
constexpr std::uint32_t largest(unsigned bits) {
    return bits == 0 ? 1 : (1u << bits) - 1;
}

/// value n / d, rounded towards 0. The product is below 2^59.
std::int64_t scaled(std::int32_t value, std::uint32_t n, std::uint32_t d) {
    const std::int64_t q =
        static_cast<std::int64_t>(numeric::divide(numeric::abs_u64(std::int64_t{value} * n), d).quotient);
    return value < 0 ? -q : q;
}

/// Does any operation except clear. `colors` is the surface that is read, or the surface that give_back
/// writes.
void pass(const Surface& s, const AccumRequest& r, const Rect& area, const Surface& colors) {
    using Op = AccumRequest::Op;
    constexpr int guard = 8;
    const bool reads = r.op == Op::accumulate || r.op == Op::load, gives = r.op == Op::give_back,
               adds = r.op == Op::add, keeps = adds || r.op == Op::accumulate;
    const FormatInfo& info = drawn_info(colors.format);
    const unsigned bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
    // The product is k v 32767 / (2^bits - 1), where k has 8 bits, v 32 bits, and the factor 15 bits and 8
    // guard bits. In give_back it is in colour units: A has 15 bits, v 32 bits, and color_one / 32767 has 14
    // bits.
    std::int64_t factor[4];
    for (int c = 0; c < 4; ++c)
        factor[c] = scaled(r.value,
                           gives   ? color_one
                           : reads ? accum_one << guard
                                   : 1 << guard,
                           gives   ? accum_one
                           : reads ? largest(bits[c])
                                   : 1);
    each(s, area, [&](std::int32_t x, std::int32_t y, std::int16_t* a) {
        StoredColor color;
        if (reads || gives)
            color = read_color(colors, x, y);
        std::uint32_t k[4];
        for (unsigned c = 0; c < 4; ++c) {
            const std::int32_t of = reads ? color.c[c].k : adds ? accum_one : a[c];
            const std::int64_t product = of * factor[c];
            if (!gives) {
                a[c] = saturated(rounded(product, accum_value_bits + guard) + (keeps ? a[c] : 0));
                continue;
            }
            k[c] = color.c[c].k;
            if ((r.channels >> c & 1) == 0 || bits[c] == 0)
                continue;
            const std::int64_t v = rounded(product, accum_return_bits);
            const auto units = static_cast<std::uint32_t>(v < 0 ? 0 : v > color_one ? color_one : v);
            k[c] = stored_component(units, bits[c], r.dither, dither_threshold(dither_row(y), x));
        }
        if (gives)
            write_color(colors, x, y, k);
    });
}

} // namespace

void clear_accum(const Surface& s, Rect area, const std::int16_t (&value)[4]) {
    each(s, area, [&](std::int32_t, std::int32_t, std::int16_t* a) {
        for (int c = 0; c < 4; ++c)
            a[c] = value[c];
    });
}

namespace {

/// The intersection of two areas; w or h is not positive if it is empty.
Rect intersection(const Rect& a, const Rect& b) {
    const auto later = [](std::int32_t v, std::int32_t w) { return v > w ? v : w; };
    const auto sooner = [](std::int32_t v, std::int32_t w) { return v < w ? v : w; };
    const std::int32_t x = later(a.x, b.x), y = later(a.y, b.y);
    return {x, y, sooner(a.x + a.w, b.x + b.w) - x, sooner(a.y + a.h, b.y + b.h) - y};
}

} // namespace

void accum(const Surface& s, const AccumRequest& r, const Surface& source) {
    using Op = AccumRequest::Op;
    switch (r.op) {
    case Op::clear:
        return clear_accum(s, r.area, r.clear);
    case Op::accumulate:
    case Op::load:
        resolve(source);
        return pass(s, r, intersection(r.area, source.area()), source);
    case Op::multiply:
    case Op::add:
        return pass(s, r, r.area, s);
    case Op::give_back:
        return each_sample(s, [&r](const Surface& sample, unsigned) { pass(sample, r, r.area, sample); });
    }
}

} // namespace spangle::raster
