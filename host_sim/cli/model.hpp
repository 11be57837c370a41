// A 3D model from a file, read by libassimp and flattened to what GL 1.x draws.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/cli/confined.hpp"

namespace spangle::cli {

struct ModelVertex {
    float position[3];
    float normal[3];
    float texcoord[2];
    float color[4]; ///< colour of the vertex, where ModelPart::colored
};

struct ModelImage {
    int width = 0, height = 0;      ///< pixels; powers of two
    std::vector<std::uint8_t> rgba; ///< rows of R G B A bytes; row 0 is t = 0
    bool translucent = false;
};

struct ModelPart {
    enum class Kind : std::uint8_t { points, lines, triangles };
    Kind kind = Kind::triangles;
    std::vector<ModelVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::array<float, 4> diffuse{0.8f, 0.8f, 0.8f, 1.0f};
    std::array<float, 4> specular{0.0f, 0.0f, 0.0f, 1.0f};
    std::array<float, 4> emission{0.0f, 0.0f, 0.0f, 1.0f};
    float shininess = 0.0f; ///< specular exponent, 0 .. 128
    int image = -1;         ///< index of the texture in Model::images; -1: no texture
    bool colored = false;   ///< every vertex has a diffuse colour of its own
};

struct Model {
    std::string name;
    std::vector<ModelPart> parts;
    std::vector<ModelImage> images;
    std::vector<std::string>
        notes; ///< what was left out of the model, in plain words (a texture that cannot be read, ...)
    std::size_t triangles = 0;
};

/// A model read from a file, or why there is none.
struct ModelResult {
    Model model;
    std::string error; ///< what went wrong; empty on success
};

struct ImageResult {
    ModelImage image;
    std::string error; ///< what went wrong; empty on success
};

/// The longest side of a texture in texels unless asked otherwise, which a display board could hold.
inline constexpr int usual_texture_size = 256;

/// Reads a file of any format that libassimp knows, and scales the model into the unit sphere around the
/// origin. Textures become powers of two no larger than `largest_texture`. Whatever the file holds, the model
/// can be drawn: see unpack().
ModelResult load_model(const std::string& path, int largest_texture = usual_texture_size,
                       const ReadLimits& limits = {});

/// Reads a single picture of any format that SDL_image knows.
ImageResult load_image(const std::string& path, int largest = usual_texture_size,
                       const ReadLimits& limits = {});

/// Whether libassimp reads files whose names end like this one.
bool is_model_name(const std::string& path);

/// Sets up GL for the model in a fresh context.
void setup_model(const Model& model, int width, int height);
void draw_model(const Model& model, int frame);

} // namespace spangle::cli
