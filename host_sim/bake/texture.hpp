// A picture as the texels that GL keeps, in every format that it reads where they lie.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "host_sim/cli/model.hpp"

namespace spangle::bake {

/// How a texel's word holds R, G, B, A, or what else it is.
enum class TexelKind : std::uint8_t { packed, bytes, palette, etc1 };

struct TextureFormat {
    const char* name; ///< what the command line calls it
    TexelKind kind;
    std::uint8_t bits[4];        ///< of R, G, B, A as a texel or an entry of the palette keeps them
    bool luminance;              ///< R is the luminance
    unsigned texel_bytes;        ///< of a texel, or an entry of the palette; 0 for blocks
    unsigned index_bits;         ///< of a palette
    const char* internal_format; ///< tokens of GL, by name
    const char* format;          ///< of TexImage, for other GLs; null: compressed
    const char* type;
};

/// All of them; the first is that of opaque pictures.
struct FormatList {
    const TextureFormat* first;
    std::size_t count;
    const TextureFormat* begin() const { return first; }
    const TextureFormat* end() const { return first + count; }
};
FormatList texture_formats();
const TextureFormat* find_format(std::string_view name);

struct TextureOptions {
    const TextureFormat* format = nullptr; ///< null: RGB565, or RGBA4444 for pictures with alpha
    bool mipmaps = true;
};

struct BakedLevel {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes; ///< texels, least significant byte first; of a palette, all levels
};

struct BakedTexture {
    const TextureFormat* format = nullptr;
    int chain = 0;                  ///< levels of the mip chain
    std::vector<BakedLevel> levels; ///< one for palettes, whose levels lie behind each other
    double psnr_db = 0.0;           ///< of level 0, over the components that the format keeps; 99: exact
    std::size_t bytes() const;
};

BakedTexture bake_texture(const cli::ModelImage& image, const TextureOptions& options);

/// What GL samples of a level of the chain: RGBA bytes.
std::vector<std::uint8_t> decode_level(const BakedTexture& texture, int level);

} // namespace spangle::bake
