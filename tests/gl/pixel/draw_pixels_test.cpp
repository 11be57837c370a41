// Compares DrawPixels with double: every format and type under every pixel storage, zoomed; depth, stencil
// and indices; and what is refused (docs/features.md E02, E05, E06).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>

#include "tests/gl/pixel/client_oracle.hpp"
#include "tests/gl/pixel/pixel_canvas.hpp"

namespace spangle::gl::test {
namespace {

constexpr PixelFormat surfaces[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                    PixelFormat::rgba8888};
constexpr GLenum color_formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA,     GL_RGB,
                                    GL_BGR, GL_RGBA,  GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};

std::vector<GLenum> all_types() {
    std::vector<GLenum> types(std::begin(plain_types), std::end(plain_types));
    types.push_back(GL_BITMAP);
    for (const PackedType& p : packed_types)
        types.push_back(p.type);
    return types;
}

/// Returns random bytes, or floats in a range a little larger than 0 to 1.
std::vector<unsigned char> random_memory(std::mt19937& random, std::size_t bytes, GLenum type, bool swap) {
    std::vector<unsigned char> memory(bytes + 4);
    for (unsigned char& b : memory)
        b = static_cast<unsigned char>(random());
    if (type == GL_FLOAT)
        for (std::size_t i = 0; i + 4 <= bytes; i += 4) {
            const float v = static_cast<float>(random() % 3000) / 2000.0f - 0.25f;
            auto word = std::bit_cast<std::uint32_t>(v);
            if (swap)
                word = __builtin_bswap32(word);
            std::memcpy(&memory[i], &word, 4);
        }
    return memory;
}

/// Returns what a surface stores of a fraction without dithering, in 255ths. Returns -1 if the fraction is
/// nearer than `doubt` to where this changes.
int stored(double v, int bits, double doubt) {
    const double scaled = std::clamp(v, 0.0, 1.0) * 255 + 0.5;
    if (std::fabs(scaled - std::round(scaled)) < doubt && std::round(scaled) > 0 && std::round(scaled) < 256)
        return -1;
    const int k = static_cast<int>(scaled) >> (8 - bits), most = (1 << bits) - 1;
    return (k * 255 * 2 + most) / (2 * most);
}

void expect_color(const PixelCanvas& canvas, int x, int y, const double v[4]) {
    const FormatInfo info = format_info(canvas.surface().format);
    // Colours have 8 fraction bits in the balanced tier, and 20 in the exact tier.
    const double doubt = canvas.context->tier == raster::Tier::exact ? 1e-4 : 0.51 / 256;
    const int bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
    for (int c = 0; c < 4; ++c) {
        if (bits[c] == 0)
            continue;
        const int wanted = stored(v[c], bits[c], doubt);
        if (wanted >= 0) {
            ASSERT_EQ(canvas.at(x, y, c), wanted) << x << ' ' << y << ' ' << c << ' ' << v[c];
        }
    }
}

TEST(DrawPixels, EveryFormatTypeAndStorageOnEverySurface) {
    std::mt19937 random(1);
    int drawn = 0;
    for (const PixelFormat surface : surfaces)
        for (const raster::Tier tier : {raster::Tier::exact, raster::Tier::balanced})
            for (const GLenum format : color_formats)
                for (const GLenum type : all_types()) {
                    if (!goes_together(format, type))
                        continue;
                    PixelCanvas canvas({.format = surface,
                                        .tier = tier,
                                        .width = 24,
                                        .height = 12,
                                        .top_first = drawn % 2 != 0});
                    glDisable(GL_DITHER);
                    for (int i = 0; i < 4; ++i, ++drawn) {
                        const int width = 1 + static_cast<int>(random() % 9),
                                  height = 1 + static_cast<int>(random() % 5);
                        const Store store = Store::random(random, width);
                        const ClientOracle oracle(format, type, width, height, store);
                        const auto memory = random_memory(random, oracle.bytes(), type, store.swap);
                        store.apply();
                        const int x = static_cast<int>(random() % 10), y = static_cast<int>(random() % 5);
                        glClear(GL_COLOR_BUFFER_BIT);
                        glRasterPos2i(x, y);
                        glDrawPixels(width, height, format, type, memory.data());
                        for (int m = -1; m <= height; ++m)
                            for (int n = -1; n <= width; ++n) {
                                if (x + n < 0 || y + m < 0)
                                    continue;
                                double v[4] = {0, 0, 0, 0};
                                if (n >= 0 && m >= 0 && n < width && m < height)
                                    oracle.color(memory.data(), n, m, v);
                                ASSERT_NO_FATAL_FAILURE(expect_color(canvas, x + n, y + m, v))
                                    << std::hex << format << ' ' << type;
                            }
                    }
                }
    EXPECT_GT(drawn, 2000);
}

TEST(DrawPixels, ZoomPutsGroupsWhereTheRuleSays) {
    std::mt19937 random(2);
    for (int i = 0; i < 3000; ++i) {
        PixelCanvas canvas({.format = surfaces[i % 4], .width = 96, .height = 70});
        glDisable(GL_DITHER);
        const int width = static_cast<int>(random() % 20), height = static_cast<int>(random() % 12);
        std::vector<unsigned char> image(static_cast<std::size_t>(width * height * 4) + 1);
        for (unsigned char& b : image)
            b = static_cast<unsigned char>(random() | 8);
        const auto some = [&](int range, int steps) {
            return static_cast<float>(
                       static_cast<int>(random() % static_cast<unsigned>(2 * range * steps + 1)) -
                       range * steps) /
                   static_cast<float>(steps);
        };
        const float zx = some(6, 8), zy = some(6, 16), x = std::fabs(some(90, 16)),
                    y = std::fabs(some(60, 16));
        glPixelZoom(zx, zy);
        glWindowPos2f(x, y);
        if (random() % 3 == 0) {
            glEnable(GL_SCISSOR_TEST);
            glScissor(static_cast<GLint>(random() % 60), static_cast<GLint>(random() % 40), 50, 30);
        }
        GLint box[4];
        glGetIntegerv(GL_SCISSOR_BOX, box);
        const bool cut = glIsEnabled(GL_SCISSOR_TEST) != GL_FALSE;
        glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
        for (int py = 0; py < 70; ++py)
            for (int px = 0; px < 96; ++px) {
                const auto group = [](double center, double at, double zoom, int groups) {
                    for (int n = 0; n < groups; ++n) {
                        const double a = at + zoom * n, b = at + zoom * (n + 1);
                        if (center >= std::min(a, b) && center < std::max(a, b))
                            return n;
                    }
                    return -1;
                };
                int n = group(px + 0.5, x, zx, width);
                const int m = group(py + 0.5, y, zy, height);
                if (cut && (px < box[0] || px >= box[0] + 50 || py < box[1] || py >= box[1] + 30))
                    n = -1;
                double v[4] = {0, 0, 0, 0};
                if (n >= 0 && m >= 0)
                    for (int c = 0; c < 4; ++c)
                        v[c] = image[static_cast<std::size_t>((m * width + n) * 4 + c)] / 255.0;
                ASSERT_NO_FATAL_FAILURE(expect_color(canvas, px, py, v))
                    << zx << ' ' << zy << ' ' << x << ' ' << y;
            }
    }
}

TEST(DrawPixels, LongRowsAreDrawnInPartsWithoutSeams) {
    for (const PixelFormat format : surfaces) {
        PixelCanvas canvas({.format = format, .width = 400, .height = 3});
        glDisable(GL_DITHER);
        std::vector<unsigned char> image(400 * 4);
        for (std::size_t i = 0; i < image.size(); ++i)
            image[i] = static_cast<unsigned char>(i * 7 + i / 256);
        glRasterPos2i(0, 1);
        glDrawPixels(400, 1, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
        for (int x = 0; x < 400; ++x) {
            double v[4];
            for (std::size_t c = 0; c < 4; ++c)
                v[c] = image[static_cast<std::size_t>(x) * 4 + c] / 255.0;
            ASSERT_NO_FATAL_FAILURE(expect_color(canvas, x, 1, v));
        }
    }
}

/// Dithering does not change colours that 16 bits hold exactly.
TEST(DrawPixels, ColoursOf565AreNeverDithered) {
    for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb565_le})
        for (const bool blend : {false, true}) {
            PixelCanvas canvas({.format = format, .width = 256, .height = 256});
            if (blend) // with blending, rows are not copied directly
                glEnable(GL_BLEND);
            std::vector<std::uint16_t> image(65536);
            for (std::size_t i = 0; i < image.size(); ++i)
                image[i] = static_cast<std::uint16_t>(i);
            glDrawPixels(256, 256, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, image.data());
            std::vector<std::uint16_t> back(65536);
            glReadPixels(0, 0, 256, 256, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, back.data());
            EXPECT_EQ(image, back);
            EXPECT_EQ(canvas.color[0], 0);
        }
}

TEST(DrawPixels, AtAnInvalidPositionNothingIsDrawn) {
    PixelCanvas canvas;
    const unsigned char white[4] = {255, 255, 255, 255};
    glRasterPos2i(-1, 0);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
    glPixelZoom(50, 50);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
    glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, white);
    glCopyPixels(0, 0, 1, 1, GL_COLOR);
    for (const auto byte : canvas.color)
        ASSERT_EQ(byte, 0);
    EXPECT_EQ(canvas.stencil_at(3, 3), 0);
}

TEST(DrawPixels, DepthGoesThroughTheTestWithTheRasterColour) {
    for (const DepthFormat format : {DepthFormat::z16, DepthFormat::z24s8}) {
        PixelCanvas canvas({.depth = format, .width = 130, .height = 4});
        std::mt19937 random(5);
        glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT); // clears depth to 1
        glEnable(GL_DEPTH_TEST);
        glColor4ub(10, 20, 30, 40);
        glRasterPos3f(0, 0, 0.5f);
        std::vector<GLuint> z(130 * 2);
        for (GLuint& v : z)
            v = random() % 3 == 0 ? 0x80000000u : static_cast<GLuint>(random());
        z[0] = 0xFFFFFFFF;
        z[1] = 0;
        glDrawPixels(130, 2, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, z.data());
        const double most = format == DepthFormat::z16 ? 65535 : 16777215;
        for (int i = 0; i < 260; ++i) {
            const double v = z[static_cast<std::size_t>(i)] / 4294967295.0;
            const auto k = canvas.depth_at(i % 130, i / 130);
            EXPECT_LE(std::fabs(k - v * most), 0.5 + most * 0x1p-30) << i;
            EXPECT_EQ(canvas.at(i % 130, i / 130, 1), k == most ? 0 : 20); // 1 is not less than 1
        }
        EXPECT_EQ(canvas.at(0, 2, 1), 0);
        // Depth is scaled and biased, then clamped.
        glDepthFunc(GL_ALWAYS);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
#if SPANGLE_FEATURE_PIXEL_TRANSFER
        glPixelTransferf(GL_DEPTH_SCALE, 3);
        glPixelTransferf(GL_DEPTH_BIAS, -1);
        const float three[3] = {0.25f, 0.5f, 0.9f};
        glDrawPixels(3, 1, GL_DEPTH_COMPONENT, GL_FLOAT, three);
        EXPECT_EQ(canvas.depth_at(0, 0), 0u);
        EXPECT_NEAR(canvas.depth_at(1, 0), most / 2, 0.6);
        EXPECT_EQ(canvas.depth_at(2, 0), most);
        EXPECT_EQ(canvas.at(0, 0, 1), 0); // the mask keeps this channel
#endif
    }
    PixelCanvas flat({.depth = DepthFormat::none});
    const float half = 0.5f;
    glColor3f(1, 1, 1);
    glRasterPos2i(3, 3);
    glDrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &half);
    EXPECT_EQ(flat.at(3, 3, 0), 255);
}

/// Codes of a depth buffer come back unchanged.
TEST(DrawPixels, DepthIsReadBackAndDrawnToTheBit) {
    for (const DepthFormat format : {DepthFormat::z16, DepthFormat::z24s8}) {
        PixelCanvas canvas({.depth = format, .width = 256, .height = 256});
        for (std::uint32_t i = 0; i < 65536; ++i) {
            if (format == DepthFormat::z16) {
                const auto code = static_cast<std::uint16_t>(i);
                std::memcpy(canvas.surface().depth + std::size_t{2} * i, &code, 2);
            } else {
                canvas.depth[i] = ((i * 251 + 11) & 0xFFFFFF) << 8;
            }
        }
        const auto before = canvas.depth;
        std::vector<GLuint> z(65536);
        glReadPixels(0, 0, 256, 256, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, z.data());
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glDrawPixels(256, 256, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, z.data());
        EXPECT_EQ(before, canvas.depth);
    }
}

TEST(DrawPixels, StencilIsMaskedAndScissoredAndNothingElse) {
    std::mt19937 random(6);
    for (const GLenum type : all_types()) {
        if (!goes_together(GL_STENCIL_INDEX, type))
            continue;
        PixelCanvas canvas;
        glClearStencil(0x5A);
        glClear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_NEVER, 0, 0xFF);
        glStencilOp(GL_ZERO, GL_ZERO, GL_ZERO);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_NEVER);
        glEnable(GL_ALPHA_TEST);
        glAlphaFunc(GL_NEVER, 0);
        glEnable(GL_SCISSOR_TEST);
        glScissor(6, 5, 20, 9);
        const int width = 9, height = 7;
        const Store store = Store::random(random, width);
        const ClientOracle oracle(GL_STENCIL_INDEX, type, width, height, store);
        const auto memory = random_memory(random, oracle.bytes(), type, store.swap);
        store.apply();
        for (const GLuint mask : {0xFFu, 0x0Fu, 0xF0u, 0u}) {
            glStencilMask(0xFF);
            glClearStencil(static_cast<GLint>(random() % 256));
            glClear(GL_STENCIL_BUFFER_BIT);
            const auto before = canvas.depth;
            const auto color = canvas.color;
            glStencilMask(mask);
            glRasterPos2i(4, 4);
            glPixelZoom(2, 1);
            glDrawPixels(width, height, GL_STENCIL_INDEX, type, memory.data());
            for (int y = 0; y < 28; ++y)
                for (int x = 0; x < 40; ++x) {
                    const auto old = static_cast<unsigned>(before[static_cast<std::size_t>(y * 40 + x)]);
                    unsigned wanted = old & 0xFF;
                    const int n = (x - 4) / 2, m = y - 4;
                    if (x >= 6 && x < 26 && y >= 5 && y < 14 && n < width && m < height) {
                        const auto index = static_cast<unsigned>(
                            static_cast<long long>(std::floor(oracle.value(memory.data(), n, m, 0) + 0.5)));
                        wanted = (index & mask) | (wanted & ~mask & 0xFF);
                    }
                    ASSERT_EQ(canvas.stencil_at(x, y), wanted)
                        << std::hex << type << std::dec << ' ' << x << ' ' << y;
                    ASSERT_EQ(canvas.depth_at(x, y), old >> 8);
                }
            EXPECT_EQ(color, canvas.color);
        }
    }
}

#if SPANGLE_FEATURE_PIXEL_TRANSFER
TEST(DrawPixels, IndicesAreExpandedByTheMaps) {
    PixelCanvas canvas;
    glDisable(GL_DITHER);
    const GLfloat red[4] = {0, 1, 0.5f, 0.25f}, green[2] = {1, 0}, blue[4] = {0.1f, 0.2f, 0.3f, 0.4f},
                  alpha = 1;
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 4, red);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 2, green);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_B, 4, blue);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_A, 1, &alpha);
    const GLubyte indices[3] = {1, 6, 255};
    glRasterPos2i(2, 3);
    glDrawPixels(3, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, indices);
    for (int i = 0; i < 3; ++i) {
        const double v[4] = {red[indices[i] & 3], green[indices[i] & 1], blue[indices[i] & 3], 1};
        expect_color(canvas, 2 + i, 3, v);
    }
    const GLubyte bits = 0xA0;
    glDrawPixels(3, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
    EXPECT_EQ(canvas.at(2, 3, 0), 255);
    EXPECT_EQ(canvas.at(3, 3, 1), 255);
    EXPECT_EQ(canvas.at(4, 3, 0), 255);
    glPixelTransferi(GL_INDEX_OFFSET, 2);
    glDrawPixels(3, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
    EXPECT_EQ(canvas.at(2, 3, 0), 64);
}

/// Transfer changes 565 colours as it changes the same numbers in floats, and the result is dithered.
TEST(DrawPixels, ColoursOf565GoThroughTransfer) {
    const GLfloat curve[5] = {0.9f, 0.1f, 0.35f, 0.6f, 0};
    std::vector<std::uint16_t> image(64 * 64);
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = static_cast<std::uint16_t>(i * 40503);
    std::vector<GLfloat> numbers;
    for (const std::uint16_t word : image)
        for (const auto& [code, most] : {std::pair{word >> 11, 31}, {word >> 5 & 63, 63}, {word & 31, 31}})
            numbers.push_back(static_cast<GLfloat>(code) / static_cast<GLfloat>(most));
    const auto drawn = [](const PixelCanvas& canvas, GLenum type, const void* pixels) {
        glDrawPixels(64, 64, GL_RGB, type, pixels);
        return canvas.color;
    };
    for (const PixelFormat format : surfaces)
        for (const bool maps : {false, true})
            for (const bool swapped : {false, true}) {
                PixelCanvas canvas({.format = format, .width = 64, .height = 64});
                if (maps) {
                    for (const GLenum map : {GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_B_TO_B})
                        glPixelMapfv(map, 5, curve);
                    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
                } else {
                    glPixelTransferf(GL_RED_SCALE, 0.37f);
                    glPixelTransferf(GL_GREEN_BIAS, 0.21f);
                    glPixelTransferf(GL_BLUE_SCALE, -0.5f);
                    glPixelTransferf(GL_BLUE_BIAS, 0.9f);
                }
                const auto wanted = drawn(canvas, GL_FLOAT, numbers.data());
                std::vector<std::uint16_t> words = image;
                if (swapped)
                    for (std::uint16_t& word : words)
                        word = __builtin_bswap16(word);
                glPixelStorei(GL_UNPACK_SWAP_BYTES, swapped ? GL_TRUE : GL_FALSE);
                const auto got = drawn(canvas, GL_UNSIGNED_SHORT_5_6_5, words.data());
                const auto differ = std::inner_product(got.begin(), got.end(), wanted.begin(), 0,
                                                       std::plus<>(), std::not_equal_to<>());
                // k / 31 is not exact as a float, so a few colours are rounded to the other side.
                EXPECT_LE(differ, static_cast<int>(got.size() / 200)) << int(format) << maps << swapped;
            }
}

TEST(DrawPixels, TransferIsAppliedBeforeClamping) {
    for (const PixelFormat format : surfaces) {
        PixelCanvas canvas({.format = format});
        glDisable(GL_DITHER);
        glPixelTransferf(GL_RED_SCALE, 2);
        glPixelTransferf(GL_GREEN_BIAS, -0.5f);
        glPixelTransferf(GL_BLUE_SCALE, -1);
        glPixelTransferf(GL_BLUE_BIAS, 1);
        const float image[4] = {0.25f, 1.25f, 0.1f, 1};
        glRasterPos2i(1, 1);
        glDrawPixels(1, 1, GL_RGBA, GL_FLOAT, image);
        const double v[4] = {0.5000001, 0.75, 0.9, 1};
        expect_color(canvas, 1, 1, v);
    }
}
#endif

TEST(DrawPixels, WhatIsRefused) {
    const unsigned char bytes[16] = {};
    struct Case {
        GLsizei width, height;
        GLenum format, type;
        GLenum code;
    };
    const Case cases[] = {{1, 1, GL_RGBA, GL_BITMAP, GL_INVALID_ENUM},
                          {1, 1, GL_DEPTH_COMPONENT, GL_BITMAP, GL_INVALID_ENUM},
                          {1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION},
                          {1, 1, GL_BGR, GL_UNSIGNED_BYTE_3_3_2, GL_INVALID_OPERATION},
                          {1, 1, GL_COLOR_INDEX, GL_UNSIGNED_INT_8_8_8_8, GL_INVALID_OPERATION},
                          {1, 1, GL_INTENSITY, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
                          {1, 1, GL_RGBA, GL_DOUBLEBUFFER, GL_INVALID_ENUM},
                          {-1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
                          {1, -1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
                          {0, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_NO_ERROR},
                          {0, 5, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, GL_NO_ERROR},
                          {5, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, GL_NO_ERROR}};
    PixelCanvas canvas;
    const auto before = canvas.color;
    for (const Case& c : cases) {
        glDrawPixels(c.width, c.height, c.format, c.type, bytes);
        EXPECT_EQ(glGetError(), c.code) << std::hex << c.format << ' ' << c.type;
    }
    EXPECT_EQ(before, canvas.color);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    for (const DepthFormat format : {DepthFormat::none, DepthFormat::z16}) {
        PixelCanvas shallow({.depth = format});
        glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        glCopyPixels(0, 0, 1, 1, GL_STENCIL);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        glCopyPixels(0, 0, 1, 1, GL_DEPTH);
        EXPECT_EQ(glGetError(),
                  format == DepthFormat::none ? GLenum{GL_INVALID_OPERATION} : GLenum{GL_NO_ERROR});
    }
}

} // namespace
} // namespace spangle::gl::test

#endif
