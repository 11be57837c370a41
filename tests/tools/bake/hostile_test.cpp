// Tests what a file can do after it was read: bytes that are no model, numbers at the ends of floats, and
// meshes whose ordering would take forever.
#include <ctime>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/vertex_cache.hpp"
#include "host_sim/cli/model_wire.hpp"
#include "tests/tools/bake/packed_model.hpp"

namespace spangle::bake {
namespace {

TEST(PackedModels, ComeOutAsTheyWere) {
    for (const auto& seed : bake_test::packed_models()) {
        EXPECT_TRUE(bake_test::run_packed_model(seed.data(), seed.size()));
        cli::ModelResult result;
        const std::string bytes(seed.begin() + 1, seed.end());
        ASSERT_EQ(cli::unpack(bytes, result), "");
        EXPECT_EQ(cli::pack(result), bytes);
        EXPECT_NE(cli::unpack(bytes + "x", result), "") << "more than a model";
    }
}

/// A broken process can hand over any bytes.
TEST(PackedModels, ThatAreBrokenAreRefusedOrSound) {
    std::mt19937 random(20);
    int refused = 0, taken = 0;
    for (const auto& seed : bake_test::packed_models()) {
        for (std::size_t length = 1; length < seed.size(); length += 7)
            EXPECT_FALSE(bake_test::run_packed_model(seed.data(), length)) << length;
        for (int n = 0; n < 3000; ++n) {
            auto bytes = seed;
            for (unsigned changes = 1 + random() % 3; changes > 0; --changes)
                bytes[random() % bytes.size()] =
                    static_cast<std::uint8_t>(random() % 4 == 0 ? random() : 255);
            ++(bake_test::run_packed_model(bytes.data(), bytes.size()) ? taken : refused);
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_GT(taken, 100);
}

/// Breaks each rule of unpack() alone.
TEST(PackedModels, EachRule) {
    const auto broken = [](auto&& change) {
        cli::ModelResult result, out;
        cli::ModelPart part;
        part.vertices.resize(3);
        part.indices = {0, 1, 2};
        result.model.parts = {part};
        result.model.images = {{1, 1, {1, 2, 3, 4}, false}};
        change(result.model, result.model.parts[0]);
        const std::string problem = cli::unpack(cli::pack(result), out);
        EXPECT_TRUE(problem.empty() || out.model.parts.empty()) << "nothing of it is kept";
        return !problem.empty();
    };
    using cli::Model, cli::ModelPart;
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(broken([](Model&, ModelPart&) {}));
    EXPECT_TRUE(broken([](Model&, ModelPart& p) { p.indices[1] = 3; }));
    EXPECT_TRUE(broken([](Model&, ModelPart& p) { p.indices.pop_back(); }));
    EXPECT_TRUE(broken([](Model&, ModelPart& p) { p.indices.clear(); }));
    EXPECT_TRUE(broken([](Model&, ModelPart& p) { p.image = 1; }));
    EXPECT_TRUE(broken([](Model&, ModelPart& p) { p.image = -2; }));
    EXPECT_TRUE(broken([&](Model&, ModelPart& p) { p.vertices[2].position[2] = nan; }));
    EXPECT_TRUE(broken([&](Model&, ModelPart& p) { p.vertices[2].normal[0] = infinity; }));
    EXPECT_TRUE(broken([&](Model&, ModelPart& p) { p.vertices[2].texcoord[1] = -infinity; }));
    EXPECT_TRUE(broken([&](Model&, ModelPart& p) { p.vertices[2].color[3] = nan; }));
    EXPECT_TRUE(broken([&](Model&, ModelPart& p) { p.diffuse[0] = nan; }));
    EXPECT_TRUE(broken([&](Model&, ModelPart& p) { p.shininess = nan; }));
    EXPECT_TRUE(broken([](Model&, ModelPart& p) { p.shininess = 128.5f; }));
    EXPECT_TRUE(broken([](Model& m, ModelPart&) {
        m.images[0] = {3, 1, std::vector<std::uint8_t>(12), false};
    }));
    EXPECT_TRUE(broken([](Model& m, ModelPart&) { m.images[0].height = 0; }));
    EXPECT_TRUE(broken([](Model& m, ModelPart&) { m.images[0].width = 2; })) << "fewer texels than that";
    EXPECT_TRUE(broken([](Model& m, ModelPart&) { m.triangles = cli::most_triangles + 1; }));
}

/// Texture coordinates may be any finite numbers: what is less than a step is 0, and steps are never 0.
TEST(HostileMeshes, NumbersAtTheEndsOfFloats) {
    for (const float largest : {3.4e38f, 1e-45f, 1e-38f, 0.0f})
        for (const Number number : {Number::fixed, Number::short_integer, Number::byte}) {
            cli::Model model;
            model.images = {{1, 1, {1, 2, 3, 4}, false}};
            cli::ModelPart part;
            part.vertices = {{{0, 0, 0}, {0, 0, 1}, {largest, 0}, {}},
                             {{1, 0, 0}, {0, 0, 0}, {-largest, largest}, {}},
                             {{0, 1, 0}, {largest, 0, 1}, {0, 0}, {}}};
            part.indices = {0, 1, 2};
            part.image = 0;
            model.parts = {part};
            MeshOptions options;
            options.texcoord = options.normal = number;
            const BakedMesh mesh = bake_mesh(model, options);
            EXPECT_GT(mesh.texcoord_step, 0.0);
            EXPECT_TRUE(std::isfinite(mesh.report.texcoord_error)) << largest;
            EXPECT_TRUE(std::isfinite(mesh.report.normal_error)) << largest;
        }
}

/// Returns the processor seconds for a strip of that many triangles at one edge.
double seconds_of_strip(std::uint32_t triangles) {
    IndexList list;
    for (std::uint32_t n = 0; n < triangles; ++n)
        list.insert(list.end(), {n % 2, 1 - n % 2, n + 2});
    const std::clock_t begin = std::clock();
    const IndexList strip = make_strip(list, 2 * list.size());
    const std::clock_t end = std::clock();
    EXPECT_GE(strip.size(), triangles);
    return static_cast<double>(end - begin) / CLOCKS_PER_SEC;
}

/// With thousands of triangles at one edge, the time must not grow with the square of their number.
TEST(HostileMeshes, SharedEdgesTakeNoForever) {
    const double few = seconds_of_strip(50000);
    EXPECT_LT(seconds_of_strip(400000), 24 * few)
        << "eight times as many take 64 times as long where every triangle asks all others";
}

} // namespace
} // namespace spangle::bake
