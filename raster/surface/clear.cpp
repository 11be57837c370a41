#include <spangle/raster/clear.hpp>

#include <bit>

#include "raster/surface/fill_pattern.hpp"
#include "raster/surface/narrow.hpp"
#include "raster/surface/quantize.hpp"
#include "raster/surface/surface.hpp"
#include <spangle/raster/limits.hpp>

namespace spangle::raster {

namespace {

using namespace clearing;

/// Fills rows of a plane with one pattern, or with four by turns. Where the mask is not null, only its bits
/// are written.
void fill_rows(std::uint8_t* first, std::int32_t stride, std::int32_t rows, const Pattern* pattern,
               std::int32_t patterns, const Pattern* mask, std::int32_t bytes) {
    // Rows that touch are filled as one piece.
    if (joins_rows && patterns == 1 && (stride == bytes || stride == -bytes) &&
        bytes % pattern->period() == 0) {
        if (stride < 0)
            first += static_cast<std::intptr_t>(rows - 1) * stride;
        bytes *= rows;
        rows = 1;
    }
    for (std::int32_t y = 0; y < rows; ++y, first += stride) {
        const Pattern& of_row = pattern[y & (patterns - 1)];
        if (mask == nullptr)
            fill(first, of_row, bytes);
        else
            fill_masked(first, of_row, *mask, bytes);
    }
}

/// Repeats the first `bytes` bytes, whole words, to the length that fill() reads.
void repeat(Pattern& p, std::int32_t bytes) {
    for (std::int32_t i = bytes; i < 64; i += 4)
        __builtin_memcpy(__builtin_assume_aligned(p.byte + i, 4),
                         __builtin_assume_aligned(p.byte + i - bytes, 4), 4);
}

/// One pixel as it lies in memory.
struct Pixel {
    std::uint8_t byte[4];
};

Pixel pack(PixelFormat format, const std::uint32_t (&color)[4], bool dither, std::uint32_t threshold) {
    if (drawn_indexed(format))
        return {{static_cast<std::uint8_t>(stored_index(color[0], dither, threshold)), 0, 0, 0}};
    const FormatInfo& info = drawn_info(format);
    const std::uint32_t r = stored_component(color[0], info.red_bits, dither, threshold);
    const std::uint32_t g = stored_component(color[1], info.green_bits, dither, threshold);
    const std::uint32_t b = stored_component(color[2], info.blue_bits, dither, threshold);
    const auto low = [](std::uint32_t v) { return static_cast<std::uint8_t>(v); };
    switch (drawn(format)) {
    case PixelFormat::rgb565_be:
        return {{low(r << 3 | g >> 3), low(g << 5 | b), 0, 0}};
    case PixelFormat::rgb565_le:
        return {{low(g << 5 | b), low(r << 3 | g >> 3), 0, 0}};
    default:
        return {{low(r), low(g), low(b), low(color_to_8(color[3]))}};
    }
}

/// Sets the pattern to the pixels of row y from column x on.
void set_pattern(Pattern& p, PixelFormat format, const std::uint32_t (&color)[4], bool dither, std::int32_t x,
                 std::int32_t y) {
    const std::int32_t bytes = drawn_info(format).bytes_per_pixel;
    p.bytes = bytes == 3 ? 48 : 16;
    const std::uint32_t row = dither_row(y);
    for (std::int32_t i = 0; i < 4; ++i) { // the dither matrix has four columns
        const Pixel pixel = pack(format, color, dither, dither_threshold(row, x + i));
        copy_bytes(p.byte + i * bytes, pixel.byte, bytes);
    }
    repeat(p, 4 * bytes);
}

bool writes_all(PixelFormat format, std::uint8_t channels) {
    const std::uint8_t needed = drawn_indexed(format) ? 0xFF : drawn_info(format).alpha_bits != 0 ? 0xF : 0x7;
    return (channels & needed) == needed;
}

/// Sets the mask to the bits of the named channels. They are the bits of a colour that is 1 in these channels
/// and 0 in all others.
void set_mask(Pattern& p, PixelFormat format, std::uint8_t channels) {
    std::uint32_t color[4];
    for (unsigned c = 0; c < 4; ++c)
        color[c] = (channels >> c & 1) != 0 ? color_one : 0;
    if (drawn_indexed(format))
        color[0] = std::uint32_t{channels} << color_fraction_bits;
    set_pattern(p, format, color, false, 0, 0);
}

/// The stored bits of a clear colour on a surface of a narrow format.
std::uint32_t narrow_clear_word(PixelFormat format, const ClearRequest& r, std::uint32_t threshold) {
    const Rgb8 rgb = {color_to_8(r.color[0]), color_to_8(r.color[1]), color_to_8(r.color[2])};
    if (!has_format(PixelFormat::rgb666) || format != PixelFormat::rgb666)
        return narrow_word(format, rgb, r.dither, threshold);
    if (!r.dither)
        return word_666(rgb.r >> 2, rgb.g >> 2, rgb.b >> 2);
    return word_666(dithered<6>(r.color[0], threshold), dithered<6>(r.color[1], threshold),
                    dithered<6>(r.color[2], threshold));
}

/// Clears mono surfaces, whose bytes hold eight rows each: rows that share bytes are written at once.
void clear_pages(const Surface& s, const Rect& area, const std::uint32_t (&word)[4][4]) {
    for (std::int32_t y = area.y, end = 0; y < area.y + area.h; y = end) {
        end = (y | 7) + 1 < area.y + area.h ? (y | 7) + 1 : area.y + area.h;
        unsigned rows = 0, columns[4] = {};
        for (std::int32_t i = y; i < end; ++i) {
            rows |= 0x80u >> (i & 7);
            for (int x = 0; x < 4; ++x)
                columns[x] |= word[i & 3][x] != 0 ? 0x80u >> (i & 7) : 0;
        }
        const std::uint8_t bytes[4] = {
            static_cast<std::uint8_t>(columns[0]), static_cast<std::uint8_t>(columns[1]),
            static_cast<std::uint8_t>(columns[2]), static_cast<std::uint8_t>(columns[3])};
        fill_page(s.color_row(y), static_cast<std::uint8_t>(rows), area.x, area.x + area.w, bytes);
    }
}

/// Clears with some channels masked. A masked component is converted to colour units that are stored as the
/// same steps again.
void clear_narrow_masked(const Surface& s, const ClearRequest& r) {
    for (std::int32_t y = r.area.y; y < r.area.y + r.area.h; ++y) {
        const std::uint32_t thresholds = dither_row(y);
        for (std::int32_t x = r.area.x; x < r.area.x + r.area.w; ++x) {
            const NarrowColor old = narrow_color(s.format, load_narrow(s.format, s.color_row(y), x, y));
            ClearRequest fresh = r;
            for (int i = 0; i < 3; ++i)
                if ((r.channels >> i & 1) == 0)
                    fresh.color[i] = narrow_units(old.k[i], old.max[i]);
            store_narrow(s.format, s.color_row(y), x, y,
                         narrow_clear_word(s.format, fresh, dither_threshold(thresholds, x)));
        }
    }
}

[[maybe_unused]] void clear_narrow(const Surface& s, const ClearRequest& r) {
    if ((r.channels & 7) != 7)
        return clear_narrow_masked(s, r);
    std::uint32_t word[4][4];
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            word[y][x] = narrow_clear_word(s.format, r, dither_threshold(dither_row(y), x));
    if (s.format == PixelFormat::mono)
        return clear_pages(s, r.area, word);
    for (std::int32_t y = r.area.y; y < r.area.y + r.area.h; ++y)
        fill_narrow(s.format, s.color_row(y), y, r.area.x, r.area.x + r.area.w, word[y & 3]);
}

void clear_wide(const Surface& s, const ClearRequest& r) {
    const std::int32_t bytes = drawn_info(s.format).bytes_per_pixel;
    const bool all = writes_all(s.format, r.channels),
               dithers = r.dither && drawn_info(s.format).red_bits < 8;
    Pattern pattern[4], mask;
    for (std::int32_t i = 0; i < (dithers ? 4 : 1); ++i)
        set_pattern(pattern[i], s.format, r.color, r.dither, r.area.x, r.area.y + i);
    if (!all)
        set_mask(mask, s.format, r.channels);
    fill_rows(s.color_row(r.area.y) + static_cast<std::intptr_t>(r.area.x) * bytes, s.color_stride, r.area.h,
              pattern, dithers ? 4 : 1, all ? nullptr : &mask, r.area.w * bytes);
}

void clear_color(const Surface& s, const ClearRequest& r) {
    if (has_wide_formats && !drawn_narrow(s.format))
        clear_wide(s, r);
    else if constexpr (has_narrow_formats)
        clear_narrow(s, r);
}

/// Clears the bits of the mask in the depth plane. `word` holds two equal pixels of 16 bits or one of 32;
/// `pixel` is the size of a pixel in bytes.
void clear_depth(const Surface& s, const Rect& area, std::uint32_t word, std::uint32_t mask,
                 std::int32_t pixel) {
    const bool all = mask == 0xFFFFFFFFu;
    Pattern p, open;
    __builtin_memcpy(p.byte, &word, sizeof word);
    repeat(p, 4);
    if (!all) {
        __builtin_memcpy(open.byte, &mask, sizeof mask);
        repeat(open, 4);
    }
    fill_rows(s.depth_row(area.y) + static_cast<std::intptr_t>(area.x) * pixel, s.depth_stride, area.h, &p, 1,
              all ? nullptr : &open, area.w * pixel);
}

void clear_z24s8(const Surface& s, const ClearRequest& r) {
    const std::uint32_t mask = (r.depth ? 0xFFFFFF00u : 0u) | r.stencil_mask;
    clear_depth(s, r.area, depth_to_24(r.z) << 8 | r.stencil, mask, 4);
}

/// A value that is equal for two full clears exactly if their pictures are equal. Pixels of 24 and 32 bits
/// are never dithered, so it is the pixel itself. For 16 bits it is the sum of each component over the
/// sixteen thresholds. The sum grows with every pixel that changes (at most 31 * 16 and 63 * 16, which take
/// 9, 10 and 9 bits).
std::uint32_t clear_value(const Surface& s, const ClearRequest& r) {
    const FormatInfo& info = drawn_info(s.format);
    if (info.red_bits == 8) {
        const Pixel p = pack(s.format, r.color, false, 0);
        const std::uint32_t alpha = info.alpha_bits != 0 ? p.byte[3] : 0u;
        return std::uint32_t{p.byte[0]} | std::uint32_t{p.byte[1]} << 8 | std::uint32_t{p.byte[2]} << 16 |
               alpha << 24;
    }
    std::uint32_t red = 0, green = 0, blue = 0;
    for (std::uint32_t threshold = 1; drawn_indexed(s.format) && threshold < 32; threshold += 2)
        red += stored_index(r.color[0], r.dither, threshold);
    if (drawn_indexed(s.format))
        return red;
    for (std::uint32_t threshold = 1; drawn_narrow(s.format) && threshold < 32; threshold += 2) {
        const NarrowColor c = narrow_color(s.format, narrow_clear_word(s.format, r, threshold));
        red += c.k[0];
        green += c.k[1];
        blue += c.k[2];
    }
    if (drawn_narrow(s.format)) // each sum is at most 63 * 16
        return red | green << 10 | blue << 20;
    for (std::uint32_t threshold = 1; threshold < 32; threshold += 2) {
        red += stored_component(r.color[0], 5, r.dither, threshold);
        green += stored_component(r.color[1], 6, r.dither, threshold);
        blue += stored_component(r.color[2], 5, r.dither, threshold);
    }
    return red | green << 9 | blue << 19;
}

void record(const Surface& s, const ClearRequest& r) {
    if (!clears_all(s, r) || s.extents == nullptr) {
        for (std::int32_t y = r.area.y; y < r.area.y + r.area.h; ++y)
            mark_damage(s, y, r.area.x, r.area.x + r.area.w);
        return;
    }
    for (std::int32_t i = 0; i < s.extents->height; ++i)
        s.extents->rows[i] = RowSpan{};
    s.extents->cleared = true;
    s.extents->clear_value = clear_value(s, r);
}

} // namespace

bool clears_all(const Surface& s, const ClearRequest& r) {
    return r.area == s.area() && writes_all(s.format, r.channels);
}

void clear(const Surface& surface, const ClearRequest& request) {
    if (request.area.w <= 0 || request.area.h <= 0)
        return;
    if (surface.color != nullptr && request.channels != 0) {
        clear_color(surface, request);
        record(surface, request);
    }
    if (has_format(DepthFormat::z16) && surface.depth_format == DepthFormat::z16 && request.depth)
        clear_depth(surface, request.area, depth_to_16(request.z) * 0x10001u, 0xFFFFFFFFu, 2);
    if (has_format(DepthFormat::z24s8) && surface.depth_format == DepthFormat::z24s8 &&
        (request.depth || request.stencil_mask != 0))
        clear_z24s8(surface, request);
}

} // namespace spangle::raster
