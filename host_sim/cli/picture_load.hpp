// A picture that somebody else made, read by SDL_image and scaled to what GL 1.x takes as a texture. Files
// are not trusted: these run within confined().
#pragma once

#include <cstddef>
#include <string>

#include "host_sim/cli/model.hpp"

namespace spangle::cli {

/// Sides become powers of two no larger than `largest`. Empty, or why there is no picture.
std::string read_picture(const std::string& path, int largest, ModelImage& out);
/// The bytes of such a file.
std::string read_picture(const void* bytes, std::size_t size, int largest, ModelImage& out);
/// Texels of B, G, R, A bytes, top row first.
std::string read_texels(void* bgra, std::size_t width, std::size_t height, int largest, ModelImage& out);

} // namespace spangle::cli
