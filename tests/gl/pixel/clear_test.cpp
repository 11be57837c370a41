// Compares Clear with a plain reading of GL 1.3, 4.2.3: only scissor, masks and dithering apply
// (docs/features.md G14, G19, G20). docs/architecture/numbers.md has the rules of rounding and of the dither
// matrix.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "gl/api/generated/commands.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "tests/gl/pixel/bare_context.hpp"

namespace spangle::gl {
namespace {

using test::BareContext;
using test::SharedMemory;

Real real(double v) {
    return numeric::from_double(v);
}

/// Returns R, G, B and A of a pixel as stored codes.
void codes(PixelFormat format, const std::uint8_t* p, unsigned out[4]) {
    if (format == PixelFormat::rgb565_be || format == PixelFormat::rgb565_le) {
        const unsigned word = format == PixelFormat::rgb565_be ? p[0] * 256u + p[1] : p[1] * 256u + p[0];
        out[0] = word >> 11;
        out[1] = word >> 5 & 63;
        out[2] = word & 31;
        out[3] = 0;
        return;
    }
    for (int c = 0; c < 4; ++c)
        out[c] = c < 3 || format == PixelFormat::rgba8888 ? p[c] : 0;
}

TEST(Clear, RandomStateInEveryFormat) {
    std::mt19937 random(21);
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    const PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                   PixelFormat::rgba8888};
    const DepthFormat depths[] = {DepthFormat::none, DepthFormat::z16, DepthFormat::z24s8};
    SharedMemory memory(1 << 16);
    for (int round = 0; round < 6000; ++round) {
        const int width = 1 + below(40), height = 1 + below(5);
        BareContext b(memory, formats[round % 4], depths[round / 4 % 3], width, height);
        Context& c = b.context;
        for (auto& byte : b.color)
            byte = static_cast<std::uint8_t>(random());
        for (auto& byte : b.planes)
            byte = static_cast<std::uint8_t>(random());
        const std::vector<std::uint8_t> color = b.color, planes = b.planes;

        c.fragment_ops.scissor_test = below(2) != 0;
        cmd::Scissor(c, below(50) - 5, below(8) - 2, below(40), below(6));
        bool mask[4];
        for (bool& m : mask)
            m = below(3) != 0;
        if (below(2) != 0)
            mask[0] = mask[1] = mask[2] = mask[3] = true;
        cmd::ColorMask(c, mask[0], mask[1], mask[2], mask[3]);
        c.fragment_ops.dither = below(2) != 0;
        cmd::DepthMask(c, below(4) != 0);
        const auto stencil_mask = static_cast<GLuint>(random());
        cmd::StencilMask(c, stencil_mask);
        double rgba[4];
        for (double& v : rgba)
            v = below(4) == 0 ? below(3) - 0.5 : below(256) / 255.0;
        cmd::ClearColor(c, real(rgba[0]), real(rgba[1]), real(rgba[2]), real(rgba[3]));
        const double z = below(4) == 0 ? below(3) - 0.5
                                       : static_cast<float>(random() / 4294967295.0); // state is kept as Real
        cmd::ClearDepth(c, real(z));
        const auto index = static_cast<GLint>(random());
        cmd::ClearStencil(c, index);
        if (below(16) == 0)
            cmd::DrawBuffer(c, GL_NONE);
        // Tests of fragments are enabled, but must not matter.
        c.fragment_ops.alpha_test = c.fragment_ops.stencil_test = c.fragment_ops.depth_test =
            c.fragment_ops.blend = true;
        cmd::DepthFunc(c, GL_NEVER);
        const GLbitfield buffers = static_cast<GLbitfield>(random()) &
                                   (GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        cmd::Clear(c, buffers);
        ASSERT_EQ(b.take_error(), GLenum{GL_NO_ERROR});

        const GLint* box = c.fragment_ops.scissor_box;
        const FormatInfo info = format_info(formats[round % 4]);
        const unsigned bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool inside = !c.fragment_ops.scissor_test || (x >= box[0] && x < box[0] + box[2] &&
                                                                     y >= box[1] && y < box[1] + box[3]);
                const auto i = static_cast<std::size_t>(y * width + x);
                unsigned was[4], is[4];
                codes(formats[round % 4], &color[i * info.bytes_per_pixel], was);
                codes(formats[round % 4], &b.color[i * info.bytes_per_pixel], is);
                for (int k = 0; k < 4; ++k) {
                    if (bits[k] == 0)
                        continue;
                    const bool written = inside && mask[k] && (buffers & GL_COLOR_BUFFER_BIT) != 0 &&
                                         c.fragment_ops.draw_buffer != GL_NONE;
                    if (!written) {
                        ASSERT_EQ(is[k], was[k]) << round << " " << x << " " << y << " " << k;
                        continue;
                    }
                    const double f = std::fmin(1, std::fmax(0, rgba[k]));
                    const auto eight = static_cast<unsigned>(std::floor(f * 255 + 0.5));
                    if (!c.fragment_ops.dither || bits[k] == 8) {
                        ASSERT_EQ(is[k], eight >> (8 - bits[k])) << round;
                    } else { // dithering gives floor or ceiling of the exact value
                        const double steps = f * ((1 << bits[k]) - 1);
                        ASSERT_LE(is[k], std::ceil(steps - 1e-5)) << round;
                        ASSERT_GE(is[k], std::floor(steps + 1e-5)) << round;
                    }
                }
                if (depths[round / 4 % 3] == DepthFormat::none)
                    continue;
                const double clamped = std::fmin(1, std::fmax(0, z));
                const bool depth_written =
                    inside && c.fragment_ops.depth_mask && (buffers & GL_DEPTH_BUFFER_BIT) != 0;
                if (depths[round / 4 % 3] == DepthFormat::z16) {
                    std::uint16_t before, after;
                    std::memcpy(&before, &planes[i * 2], 2);
                    std::memcpy(&after, &b.planes[i * 2], 2);
                    if (depth_written) {
                        ASSERT_LE(std::fabs(after - clamped * 65535), 0.51) << round;
                    } else {
                        ASSERT_EQ(after, before) << round;
                    }
                    continue;
                }
                std::uint32_t before, after;
                std::memcpy(&before, &planes[i * 4], 4);
                std::memcpy(&after, &b.planes[i * 4], 4);
                if (depth_written) {
                    ASSERT_LE(std::fabs((after >> 8) - clamped * 16777215), 0.52) << round;
                } else {
                    ASSERT_EQ(after >> 8, before >> 8) << round;
                }
                const std::uint32_t bits_written =
                    inside && (buffers & GL_STENCIL_BUFFER_BIT) != 0 ? stencil_mask & 0xFF : 0;
                ASSERT_EQ(after & 0xFF,
                          (before & 0xFF & ~bits_written) | (static_cast<GLuint>(index) & bits_written))
                    << round;
            }
    }
}

TEST(Clear, DitheringKeepsTheMeanOfAConstant) {
    SharedMemory memory(1 << 16);
    BareContext b(memory, PixelFormat::rgb565_be, DepthFormat::none, 16, 16);
    for (int v = 0; v <= 255; ++v) {
        cmd::ClearColor(b.context, real(v / 255.0), real(v / 255.0), real(0), real(0));
        cmd::Clear(b.context, GL_COLOR_BUFFER_BIT);
        double red = 0, green = 0;
        for (std::size_t i = 0; i < 256; ++i) {
            unsigned code[4];
            codes(PixelFormat::rgb565_be, &b.color[i * 2], code);
            red += code[0] / 256.0;
            green += code[1] / 256.0;
        }
        // The mean of sixteen thresholds is exact to half of their step.
        EXPECT_NEAR(red, v / 255.0 * 31, 1 / 31.0) << v;
        EXPECT_NEAR(green, v / 255.0 * 63, 1 / 31.0) << v;
    }
}

TEST(Clear, ErrorsClearNothing) {
    SharedMemory memory(1 << 16);
    BareContext b(memory);
    const std::vector<std::uint8_t> before = b.color;
    cmd::ClearColor(b.context, real(1), real(1), real(1), real(1));
    for (GLbitfield bad : {1u, 0x80000000u, 0xFFFFFFFFu, static_cast<unsigned>(GL_COLOR_BUFFER_BIT | 2)}) {
        cmd::Clear(b.context, bad);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE});
        EXPECT_EQ(b.color, before);
    }
    cmd::Clear(b.context, 0x200); // ACCUM_BUFFER_BIT: a missing buffer is ignored
    EXPECT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(b.color, before);
}

TEST(Clear, FullClearsAreTold) {
    SharedMemory memory(1 << 16);
    BareContext b(memory, PixelFormat::rgb565_be, DepthFormat::z16, 8, 6);
    std::vector<RowSpan> rows(6);
    RowExtents extents{rows.data(), 6, false, 0};
    b.context.drawable.surface.extents = &extents;
    b.context.drawable.surface.touched = rows.data();
    b.context.drawable.surface.touched_step = 1;
    Context& c = b.context;
    cmd::Clear(c, GL_DEPTH_BUFFER_BIT); // must not change colours
    EXPECT_FALSE(extents.cleared);
    EXPECT_EQ(rows[0], RowSpan{});
    c.fragment_ops.scissor_test = true;
    cmd::Scissor(c, 2, 1, 3, 2);
    cmd::Clear(c, GL_COLOR_BUFFER_BIT);
    EXPECT_FALSE(extents.cleared);
    EXPECT_EQ(rows[0], RowSpan{});
    EXPECT_EQ(rows[1], (RowSpan{2, 5}));
    EXPECT_EQ(rows[2], (RowSpan{2, 5}));
    EXPECT_EQ(rows[3], RowSpan{});
    c.fragment_ops.scissor_test = false;
    cmd::ColorMask(c, true, true, false, true);
    cmd::Clear(c, GL_COLOR_BUFFER_BIT); // does not write all channels
    EXPECT_FALSE(extents.cleared);
    EXPECT_EQ(rows[5], (RowSpan{0, 8}));
    cmd::ColorMask(c, true, true, true, false); // the surface has no alpha to mask
    cmd::Clear(c, GL_COLOR_BUFFER_BIT);
    EXPECT_TRUE(extents.cleared);
    EXPECT_EQ(rows[5], RowSpan{});
    const std::uint32_t black = extents.clear_value;
    cmd::ClearColor(c, real(1), real(0), real(0), real(0));
    cmd::Clear(c, GL_COLOR_BUFFER_BIT);
    EXPECT_NE(extents.clear_value, black);
    cmd::ClearColor(c, real(0), real(0), real(0), real(1));
    cmd::Clear(c, GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(extents.clear_value, black); // pictures with equal bytes have equal clear values
}

} // namespace
} // namespace spangle::gl
