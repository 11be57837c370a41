// The arrays and textures that `spangle bake` writes for a model, in this machine's memory. Drawing from
// these gives what the image of a firmware draws.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include <spangle/baked.hpp>

#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/texture.hpp"
#include "host_sim/cli/model.hpp"

namespace spangle::cli {

/// A model as the header of `spangle bake MODEL -o FILE` describes it, with the usual options. Its members
/// point to each other, so it cannot be copied.
class BakedModel {
  public:
    /// `model` must live longer than this object.
    explicit BakedModel(const Model& model);
    BakedModel(const BakedModel&) = delete;
    BakedModel& operator=(const BakedModel&) = delete;

    const baked::Mesh& mesh() const { return mesh_; }
    /// The text of the header, whose namespace has this name.
    std::string header(const std::string& name) const;

  private:
    void add_texture(const ModelImage& image);
    void add_part(const bake::BakedPart& part);

    bake::BakedMesh arrays_;
    std::vector<bake::BakedTexture> images_;
    std::vector<bool> translucent_; ///< for each image of the model, whether it has alpha below 255
    std::deque<std::vector<baked::Level>> levels_;
    std::deque<baked::Texture> textures_; ///< textures in the order of the model's images
    std::deque<std::vector<std::uint8_t>> bytes_;
    std::vector<baked::Part> parts_;
    baked::Mesh mesh_{};
};

} // namespace spangle::cli
