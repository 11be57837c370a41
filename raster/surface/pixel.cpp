#include "raster/surface/pixel.hpp"

#include "raster/surface/narrow.hpp"
#include <spangle/raster/limits.hpp>

namespace spangle::raster {
namespace {

std::uint8_t* color_at(const Surface& s, std::int32_t x, std::int32_t y) {
    return s.color_row(y) + static_cast<std::intptr_t>(x) * drawn_info(s.format).bytes_per_pixel;
}

// Depth words are in host order. Their bytes are copied, because a plane may start at any address.
template <class Word> Word load(const Surface& s, std::int32_t x, std::int32_t y) {
    Word v;
    __builtin_memcpy(&v, s.depth_row(y) + static_cast<std::intptr_t>(x) * std::intptr_t{sizeof(Word)},
                     sizeof v);
    return v;
}

template <class Word> void store(const Surface& s, std::int32_t x, std::int32_t y, Word v) {
    __builtin_memcpy(s.depth_row(y) + static_cast<std::intptr_t>(x) * std::intptr_t{sizeof(Word)}, &v,
                     sizeof v);
}

std::uint32_t load_bytes(const std::uint8_t* p, unsigned count) {
    std::uint32_t v = 0;
    for (unsigned i = 0; i < count; ++i)
        v |= std::uint32_t{p[i]} << (8 * i);
    return v;
}

StoredColor read_narrow(const Surface& s, std::int32_t x, std::int32_t y) {
    const NarrowColor c = narrow_color(s.format, load_narrow(s.format, s.color_row(y), x, y));
    return {{{c.k[0], c.max[0]}, {c.k[1], c.max[1]}, {c.k[2], c.max[2]}, {1, 1}}};
}

/// Packs components next to each other, red in the highest bits, as narrow words have them.
std::uint32_t word_of(PixelFormat format, const std::uint32_t k[4]) {
    const FormatInfo f = format_info(format);
    return f.grey ? k[0] : (k[0] << f.green_bits | k[1]) << f.blue_bits | k[2];
}

} // namespace

StoredColor read_color(const Surface& s, std::int32_t x, std::int32_t y) {
    if (drawn_narrow(s.format))
        return read_narrow(s, x, y);
    return unpack_pixel(drawn(s.format), load_bytes(color_at(s, x, y), drawn_info(s.format).bytes_per_pixel));
}

void read_color_row(const Surface& s, std::int32_t x, std::int32_t y, std::int32_t count, StoredColor* out) {
    if (drawn_narrow(s.format)) {
        for (std::int32_t i = 0; i < count; ++i)
            out[i] = read_narrow(s, x + i, y);
        return;
    }
    const unsigned bytes = drawn_info(s.format).bytes_per_pixel;
    const std::uint8_t* p = color_at(s, x, y);
    for (std::int32_t i = 0; i < count; ++i, p += bytes)
        out[i] = unpack_pixel(drawn(s.format), load_bytes(p, bytes));
}

std::uint8_t read_index(const Surface& s, std::int32_t x, std::int32_t y) {
    return drawn_indexed(s.format) ? *color_at(s, x, y) : std::uint8_t{0};
}

StoredDepth read_depth(const Surface& s, std::int32_t x, std::int32_t y) {
    switch (s.depth_format) {
    case DepthFormat::none:
        break;
    case DepthFormat::z16:
        return {load<std::uint16_t>(s, x, y), 0xFFFF};
    case DepthFormat::z24s8:
        return {load<std::uint32_t>(s, x, y) >> 8, 0xFFFFFF};
    }
    return {};
}

std::uint8_t read_stencil(const Surface& s, std::int32_t x, std::int32_t y) {
    return has_format(DepthFormat::z24s8) && s.depth_format == DepthFormat::z24s8
               ? static_cast<std::uint8_t>(load<std::uint32_t>(s, x, y))
               : std::uint8_t{0};
}

void write_color(const Surface& s, std::int32_t x, std::int32_t y, const std::uint32_t k[4]) {
    mark_damage(s, y, x, x + 1);
    if (drawn_narrow(s.format))
        return store_narrow(s.format, s.color_row(y), x, y, word_of(s.format, k));
    const std::uint32_t v = pack_pixel(drawn(s.format), k);
    std::uint8_t* p = color_at(s, x, y);
    for (unsigned i = 0; i < drawn_info(s.format).bytes_per_pixel; ++i)
        p[i] = static_cast<std::uint8_t>(v >> (8 * i));
}

void write_stencil(const Surface& s, std::int32_t x, std::int32_t y, std::uint8_t value) {
    if (has_format(DepthFormat::z24s8) && s.depth_format == DepthFormat::z24s8)
        store(s, x, y, (load<std::uint32_t>(s, x, y) & 0xFFFFFF00u) | value);
}

} // namespace spangle::raster
