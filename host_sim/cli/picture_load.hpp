// Reads pictures with SDL_image, and scales them to what GL 1.x takes as a texture. The files are not
// trusted: these functions run within run_confined().
#pragma once

#include <cstddef>
#include <string>

#include "host_sim/cli/model.hpp"

namespace spangle::cli {

/// Reads a picture file. Its sides become powers of two no larger than `largest`. Returns why there is no
/// picture, or an empty string.
std::string read_picture(const std::string& path, int largest, ModelImage& out);
/// Reads a picture from the bytes of a picture file. Returns why there is no picture, or an empty string.
std::string read_picture(const void* bytes, std::size_t size, int largest, ModelImage& out);
/// Reads a picture of B, G, R, A bytes, top row first. Returns why there is no picture, or an empty string.
std::string read_texels(void* bgra, std::size_t width, std::size_t height, int largest, ModelImage& out);

} // namespace spangle::cli
