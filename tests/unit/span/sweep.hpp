// Draws random primitives in a chosen state through several span functions, whose bytes must be equal.
#pragma once

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

#include "raster/primitive/draw.hpp"

namespace spangle::raster::test {

/// A surface whose planes are exactly as large as its pixels, so that sanitizers see every byte outside.
struct Canvas {
    std::vector<std::uint8_t> color, depth;
    Surface surface;
    Canvas(int width, int height, PixelFormat format, DepthFormat depth_format) {
        const int depth_bytes = depth_format == DepthFormat::z16 ? 2 : 4;
        color.resize(static_cast<std::size_t>(row_bytes(format, width)) * stored_rows(format, height));
        if (depth_format != DepthFormat::none)
            depth.resize(static_cast<std::size_t>(width) * height * depth_bytes);
        surface.color = color.data();
        surface.depth = depth.empty() ? nullptr : depth.data();
        surface.color_stride = row_bytes(format, width);
        surface.depth_stride = width * depth_bytes;
        surface.width = width;
        surface.height = height;
        surface.format = format;
        surface.depth_format = depth_format;
    }
    /// Fills the planes with random values to blend with and to be hidden by.
    void noise(std::uint32_t seed) {
        std::mt19937 random(seed);
        for (auto& byte : color)
            byte = static_cast<std::uint8_t>(random());
        for (auto& byte : depth)
            byte = static_cast<std::uint8_t>(random());
    }
};

struct RandomVertices {
    std::mt19937 random;
    explicit RandomVertices(std::uint32_t seed) : random(seed) {}

    std::uint32_t word() { return static_cast<std::uint32_t>(random()); }
    std::uint32_t below(std::uint32_t n) { return word() % n; }

    FixedVertex vertex(int width, int height) {
        FixedVertex v{};
        v.x = static_cast<std::int32_t>(below(static_cast<std::uint32_t>(width * 256)));
        v.y = static_cast<std::int32_t>(below(static_cast<std::uint32_t>(height * 256)));
        v.z = below(depth_one + 1);
        for (auto& c : v.color)
            c = below(4) == 0 ? (below(2) == 0 ? 0 : color_one) : below(color_one + 1);
        for (auto& c : v.secondary)
            c = below(color_one / 2);
        v.w_mantissa = 0x80000000u | word();
        v.w_exponent = static_cast<std::int16_t>(-32 - static_cast<int>(below(3)));
        v.fog_mantissa = static_cast<std::int32_t>(word() >> 1);
        v.fog_exponent = -29; // fog coordinates up to 4
        for (auto& tex : v.tex) {
            tex.s = static_cast<std::int32_t>(word());
            tex.t = static_cast<std::int32_t>(word());
            tex.exponent = -29;
            tex.q = 1 << 29;
            tex.q_is_one = 1;
        }
        for (int i = 0; i < max_texture_units; ++i)
            v.r[i] = static_cast<std::int32_t>(0x9E3779B9u * static_cast<std::uint32_t>(v.tex[i].s));
        return v;
    }
};

/// A triangle of one kind: all w are equal (affine), or all colours are equal (flat), or neither.
struct Triangle {
    FixedVertex v[3];
};
inline Triangle random_triangle(RandomVertices& source, int width, int height, Kind kind) {
    Triangle t{{source.vertex(width, height), source.vertex(width, height), source.vertex(width, height)}};
    for (int i = 1; i < 3; ++i) {
        if (kind == Kind::flat || kind == Kind::affine)
            t.v[i].w_mantissa = t.v[0].w_mantissa, t.v[i].w_exponent = t.v[0].w_exponent;
        if (kind == Kind::flat)
            std::copy_n(t.v[0].color, 4, t.v[i].color);
    }
    if (kind == Kind::textured) { // colours vary too little for perspective, coordinates do not
        const FixedVertex base = t.v[0];
        for (auto& v : t.v)
            for (int c = 0; c < 4; ++c)
                v.color[c] = base.color[c] / 2 + source.below(1 << 10);
    }
    return t;
}
/// Returns an axis-aligned sprite. Its texels lie along pixels one to one, mirrored, or in other ratios; 1/w
/// changes from row to row only, or not at all.
inline Triangle random_sprite(RandomVertices& source, int width, int height, Kind kind) {
    Triangle t = random_triangle(source, width, height, kind);
    const auto other = [&](std::int32_t v, int size) {
        const auto by = 1 + static_cast<std::int32_t>(source.below(static_cast<std::uint32_t>(size - 1)));
        return (v + by) % size;
    };
    const auto x0 = static_cast<std::int32_t>(source.below(static_cast<std::uint32_t>(width)));
    const auto y0 = static_cast<std::int32_t>(source.below(static_cast<std::uint32_t>(height)));
    const std::int32_t x1 = other(x0, width), y1 = other(y0, height);
    constexpr std::int32_t texel = 1 << 23; // one of 64 texels; s and t have 29 fraction bits
    constexpr std::int32_t steps[] = {texel, texel, texel, -texel, texel / 3, 0, 5 * texel / 2};
    const std::int32_t ds = steps[source.below(7)], dt = steps[source.below(7)];
    const auto s0 = static_cast<std::int32_t>(source.below(64)) * texel;
    for (int i = 0; i < 3; ++i) {
        FixedVertex& v = t.v[i];
        const std::int32_t x = i == 0 ? x0 : x1, y = i == 2 ? y1 : y0;
        v.x = x * 256;
        v.y = y * 256;
        v.tex[0].s = s0 + (x - x0) * ds;
        v.tex[0].t = s0 / 2 + (y - y0) * dt;
    }
    t.v[1].w_mantissa = t.v[0].w_mantissa;
    t.v[1].w_exponent = t.v[0].w_exponent;
    return t;
}
inline void draw(const DrawState& state, const Surface& surface, const Triangle& t) {
    const auto& v = t.v;
    const std::int64_t area = signed_area(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y);
    if (area != 0)
        draw_triangle<FixedVertex>(state, surface, v[0], v[1], v[2], v[2], area);
}

/// A texture of 64 x 64 texels of any format.
struct TestTexture {
    std::vector<std::uint8_t> texels;
    Texture texture;
    TestTexture(TexelFormat format, BaseFormat base, int log2_width = 6, int log2_height = 6) {
        constexpr int bytes_of[] = {1, 1, 1, 2, 2, 3, 4};
        const int bytes = bytes_of[static_cast<int>(format)], w = 1 << log2_width, h = 1 << log2_height;
        texels.resize(static_cast<std::size_t>(w) * h * bytes);
        std::mt19937 random(99);
        for (auto& byte : texels)
            byte = static_cast<std::uint8_t>(random());
        texture.level[0] = {texels.data(), static_cast<std::uint16_t>(w), static_cast<std::uint16_t>(h),
                            static_cast<std::uint32_t>(w * bytes)};
        texture.level_count = 1;
        texture.format = format;
        texture.base = base;
        texture.mag = texture.min = Filter::nearest;
    }
};

} // namespace spangle::raster::test
