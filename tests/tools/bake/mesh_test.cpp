// Tests baked meshes: every vertex is as near to its place as the report says, and drawing takes no memory.
#include <cmath>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <spangle/baked.hpp>
#include <spangle/native.hpp>

#include "boards/scenes/models/rocket.hpp"
#include "boards/scenes/scene.hpp"
#include "gl/context/context.hpp"
#include "gl/texture/texture_target.hpp"
#include "gl/vertex/arrays_state.hpp"
#include "host_sim/bake/header.hpp"
#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/vertex_cache.hpp"
#include "tests/source_dir.hpp"
#include "tests/support/headless_gl.hpp"

namespace spangle::bake {
namespace {

const std::string rocket_file = std::string(SPANGLE_SOURCE_DIR) + "/boards/scenes/models/rocket.obj";

cli::Model rocket() {
    cli::ModelResult result = cli::load_model(rocket_file);
    EXPECT_EQ(result.error, "");
    return std::move(result.model);
}

/// Triangles by the rounded places of their vertices, which are equal whatever the order and the
/// quantization.
using Places = std::multiset<std::array<int, 9>>;
template <class At>
void add(Places& places, std::uint32_t a, std::uint32_t b, std::uint32_t c, const At& at) {
    std::array<std::array<int, 3>, 3> corners;
    const std::uint32_t of[3] = {a, b, c};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            corners[i][k] = static_cast<int>(std::lround(at(of[i], k) * 200.0));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::array<int, 9> all{};
    for (std::size_t i = 0; i < 9; ++i)
        all[i] = corners[i / 3][i % 3];
    places.insert(all);
}

TEST(BakedMeshes, AreTheModelWithinTheReportedError) {
    const cli::Model model = rocket();
    const std::pair<Number, double> numbers[] = {
        {Number::fixed, 1.4e-5}, {Number::short_integer, 3e-5}, {Number::byte, 8e-3}};
    for (const auto& [number, most] : numbers)
        for (const Strips strips : {Strips::never, Strips::always, Strips::smaller}) {
            MeshOptions options;
            options.position = options.texcoord = number;
            options.strips = strips;
            const BakedMesh mesh = bake_mesh(model, options);
            EXPECT_GT(mesh.report.position_error, 0.0);
            EXPECT_LE(mesh.report.position_error, most);
            EXPECT_LE(mesh.report.texcoord_error, most);
            ASSERT_EQ(mesh.parts.size(), 1u);
            const BakedPart& part = mesh.parts[0];
            EXPECT_EQ(part.strip, strips != Strips::never);
            Places given, kept;
            const cli::ModelPart& from = model.parts[0];
            for (std::size_t i = 0; i + 2 < from.indices.size(); i += 3)
                add(given, from.indices[i], from.indices[i + 1], from.indices[i + 2],
                    [&](std::uint32_t v, std::size_t k) {
                        return static_cast<double>(from.vertices[v].position[k]);
                    });
            const auto at = [&](std::uint32_t v, std::size_t k) {
                EXPECT_LT(v, part.vertices.size());
                return part.vertices[v].position[k] * mesh.position_step;
            };
            const IndexList& list = part.indices;
            for (std::size_t i = 0; i + 2 < list.size(); i += part.strip ? 1 : 3) {
                const bool odd = part.strip && i % 2 == 1;
                const std::uint32_t a = list[odd ? i + 1 : i], b = list[odd ? i : i + 1], c = list[i + 2];
                if (a != b && b != c && c != a)
                    add(kept, a, b, c, at);
            }
            if (number != Number::byte) {
                EXPECT_EQ(kept, given);
            } else {
                EXPECT_EQ(kept.size(), given.size());
            }
        }
}

TEST(BakedMeshes, TheReportIsWhatWasDone) {
    const cli::Model model = rocket();
    MeshOptions options;
    options.cache = 24;
    const BakedMesh mesh = bake_mesh(model, options);
    const MeshReport& r = mesh.report;
    EXPECT_EQ(r.triangles, 202u);
    EXPECT_EQ(r.vertices_before, model.parts[0].vertices.size());
    EXPECT_EQ(r.vertex_bytes, r.vertices * 14)
        << "three shorts, three bytes, two shorts, and one to the next";
    EXPECT_EQ(r.index_bytes, r.indices) << "few vertices: bytes";
    EXPECT_EQ(r.misses, cache_misses(mesh.parts[0].indices, 24));
    EXPECT_EQ(r.misses_before, cache_misses(model.parts[0].indices, 24));
    EXPECT_LE(r.misses, r.misses_before);
    EXPECT_LT(r.normal_error, 0.5);
    EXPECT_LT(r.vertex_bytes + r.index_bytes, r.float_bytes / 2);
}

TEST(BakedMeshes, VerticesThatBecomeTheSameAreOne) {
    cli::Model model;
    cli::ModelPart part;
    for (const float x : {0.0f, 1.0f, 0.5f, 0.500001f})
        part.vertices.push_back({{x, x == 0.5f ? 1.0f : 0.0f, 0.0f}, {0, 0, 1}, {0, 0}, {1, 0.5f, 0, 1}});
    part.vertices[3] = part.vertices[2];
    part.vertices[3].position[0] += 1e-6f;
    part.indices = {0, 1, 2, 0, 1, 3, 0, 2, 3};
    part.colored = true;
    model.parts = {part};
    model.triangles = 3;
    MeshOptions options;
    options.strips = Strips::never;
    const BakedMesh mesh = bake_mesh(model, options);
    EXPECT_EQ(mesh.parts[0].vertices.size(), 3u);
    EXPECT_EQ(mesh.parts[0].indices.size(), 6u) << "what has lost a corner covers nothing";
    EXPECT_EQ(mesh.parts[0].vertices[0].color[1], 128);
}

TEST(BakedMeshes, LinesAndPointsStayInOrder) {
    cli::Model model;
    cli::ModelPart part;
    part.kind = cli::ModelPart::Kind::lines;
    for (int i = 0; i < 4; ++i)
        part.vertices.push_back({{static_cast<float>(i), 0, 0}, {0, 0, 1}, {0, 0}, {1, 1, 1, 1}});
    part.indices = {3, 2, 2, 1, 1, 0};
    model.parts = {part};
    const BakedMesh mesh = bake_mesh(model, {});
    EXPECT_EQ(mesh.parts[0].indices, (IndexList{0, 1, 1, 2, 2, 3}));
    EXPECT_EQ(mesh.parts[0].vertices[0].position[0], 32767);
    EXPECT_FALSE(has_normals(mesh, mesh.parts[0]));
}

TEST(BakedMeshes, NamesAreIdentifiers) {
    EXPECT_EQ(identifier_of("my-model.v2"), "my_model_v2");
    EXPECT_EQ(identifier_of("3d"), "_3d");
    EXPECT_EQ(identifier_of("--"), "");
}

/// GL reads texels and vertices of the scene's model where they lie, and takes one block of the arena for
/// each level.
TEST(BakedScene, IsDrawnFromConstantMemory) {
    test::HeadlessGl gl(64, 64);
    const GLfloat point[3] = {};
    const std::vector<GLubyte> many(1000, 0);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, point);
    glDrawElements(GL_POINTS, 1000, GL_UNSIGNED_BYTE,
                   many.data()); // makes the vertex cache grow to its full size
    const std::size_t before = memory_use().used;
    scenes::rocket.setup(64, 64);
    const std::size_t after = memory_use().used;
    EXPECT_LT(after - before, sizeof(baked::rocket::texture0_level0) / 8)
        << "the object, its level, its name";
    scenes::rocket.draw(3);
    EXPECT_EQ(memory_use().used, after) << "drawing takes nothing";
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    gl::Context& context = *gl::current_context();
    const gl::TextureObject& texture = gl::bound_texture(context, gl::TextureKind::two);
    EXPECT_EQ(static_cast<const void*>(texture.level[0]->texels), baked::rocket::texture0_level0);
    EXPECT_EQ(context.arrays.vertex.pointer, baked::rocket::vertices0[0].position);
    std::vector<GLubyte> pixels(64 * 64 * 4);
    glReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    int drawn = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        drawn += pixels[i] != pixels[0] ? 1 : 0;
    EXPECT_GT(drawn, 400);
}

} // namespace
} // namespace spangle::bake
