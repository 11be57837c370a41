// Writes what was baked as a C++ header of constants (spangle/baked.hpp).
#pragma once

#include <string>
#include <vector>

#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/texture.hpp"

namespace spangle::bake {

struct HeaderInput {
    std::string name;      ///< name of the namespace inside of spangle::baked
    std::string command;   ///< command that writes the header again
    const BakedMesh* mesh; ///< null: the header has textures only
    const std::vector<BakedTexture>* textures;
    /// For each picture, in their order, whether it has alpha below 255.
    const std::vector<bool>* translucent;
};

std::string write_header(const HeaderInput& input);

/// The text as an identifier: letters, digits and underscores, not beginning with a digit. Empty if nothing
/// of the text can be kept.
std::string identifier_of(const std::string& text);

} // namespace spangle::bake
