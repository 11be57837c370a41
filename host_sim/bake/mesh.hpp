// A model as arrays of integers that GL reads where they lie: quantized, without duplicates, in an order that
// the vertex cache likes.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/cli/model.hpp"

namespace spangle::bake {

/// What a component is kept as. Fixed is GL_FIXED, S15.16; the others are multiples of a step that the matrix
/// of their coordinates undoes.
enum class Number : std::uint8_t { fixed, short_integer, byte };

enum class Strips : std::uint8_t { smaller, always, never };

struct MeshOptions {
    Number position = Number::short_integer, normal = Number::byte, texcoord = Number::short_integer;
    bool with_normals = true;
    Strips strips = Strips::smaller;
    unsigned cache = 80; ///< entries of the vertex cache that the order is for
};

struct BakedVertex {
    std::int32_t position[3], normal[3], texcoord[2];
    std::uint8_t color[4];
    bool operator==(const BakedVertex&) const = default;
};

struct BakedPart {
    const cli::ModelPart* from = nullptr; ///< kind and material
    bool strip = false;
    std::vector<BakedVertex> vertices;
    std::vector<std::uint32_t> indices;
    bool operator==(const BakedPart&) const = default;
};

/// What it cost.
struct MeshReport {
    double position_error = 0.0; ///< largest distance from where a vertex was; the model has radius 1
    double normal_error = 0.0;   ///< largest angle, in degrees
    double texcoord_error = 0.0; ///< largest difference of s or t
    std::size_t vertices_before = 0, vertices = 0, triangles = 0, indices = 0;
    std::size_t misses_before = 0,
                misses = 0; ///< vertices that the cache has to process, in one drawing of it
    std::size_t vertex_bytes = 0, index_bytes = 0,
                float_bytes = 0; ///< the last: as floats and 32-bit indices
};

struct BakedMesh {
    MeshOptions options;
    double position_step = 1.0, texcoord_step = 1.0; ///< of one unit of the integers that GL is given
    bool textured = false;                           ///< some part has texture coordinates
    std::vector<BakedPart> parts;
    MeshReport report;
};

/// Bytes of one component, of an index of a part, of a vertex of a part.
unsigned bytes_of(Number number);
unsigned index_bytes(const BakedPart& part);
unsigned vertex_bytes(const BakedMesh& mesh, const BakedPart& part);

/// The arrays a part has.
bool has_normals(const BakedMesh& mesh, const BakedPart& part);
bool has_texcoords(const BakedPart& part);

/// The model outlives what is made of it.
BakedMesh bake_mesh(const cli::Model& model, const MeshOptions& options);

} // namespace spangle::bake
