// How a model gets from the process that reads a file to the one that draws it.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/cli/model.hpp"

namespace spangle::cli {

/// What a model may hold. Beyond this no board, and no patience, follows.
inline constexpr std::size_t most_triangles = 2'000'000, most_vertices = 3 * most_triangles,
                             most_indices = 3 * most_triangles, most_texels = std::size_t{1} << 26;

std::string pack(const ModelResult& result);

/// Whoever packed the bytes is not trusted: a model that comes out is one that can be drawn. Indices are of
/// vertices that are there, numbers are finite, sides of pictures are powers of two. Empty, or what is wrong.
std::string unpack(std::string_view bytes, ModelResult& result);

} // namespace spangle::cli
