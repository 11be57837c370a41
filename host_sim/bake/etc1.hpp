// Encodes pictures as blocks of ETC1: 4 x 4 texels in 8 bytes (OES_compressed_ETC1_RGB8_texture).
#pragma once

#include <cstdint>
#include <vector>

namespace spangle::bake {

/// Returns the blocks of an RGBA picture. Texels of a block beyond the picture repeat its last row or column.
std::vector<std::uint8_t> encode_etc1(const std::vector<std::uint8_t>& rgba, int width, int height);

/// Decodes blocks to RGBA, by the tables of the extension.
std::vector<std::uint8_t> decode_etc1(const std::vector<std::uint8_t>& blocks, int width, int height);

} // namespace spangle::bake
