// A 3D model that somebody else made, read by libassimp and flattened to what GL 1.x draws.
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
    float color[4]; ///< of ModelPart::colored parts
};

struct ModelImage {
    int width = 0, height = 0;      ///< powers of two
    std::vector<std::uint8_t> rgba; ///< row 0 is t = 0
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
    float shininess = 0.0f; ///< 0 .. 128
    int image = -1;         ///< index into Model::images, or -1
    bool colored = false;   ///< every vertex has its own diffuse colour
};

struct Model {
    std::string name;
    std::vector<ModelPart> parts;
    std::vector<ModelImage> images;
    std::vector<std::string>
        notes; ///< what was left out, in plain words (a texture that cannot be read, ...)
    std::size_t triangles = 0;
};

/// A model, or why there is none.
struct ModelResult {
    Model model;
    std::string error; ///< empty on success
};

struct ImageResult {
    ModelImage image;
    std::string error; ///< empty on success
};

/// The longest side of a texture, unless asked otherwise: what a display board would hold.
inline constexpr int usual_texture_size = 256;

/// Reads a file of any format libassimp knows and scales it into the unit sphere around the origin. Textures
/// become powers of two no larger than that. Whatever the file holds, what comes out can be drawn: see
/// unpack().
ModelResult load_model(const std::string& path, int largest_texture = usual_texture_size,
                       const ReadLimits& limits = {});

/// A picture by itself, of any format SDL_image knows.
ImageResult load_image(const std::string& path, int largest = usual_texture_size,
                       const ReadLimits& limits = {});

/// Whether libassimp reads files whose names end like this one.
bool is_model_name(const std::string& path);

/// Sets up GL for the model in a fresh context, then draws frame f of its turn (360 frames, 2 degrees each).
void setup_model(const Model& model, int width, int height);
void draw_model(const Model& model, int frame);

} // namespace spangle::cli
