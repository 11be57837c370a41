// spangle bake: writes models and pictures as constants for flash.
#pragma once

#include <string>

#include "host_sim/bake/mesh.hpp"

namespace CLI {
class App;
}

namespace spangle::cli {

struct BakeOptions {
    std::string input, output, name;
    std::string texture_format = "auto";
    int texture_size = 256;
    bool no_mipmaps = false, no_normals = false, json = false;
    std::string positions = "short", normals = "byte", texcoords = "short", strips = "smaller";
    unsigned cache = 80;
};

/// Adds the command with its options.
CLI::App* add_bake(CLI::App& app, BakeOptions& options);

/// Writes the header and prints its size. Returns the exit status.
int bake(const BakeOptions& options);

} // namespace spangle::cli
