// Random textures of every kind.
#pragma once

#include <algorithm>
#include <vector>

#include "raster/ops/texel_other.hpp"
#include "tests/support/random.hpp"

namespace spangle::raster::test {

using spangle::test::Random;

/// A texture of random format, shape, size, wrap modes and filters, with all its levels. It has a border of
/// texels or a border colour.
struct AnyTexture {
    std::vector<std::uint8_t> texels;
    std::uint8_t palette[256 * 4];
    CubeFaces faces{};
    Texture texture;

    explicit AnyTexture(Random& random) {
        choose_format(random);
        choose_shape(random);
        choose_comparison(random);
        texture.wrap_s = static_cast<Wrap>(random.below(5));
        texture.wrap_t = static_cast<Wrap>(random.below(5));
        texture.wrap_r = static_cast<Wrap>(random.below(5));
        texture.mag = static_cast<Filter>(random.below(2));
        texture.min = static_cast<Filter>(random.below(2));
        texture.mip = static_cast<MipFilter>(random.below(3));
        for (auto& c : texture.border_color)
            c = static_cast<std::uint8_t>(random.below(256));
        fill(random);
    }
    AnyTexture(const AnyTexture&) = delete;
    AnyTexture& operator=(const AnyTexture&) = delete;

  private:
    void choose_format(Random& random) {
        constexpr BaseFormat bases[] = {
            BaseFormat::alpha, BaseFormat::luminance, BaseFormat::intensity, BaseFormat::luminance_alpha,
            BaseFormat::rgb,   BaseFormat::rgb,       BaseFormat::rgba,      BaseFormat::rgba,
            BaseFormat::rgba,  BaseFormat::rgb,       BaseFormat::luminance, BaseFormat::intensity,
            BaseFormat::rgba,  BaseFormat::rgb,       BaseFormat::rgb};
        texture.format = static_cast<TexelFormat>(random.below(15));
        texture.base = bases[static_cast<int>(texture.format)];
        texture.palette = palette;
        texture.palette_format =
            texture.format == TexelFormat::p4 ? TexelFormat::rgba8888 : TexelFormat::rgb565;
        for (auto& byte : palette)
            byte = static_cast<std::uint8_t>(random.below(256));
    }
    void choose_shape(Random& random) {
        texture.shape =
            is_indirect(texture.format) ? TextureShape::plane : static_cast<TextureShape>(random.below(4));
        const auto size = [&] {
            return static_cast<std::uint16_t>(random.below(2) == 0 ? 1u << random.below(6)
                                                                   : 1 + random.below(40));
        };
        texture.level[0].width = size();
        texture.level[0].height = texture.shape == TextureShape::line   ? std::uint16_t{1}
                                  : texture.shape == TextureShape::cube ? texture.level[0].width
                                                                        : size();
        if (texture.shape == TextureShape::volume)
            texture.depth = static_cast<std::uint16_t>(1 + random.below(9));
        texture.border_texels =
            static_cast<std::uint8_t>(!is_indirect(texture.format) && random.below(4) == 0);
    }
    void choose_comparison(Random& random) {
        const bool depths = texture.format == TexelFormat::z16 || texture.format == TexelFormat::z24;
        const bool flat =
            texture.shape <= TextureShape::plane; // other shapes may not compare depths (GL 1.4, 3.8.14)
        texture.compares = depths && flat && random.below(2) == 0;
        texture.compare = static_cast<Compare>(random.below(8));
    }
    void fill(Random& random) {
        const int bytes = is_indirect(texture.format) ? 1 : texel_bytes(texture.format),
                  border = 2 * texture.border_texels;
        const int images = texture.shape == TextureShape::cube ? 6 : 1;
        const auto halved = [](int size, int level) {
            return static_cast<std::uint16_t>(size >> level > 1 ? size >> level : 1);
        };
        const TextureLevel& base = texture.level[0];
        const int largest = std::max({base.width, base.height, texture.depth});
        std::vector<std::size_t> at[6];
        for (int l = 0; l <= log2_of(largest); ++l) {
            TextureLevel& level = texture.level[l];
            level = {nullptr, halved(base.width, l), halved(base.height, l), 0};
            level.stride = static_cast<std::uint32_t>(
                (level.width + border + static_cast<int>(random.below(2))) * bytes);
            const std::size_t slice =
                std::size_t{level.stride} * static_cast<std::size_t>(level.height + border);
            const bool volume = texture.shape == TextureShape::volume;
            const std::size_t slices =
                static_cast<std::size_t>(halved(texture.depth, l) + (volume ? border : 0));
            const std::size_t first = texture.border_texels *
                                      ((volume ? slice : 0) + level.stride + static_cast<std::size_t>(bytes));
            for (int face = 0; face < images; ++face) {
                at[face].push_back(texels.size() + first);
                texels.resize(texels.size() + slices * slice + 16);
            }
            ++texture.level_count;
        }
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = static_cast<std::uint8_t>(random.below(256));
        // Every texel lies at a multiple of four bytes, borders included.
        if (texture.format == TexelFormat::z24)
            for (std::size_t i = 3; i < texels.size(); i += 4)
                texels[i] = 0;
        for (int l = 0; l < texture.level_count; ++l) {
            texture.level[l].texels = texels.data() + at[0][static_cast<std::size_t>(l)];
            for (int face = 0; face < images; ++face)
                faces.texels[face][l] = texels.data() + at[face][static_cast<std::size_t>(l)];
        }
        texture.faces = &faces;
    }
};

} // namespace spangle::raster::test
