// Compares the multisample buffer with a reading of GL 1.3, 4.1.10 and 4.2.3: means component by component,
// of what was touched and nothing else.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "raster/surface/pixel.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::raster {
namespace {

constexpr int width = 21, height = 13;

struct Buffers {
    std::vector<std::uint8_t> color, depth, samples;
    std::vector<RowSpan> rows, unresolved;
    RowExtents extents;
    Samples buffer;
    Surface s;
    Buffers(PixelFormat format, DepthFormat depth_format)
        : color(plane(format)), depth(std::size_t{width} * height * 4 * sample_count),
          samples(color.size() * sample_count), rows(height), unresolved(height) {
        const std::int32_t stride = row_bytes(format, width);
        const auto last = static_cast<std::ptrdiff_t>(stored_rows(format, height) - 1);
        extents = {rows.data(), height, false, 0};
        s.format = format;
        s.depth_format = depth_format;
        s.width = width;
        s.height = height;
        s.color = color.data() + last * stride; // top row first
        s.color_stride = -stride;
        s.depth = depth.data();
        s.depth_stride = width * 4;
        s.extents = &extents;
        s.touched = rows.data() + height - 1;
        s.touched_step = -1;
        buffer = {samples.data(), stride, static_cast<std::ptrdiff_t>(color.size()), width * height * 4,
                  unresolved.data()};
        s.samples = &buffer;
    }
    static std::size_t plane(PixelFormat format) {
        return static_cast<std::size_t>(row_bytes(format, width) * stored_rows(format, height));
    }
    RowSpan touched(std::int32_t y) const { return rows[static_cast<std::size_t>(height - 1 - y)]; }
};

constexpr int formats = static_cast<int>(PixelFormat::index8); // surfaces of indices have no samples
struct OfFormat : testing::TestWithParam<int> {
    PixelFormat format = static_cast<PixelFormat>(GetParam());
    std::mt19937 random{static_cast<std::uint32_t>(GetParam())};
};

TEST_P(OfFormat, ColoursAreMeansWhereSomethingWasDrawn) {
    Buffers b(format, DepthFormat::none);
    for (auto& byte : b.samples)
        byte = static_cast<std::uint8_t>(random());
    for (auto& byte : b.color)
        byte = 0x5A;
    const Buffers before = b;
    RowSpan drawn[height];
    for (int y = 0; y < height; ++y) {
        if (y % 3 == 0)
            continue;
        const auto begin = static_cast<std::int16_t>(random() % width);
        drawn[y] = {begin,
                    static_cast<std::int16_t>(begin + 1 + random() % (width - static_cast<unsigned>(begin)))};
        b.unresolved[static_cast<std::size_t>(y)] = drawn[y];
    }
    resolve(b.s);
    Surface old = b.s;
    old.color = const_cast<std::uint8_t*>(before.color.data()) + (b.s.color - b.color.data());
    for (std::int32_t y = 0; y < height; ++y) {
        EXPECT_EQ(b.touched(y), drawn[y]);
        EXPECT_EQ(b.unresolved[static_cast<std::size_t>(y)], RowSpan{}) << "nothing is left to do";
        for (std::int32_t x = 0; x < width; ++x) {
            const StoredColor got = read_color(b.s, x, y);
            const bool inside = x >= drawn[y].begin && x < drawn[y].end;
            for (int c = 0; c < 4; ++c) {
                unsigned sum = 2;
                for (unsigned i = 0; i < sample_count; ++i)
                    sum += read_color(sample_of(b.s, i), x, y).c[c].k;
                ASSERT_EQ(got.c[c].k, inside ? sum / 4 : read_color(old, x, y).c[c].k)
                    << x << ',' << y << ' ' << c;
            }
        }
    }
}

/// A whole clear is not resolved: the display gets it as any other clear.
TEST_P(OfFormat, WholeClearsAreShownAtOnce) {
    Buffers b(format, DepthFormat::z24s8);
    ClearRequest request;
    request.area = {0, 0, width, height};
    request.channels = 0xF;
    request.dither = true;
    for (auto& c : request.color)
        c = static_cast<std::uint32_t>(random() % (color_one + 1));
    request.depth = true;
    request.stencil_mask = 0xFF;
    request.stencil = 0x35;
    request.z = depth_one / 3;
    b.unresolved[4] = {3, 9};
    clear_samples(b.s, request);
    EXPECT_TRUE(b.extents.cleared);
    Buffers plain(format, DepthFormat::z24s8);
    plain.s.samples = nullptr;
    clear(plain.s, request);
    EXPECT_EQ(b.extents.clear_value, plain.extents.clear_value);
    EXPECT_EQ(b.color, plain.color);
    for (const RowSpan& row : b.unresolved)
        EXPECT_EQ(row, RowSpan{});
    for (unsigned i = 0; i < sample_count; ++i)
        for (std::int32_t y = 0; y < height; ++y)
            for (std::int32_t x = 0; x < width; ++x) {
                const Surface sample = sample_of(b.s, i);
                ASSERT_EQ(read_stencil(sample, x, y), 0x35);
                ASSERT_EQ(read_depth(sample, x, y).k, read_depth(plain.s, x, y).k);
                for (int c = 0; c < 4; ++c)
                    ASSERT_EQ(read_color(sample, x, y).c[c], read_color(plain.s, x, y).c[c]);
            }
}

/// After a clear of a part, or of some channels, each pixel is the mean of old and new samples.
TEST_P(OfFormat, OtherClearsAreResolvedLater) {
    for (const bool masked : {false, true}) {
        Buffers b(format, DepthFormat::none);
        ClearRequest request;
        request.area = masked ? Rect{0, 0, width, height} : Rect{3, 2, 9, 5};
        request.channels = masked ? 3 : 0xF;
        request.color[0] = request.color[1] = request.color[2] = color_one;
        const std::vector<std::uint8_t> shown = b.color;
        clear_samples(b.s, request);
        EXPECT_FALSE(b.extents.cleared);
        EXPECT_EQ(b.color, shown) << "not yet";
        EXPECT_EQ(b.unresolved[3], (masked ? RowSpan{0, width} : RowSpan{3, 12}));
        resolve(b.s);
        const StoredColor in = read_color(b.s, 5, 3), out = read_color(b.s, 15, 9);
        if (!masked || !format_info(format).grey) { // the mask counts for the luma
            EXPECT_EQ(in.c[0].k, in.c[0].max);
        }
        EXPECT_EQ(out.c[0].k, masked ? in.c[0].k : 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, OfFormat, testing::Range(0, formats));

TEST(Samples, SurfacesWithoutThemAreDrawnOnce) {
    Buffers b(PixelFormat::rgba8888, DepthFormat::z24s8);
    std::vector<unsigned> drawn;
    each_sample(b.s, [&](const Surface& s, unsigned i) {
        EXPECT_EQ(s.color - b.samples.data(), static_cast<std::ptrdiff_t>(i) * width * height * 4);
        EXPECT_EQ(s.depth - b.depth.data(), static_cast<std::ptrdiff_t>(i) * width * height * 4);
        drawn.push_back(i);
    });
    EXPECT_EQ(drawn, (std::vector<unsigned>{0, 1, 2, 3}));
    b.s.samples = nullptr;
    each_sample(b.s, [&](const Surface& s, unsigned i) {
        EXPECT_EQ(s.color, b.s.color);
        EXPECT_EQ(i, 0u);
        drawn.clear();
    });
    EXPECT_TRUE(drawn.empty());
}

} // namespace
} // namespace spangle::raster
