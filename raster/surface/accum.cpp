#include "raster/surface/accum.hpp"

#include "raster/surface/pixel.hpp"
#include "raster/surface/quantize.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::raster {

namespace {

std::int16_t saturated(std::int64_t v) {
    return static_cast<std::int16_t>(v < -accum_one ? -accum_one : v > accum_one ? accum_one : v);
}

/// v / 2^bits to nearest.
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

/// Of a component with `bits` bits (none: the alpha of formats that have none is 1).
constexpr std::int32_t largest(unsigned bits) {
    return bits == 0 ? 1 : (1 << bits) - 1;
}

} // namespace

void clear_accum(const Surface& s, Rect area, const std::int16_t (&value)[4]) {
    each(s, area, [&](std::int32_t, std::int32_t, std::int16_t* a) {
        for (int c = 0; c < 4; ++c)
            a[c] = value[c];
    });
}

void accumulate(const Surface& s, Rect area, const Surface& source, std::int32_t value, bool load) {
    // k v 32767 / (2^bits - 1): 8 bits k, 32 bits v, 15 and 8 more of the factor.
    constexpr int guard = 8;
    const FormatInfo& info = drawn_info(source.format);
    const unsigned bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
    std::int64_t factor[4];
    for (int c = 0; c < 4; ++c)
        factor[c] = ((std::int64_t{value} * accum_one) << guard) / largest(bits[c]);
    each(s, area, [&](std::int32_t x, std::int32_t y, std::int16_t* a) {
        const StoredColor color = read_color(source, x, y);
        for (int c = 0; c < 4; ++c)
            a[c] = saturated(rounded(color.c[c].k * factor[c], accum_value_bits + guard) + (load ? 0 : a[c]));
    });
}

void multiply_accum(const Surface& s, Rect area, std::int32_t value) {
    each(s, area, [value](std::int32_t, std::int32_t, std::int16_t* a) {
        for (int c = 0; c < 4; ++c)
            a[c] = saturated(rounded(std::int64_t{a[c]} * value, accum_value_bits));
    });
}

void add_accum(const Surface& s, Rect area, std::int32_t value) {
    const std::int64_t v = rounded(std::int64_t{value} * accum_one, accum_value_bits);
    each(s, area, [v](std::int32_t, std::int32_t, std::int16_t* a) {
        for (int c = 0; c < 4; ++c)
            a[c] = saturated(a[c] + v);
    });
}

void return_accum(const Surface& s, Rect area, std::int32_t value, std::uint8_t channels, bool dither) {
    // In colour units: 15 bits A, 32 bits v, 14 bits of color_one / 32767.
    const std::int64_t factor = std::int64_t{value} * color_one / accum_one;
    const FormatInfo& info = drawn_info(s.format);
    const unsigned bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
    each(s, area, [&](std::int32_t x, std::int32_t y, const std::int16_t* a) {
        const StoredColor under = read_color(s, x, y);
        const std::uint32_t threshold = dither_threshold(dither_row(y), x);
        std::uint32_t k[4];
        for (unsigned c = 0; c < 4; ++c) {
            k[c] = under.c[c].k;
            if ((channels >> c & 1) == 0 || bits[c] == 0)
                continue;
            const std::int64_t v = rounded(a[c] * factor, accum_return_bits);
            const auto units = static_cast<std::uint32_t>(v < 0 ? 0 : v > color_one ? color_one : v);
            k[c] = stored_component(units, bits[c], dither, threshold);
        }
        write_color(s, x, y, k);
    });
}

namespace {

/// What two areas have in common; empty where it is nothing.
Rect common(const Rect& a, const Rect& b) {
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
        return accumulate(s, common(r.area, source.area()), source, r.value, r.op == Op::load);
    case Op::multiply:
        return multiply_accum(s, r.area, r.value);
    case Op::add:
        return add_accum(s, r.area, r.value);
    case Op::give_back:
        return each_sample(s, [&r](const Surface& sample, unsigned) {
            return_accum(sample, r.area, r.value, r.channels, r.dither);
        });
    }
}

} // namespace spangle::raster
