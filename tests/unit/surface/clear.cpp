// Compares clears with single pixels by GL's rules. Nothing outside of the rectangle may change.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "raster/surface/pixel.hpp"
#include <spangle/raster/clear.hpp>

namespace spangle::raster {
namespace {

constexpr PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                   PixelFormat::rgba8888};

/// Planes of exactly the size needed, `shift` bytes off alignment, so that ASan sees every stray byte.
struct Planes {
    std::unique_ptr<std::uint8_t[]> color, depth;
    std::size_t color_bytes, depth_bytes;
    std::vector<RowSpan> rows;
    RowExtents extents;
    Surface s;
    Planes(PixelFormat format, DepthFormat depth_format, int w, int h, int shift, int pad, bool top_down) {
        const int bytes = format_info(format).bytes_per_pixel,
                  depth_pixel = depth_format == DepthFormat::z16 ? 2 : 4;
        const int stride = w * bytes + pad, depth_stride = w * depth_pixel;
        color_bytes = static_cast<std::size_t>(shift + (h - 1) * stride + w * bytes);
        depth_bytes = static_cast<std::size_t>(h * depth_stride);
        color = std::make_unique<std::uint8_t[]>(color_bytes);
        depth = std::make_unique<std::uint8_t[]>(depth_bytes);
        for (std::size_t i = 0; i < color_bytes; ++i)
            color[i] = static_cast<std::uint8_t>(i * 7 + 1);
        for (std::size_t i = 0; i < depth_bytes; ++i)
            depth[i] = static_cast<std::uint8_t>(i * 11 + 3);
        rows.resize(static_cast<std::size_t>(h));
        extents.rows = rows.data();
        extents.height = h;
        s.color = color.get() + shift + (top_down ? (h - 1) * stride : 0);
        s.color_stride = top_down ? -stride : stride;
        s.depth = depth.get() + (top_down ? (h - 1) * depth_stride : 0);
        s.depth_stride = top_down ? -depth_stride : depth_stride;
        s.extents = &extents;
        s.touched = rows.data() + (top_down ? h - 1 : 0);
        s.touched_step = top_down ? -1 : 1;
        s.width = w;
        s.height = h;
        s.format = format;
        s.depth_format = depth_format;
    }
};

/// Returns GL's stored component: rounded to eight bits, then the top bits; or dithered: floor(c (2^m - 1) +
/// t).
std::uint32_t stored(std::uint32_t units, int bits, bool dither, int x, int y) {
    static constexpr int matrix[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const double c = static_cast<double>(units) / (255.0 * (1 << 20));
    if (dither && bits < 8)
        return static_cast<std::uint32_t>(c * ((1 << bits) - 1) + (matrix[y & 3][x & 3] + 0.5) / 16);
    return static_cast<std::uint32_t>(std::floor(c * 255 + 0.5)) >> (8 - bits);
}

TEST(Clear, EveryRectangleAlignmentAndMask) {
    std::mt19937 random(1);
    for (const PixelFormat format : formats)
        for (int shift = 0; shift < 4; ++shift)
            for (int width = 1; width <= 70; width += width < 20 ? 1 : 13)
                for (int trial = 0; trial < 6; ++trial) {
                    const int w = width + trial, h = 6;
                    Planes p(format, DepthFormat::z24s8, w, h, shift, trial & 1 ? 5 : 0, trial & 2);
                    const std::vector<std::uint8_t> before(p.color.get(), p.color.get() + p.color_bytes);
                    Planes old(format, DepthFormat::z24s8, w, h, shift, trial & 1 ? 5 : 0, trial & 2);
                    ClearRequest r;
                    r.area = trial == 0 ? Rect{0, 0, w, h} : Rect{trial % w, trial & 1, w - trial % w, h - 2};
                    r.channels = static_cast<std::uint8_t>(trial < 3 ? 0xF : random() & 0xF);
                    r.dither = random() & 1;
                    for (auto& c : r.color)
                        c = random() % (color_one + 1);
                    clear(p.s, r);
                    const FormatInfo info = format_info(format);
                    const int bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
                    for (int y = 0; y < h; ++y)
                        for (int x = 0; x < w; ++x) {
                            const bool inside = x >= r.area.x && x < r.area.x + r.area.w && y >= r.area.y &&
                                                y < r.area.y + r.area.h;
                            const StoredColor now = read_color(p.s, x, y), was = read_color(old.s, x, y);
                            for (int i = 0; i < 4; ++i) {
                                const bool writes = inside && bits[i] != 0 && (r.channels >> i & 1);
                                const std::uint32_t want =
                                    writes ? stored(r.color[i], bits[i], r.dither && i < 3, x, y)
                                           : was.c[i].k;
                                ASSERT_EQ(now.c[i].k, want) << int(format) << ' ' << shift << ' ' << w
                                                            << " at " << x << ',' << y << " component " << i;
                            }
                        }
                    // Padding between rows stays.
                    for (std::size_t i = 0; i < static_cast<std::size_t>(shift); ++i)
                        ASSERT_EQ(p.color[i], before[i]);
                }
}

TEST(Clear, DepthAndStencilUnderMasks) {
    for (const DepthFormat format : {DepthFormat::z16, DepthFormat::z24s8})
        for (const std::uint32_t z : {0u, 1u, depth_one / 3, depth_one / 2, depth_one - 1, depth_one})
            for (const int mask : {0, 0xFF, 0x0F, 0xA5})
                for (int w = 1; w < 40; w += 3)
                    for (const bool depth : {false, true})
                        for (const bool top_down : {false, true}) {
                            Planes p(PixelFormat::rgb565_be, format, w, 5, 0, 0, top_down);
                            Planes old(PixelFormat::rgb565_be, format, w, 5, 0, 0, top_down);
                            ClearRequest r;
                            const int left = mask == 0xA5 ? 0 : w / 3; // whole rows are cleared in one piece
                            r.area = {left, 1, w - left, 4};
                            r.depth = depth;
                            r.z = z;
                            r.stencil = 0x3C;
                            r.stencil_mask = static_cast<std::uint8_t>(mask);
                            clear(p.s, r);
                            const double max = format == DepthFormat::z16 ? 65535 : 16777215;
                            for (int y = 0; y < 5; ++y)
                                for (int x = 0; x < w; ++x) {
                                    const bool inside = x >= r.area.x && y >= 1;
                                    const auto code = static_cast<std::uint32_t>(
                                        std::floor(static_cast<double>(z) / depth_one * max + 0.5));
                                    ASSERT_EQ(read_depth(p.s, x, y).k,
                                              inside && depth ? code : read_depth(old.s, x, y).k);
                                    if (format == DepthFormat::z24s8) {
                                        const int was = read_stencil(old.s, x, y);
                                        ASSERT_EQ(read_stencil(p.s, x, y),
                                                  inside ? (was & ~mask) | (0x3C & mask) : was);
                                    }
                                }
                            for (const RowSpan& row : p.rows)
                                ASSERT_EQ(row, RowSpan{}); // depth is not presented
                        }
}

TEST(Clear, ExtentsOfPartialAndFullClears) {
    for (const bool top_down : {false, true}) {
        Planes p(PixelFormat::rgb565_be, DepthFormat::z16, 20, 6, 0, 0, top_down);
        ClearRequest r;
        r.area = {3, 1, 7, 2};
        r.channels = 0xF;
        clear(p.s, r);
        EXPECT_FALSE(p.extents.cleared);
        for (int y = 0; y < 6; ++y) {
            const RowSpan row = p.rows[static_cast<std::size_t>(top_down ? 5 - y : y)];
            EXPECT_EQ(row, y == 1 || y == 2 ? (RowSpan{3, 10}) : RowSpan{}) << y;
        }
        r.area = {0, 0, 20, 6};
        r.channels = 0x3; // not all channels: every row is touched, nothing is "cleared"
        clear(p.s, r);
        EXPECT_FALSE(p.extents.cleared);
        for (const RowSpan& row : p.rows)
            EXPECT_EQ(row, (RowSpan{0, 20}));
        r.channels = 0x7;
        clear(p.s, r);
        EXPECT_TRUE(p.extents.cleared);
        for (const RowSpan& row : p.rows)
            EXPECT_EQ(row, RowSpan{});
        r.area = {0, 0, 0, 6};
        clear(p.s, r);
        for (const RowSpan& row : p.rows)
            EXPECT_EQ(row, RowSpan{});
    }
}

/// Two full clears have the same clear_value exactly if they store the same bytes.
TEST(Clear, ClearValueTellsPicturesApart) {
    std::mt19937 random(3);
    for (const PixelFormat format : formats) {
        std::map<std::vector<std::uint8_t>, std::uint32_t> value_of;
        std::map<std::uint32_t, std::vector<std::uint8_t>> picture_of;
        for (int i = 0; i < 4000; ++i) {
            Planes p(format, DepthFormat::none, 4, 4, 0, 0, false);
            ClearRequest r;
            r.area = {0, 0, 4, 4};
            r.channels = 0xF;
            r.dither = i & 1;
            for (auto& c : r.color)
                c = i < 1000 ? random() % (color_one + 1)
                             : color_one / 40 * (random() % 3) + (random() % 9 << 18);
            clear(p.s, r);
            const std::vector<std::uint8_t> picture(p.color.get(), p.color.get() + p.color_bytes);
            const std::uint32_t value = p.extents.clear_value;
            const auto [at, fresh] = value_of.emplace(picture, value);
            EXPECT_EQ(at->second, value);
            const auto [back, fresh_value] = picture_of.emplace(value, picture);
            EXPECT_EQ(back->second, picture);
            EXPECT_EQ(fresh, fresh_value);
        }
    }
}

#if SPANGLE_FEATURE_COLOR_INDEX
/// Clears indices by their bits, to the nearest or dithered; the last index is the largest. The record is as
/// with colours.
TEST(Clear, Indices) {
    std::mt19937 random(31);
    for (int trial = 0; trial < 4000; ++trial) {
        const int w = 1 + trial % 40, h = 6;
        Planes p(PixelFormat::index8, DepthFormat::none, w, h, trial % 3, trial & 1 ? 3 : 0, trial & 2);
        Planes old(PixelFormat::index8, DepthFormat::none, w, h, trial % 3, trial & 1 ? 3 : 0, trial & 2);
        ClearRequest r;
        r.area = trial % 4 == 0 ? Rect{0, 0, w, h} : Rect{w / 3, 1, w - w / 3, 4};
        r.channels = trial % 3 == 0 ? static_cast<std::uint8_t>(random() | 1) : std::uint8_t{0xFF};
        r.dither = random() & 1;
        r.color[0] = trial % 5 == 0 ? random() % (256u << 20) : random() % 256 << 20;
        clear(p.s, r);
        const double c = std::fmin(r.color[0] / 1048576.0, 255);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const bool inside = x >= r.area.x && y >= r.area.y && y < r.area.y + r.area.h;
                static constexpr int matrix[4][4] = {
                    {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
                const int want = static_cast<int>(r.dither ? std::floor(c + (matrix[y & 3][x & 3] + 0.5) / 16)
                                                           : std::floor(c + 0.5));
                const int was = read_index(old.s, x, y);
                ASSERT_EQ(read_index(p.s, x, y), inside ? (want & r.channels) | (was & ~r.channels) : was)
                    << trial << " at " << x << ' ' << y;
            }
        EXPECT_EQ(p.extents.cleared, r.area.w == w && r.area.h == h && r.channels == 0xFF) << trial;
    }
}

TEST(Clear, ClearValueOfIndicesTellsPicturesApart) {
    std::map<std::vector<std::uint8_t>, std::uint32_t> value_of;
    std::map<std::uint32_t, std::vector<std::uint8_t>> picture_of;
    std::mt19937 random(7);
    for (int i = 0; i < 4000; ++i) {
        Planes p(PixelFormat::index8, DepthFormat::none, 4, 4, 0, 0, false);
        ClearRequest r;
        r.area = {0, 0, 4, 4};
        r.channels = 0xFF;
        r.dither = i & 1;
        r.color[0] = random() % (256u << 20);
        clear(p.s, r);
        const std::vector<std::uint8_t> picture(p.color.get(), p.color.get() + p.color_bytes);
        EXPECT_EQ(value_of.emplace(picture, p.extents.clear_value).first->second, p.extents.clear_value);
        EXPECT_EQ(picture_of.emplace(p.extents.clear_value, picture).first->second, picture);
    }
}
#endif

} // namespace
} // namespace spangle::raster
