// Tests the narrow formats bit by bit: where pixels lie, what colours become, and that neighbours stay.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "raster/surface/narrow.hpp"
#include "raster/surface/pixel.hpp"
#include <spangle/raster/clear.hpp>

namespace spangle::raster {
namespace {

constexpr PixelFormat formats[] = {PixelFormat::rgb666, PixelFormat::rgb444, PixelFormat::rgb332,
                                   PixelFormat::grey4, PixelFormat::mono};

/// A plane with the top row first, as displays have it, in memory of exactly the size needed.
struct Plane {
    std::vector<std::uint8_t> bytes;
    std::vector<RowSpan> rows;
    RowExtents extents;
    Surface s;
    Plane(PixelFormat format, int w, int h, unsigned seed = 0)
        : bytes(static_cast<std::size_t>(row_bytes(format, w) * stored_rows(format, h))),
          rows(static_cast<std::size_t>(h)) {
        std::mt19937 random(seed);
        for (auto& b : bytes)
            b = static_cast<std::uint8_t>(seed == 0 ? 0 : random());
        if (format == PixelFormat::rgb666)
            for (auto& b : bytes)
                b &= 0xFC;
        extents = {rows.data(), h, false, 0};
        s.format = format;
        s.width = w;
        s.height = h;
        s.color_stride = -row_bytes(format, w);
        s.color = bytes.data() + (stored_rows(format, h) - 1) * row_bytes(format, w);
        s.extents = &extents;
        s.touched = rows.data() + h - 1;
        s.touched_step = -1;
    }
    std::uint32_t word(int x, int y) const { return load_narrow(s.format, s.color_row(y), x, y); }
};

TEST(Narrow, BytesAreTheControllers) {
    const auto bytes = [](PixelFormat format, std::initializer_list<std::uint32_t> words) {
        Plane p(format, static_cast<int>(words.size()), 8);
        int x = 0;
        for (const std::uint32_t word : words)
            store_narrow(format, p.s.color_row(7), x++, 7, word);
        return std::vector<std::uint8_t>(p.bytes.begin(),
                                         p.bytes.begin() + row_bytes(format, static_cast<int>(words.size())));
    };
    using Bytes = std::vector<std::uint8_t>;
    EXPECT_EQ(bytes(PixelFormat::rgb666, {0x3F | 1u << 12}), (Bytes{0x04, 0x00, 0xFC}));
    EXPECT_EQ(bytes(PixelFormat::rgb444, {0x123, 0x456, 0x789}), (Bytes{0x12, 0x34, 0x56, 0x78, 0x90}))
        << "RRRRGGGG BBBBRRRR GGGGBBBB";
    EXPECT_EQ(bytes(PixelFormat::rgb332, {0xE3, 0x1C}), (Bytes{0xE3, 0x1C}));
    EXPECT_EQ(bytes(PixelFormat::grey4, {0xA, 0x5, 0x3}), (Bytes{0xA5, 0x30}));
    EXPECT_EQ(bytes(PixelFormat::mono, {1, 0, 1}), (Bytes{0x01, 0x00, 0x01})) << "the top row is bit 0";
    Plane page(PixelFormat::mono, 2, 16);
    store_narrow(page.s.format, page.s.color_row(0), 1, 0, 1);
    EXPECT_EQ(page.bytes, (Bytes{0, 0, 0, 0x80})) << "the lowest row is bit 7 of the last page";
    store_narrow(page.s.format, page.s.color_row(8), 0, 8, 1);
    EXPECT_EQ(page.bytes, (Bytes{0x80, 0, 0, 0x80}));
}

TEST(Narrow, PixelsDoNotDisturbTheirNeighbours) {
    for (const PixelFormat format : formats)
        for (const int w : {1, 2, 5, 8}) {
            const int h = 11;
            std::mt19937 random(7);
            Plane p(format, w, h);
            std::vector<std::uint32_t> model(static_cast<std::size_t>(w * h));
            const FormatInfo info = format_info(format);
            const unsigned bits =
                info.grey ? info.red_bits : unsigned{info.red_bits} + info.green_bits + info.blue_bits;
            for (int i = 0; i < 2000; ++i) {
                const int x = static_cast<int>(random() % static_cast<unsigned>(w)),
                          y = static_cast<int>(random() % h);
                const std::uint32_t word = random() & ((1u << bits) - 1);
                store_narrow(format, p.s.color_row(y), x, y, word);
                model[static_cast<std::size_t>(y * w + x)] = word;
                const int rx = static_cast<int>(random() % static_cast<unsigned>(w)),
                          ry = static_cast<int>(random() % h);
                ASSERT_EQ(p.word(rx, ry), model[static_cast<std::size_t>(ry * w + rx)]);
            }
        }
}

TEST(Narrow, RunsAreTheirPixels) {
    for (const PixelFormat format : formats)
        for (int begin = 0; begin < 9; ++begin)
            for (int end = begin; end < 24; ++end) {
                const int w = 23 + end % 2, h = 8, y = begin % 8;
                if (end > w)
                    continue;
                Plane run(format, w, h, 5), single(format, w, h, 5);
                const std::uint32_t word[4] = {1, 0, format == PixelFormat::mono ? 1u : 7u, 1};
                fill_narrow(format, run.s.color_row(y), y, begin, end, word);
                for (int x = begin; x < end; ++x)
                    store_narrow(format, single.s.color_row(y), x, y, word[x & 3]);
                ASSERT_EQ(run.bytes, single.bytes) << int(format) << ' ' << begin << ' ' << end;
            }
}

/// Returns floor(k / 255 (2^m - 1) + t), or the top bits.
unsigned step(unsigned c8, int bits, bool dither, int x, int y) {
    static constexpr int matrix[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const double t = (matrix[y & 3][x & 3] + 0.5) / 16;
    return dither ? static_cast<unsigned>(std::floor(c8 * ((1 << bits) - 1) / 255.0 + t + 1e-9))
                  : c8 >> (8 - bits);
}

TEST(Narrow, ClearsAreTheirPixels) {
    std::mt19937 random(3);
    for (const PixelFormat format : formats)
        for (int trial = 0; trial < 400; ++trial) {
            const int w = 1 + static_cast<int>(random() % 30), h = 1 + static_cast<int>(random() % 20);
            Plane p(format, w, h, 1 + static_cast<unsigned>(trial)), old = p;
            old.s.color = old.bytes.data() + (p.s.color - p.bytes.data());
            ClearRequest r;
            r.area.x = static_cast<int>(random() % static_cast<unsigned>(w));
            r.area.y = static_cast<int>(random() % static_cast<unsigned>(h));
            r.area.w = 1 + static_cast<int>(random() % static_cast<unsigned>(w - r.area.x));
            r.area.h = 1 + static_cast<int>(random() % static_cast<unsigned>(h - r.area.y));
            r.channels = static_cast<std::uint8_t>(trial % 2 == 0 ? 7 : random() % 16);
            r.dither = trial % 3 != 0;
            unsigned c8[3];
            for (int i = 0; i < 3; ++i) {
                c8[i] = random() % 256;
                r.color[i] = c8[i] * (color_one / 255);
            }
            clear(p.s, r);
            const FormatInfo info = format_info(format);
            const int bits[3] = {info.red_bits, info.green_bits, info.blue_bits};
            for (int y = 0; y < h; ++y)
                for (int x = 0; x < w; ++x) {
                    const bool inside =
                        x >= r.area.x && x < r.area.x + r.area.w && y >= r.area.y && y < r.area.y + r.area.h;
                    const StoredColor was = read_color(old.s, x, y), now = read_color(p.s, x, y);
                    unsigned want[3];
                    for (int i = 0; i < 3; ++i)
                        want[i] = inside && (r.channels >> i & 1) ? c8[i] : was.c[i].to_8();
                    const unsigned grey = (3 * want[0] + 6 * want[1] + want[2]) / 10;
                    for (int i = 0; i < 3; ++i) {
                        const bool writes =
                            inside && (info.grey ? (r.channels & 7) != 0 : r.channels >> i & 1);
                        const unsigned k =
                            writes ? step(info.grey ? grey : want[i], bits[i], r.dither, x, y) : was.c[i].k;
                        ASSERT_EQ(now.c[i].k, k) << int(format) << " channel " << i << " at " << x << ',' << y
                                                 << " of " << w << 'x' << h << " mask " << int(r.channels);
                    }
                }
        }
}

TEST(Narrow, ClearValuesTellPicturesApart) {
    for (const PixelFormat format : formats)
        for (const bool dither : {false, true}) {
            Plane p(format, 8, 8);
            std::vector<std::pair<std::uint32_t, std::vector<std::uint8_t>>> seen;
            for (unsigned shade = 0; shade < 3 * 256; shade += 3) { // one component after the other
                ClearRequest r;
                r.area = {0, 0, 8, 8};
                r.channels = 0xF;
                r.dither = dither;
                for (unsigned i = 0; i < 3; ++i)
                    r.color[i] = (shade / 256 == i ? shade % 256 : 100) * (color_one / 255);
                clear(p.s, r);
                ASSERT_TRUE(p.extents.cleared);
                for (const auto& [value, bytes] : seen)
                    ASSERT_EQ(value == p.extents.clear_value, bytes == p.bytes)
                        << int(format) << ' ' << shade;
                seen.emplace_back(p.extents.clear_value, p.bytes);
            }
        }
}

TEST(Narrow, PixelsAreReadAndWrittenByComponent) {
    for (const PixelFormat format : formats) {
        Plane p(format, 5, 9);
        const FormatInfo info = format_info(format);
        const std::uint32_t most[3] = {(1u << info.red_bits) - 1, (1u << info.green_bits) - 1,
                                       (1u << info.blue_bits) - 1};
        const std::uint32_t k[4] = {most[0], info.grey ? most[0] : most[1] / 2, info.grey ? most[0] : 1, 9};
        write_color(p.s, 3, 4, k);
        StoredColor row[5];
        read_color_row(p.s, 0, 4, 5, row);
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(row[3].c[i],
                      (Component{static_cast<std::uint8_t>(k[i]), static_cast<std::uint8_t>(most[i])}));
            EXPECT_EQ(read_color(p.s, 3, 4).c[i], row[3].c[i]);
            EXPECT_EQ(row[2].c[i].k, 0);
        }
        EXPECT_EQ(row[3].c[3], (Component{1, 1}));
        EXPECT_EQ(p.rows[4], (RowSpan{3, 4})) << "GL row 4 of nine is the fifth from the top";
        EXPECT_EQ(p.rows[5], RowSpan{});
    }
}

} // namespace
} // namespace spangle::raster
