#include "host_sim/bake/texture.hpp"

#include <cmath>

#include "host_sim/bake/etc1.hpp"
#include "host_sim/bake/palette.hpp"

namespace spangle::bake {

namespace {

using Kind = TexelKind;
using Bytes = std::vector<std::uint8_t>;

constexpr TextureFormat formats[] = {
    {"rgb565", Kind::packed, {5, 6, 5, 0}, false, 2, 0, "GL_RGB565", "GL_RGB", "GL_UNSIGNED_SHORT_5_6_5"},
    {"rgba4444", Kind::packed, {4, 4, 4, 4}, false, 2, 0, "GL_RGBA4", "GL_RGBA", "GL_UNSIGNED_SHORT_4_4_4_4"},
    {"rgba5551",
     Kind::packed,
     {5, 5, 5, 1},
     false,
     2,
     0,
     "GL_RGB5_A1",
     "GL_RGBA",
     "GL_UNSIGNED_SHORT_5_5_5_1"},
    {"rgb332", Kind::packed, {3, 3, 2, 0}, false, 1, 0, "GL_R3_G3_B2", "GL_RGB", "GL_UNSIGNED_BYTE_3_3_2"},
    {"rgb888", Kind::bytes, {8, 8, 8, 0}, false, 3, 0, "GL_RGB8", "GL_RGB", "GL_UNSIGNED_BYTE"},
    {"rgba8888", Kind::bytes, {8, 8, 8, 8}, false, 4, 0, "GL_RGBA8", "GL_RGBA", "GL_UNSIGNED_BYTE"},
    {"l8", Kind::bytes, {8, 0, 0, 0}, true, 1, 0, "GL_LUMINANCE8", "GL_LUMINANCE", "GL_UNSIGNED_BYTE"},
    {"a8", Kind::bytes, {0, 0, 0, 8}, false, 1, 0, "GL_ALPHA8", "GL_ALPHA", "GL_UNSIGNED_BYTE"},
    {"la88",
     Kind::bytes,
     {8, 0, 0, 8},
     true,
     2,
     0,
     "GL_LUMINANCE8_ALPHA8",
     "GL_LUMINANCE_ALPHA",
     "GL_UNSIGNED_BYTE"},
    {"p4-rgb888", Kind::palette, {8, 8, 8, 0}, false, 3, 4, "GL_PALETTE4_RGB8_OES", nullptr, nullptr},
    {"p4-rgba8888", Kind::palette, {8, 8, 8, 8}, false, 4, 4, "GL_PALETTE4_RGBA8_OES", nullptr, nullptr},
    {"p4-rgb565", Kind::palette, {5, 6, 5, 0}, false, 2, 4, "GL_PALETTE4_R5_G6_B5_OES", nullptr, nullptr},
    {"p4-rgba4444", Kind::palette, {4, 4, 4, 4}, false, 2, 4, "GL_PALETTE4_RGBA4_OES", nullptr, nullptr},
    {"p4-rgba5551", Kind::palette, {5, 5, 5, 1}, false, 2, 4, "GL_PALETTE4_RGB5_A1_OES", nullptr, nullptr},
    {"p8-rgb888", Kind::palette, {8, 8, 8, 0}, false, 3, 8, "GL_PALETTE8_RGB8_OES", nullptr, nullptr},
    {"p8-rgba8888", Kind::palette, {8, 8, 8, 8}, false, 4, 8, "GL_PALETTE8_RGBA8_OES", nullptr, nullptr},
    {"p8-rgb565", Kind::palette, {5, 6, 5, 0}, false, 2, 8, "GL_PALETTE8_R5_G6_B5_OES", nullptr, nullptr},
    {"p8-rgba4444", Kind::palette, {4, 4, 4, 4}, false, 2, 8, "GL_PALETTE8_RGBA4_OES", nullptr, nullptr},
    {"p8-rgba5551", Kind::palette, {5, 5, 5, 1}, false, 2, 8, "GL_PALETTE8_RGB5_A1_OES", nullptr, nullptr},
    {"etc1", Kind::etc1, {8, 8, 8, 0}, false, 0, 0, "GL_ETC1_RGB8_OES", nullptr, nullptr},
};

struct Picture {
    int width, height;
    Bytes rgba;
};

int half_size(int side) {
    return side > 1 ? side / 2 : 1;
}

/// The next level: means of 2 x 2 texels, as GENERATE_MIPMAP makes them.
Picture half_of(const Picture& from) {
    Picture to{half_size(from.width), half_size(from.height), {}};
    to.rgba.resize(static_cast<std::size_t>(to.width * to.height) * 4);
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            for (int c = 0; c < 4; ++c) {
                unsigned sum = 0;
                for (int i = 0; i < 4; ++i) {
                    const int u = from.width > 1 ? 2 * x + (i & 1) : 0,
                              v = from.height > 1 ? 2 * y + (i >> 1) : 0;
                    sum += from.rgba[static_cast<std::size_t>((v * from.width + u) * 4 + c)];
                }
                to.rgba[static_cast<std::size_t>((y * to.width + x) * 4 + c)] =
                    static_cast<std::uint8_t>((sum + 2) / 4);
            }
    return to;
}

/// The picture that a format can store. Luminance formats take the luminance of Rec. 601, and greys keep
/// their values.
Picture seen_as(const TextureFormat& format, const cli::ModelImage& image) {
    Picture picture{image.width, image.height, image.rgba};
    for (std::size_t i = 0; format.luminance && i < picture.rgba.size(); i += 4) {
        std::uint8_t* const p = &picture.rgba[i];
        p[0] = p[1] = p[2] = static_cast<std::uint8_t>((299 * p[0] + 587 * p[1] + 114 * p[2] + 500) / 1000);
    }
    return picture;
}

std::uint32_t code_of(std::uint8_t byte, unsigned bits) {
    const std::uint32_t most = (1u << bits) - 1;
    return (byte * most + 127) / 255;
}

/// Appends a texel or an entry of a palette, least significant byte first.
void append_texel(const TextureFormat& format, const std::uint8_t* rgba, Bytes& to) {
    if (format.kind == Kind::bytes || format.texel_bytes > 2) {
        for (int c = 0; c < 4; ++c)
            if (format.bits[c] != 0)
                to.push_back(rgba[c]);
        return;
    }
    std::uint32_t word = 0;
    for (int c = 0; c < 4; ++c)
        word = word << format.bits[c] | code_of(rgba[c], format.bits[c]);
    for (unsigned i = 0; i < format.texel_bytes; ++i)
        to.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
}

void load_texel(const TextureFormat& format, const std::uint8_t* from, std::uint8_t* rgba) {
    const bool bytes = format.kind == Kind::bytes || format.texel_bytes > 2;
    std::uint32_t word = from[0];
    if (format.texel_bytes == 2)
        word |= static_cast<std::uint32_t>(from[1] << 8);
    for (int c = 3, at = static_cast<int>(format.texel_bytes); c >= 0; --c) {
        const unsigned bits = format.bits[c];
        const std::uint32_t most = (1u << bits) - 1;
        if (bits == 0)
            rgba[c] = 255;
        else if (bytes)
            rgba[c] = from[--at];
        else
            rgba[c] = static_cast<std::uint8_t>(((word & most) * 255 + most / 2) / most);
        word >>= bytes ? 0 : bits;
    }
    if (format.luminance)
        rgba[1] = rgba[2] = rgba[0];
}

/// Appends the indices of a level. Indices of 4 bits continue from row to row, the first in the high half of
/// a byte; a level starts at a byte.
void append_indices(const std::vector<Rgba>& palette, unsigned bits, const Bytes& rgba, Bytes& to) {
    for (std::size_t i = 0; i < rgba.size() / 4; ++i) {
        const std::uint8_t* const p = &rgba[4 * i];
        const auto index = static_cast<std::uint8_t>(nearest_entry(palette, {p[0], p[1], p[2], p[3]}));
        if (bits == 8)
            to.push_back(index);
        else if (i % 2 == 0)
            to.push_back(static_cast<std::uint8_t>(index << 4));
        else
            to.back() = static_cast<std::uint8_t>(to.back() | index);
    }
}

BakedLevel encode(const TextureFormat& format, const Picture& picture) {
    BakedLevel level{picture.width, picture.height, {}};
    if (format.kind == Kind::etc1)
        level.bytes = encode_etc1(picture.rgba, picture.width, picture.height);
    else
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            append_texel(format, &picture.rgba[i], level.bytes);
    return level;
}

BakedLevel encode_palette(const TextureFormat& format, const std::vector<Picture>& chain) {
    BakedLevel level{chain[0].width, chain[0].height, {}};
    const std::size_t entries = std::size_t{1} << format.index_bits;
    std::vector<Rgba> palette = choose_palette(chain[0].rgba, entries, format.bits);
    for (const Rgba& entry : palette)
        append_texel(format, entry.data(), level.bytes);
    level.bytes.resize(entries * format.texel_bytes); // entries of the palette that are not used
    for (const Picture& picture : chain)
        append_indices(palette, format.index_bits, picture.rgba, level.bytes);
    return level;
}

Bytes decode_palette(const TextureFormat& format, const BakedLevel& level, int number) {
    std::size_t at = (std::size_t{1} << format.index_bits) * format.texel_bytes;
    int width = level.width, height = level.height;
    for (; number > 0; --number, width = half_size(width), height = half_size(height))
        at += (static_cast<std::size_t>(width * height) * format.index_bits + 7) / 8;
    Bytes rgba(static_cast<std::size_t>(width * height) * 4);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i) {
        const std::uint8_t byte = level.bytes[at + i * format.index_bits / 8];
        const unsigned index = format.index_bits == 8 ? byte : i % 2 == 0 ? byte >> 4 : byte & 15u;
        load_texel(format, &level.bytes[index * format.texel_bytes], &rgba[4 * i]);
    }
    return rgba;
}

double psnr(const TextureFormat& format, const Bytes& given, const Bytes& kept) {
    double sum = 0.0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < given.size(); ++i)
        if (format.bits[i % 4] != 0) {
            const double d = given[i] - kept[i];
            sum += d * d;
            ++n;
        }
    return sum > 0.0 ? 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(n) / sum) : 99.0;
}

} // namespace

FormatList texture_formats() {
    return {formats, sizeof formats / sizeof formats[0]};
}

const TextureFormat* find_format(std::string_view name) {
    for (const TextureFormat& format : formats)
        if (name == format.name)
            return &format;
    return nullptr;
}

std::size_t BakedTexture::bytes() const {
    std::size_t sum = 0;
    for (const BakedLevel& level : levels)
        sum += level.bytes.size();
    return sum;
}

BakedTexture bake_texture(const cli::ModelImage& image, const TextureOptions& options) {
    BakedTexture texture;
    texture.format = options.format != nullptr ? options.format : &formats[image.translucent ? 1 : 0];
    std::vector<Picture> chain{seen_as(*texture.format, image)};
    while (options.mipmaps && (chain.back().width > 1 || chain.back().height > 1))
        chain.push_back(half_of(chain.back()));
    texture.chain = static_cast<int>(chain.size());
    if (texture.format->kind == Kind::palette)
        texture.levels.push_back(encode_palette(*texture.format, chain));
    else
        for (const Picture& picture : chain)
            texture.levels.push_back(encode(*texture.format, picture));
    texture.psnr_db = psnr(*texture.format, chain[0].rgba, decode_level(texture, 0));
    return texture;
}

std::vector<std::uint8_t> decode_level(const BakedTexture& texture, int level) {
    const TextureFormat& format = *texture.format;
    if (format.kind == Kind::palette)
        return decode_palette(format, texture.levels[0], level);
    const BakedLevel& from = texture.levels[static_cast<std::size_t>(level)];
    if (format.kind == Kind::etc1)
        return decode_etc1(from.bytes, from.width, from.height);
    Bytes rgba(static_cast<std::size_t>(from.width * from.height) * 4);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i)
        load_texel(format, &from.bytes[i * format.texel_bytes], &rgba[4 * i]);
    return rgba;
}

} // namespace spangle::bake
