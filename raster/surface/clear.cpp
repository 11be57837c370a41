#include "raster/surface/clear.hpp"

#include <bit>

#include "raster/surface/quantize.hpp"

namespace spangle::raster {

namespace {

/// Sixteen bytes of a row, repeated; every pixel size here divides them but rgb888's three.
struct Pattern {
    std::uint8_t byte[48] = {}; ///< three times sixteen, so that three-byte pixels repeat too
    std::int32_t period = 16;   ///< 16 or 48
};

using Vector [[gnu::vector_size(16), gnu::aligned(1), gnu::may_alias]] = std::uint64_t;

void copy_bytes(std::uint8_t* to, const std::uint8_t* from, std::int32_t n) {
    for (std::int32_t i = 0; i < n; ++i)
        to[i] = from[i];
}

/// `bytes` bytes of the pattern, from its start; nothing beyond is touched.
void fill(std::uint8_t* to, const Pattern& pattern, std::int32_t bytes) {
    std::int32_t left = bytes;
    if (pattern.period == 16) {
        const Vector v = *reinterpret_cast<const Vector*>(pattern.byte);
        for (; left >= 64; left -= 64, to += 64) {
            Vector* const at = reinterpret_cast<Vector*>(to); // not auto: deduction drops the alignment
            at[0] = v;
            at[1] = v;
            at[2] = v;
            at[3] = v;
        }
        for (; left >= 16; left -= 16, to += 16)
            *reinterpret_cast<Vector*>(to) = v;
    } else {
        for (; left >= 48; left -= 48, to += 48)
            copy_bytes(to, pattern.byte, 48);
    }
    copy_bytes(to, pattern.byte, left);
}

std::uint32_t component(std::uint32_t c, unsigned bits, bool dither, std::uint32_t threshold) {
    if (bits == 8)
        return color_to_8(c);
    if (bits == 5)
        return dither ? dithered<5>(c, threshold) : truncated<5>(c);
    return dither ? dithered<6>(c, threshold) : truncated<6>(c);
}

/// One pixel as it lies in memory.
struct Pixel {
    std::uint8_t byte[4];
};

Pixel pack(PixelFormat format, const std::uint32_t (&color)[4], bool dither, std::uint32_t threshold) {
    const FormatInfo info = format_info(format);
    const std::uint32_t r = component(color[0], info.red_bits, dither, threshold);
    const std::uint32_t g = component(color[1], info.green_bits, dither, threshold);
    const std::uint32_t b = component(color[2], info.blue_bits, dither, threshold);
    const auto low = [](std::uint32_t v) { return static_cast<std::uint8_t>(v); };
    switch (format) {
    case PixelFormat::rgb565_be:
        return {{low(r << 3 | g >> 3), low(g << 5 | b), 0, 0}};
    case PixelFormat::rgb565_le:
        return {{low(g << 5 | b), low(r << 3 | g >> 3), 0, 0}};
    default:
        return {{low(r), low(g), low(b), low(color_to_8(color[3]))}};
    }
}

/// Bits of a pixel that the channels name, as they lie in memory.
Pixel mask_of(PixelFormat format, std::uint8_t channels) {
    const std::uint32_t one = color_one;
    const std::uint32_t color[4] = {(channels & 1) != 0 ? one : 0, (channels & 2) != 0 ? one : 0,
                                    (channels & 4) != 0 ? one : 0, (channels & 8) != 0 ? one : 0};
    return pack(format, color, false, 0);
}

/// The pixels of row y from column x on.
Pattern row_pattern(const Surface& s, const ClearRequest& r, std::int32_t x, std::int32_t y) {
    const std::int32_t bytes = format_info(s.format).bytes_per_pixel;
    Pattern p;
    p.period = bytes == 3 ? 48 : 16;
    const std::uint32_t row = dither_row(y);
    for (std::int32_t i = 0; i * bytes < p.period; ++i) {
        const Pixel pixel = pack(s.format, r.color, r.dither, dither_threshold(row, x + i));
        copy_bytes(p.byte + i * bytes, pixel.byte, bytes);
    }
    return p;
}

bool writes_all(PixelFormat format, std::uint8_t channels) {
    const std::uint8_t needed = format_info(format).alpha_bits != 0 ? 0xF : 0x7;
    return (channels & needed) == needed;
}

void fill_masked(std::uint8_t* to, const Pattern& pattern, const Pixel& mask, std::int32_t bytes_per_pixel,
                 std::int32_t bytes) {
    for (std::int32_t i = 0, phase = 0; i < bytes;
         ++i, phase = phase + 1 == bytes_per_pixel ? 0 : phase + 1) {
        const unsigned keep = mask.byte[phase];
        to[i] = static_cast<std::uint8_t>((to[i] & ~keep) | (pattern.byte[i % pattern.period] & keep));
    }
}

void clear_color(const Surface& s, const ClearRequest& r) {
    const std::int32_t bytes = format_info(s.format).bytes_per_pixel, row_bytes = r.area.w * bytes;
    const bool all = writes_all(s.format, r.channels),
               dithers = r.dither && format_info(s.format).red_bits < 8;
    const Pixel mask = mask_of(s.format, r.channels);
    Pattern pattern[4];
    for (std::int32_t i = 0; i < (dithers ? 4 : 1); ++i)
        pattern[i] = row_pattern(s, r, r.area.x, r.area.y + i);
    for (std::int32_t y = 0; y < r.area.h; ++y) {
        std::uint8_t* const at = s.color_row(r.area.y + y) + static_cast<std::intptr_t>(r.area.x) * bytes;
        const Pattern& p = pattern[dithers ? y & 3 : 0];
        if (all)
            fill(at, p, row_bytes);
        else
            fill_masked(at, p, mask, bytes, row_bytes);
    }
}

void clear_z16(const Surface& s, const ClearRequest& r) {
    const auto code = static_cast<std::uint16_t>(depth_to_16(r.z));
    Pattern p;
    for (int i = 0; i < 16; i += 2)
        __builtin_memcpy(p.byte + i, &code, sizeof code);
    for (std::int32_t y = 0; y < r.area.h; ++y)
        fill(s.depth_row(r.area.y + y) + static_cast<std::intptr_t>(r.area.x) * 2, p, r.area.w * 2);
}

void clear_z24s8(const Surface& s, const ClearRequest& r) {
    const std::uint32_t word = depth_to_24(r.z) << 8 | r.stencil;
    const std::uint32_t mask = (r.depth ? 0xFFFFFF00u : 0u) | r.stencil_mask;
    Pattern p;
    for (int i = 0; i < 16; i += 4)
        __builtin_memcpy(p.byte + i, &word, sizeof word);
    for (std::int32_t y = 0; y < r.area.h; ++y) {
        std::uint8_t* at = s.depth_row(r.area.y + y) + static_cast<std::intptr_t>(r.area.x) * 4;
        if (mask == 0xFFFFFFFFu) {
            fill(at, p, r.area.w * 4);
            continue;
        }
        for (std::int32_t x = 0; x < r.area.w; ++x, at += 4) {
            std::uint32_t old;
            __builtin_memcpy(&old, at, sizeof old);
            const std::uint32_t fresh = (old & ~mask) | (word & mask);
            __builtin_memcpy(at, &fresh, sizeof fresh);
        }
    }
}

/// Equal for equal pictures of a full clear: the colour as stored where nothing is dithered, else as given.
std::uint32_t clear_value(const Surface& s, const ClearRequest& r) {
    std::uint32_t hash = r.dither && format_info(s.format).red_bits < 8 ? 1u : 0u;
    if (hash == 0) {
        const Pixel pixel = pack(s.format, r.color, false, 0);
        for (const std::uint8_t byte : pixel.byte)
            hash = (hash ^ byte) * 0x01000193u;
        return hash;
    }
    for (const std::uint32_t c : r.color)
        hash = (hash ^ c) * 0x9E3779B1u ^ (hash >> 15);
    return hash;
}

void record(const Surface& s, const ClearRequest& r) {
    const bool whole = r.area == Rect{0, 0, s.width, s.height} && writes_all(s.format, r.channels);
    if (!whole || s.extents == nullptr) {
        for (std::int32_t y = r.area.y; y < r.area.y + r.area.h; ++y)
            touch(s, y, r.area.x, r.area.x + r.area.w);
        return;
    }
    for (std::int32_t i = 0; i < s.extents->height; ++i)
        s.extents->rows[i] = RowSpan{};
    s.extents->cleared = true;
    s.extents->clear_value = clear_value(s, r);
}

} // namespace

void clear(const Surface& surface, const ClearRequest& request) {
    if (request.area.w <= 0 || request.area.h <= 0)
        return;
    if (surface.color != nullptr && request.channels != 0) {
        clear_color(surface, request);
        record(surface, request);
    }
    if (surface.depth_format == DepthFormat::z16 && request.depth)
        clear_z16(surface, request);
    if (surface.depth_format == DepthFormat::z24s8 && (request.depth || request.stencil_mask != 0))
        clear_z24s8(surface, request);
}

} // namespace spangle::raster
