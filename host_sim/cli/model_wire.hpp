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

/// Reads a model from bytes that nobody trusts. A model that comes out can be drawn: its indices name
/// vertices that are there, its numbers are finite, the sides of its pictures are powers of two. Returns
/// nothing, or what is wrong.
std::string unpack(std::string_view bytes, ModelResult& result);

} // namespace spangle::cli
