// Uses the rasterizer as a library, with spangle/raster.hpp only.
#include <spangle/raster.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cstring>
#include <string>
#include <vector>

namespace spangle::raster {
namespace {

constexpr int width = 16, height = 12;

/// An RGB565 picture with depth, bottom row first. Guard bytes around it must keep their value.
struct Picture {
    std::vector<std::uint8_t> color = std::vector<std::uint8_t>(width * height * 2 + 64, 0xA5);
    std::vector<std::uint16_t> depth = std::vector<std::uint16_t>(width * height, 0xFFFF);
    Surface surface;

    Picture() {
        surface.color = color.data() + 32;
        surface.color_stride = width * 2;
        surface.depth = reinterpret_cast<std::uint8_t*>(depth.data());
        surface.depth_stride = width * 2;
        surface.width = width;
        surface.height = height;
        surface.format = PixelFormat::rgb565_be;
        surface.depth_format = DepthFormat::z16;
        ClearRequest black;
        black.area = {0, 0, width, height};
        black.channels = 0xF;
        clear(surface, black);
    }
    ~Picture() {
        for (std::size_t i = 0; i < 32; ++i) {
            EXPECT_EQ(color[i], 0xA5);
            EXPECT_EQ(color[color.size() - 1 - i], 0xA5);
        }
    }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    unsigned at(int x, int y) const {
        const std::uint8_t* const p = surface.color + y * surface.color_stride + 2 * x;
        return static_cast<unsigned>(p[0] << 8 | p[1]);
    }
    /// Returns the picture as text, top row first: '.' is black, '#' white, 'r', 'g' and 'b' the primary
    /// colours, '?' another colour.
    std::string ascii(Rect part = {0, 0, width, height}) const {
        std::string out;
        for (int y = part.y + part.h - 1; y >= part.y; --y, out += '\n')
            for (int x = part.x; x < part.x + part.w; ++x) {
                const unsigned c = at(x, y);
                out += c == 0        ? '.'
                       : c == 0xFFFF ? '#'
                       : c == 0xF800 ? 'r'
                       : c == 0x07E0 ? 'g'
                       : c == 0x001F ? 'b'
                                     : '?';
            }
        return out;
    }
};

FixedVertex colored(FixedVertex v, int channel) {
    for (int c = 0; c < 3; ++c)
        v.color[c] = c == channel ? color_one : 0;
    return v;
}
FixedVertex deep(FixedVertex v, std::uint32_t z) {
    v.z = z;
    return v;
}

TEST(Rasterizer, TrianglesLinesPoints) {
    Picture picture;
    const Rasterizer draw(whole(picture.surface), picture.surface);
    draw.triangle(at(1, 1), at(6, 1), at(1, 6)); // centres on the diagonal belong to the other triangle
    draw.line(colored(at(8, 2), 0), colored(at(14, 2), 0));
    draw.point(colored(at(11, 7), 1), 3);
    EXPECT_EQ(picture.ascii({0, 0, width, 10}), "................\n" // 3 pixels around (11, 7)
                                                "..........ggg...\n"
                                                "..........ggg...\n"
                                                "..........ggg...\n"
                                                "................\n"
                                                ".#..............\n"
                                                ".##.............\n"
                                                ".###............\n"
                                                ".####...rrrrrr..\n" // y = 2 is the upper edge of row 1
                                                "................\n");
}

/// The state of fragments works as in GL: depth test, blending, a texture, flat shading, scissor.
TEST(Rasterizer, FragmentsGoThroughTheirState) {
    Picture picture;
    FragmentState state = whole(picture.surface);
    state.depth_test = true;
    Rasterizer draw(state, picture.surface);
    const auto quad = [&](const Rasterizer& with, int channel, std::uint32_t z, int x, int y, int size) {
        const FixedVertex v[4] = {
            colored(deep(at(x, y), z), channel), colored(deep(at(x + size, y), z), channel),
            colored(deep(at(x + size, y + size), z), channel), colored(deep(at(x, y + size), z), channel)};
        with.triangle(v[0], v[1], v[2]);
        with.triangle(v[0], v[2], v[3]);
    };
    quad(draw, 0, depth_one / 2, 0, 0, 4);
    quad(draw, 1, depth_one / 4 * 3, 2, 0, 4); // farther than the stored depth
    quad(draw, 2, depth_one / 4, 0, 2, 2);     // nearer than the stored depth
    EXPECT_EQ(picture.ascii({0, 0, 7, 5}), ".......\nbbrrgg.\nbbrrgg.\nrrrrgg.\nrrrrgg.\n");

    state.depth_test = false;
    state.scissor = {10, -5, 100, 8}; // clipped to the surface
    quad(Rasterizer(state, picture.surface), 0, 0, 8, 0, 8);
    EXPECT_EQ(picture.ascii({8, 0, 8, 4}), "........\n..rrrrrr\n..rrrrrr\n..rrrrrr\n");

    // The texture has 2 x 2 texels.
    const std::uint8_t texels[] = {255, 255, 255, 0, 0, 255, 0, 255, 0, 255, 0, 0};
    Texture texture;
    texture.level[0] = {texels, 2, 2, 6};
    texture.level_count = 1;
    texture.mag = texture.min = Filter::nearest;
    state = whole(picture.surface);
    state.unit[0].texture = &texture;
    state.unit[0].env = TexEnv::replace;
    draw = Rasterizer(state, picture.surface); // a rasterizer with the same state draws the same
    FixedVertex v[3] = {at(8, 6), at(16, 6), at(8, 14)};
    for (int i = 0; i < 3; ++i) { // s and t go from 0 to 2, each a mantissa times 2^exponent
        v[i].tex[0].exponent = -29;
        v[i].tex[0].s = i == 1 ? 1 << 30 : 0;
        v[i].tex[0].t = i == 2 ? 1 << 30 : 0;
    }
    draw.triangle(v[0], v[1], v[2]);
    EXPECT_EQ(picture.ascii({8, 6, 8, 6}), "##......\n##b.....\nggrr....\nggrrg...\n##bb##..\n##bb##b.\n");
}

TEST(Rasterizer, FlatShadingTakesTheProvokingVertex) {
    Picture picture;
    FragmentState state = whole(picture.surface);
    state.flat = true;
    const Rasterizer draw(state, picture.surface);
    const FixedVertex a = colored(at(0, 0), 0), b = colored(at(4, 0), 1), c = colored(at(0, 4), 2);
    draw.triangle(a, b, c);
    EXPECT_EQ(picture.at(0, 0), 0x001Fu);
    draw.triangle(a, b, c, b);
    EXPECT_EQ(picture.at(0, 0), 0x07E0u);
    draw.line(a, b);
    EXPECT_EQ(picture.at(1, 0), 0x07E0u);
}

/// Primitives with arguments out of range are not drawn, and nothing outside of the surface is touched.
TEST(Rasterizer, BadArgumentsDrawNothing) {
    Picture picture;
    const Rasterizer draw(whole(picture.surface), picture.surface);
    const FixedVertex a = at(1, 1), b = at(9, 1), c = at(1, 9);
    const auto bad = [&](auto change) {
        FixedVertex v = c;
        change(v);
        draw.triangle(a, b, v);
        draw.triangle(a, v, b);
        draw.triangle(v, a, b);
        draw.triangle(a, b, c, v);
        draw.line(a, v);
        draw.line(v, a);
        draw.point(v);
    };
    bad([](FixedVertex& v) { v.x = INT_MIN; });
    bad([](FixedVertex& v) { v.y = INT_MAX; });
    bad([](FixedVertex& v) { v.x = 4 * 2048 * subpixel_one; });
    bad([](FixedVertex& v) { v.z = depth_one + 1; });
    bad([](FixedVertex& v) { v.w_mantissa = 0; });
    bad([](FixedVertex& v) { v.color[3] = color_one + 1; });
    bad([](FixedVertex& v) { v.secondary[0] = ~0u; });
    draw.triangle(a, b, at(17, 1)); // a triangle without area
    FragmentState outside = whole(picture.surface);
    for (const Rect box : {Rect{0, 0, -5, 5}, Rect{INT_MAX, 0, INT_MAX, 9}, Rect{width, 0, 5, 5}, Rect{}}) {
        outside.scissor = box;
        Rasterizer(outside, picture.surface).triangle(a, b, c);
    }
    Surface none = picture.surface;
    none.color = nullptr;
    Rasterizer(whole(none), none).triangle(a, b, c);
    EXPECT_EQ(picture.ascii().find_first_not_of(".\n"), std::string::npos) << picture.ascii();
    // Primitives from edge to edge of the guard band, and widths beyond their limits, are drawn.
    draw.triangle(at(-8191, -8191), at(8191, -8191), at(0, 8191));
    EXPECT_EQ(picture.ascii().find_first_not_of("#\n"), std::string::npos);
    draw.line(colored(at(-100, 5), 0), colored(at(100, 5), 0), INT_MAX);
    draw.point(colored(at(8, 6), 1), INT_MIN);
    draw.line(colored(at(0, 1), 2), colored(at(100, 1), 2), -7);
    EXPECT_EQ(picture.at(0, 11), 0xF800u);
    EXPECT_EQ(picture.at(8, 6), 0x07E0u);
    EXPECT_EQ(picture.at(9, 6), 0xF800u);
    EXPECT_EQ(picture.at(9, 0), 0x001Fu);
    EXPECT_EQ(picture.at(9, 1), 0xF800u);
}

/// Colours may be affine in the window only where perspective bends them less than a quarter of a step of the
/// target, however much 1/w varies.
TEST(Rasterizer, PerspectiveBendsColors) {
    std::vector<std::uint8_t> pixels(width * height * 4);
    Surface surface;
    surface.color = pixels.data();
    surface.color_stride = width * 4;
    surface.width = width;
    surface.height = height;
    surface.format = PixelFormat::rgba8888;
    FragmentState state = whole(surface);
    state.tier = Tier::balanced;
    const Rasterizer draw(state, surface);
    constexpr int side = 12;
    for (std::uint32_t nearer = 1u << 16; nearer < 1u << 31; nearer += nearer / 4) {
        FixedVertex v[3] = {colored(at(0, 0), 0), colored(at(side, 0), 1), colored(at(0, side), 2)};
        v[1].w_mantissa = v[0].w_mantissa + nearer;
        std::fill(pixels.begin(), pixels.end(), std::uint8_t{0});
        draw.triangle(v[0], v[1], v[2]);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x + y < side - 1; ++x) {
                const double across = (x + .5) / side, up = (y + .5) / side;
                const double weight[3] = {(1 - across - up) * v[0].w_mantissa, across * v[1].w_mantissa,
                                          up * v[2].w_mantissa};
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(pixels[static_cast<std::size_t>(4 * (y * width + x) + c)],
                                255 * weight[c] / (weight[0] + weight[1] + weight[2]), .5 + .25 + .05)
                        << "1/w grows by " << nearer << " at " << x << ", " << y;
            }
    }
}

} // namespace
} // namespace spangle::raster
