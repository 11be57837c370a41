// Compares the accumulation buffer with sums of rational numbers (GL 1.3, 4.2.4; docs/features.md G22).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gl/api/generated/commands.hpp"
#include "raster/surface/pixel.hpp"
#include "raster/surface/quantize.hpp"
#include "tests/gl/pixel/bare_context.hpp"
#include "tests/support/random.hpp"

namespace spangle::gl {
namespace {

using test::BareContext;
using test::SharedMemory;

constexpr std::int32_t width = 8, height = 6;
constexpr PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                   PixelFormat::rgba8888};

Real real(double v) {
    return numeric::from_float(static_cast<float>(v));
}

/// A context with an accumulation buffer, and the values that it must hold.
struct Twin {
    SharedMemory memory{1 << 16};
    BareContext b;
    Context& c = b.context;
    std::vector<std::int16_t> plane = std::vector<std::int16_t>(4 * width * height, 12345);
    std::vector<double> want = std::vector<double>(4 * width * height);

    explicit Twin(PixelFormat format) : b(memory, format, DepthFormat::none, width, height) {
        c.drawable.surface.accum = plane.data();
        cmd::ClearAccum(c, real(0.25), real(-0.5), real(7), real(-9));
        cmd::Clear(c, GL_ACCUM_BUFFER_BIT);
        const double clear[4] = {0.25, -0.5, 1, -1};
        for (std::size_t i = 0; i < want.size(); ++i)
            want[i] = clear[i % 4];
    }
    raster::StoredColor pixel(std::int32_t x, std::int32_t y) const {
        return raster::read_color(c.drawable.surface, x, y);
    }
    double& at(std::int32_t x, std::int32_t y, int i) {
        return want[static_cast<std::size_t>(4 * (y * width + x) + i)];
    }
    void noise(spangle::test::Random& random) {
        for (auto& byte : b.color)
            byte = static_cast<std::uint8_t>(random.below(256));
    }
    /// Compares the buffer with the exact values; each operation may add an error of half a unit.
    void compare(int operations) const {
        for (std::size_t i = 0; i < want.size(); ++i)
            ASSERT_NEAR(plane[i] / 32767., want[i], (0.5 * operations + 0.01) / 32767) << i;
    }
};

void scissor(Context& c, const Rect& box) {
    cmd::Enable(c, GL_SCISSOR_TEST);
    cmd::Scissor(c, box.x, box.y, box.w, box.h);
}

double clamped(double v) {
    return std::fmax(-1, std::fmin(1, v));
}

TEST(Accum, SumsOfPictures) {
    for (const PixelFormat format : formats) {
        Twin t(format);
        spangle::test::Random random{static_cast<std::uint32_t>(format) + 3};
        t.compare(1);
        for (int round = 0; round < 60; ++round) {
            t.noise(random);
            const double v = (static_cast<double>(random.below(4001)) - 2000) / 1024;
            const Rect box = {static_cast<std::int32_t>(random.below(6)) - 2,
                              static_cast<std::int32_t>(random.below(4)) - 1,
                              static_cast<std::int32_t>(random.below(9)),
                              static_cast<std::int32_t>(random.below(7))};
            scissor(t.c, box);
            const GLenum ops[] = {GL_LOAD, GL_ACCUM, GL_MULT, GL_ADD};
            const GLenum op = ops[random.below(4)];
            // The stored values replace the exact ones, so that errors of half a unit do not add up.
            for (std::size_t i = 0; i < t.want.size(); ++i)
                t.want[i] = t.plane[i] / 32767.;
            cmd::Accum(t.c, op, real(v));
            for (std::int32_t y = 0; y < height; ++y)
                for (std::int32_t x = 0; x < width; ++x) {
                    if (x < box.x || x >= box.x + box.w || y < box.y || y >= box.y + box.h)
                        continue;
                    const raster::StoredColor color = t.pixel(x, y);
                    for (int i = 0; i < 4; ++i) {
                        const double k = static_cast<double>(color.c[i].k) / color.c[i].max;
                        double& a = t.at(x, y, i);
                        a = clamped(op == GL_LOAD    ? k * v
                                    : op == GL_ACCUM ? a + k * v
                                    : op == GL_MULT  ? a * v
                                                     : a + v);
                    }
                }
            t.compare(1);
        }
        EXPECT_EQ(t.b.take_error(), GLenum{GL_NO_ERROR});
    }
}

/// A picture comes back unchanged, and the mean of several pictures is exact.
TEST(Accum, LoadAndReturnIsNothing) {
    for (const PixelFormat format : formats)
        for (const bool dither : {false, true}) {
            Twin t(format);
            spangle::test::Random random{99};
            t.noise(random);
            const std::vector<std::uint8_t> before = t.b.color;
            dither ? cmd::Enable(t.c, GL_DITHER) : cmd::Disable(t.c, GL_DITHER);
            cmd::Accum(t.c, GL_LOAD, real(1));
            std::fill(t.b.color.begin(), t.b.color.end(), std::uint8_t{0x5A});
            cmd::Accum(t.c, GL_RETURN, real(1));
            EXPECT_EQ(t.b.color, before) << int(format);
            cmd::Accum(t.c, GL_LOAD, real(0.25));
            for (int i = 0; i < 3; ++i)
                cmd::Accum(t.c, GL_ACCUM, real(0.25));
            std::fill(t.b.color.begin(), t.b.color.end(), std::uint8_t{0});
            cmd::Accum(t.c, GL_RETURN, real(1));
            EXPECT_EQ(t.b.color, before) << int(format);
        }
}

TEST(Accum, ReturnIsClampedMaskedAndDithered) {
    for (const PixelFormat format : formats)
        for (const bool dither : {false, true})
            for (unsigned mask = 0; mask < 16; ++mask) {
                Twin t(format);
                spangle::test::Random random{mask};
                t.noise(random);
                for (auto& a : t.plane)
                    a = static_cast<std::int16_t>(static_cast<int>(random.below(65535)) - 32767);
                const std::vector<std::int16_t> sums = t.plane;
                const std::vector<std::uint8_t> before = t.b.color;
                cmd::ColorMask(t.c, (mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0, (mask & 8) != 0);
                dither ? cmd::Enable(t.c, GL_DITHER) : cmd::Disable(t.c, GL_DITHER);
                scissor(t.c, {1, 1, 5, 4});
                const double v = mask % 2 == 0 ? 1.5 : -0.75;
                cmd::Accum(t.c, GL_RETURN, real(v));
                EXPECT_EQ(t.plane, sums);
                const FormatInfo info = format_info(format);
                const unsigned bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
                BareContext old(t.memory, format, DepthFormat::none, width, height);
                old.color = before;
                old.context.drawable.surface.color = old.color.data();
                for (std::int32_t y = 0; y < height; ++y)
                    for (std::int32_t x = 0; x < width; ++x) {
                        const bool inside = x >= 1 && x < 6 && y >= 1 && y < 5;
                        const raster::StoredColor got = t.pixel(x, y),
                                                  kept =
                                                      raster::read_color(old.context.drawable.surface, x, y);
                        for (unsigned i = 0; i < 4; ++i) {
                            if (!inside || (mask >> i & 1u) == 0 || bits[i] == 0) {
                                EXPECT_EQ(got.c[i].k, kept.c[i].k);
                                continue;
                            }
                            const double a = sums[static_cast<std::size_t>(4 * (y * width + x)) + i] / 32767.;
                            const auto units = static_cast<std::uint32_t>(
                                std::lround(std::fmax(0, std::fmin(1, a * v)) * raster::color_one));
                            const std::uint32_t threshold = dither_threshold(dither_row(y), x);
                            EXPECT_EQ(got.c[i].k, raster::stored_component(units, bits[i], dither, threshold))
                                << x << ' ' << y << ' ' << i;
                        }
                    }
            }
}

/// RETURN stores the product rounded to nearest, for every sum that the buffer can hold (GL 1.3, 4.2.4 and
/// 2.13.9).
TEST(Accum, ReturnIsTheNearest) {
    Twin t(PixelFormat::rgba8888);
    const auto sum_of = [](int first, std::size_t i) {
        return static_cast<std::int16_t>(std::min(first + static_cast<int>(i), 32767));
    };
    for (const double v : {1., 0.5, 0.75, 1.5, 3.5, 1 / 3.}) {
        const double used = std::round(v * 65536) / 65536;
        for (int first = -40; first <= 32767; first += static_cast<int>(t.plane.size())) {
            for (std::size_t i = 0; i < t.plane.size(); ++i)
                t.plane[i] = sum_of(first, i);
            cmd::Accum(t.c, GL_RETURN, real(v));
            for (std::size_t i = 0; i < t.plane.size(); ++i) {
                const double wanted = std::fmax(0, std::fmin(1, sum_of(first, i) / 32767. * used)) * 255;
                ASSERT_NEAR(t.b.color[i], wanted, 0.500001) << sum_of(first, i) << " times " << v;
            }
        }
    }
}

/// A product halfway between two codes is rounded up, as every colour is. Components of 5 and 6 bits are the
/// upper bits of the 8-bit result.
TEST(Accum, ReturnRoundsHalfUp) {
    for (const PixelFormat format : formats)
        for (const int divisor : {1, 7, 31, 151, 217, 1057, 4681, 32767}) {
            Twin t(format);
            cmd::Disable(t.c, GL_DITHER);
            std::fill(t.plane.begin(), t.plane.end(), static_cast<std::int16_t>(32767 / divisor));
            cmd::Accum(t.c, GL_RETURN, real(divisor / 2.)); // returns 127.5 255ths
            const FormatInfo info = format_info(format);
            const unsigned bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
            for (unsigned c = 0; c < 4; ++c)
                if (bits[c] != 0) {
                    EXPECT_EQ(t.pixel(1, 1).c[c].k, 1u << (bits[c] - 1)) << divisor << ' ' << c;
                }
        }
}

TEST(Accum, ErrorsChangeNothing) {
    Twin t(PixelFormat::rgba8888);
    const std::vector<std::int16_t> before = t.plane;
    for (const GLenum op : {GLenum{GL_ACCUM} - 1, GLenum{GL_ADD} + 1}) {
        cmd::Accum(t.c, op, real(1));
        EXPECT_EQ(t.b.take_error(), GLenum{GL_INVALID_ENUM});
    }
    t.c.drawable.surface.accum = nullptr;
    cmd::Accum(t.c, GL_LOAD, real(1));
    EXPECT_EQ(t.b.take_error(), GLenum{GL_INVALID_OPERATION});
    cmd::Clear(t.c, GL_ACCUM_BUFFER_BIT);
    EXPECT_EQ(t.b.take_error(), GLenum{GL_NO_ERROR}) << "missing buffers are ignored";
    EXPECT_EQ(t.plane, before);
}

/// Colours may come from another surface, smaller than the one drawn to.
TEST(Accum, ReadsTheReadSurface) {
    Twin t(PixelFormat::rgb565_le);
    BareContext small(t.memory, PixelFormat::rgba8888, DepthFormat::none, 3, 9);
    for (std::size_t i = 0; i < small.color.size(); ++i)
        small.color[i] = static_cast<std::uint8_t>(17 * i);
    t.c.drawable.read = small.context.drawable.surface;
    cmd::Accum(t.c, GL_LOAD, real(0.5));
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < 3; ++x)
            for (int i = 0; i < 4; ++i)
                t.at(x, y, i) = raster::read_color(small.context.drawable.surface, x, y).c[i].k / 510.;
    t.compare(1);
}

} // namespace
} // namespace spangle::gl
