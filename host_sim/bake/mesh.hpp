// A model as arrays of integers that GL reads in place: quantized, without duplicates, in an order that suits
// the vertex cache.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/cli/model.hpp"

namespace spangle::bake {

/// The type of a stored component. Fixed is GL_FIXED, S15.16. The others are multiples of a step that the
/// matrix of their coordinates undoes.
enum class Number : std::uint8_t { fixed, short_integer, byte };

enum class Strips : std::uint8_t { smaller, always, never };

struct MeshOptions {
    Number position = Number::short_integer, normal = Number::byte, texcoord = Number::short_integer;
    bool with_normals = true;
    Strips strips = Strips::smaller;
    unsigned cache = 80; ///< entries of the vertex cache for which the order is made
};

struct BakedVertex {
    std::int32_t position[3], normal[3], texcoord[2];
    std::uint8_t color[4];
    bool operator==(const BakedVertex&) const = default;
};

struct BakedPart {
    const cli::ModelPart* from = nullptr; ///< the part of the model that was baked, with kind and material
    bool strip = false;
    std::vector<BakedVertex> vertices;
    std::vector<std::uint32_t> indices;
    bool operator==(const BakedPart&) const = default;
};

/// The errors and the sizes that baking led to.
struct MeshReport {
    double position_error = 0.0; ///< largest distance of a vertex from its place; the model has radius 1
    double normal_error = 0.0;   ///< degrees; largest angle
    double texcoord_error = 0.0; ///< largest difference of a texture coordinate s or t
    std::size_t vertices_before = 0, vertices = 0, triangles = 0, indices = 0;
    std::size_t misses_before = 0,
                misses = 0; ///< vertices that the cache processes when the model is drawn once
    std::size_t vertex_bytes = 0, index_bytes = 0,
                float_bytes = 0; ///< float_bytes: the same model as floats and 32-bit indices
};

struct BakedMesh {
    MeshOptions options;
    double position_step = 1.0, texcoord_step = 1.0; ///< length of one unit of the integers that GL is given
    bool textured = false;                           ///< at least one part has texture coordinates
    std::vector<BakedPart> parts;
    MeshReport report;
};

/// The bytes of one component, of an index of a part, and of a vertex of a part.
unsigned bytes_of(Number number);
unsigned index_bytes(const BakedPart& part);
unsigned vertex_bytes(const BakedMesh& mesh, const BakedPart& part);

/// Whether a part has these arrays.
bool has_normals(const BakedMesh& mesh, const BakedPart& part);
bool has_texcoords(const BakedPart& part);

/// Bakes a model, which must live longer than the result.
BakedMesh bake_mesh(const cli::Model& model, const MeshOptions& options);

} // namespace spangle::bake
