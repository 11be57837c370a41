// Carries a model as bytes from the process that reads a file to the process that draws it.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/cli/model.hpp"

namespace spangle::cli {

/// The most that a model may hold. No board could draw more, and nobody would wait for it.
inline constexpr std::size_t most_triangles = 2'000'000, most_vertices = 3 * most_triangles,
                             most_indices = 3 * most_triangles, most_texels = std::size_t{1} << 26;

std::string pack(const ModelResult& result);

/// Reads a model from bytes that are not trusted. A model that comes out can be drawn: its indices name
/// existing vertices, its numbers are finite, and the sides of its pictures are powers of two. Returns what
/// is wrong, or an empty string.
std::string unpack(std::string_view bytes, ModelResult& result);

} // namespace spangle::cli
