// What the image of a model draws, on this machine: the arrays and textures that `spangle bake` writes, in
// memory.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include <spangle/baked.hpp>

#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/texture.hpp"
#include "host_sim/cli/model.hpp"

namespace spangle::cli {

/// A model as the header of `spangle bake MODEL -o FILE`, with its usual options, describes it. Pointers go
/// from one member to another: it stays where it was made.
class BakedModel {
  public:
    /// The model outlives it.
    explicit BakedModel(const Model& model);
    BakedModel(const BakedModel&) = delete;
    BakedModel& operator=(const BakedModel&) = delete;

    const baked::Mesh& mesh() const { return mesh_; }
    /// The text of that header, with this name of its namespace.
    std::string header(const std::string& name) const;

  private:
    void add_texture(const ModelImage& image);
    void add_part(const bake::BakedPart& part);

    bake::BakedMesh arrays_;
    std::vector<bake::BakedTexture> images_;
    std::vector<bool> translucent_; ///< of the images
    std::deque<std::vector<baked::Level>> levels_;
    std::deque<baked::Texture> textures_; ///< in the order of the model's images
    std::deque<std::vector<std::uint8_t>> bytes_;
    std::vector<baked::Part> parts_;
    baked::Mesh mesh_{};
};

} // namespace spangle::cli
