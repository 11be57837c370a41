// Tests what only narrow surfaces have: greys under masks, steps that are stored again, alpha over steps.
#include <gtest/gtest.h>

#include <random>

#include "raster/surface/narrow.hpp"
#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

constexpr PixelFormat formats[] = {PixelFormat::rgb666, PixelFormat::rgb444, PixelFormat::rgb332,
                                   PixelFormat::grey4, PixelFormat::mono};

Canvas noise(PixelFormat format, unsigned seed) {
    Canvas c(format, 32, 32);
    std::mt19937 random(seed);
    for (auto& b : c.color)
        b = static_cast<std::uint8_t>(random() & (format == PixelFormat::rgb666 ? 0xFC : 0xFF));
    return c;
}

/// Blending that keeps the stored value keeps it to the bit, whatever the dither, because steps are read and
/// stored again as they are.
TEST(Narrow, WhatIsStoredComesBack) {
    for (const PixelFormat format : formats)
        for (const bool dither : {false, true})
            for (const std::uint8_t mask : {std::uint8_t{7}, std::uint8_t{2}, std::uint8_t{0xF}}) {
                const Canvas blank = noise(format, 3);
                Canvas c = blank;
                FragmentState f = plain_state(c);
                f.dither = dither;
                f.color_mask = mask;
                f.blend = true;
                f.blend_rgb.src = BlendFactor::zero;
                f.blend_rgb.dst = BlendFactor::one;
                f.blend_alpha = f.blend_rgb;
                cover<FixedVertex>(f, c, Point{});
                EXPECT_EQ(c.color, blank.color) << int(format) << dither << int(mask);
            }
}

/// Logical operations and masks apply to the bits of the stored word.
TEST(Narrow, LogicIsBitwise) {
    for (const PixelFormat format : formats)
        for (const LogicOp op : {LogicOp::logical_xor, LogicOp::invert, LogicOp::and_inverted, LogicOp::set})
            for (const unsigned mask : {7u, 5u}) {
                Canvas c = noise(format, 77), old = c, plain = c;
                FragmentState f = plain_state(c);
                Point p;
                p.color[0] = 0.3, p.color[1] = 0.9, p.color[2] = 0.5;
                cover<FixedVertex>(f, plain, p);
                f.logic = true;
                f.logic_op = op;
                f.color_mask = static_cast<std::uint8_t>(mask);
                cover<FixedVertex>(f, c, p);
                for (int y = 0; y < 32; ++y)
                    for (int x = 0; x < 32; ++x)
                        for (unsigned i = 0; i < 3; ++i) {
                            const Component s = plain.at(x, y).c[i], d = old.at(x, y).c[i];
                            const bool open = format_info(format).grey ? mask == 7 : (mask >> i & 1) != 0;
                            if (format_info(format).grey && mask != 7)
                                continue; // its colour is mixed first
                            const int want = !open                         ? d.k
                                             : op == LogicOp::logical_xor  ? s.k ^ d.k
                                             : op == LogicOp::invert       ? ~d.k & d.max
                                             : op == LogicOp::and_inverted ? ~s.k & d.k
                                                                           : d.max;
                            ASSERT_EQ(c.at(x, y).c[i].k, want) << int(format) << " op " << int(op);
                        }
            }
}

/// Masked components keep their step. A grey is the luma of the written and the kept components.
TEST(Narrow, MasksKeepComponents) {
    for (const PixelFormat format : formats)
        for (unsigned mask = 0; mask < 8; ++mask)
            for (const bool dither : {false, true}) {
                Canvas c = noise(format, 9 + mask), old = c;
                FragmentState f = plain_state(c);
                f.dither = dither;
                f.color_mask = static_cast<std::uint8_t>(mask);
                Point p;
                p.color[0] = 40 / 255.0, p.color[1] = 200 / 255.0, p.color[2] = 120 / 255.0;
                cover<FixedVertex>(f, c, p);
                const bool grey = format_info(format).grey;
                for (int y = 0; y < 32; ++y)
                    for (int x = 0; x < 32; ++x) {
                        const StoredColor was = old.at(x, y), now = c.at(x, y);
                        if (!grey) {
                            for (int i = 0; i < 3; ++i) {
                                if ((mask >> i & 1) == 0) {
                                    ASSERT_EQ(now.c[i], was.c[i]) << int(format) << ' ' << mask;
                                }
                            }
                            continue;
                        }
                        const unsigned source[3] = {40, 200, 120};
                        unsigned v[3];
                        for (int i = 0; i < 3; ++i)
                            v[i] = (mask >> i & 1) != 0 ? source[i] : was.c[i].to_8();
                        const std::uint32_t want = narrow_word(format, {v[0], v[1], v[2]}, dither,
                                                               dither_threshold(dither_row(y), x));
                        ASSERT_EQ(now.c[0].k, want) << int(format) << ' ' << mask;
                    }
            }
}

} // namespace
} // namespace spangle::raster::test
