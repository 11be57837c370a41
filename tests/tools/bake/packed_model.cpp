#include "tests/tools/bake/packed_model.hpp"

#include <cmath>
#include <cstdlib>
#include <string_view>

#include "host_sim/bake/header.hpp"
#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/texture.hpp"
#include "host_sim/cli/model_wire.hpp"

namespace bake_test {

using namespace spangle;

namespace {

void require(bool condition) {
    if (!condition)
        std::abort();
}

void require_drawable(const cli::Model& model) {
    for (const cli::ModelPart& part : model.parts) {
        require(!part.indices.empty() && part.image >= -1 &&
                part.image < static_cast<int>(model.images.size()));
        for (const std::uint32_t index : part.indices)
            require(index < part.vertices.size());
        for (const cli::ModelVertex& v : part.vertices)
            require(std::isfinite(v.position[0]) && std::isfinite(v.normal[1]) &&
                    std::isfinite(v.texcoord[0]) && std::isfinite(v.color[3]));
    }
    for (const cli::ModelImage& image : model.images)
        require(image.rgba.size() ==
                std::size_t{4} * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height));
}

bake::MeshOptions options_of(std::uint8_t choice) {
    bake::MeshOptions options;
    options.position = options.texcoord = static_cast<bake::Number>(choice % 3);
    options.strips = static_cast<bake::Strips>(choice / 3 % 3);
    options.with_normals = (choice & 64) == 0;
    options.cache = 1u + choice % 80u;
    return options;
}

} // namespace

bool run_packed_model(const std::uint8_t* data, std::size_t bytes) {
    if (bytes == 0)
        return false;
    cli::ModelResult result;
    if (!cli::unpack({reinterpret_cast<const char*>(data) + 1, bytes - 1}, result).empty())
        return false;
    require_drawable(result.model);
    bake::TextureOptions texture;
    texture.format = bake::texture_formats().first + data[0] % bake::texture_formats().count;
    std::vector<bake::BakedTexture> textures;
    std::vector<bool> translucent;
    for (const cli::ModelImage& image : result.model.images) {
        textures.push_back(bake::bake_texture(image, texture));
        translucent.push_back(image.translucent);
    }
    const bake::BakedMesh mesh = bake::bake_mesh(result.model, options_of(data[0]));
    require(!bake::write_header({"name", "command", &mesh, &textures, &translucent}).empty());
    return true;
}

std::vector<std::vector<std::uint8_t>> packed_models() {
    std::vector<std::vector<std::uint8_t>> out;
    for (unsigned kind = 0; kind < 3; ++kind) {
        cli::ModelResult result;
        cli::ModelImage image{2, 4, std::vector<std::uint8_t>(32, static_cast<std::uint8_t>(60 * kind)),
                              kind == 1};
        result.model.images.assign(kind, image);
        result.model.notes.assign(kind, "a note");
        cli::ModelPart part;
        part.kind = static_cast<cli::ModelPart::Kind>(kind);
        part.image = static_cast<int>(kind) - 1;
        part.colored = kind == 2;
        for (unsigned corner = 0; corner < 4; ++corner) {
            const float x = corner & 1 ? 1.0f : -1.0f, y = corner & 2 ? 1.0f : -1.0f;
            part.vertices.push_back({{x, y, 0.0f}, {0.0f, 0.0f, 1.0f}, {x, y}, {1.0f, 0.5f, 0.0f, 1.0f}});
        }
        part.indices = {0, 1, 2, 2, 1, 3};
        result.model.parts.assign(kind + 1, part);
        result.model.triangles = 2 * (kind + 1);
        const std::string bytes = cli::pack(result);
        out.emplace_back(1, static_cast<std::uint8_t>(7 * kind));
        out.back().insert(out.back().end(), bytes.begin(), bytes.end());
    }
    return out;
}

} // namespace bake_test
