// Pictures as blocks of ETC1: 4 x 4 texels in 8 bytes (OES_compressed_ETC1_RGB8_texture).
#pragma once

#include <cstdint>
#include <vector>

namespace spangle::bake {

/// Blocks of an RGBA picture; texels beyond its sides repeat the last.
std::vector<std::uint8_t> encode_etc1(const std::vector<std::uint8_t>& rgba, int width, int height);

/// RGBA of the blocks, by the tables of the extension.
std::vector<std::uint8_t> decode_etc1(const std::vector<std::uint8_t>& blocks, int width, int height);

} // namespace spangle::bake
