// A picture as the texels that GL reads in place, in every format for which it can.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "host_sim/cli/model.hpp"

namespace spangle::bake {

/// How a texel is stored: R, G, B, A in a word, or in bytes, as an index of a palette, or in blocks.
enum class TexelKind : std::uint8_t { packed, bytes, palette, etc1 };

struct TextureFormat {
    const char* name; ///< name on the command line
    TexelKind kind;
    std::uint8_t bits[4];        ///< bits of R, G, B, A in a texel or an entry of the palette
    bool luminance;              ///< R holds the luminance, G and B are unused
    unsigned texel_bytes;        ///< bytes of a texel, or of an entry of the palette; 0 for blocks
    unsigned index_bits;         ///< bits of an index of a palette; 0 without a palette
    const char* internal_format; ///< names of GL's tokens
    const char* format;          ///< format for TexImage in other GLs; null: compressed
    const char* type;
};

/// All formats; the first is that of opaque pictures.
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
    std::vector<std::uint8_t> bytes; ///< texels, least significant byte first; of a palette format all levels
};

struct BakedTexture {
    const TextureFormat* format = nullptr;
    int chain = 0;                  ///< number of levels of the mip chain
    std::vector<BakedLevel> levels; ///< a single entry for palettes, whose levels lie one behind the other
    double psnr_db = 0.0;           ///< PSNR of level 0 over the components that the format keeps; 99: exact
    std::size_t bytes() const;
};

BakedTexture bake_texture(const cli::ModelImage& image, const TextureOptions& options);

/// The texels that GL samples of a level of the chain, as RGBA bytes.
std::vector<std::uint8_t> decode_level(const BakedTexture& texture, int level);

} // namespace spangle::bake
