#include "host_sim/cli/model_baked.hpp"

#include <algorithm>
#include <cstring>

#include <spangle/GL/gl.h>

#include "host_sim/bake/header.hpp"

namespace spangle::cli {

namespace {

using bake::Number;
using Kind = ModelPart::Kind;

GLenum token_of(Number number) {
    constexpr GLenum tokens[] = {GL_FIXED, GL_SHORT, GL_BYTE};
    return tokens[static_cast<unsigned>(number)];
}

GLenum mode_of(const bake::BakedPart& part) {
    switch (part.from->kind) {
    case Kind::points:
        return GL_POINTS;
    case Kind::lines:
        return GL_LINES;
    default:
        return part.strip ? GL_TRIANGLE_STRIP : GL_TRIANGLES;
    }
}

GLenum index_token(const bake::BakedPart& part) {
    const unsigned bytes = bake::index_bytes(part);
    return bytes == 1 ? GL_UNSIGNED_BYTE : bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
}

constexpr std::size_t word = 4; ///< bytes; each array of a vertex begins at a multiple of a word

/// Appends the low bytes of numbers, and pads to the next word.
template <class T>
void append(std::vector<std::uint8_t>& out, const T* first, std::size_t count, unsigned bytes) {
    for (std::size_t i = 0; i < count; ++i)
        for (unsigned b = 0; b < bytes; ++b)
            out.push_back(static_cast<std::uint8_t>(first[i] >> 8 * b));
    out.resize((out.size() + word - 1) / word * word);
}

} // namespace

void BakedModel::add_texture(const ModelImage& image) {
    const bake::BakedTexture& made = images_.emplace_back(bake::bake_texture(image, {}));
    translucent_.push_back(image.translucent);
    std::vector<baked::Level>& levels = levels_.emplace_back();
    for (const bake::BakedLevel& level : made.levels)
        levels.push_back(
            {level.width, level.height, static_cast<GLsizei>(level.bytes.size()), level.bytes.data()});
    // Two formats are usual, of which only one has alpha.
    const bool alpha = made.format == bake::find_format("rgba4444");
    textures_.push_back(
        {alpha ? GLenum{GL_RGBA4} : GLenum{GL_RGB565}, alpha ? GLenum{GL_RGBA} : GLenum{GL_RGB},
         alpha ? GLenum{GL_UNSIGNED_SHORT_4_4_4_4} : GLenum{GL_UNSIGNED_SHORT_5_6_5}, 0,
         static_cast<GLsizei>(levels.size()), levels.data(), made.chain > 1, image.translucent});
}

void BakedModel::add_part(const bake::BakedPart& part) {
    const bake::MeshOptions& o = arrays_.options;
    const bool normals = bake::has_normals(arrays_, part), texcoords = bake::has_texcoords(part);
    std::vector<std::uint8_t>& vertices = bytes_.emplace_back();
    std::size_t at[4] = {};
    for (const bake::BakedVertex& v : part.vertices) {
        const std::size_t begin = vertices.size();
        append(vertices, v.position, 3, bake::bytes_of(o.position));
        at[1] = vertices.size() - begin;
        append(vertices, v.normal, normals ? 3 : 0, bake::bytes_of(o.normal));
        at[2] = vertices.size() - begin;
        append(vertices, v.texcoord, texcoords ? 2 : 0, bake::bytes_of(o.texcoord));
        at[3] = vertices.size() - begin;
        append(vertices, v.color, part.from->colored ? 4 : 0, 1);
    }
    std::vector<std::uint8_t>& indices = bytes_.emplace_back();
    append(indices, part.indices.data(), part.indices.size(), bake::index_bytes(part));
    const auto array = [&](bool has, GLenum type, int which) {
        return has ? baked::Array{type, vertices.data() + at[which]} : baked::Array{0, nullptr};
    };
    const ModelPart& from = *part.from;
    baked::Part& out = parts_.emplace_back();
    out.mode = mode_of(part);
    out.indices = static_cast<GLsizei>(part.indices.size());
    out.index_type = index_token(part);
    out.index = indices.data();
    out.stride = static_cast<GLsizei>(vertices.size() / part.vertices.size());
    out.position = array(true, token_of(o.position), 0);
    out.normal = array(normals, token_of(o.normal), 1);
    out.texcoord = array(texcoords, token_of(o.texcoord), 2);
    out.color = array(from.colored, GL_UNSIGNED_BYTE, 3);
    std::copy(from.diffuse.begin(), from.diffuse.end(), out.diffuse);
    std::copy(from.specular.begin(), from.specular.end(), out.specular);
    std::copy(from.emission.begin(), from.emission.end(), out.emission);
    out.shininess = from.shininess;
    out.texture = from.image >= 0 ? &textures_[static_cast<std::size_t>(from.image)] : nullptr;
}

BakedModel::BakedModel(const Model& model) : arrays_(bake::bake_mesh(model, {})) {
    images_.reserve(model.images.size()); // levels point into the images, which must not move
    for (const ModelImage& image : model.images)
        add_texture(image);
    for (const bake::BakedPart& part : arrays_.parts)
        add_part(part);
    const auto scale = [](Number number, double step) {
        return number == Number::fixed ? 1.0f : static_cast<float>(step);
    };
    mesh_ = {scale(arrays_.options.position, arrays_.position_step),
             arrays_.textured ? scale(arrays_.options.texcoord, arrays_.texcoord_step) : 1.0f,
             static_cast<GLsizei>(parts_.size()), parts_.data()};
}

std::string BakedModel::header(const std::string& name) const {
    return bake::write_header({name, "spangle bake", &arrays_, &images_, &translucent_});
}

} // namespace spangle::cli
