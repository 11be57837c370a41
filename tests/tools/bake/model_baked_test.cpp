// Draws what images of models draw: the arrays that `spangle bake` writes, in memory. The picture must be
// nearly the model's.
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "boards/scenes/baked_model.hpp"
#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/texture.hpp"
#include "host_sim/cli/model_baked.hpp"
#include "tests/support/headless_gl.hpp"

namespace spangle::cli {
namespace {

constexpr int width = 96, height = 64;

/// Returns squares: one with a texture of two rows, one with colours at its corners, and a translucent one;
/// and a line. They have every kind of array, and a texture that two parts share.
Model squares() {
    Model model;
    ModelImage rows{4, 2, {}, false}, glass{2, 2, std::vector<std::uint8_t>(16, 128), true};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            for (const int v : {y != 0 ? 255 : 40, 60 * x, 200, 255})
                rows.rgba.push_back(static_cast<std::uint8_t>(v));
    model.images = {rows, glass};
    for (int i = 0; i < 5; ++i) {
        ModelPart part;
        part.image = i == 0 || i == 3 ? 0 : i == 2 ? 1 : -1;
        part.colored = i == 1;
        part.kind = i == 4 ? ModelPart::Kind::lines : ModelPart::Kind::triangles;
        const float x = -0.7f + 0.4f * static_cast<float>(i % 4), y = i == 3 ? -0.6f : 0.1f;
        for (int corner = 0; corner < 4; ++corner) {
            const float s = corner & 1 ? 1.0f : 0.0f, t = corner & 2 ? 1.0f : 0.0f;
            part.vertices.push_back(
                {{x + 0.35f * s, y + 0.35f * t, 0.1f * s}, {0.0f, 0.0f, 1.0f}, {s, t}, {s, t, 0.5f, 1.0f}});
        }
        part.indices =
            i == 4 ? std::vector<std::uint32_t>{0, 3} : std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3};
        model.parts.push_back(part);
    }
    return model;
}

template <class T> T number_at(const baked::Array& array, std::size_t at) {
    T out;
    std::memcpy(&out, static_cast<const char*>(array.first) + at, sizeof out);
    return out;
}

TEST(BakedModels, AreTheArraysOfTheHeader) {
    const Model model = squares();
    const BakedModel baked(model);
    const bake::BakedMesh want = bake::bake_mesh(model, {});
    const baked::Mesh& mesh = baked.mesh();
    EXPECT_EQ(mesh.position_scale, static_cast<float>(want.position_step));
    EXPECT_EQ(mesh.texcoord_scale, static_cast<float>(want.texcoord_step));
    ASSERT_EQ(static_cast<std::size_t>(mesh.parts), want.parts.size());
    for (std::size_t i = 0; i < want.parts.size(); ++i) {
        const baked::Part& part = mesh.part[i];
        const bake::BakedPart& from = want.parts[i];
        ASSERT_EQ(static_cast<std::size_t>(part.indices), from.indices.size()) << i;
        EXPECT_EQ(part.mode, from.from->kind == ModelPart::Kind::lines ? GLenum{GL_LINES}
                             : from.strip                              ? GLenum{GL_TRIANGLE_STRIP}
                                                                       : GLenum{GL_TRIANGLES});
        ASSERT_EQ(part.index_type, GLenum{GL_UNSIGNED_BYTE});
        for (std::size_t k = 0; k < from.indices.size(); ++k)
            EXPECT_EQ(static_cast<const GLubyte*>(part.index)[k], from.indices[k]) << i;
        EXPECT_EQ(part.normal.first != nullptr, from.from->kind == ModelPart::Kind::triangles);
        EXPECT_EQ(part.texcoord.first != nullptr, from.from->image >= 0);
        EXPECT_EQ(part.color.first != nullptr, from.from->colored);
        for (std::size_t v = 0; v < from.vertices.size(); ++v) {
            const std::size_t at = v * static_cast<std::size_t>(part.stride);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_EQ(number_at<GLshort>(part.position, at + 2 * c), from.vertices[v].position[c]) << i;
                if (part.normal.first != nullptr) {
                    EXPECT_EQ(number_at<GLbyte>(part.normal, at + c), from.vertices[v].normal[c]) << i;
                }
                if (part.color.first != nullptr) {
                    EXPECT_EQ(number_at<GLubyte>(part.color, at + c), from.vertices[v].color[c]) << i;
                }
                if (part.texcoord.first != nullptr && c < 2) {
                    EXPECT_EQ(number_at<GLshort>(part.texcoord, at + 2 * c), from.vertices[v].texcoord[c])
                        << i;
                }
            }
        }
    }
    const bake::BakedTexture opaque = bake::bake_texture(model.images[0], {});
    const baked::Texture& texture = *mesh.part[0].texture;
    EXPECT_EQ(texture.internal_format, GLenum{GL_RGB565});
    EXPECT_EQ(mesh.part[2].texture->internal_format, GLenum{GL_RGBA4});
    EXPECT_TRUE(mesh.part[2].texture->translucent);
    ASSERT_EQ(static_cast<std::size_t>(texture.images), opaque.levels.size());
    EXPECT_EQ(
        std::memcmp(texture.image[0].texels, opaque.levels[0].bytes.data(), opaque.levels[0].bytes.size()),
        0);
}

std::vector<GLubyte> pixels() {
    std::vector<GLubyte> out(std::size_t{4} * width * height);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return out;
}

TEST(BakedModels, DrawNearlyTheModel) {
    const Model model = squares();
    const BakedModel baked(model);
    for (const int frame : {0, 70}) {
        std::vector<GLubyte> of_model, of_baked;
        {
            const test::HeadlessGl gl(width, height);
            setup_model(model, width, height);
            draw_model(model, frame);
            of_model = pixels();
        }
        {
            const test::HeadlessGl gl(width, height);
            scenes::setup_baked(baked.mesh(), width, height);
            scenes::draw_baked(baked.mesh(), frame);
            of_baked = pixels();
            EXPECT_EQ(glIsEnabled(GL_BLEND), GL_FALSE);
        }
        int covered = 0, off = 0;
        for (std::size_t i = 0; i < of_model.size(); i += 4) {
            const bool clear = of_model[i] == of_model[0] && of_model[i + 1] == of_model[1];
            covered += clear ? 0 : 1;
            for (std::size_t c = 0; c < 3; ++c)
                // Textures of 4 bits a component differ by up to 12.
                if (std::abs(of_model[i + c] - of_baked[i + c]) > 12) {
                    ++off;
                    break;
                }
        }
        EXPECT_GT(covered, 150) << frame;
        EXPECT_LT(off, covered / 20) << "frame " << frame << ": corners lie a fraction of a pixel elsewhere";
    }
}

TEST(BakedModels, PartsShareTextures) {
    const Model model = squares();
    const BakedModel baked(model);
    EXPECT_EQ(scenes::texture_name(baked.mesh(), 0), 1u);
    EXPECT_EQ(scenes::texture_name(baked.mesh(), 1), 0u) << "it has none";
    EXPECT_EQ(scenes::texture_name(baked.mesh(), 2), 3u);
    EXPECT_EQ(scenes::texture_name(baked.mesh(), 3), 1u);
}

} // namespace
} // namespace spangle::cli
