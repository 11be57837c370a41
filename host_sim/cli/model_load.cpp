#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <new>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "host_sim/cli/model.hpp"
#include "host_sim/cli/model_wire.hpp"
#include "host_sim/cli/picture_load.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr float sharpest_smooth_edge = 66.0f; // degrees; edges of cubes stay sharp without normals

/// Replaces NaN and infinities by 0, so that a broken file still has a picture.
float finite_or_zero(float v) {
    return std::isfinite(v) ? v : 0.0f;
}

class Reader {
  public:
    Reader(const aiScene& scene, const fs::path& file, int largest_texture, Model& model)
        : scene_(scene), folder_(file.parent_path()), largest_texture_(largest_texture), model_(model) {}

    void read() { add_node(*scene_.mRootNode, aiMatrix4x4()); }
    bool too_much() const {
        return model_.triangles > most_triangles || vertices_ > most_vertices || indices_ > most_indices;
    }
    std::string how_much() const {
        return model_.triangles > most_triangles
                   ? std::to_string(model_.triangles) + " triangles; at most " +
                         std::to_string(most_triangles) + " are drawn"
                   : std::to_string(vertices_) + " vertices and " + std::to_string(indices_) +
                         " indices; at most " + std::to_string(most_vertices) + " are drawn";
    }

  private:
    const aiScene& scene_;
    fs::path folder_;
    int largest_texture_;
    Model& model_;
    std::map<std::string, int> images_;
    std::size_t vertices_ = 0, indices_ = 0, texels_ = 0;

    void add_node(const aiNode& n, const aiMatrix4x4& parent) {
        const aiMatrix4x4 world = parent * n.mTransformation;
        // A few nodes can repeat a mesh without end, so this stops as soon as there is too much.
        for (unsigned i = 0; i < n.mNumMeshes && !too_much(); ++i)
            mesh(*scene_.mMeshes[n.mMeshes[i]], world);
        for (unsigned i = 0; i < n.mNumChildren && !too_much(); ++i)
            add_node(*n.mChildren[i], world);
    }

    /// Whether a mesh has colours of its own. Old exporters write an empty, black layer that was never shown.
    static bool painted(const aiMesh& m) {
        return m.HasVertexColors(0) &&
               std::any_of(m.mColors[0], m.mColors[0] + m.mNumVertices,
                           [](const aiColor4D& c) { return c.r > 0.0f || c.g > 0.0f || c.b > 0.0f; });
    }

    void mesh(const aiMesh& m, const aiMatrix4x4& world) {
        ModelPart part;
        if (m.mMaterialIndex < scene_.mNumMaterials)
            material(*scene_.mMaterials[m.mMaterialIndex], part);
        if (!m.HasTextureCoords(0))
            part.image = -1;
        part.colored = painted(m);
        aiMatrix3x3 turn(world);
        turn.Inverse().Transpose();
        for (unsigned i = 0; i < m.mNumVertices; ++i) {
            const aiVector3D p = world * m.mVertices[i];
            aiVector3D n = m.HasNormals() ? turn * m.mNormals[i] : aiVector3D(0, 0, 1);
            if (n.SquareLength() > 0)
                n.Normalize();
            const aiVector3D t = m.HasTextureCoords(0) ? m.mTextureCoords[0][i] : aiVector3D(0, 0, 0);
            const aiColor4D c = part.colored ? m.mColors[0][i] : aiColor4D(1, 1, 1, 1);
            const std::array<float, 4>& d = part.diffuse;
            part.vertices.push_back(
                {{p.x, p.y, p.z},
                 {finite_or_zero(n.x), finite_or_zero(n.y), finite_or_zero(n.z)},
                 {finite_or_zero(t.x), finite_or_zero(t.y)},
                 {finite_or_zero(c.r * d[0]), finite_or_zero(c.g * d[1]), finite_or_zero(c.b * d[2]), d[3]}});
        }
        std::vector<std::uint32_t> by_kind[3];
        for (unsigned i = 0; i < m.mNumFaces; ++i) {
            const aiFace& face = m.mFaces[i];
            if (face.mNumIndices < 1 || face.mNumIndices > 3)
                continue;
            auto& indices = by_kind[face.mNumIndices - 1];
            indices.insert(indices.end(), face.mIndices, face.mIndices + face.mNumIndices);
        }
        model_.triangles += by_kind[2].size() / 3;
        for (unsigned kind = 0; kind < 3; ++kind)
            if (!by_kind[kind].empty()) {
                part.kind = static_cast<ModelPart::Kind>(kind);
                part.indices = std::move(by_kind[kind]);
                vertices_ += part.vertices.size();
                indices_ += part.indices.size();
                if (too_much()) // limits are checked before the vertices are copied
                    return;
                model_.parts.push_back(part);
            }
    }

    void material(const aiMaterial& m, ModelPart& part) {
        const auto color = [&m](const char* key, unsigned type, unsigned index, std::array<float, 4>& into) {
            aiColor4D c;
            if (m.Get(key, type, index, c) == AI_SUCCESS)
                into = {finite_or_zero(c.r), finite_or_zero(c.g), finite_or_zero(c.b), finite_or_zero(c.a)};
        };
        color(AI_MATKEY_COLOR_DIFFUSE, part.diffuse);
        color(AI_MATKEY_COLOR_SPECULAR, part.specular);
        color(AI_MATKEY_COLOR_EMISSIVE, part.emission);
        float value = 0.0f;
        if (m.Get(AI_MATKEY_SHININESS, value) == AI_SUCCESS)
            part.shininess = std::clamp(finite_or_zero(value), 0.0f, 128.0f);
        if (part.shininess <= 0.0f) // no highlight was meant; an exponent of 0 would light everything
            part.specular = {0.0f, 0.0f, 0.0f, 1.0f};
        if (m.Get(AI_MATKEY_OPACITY, value) == AI_SUCCESS)
            part.diffuse[3] = std::clamp(finite_or_zero(value), 0.0f, 1.0f);
        // Some exporters write an opacity of 0 for opaque materials. A part that is meant to be invisible
        // would not be exported.
        if (part.diffuse[3] <= 0.0f)
            part.diffuse[3] = 1.0f;
        aiString name;
        if (m.GetTexture(aiTextureType_DIFFUSE, 0, &name) == AI_SUCCESS ||
            m.GetTexture(aiTextureType_BASE_COLOR, 0, &name) == AI_SUCCESS)
            part.image = image(name.C_Str());
    }

    int image(const std::string& name) {
        if (const auto known = images_.find(name); known != images_.end())
            return known->second;
        int index = -1;
        ModelImage picture;
        if (!decode(name, picture)) {
            model_.notes.push_back("texture " + name + " cannot be read; drawn without it");
        } else if (texels_ + picture.rgba.size() / 4 > most_texels) {
            model_.notes.push_back("texture " + name + " is one too many; drawn without it");
        } else {
            texels_ += picture.rgba.size() / 4;
            index = static_cast<int>(model_.images.size());
            model_.images.push_back(std::move(picture));
        }
        return images_[name] = index;
    }

    static bool same_letters(const std::string& a, const std::string& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
            return std::tolower(x) == std::tolower(y);
        });
    }

    /// The file at `path` below `folder`, whatever the case of its letters; empty when there is none.
    static fs::path find(fs::path folder, const fs::path& path) {
        std::error_code ignored;
        for (const fs::path& step : path) {
            fs::path next = folder / step;
            if (!fs::exists(next, ignored)) {
                const auto entries = fs::directory_iterator(folder, ignored);
                const auto match = std::find_if(begin(entries), end(entries), [&step](const auto& entry) {
                    return same_letters(entry.path().filename().string(), step.string());
                });
                if (match == end(entries))
                    return {};
                next = match->path();
            }
            folder = next;
        }
        return fs::is_regular_file(folder, ignored) ? folder : fs::path{};
    }

    bool decode(const std::string& name, ModelImage& out) const {
        if (const aiTexture* t = scene_.GetEmbeddedTexture(name.c_str()))
            return read_embedded(*t, out);
        // Exporters leave Windows paths, absolute paths and odd case behind. This looks first for the path
        // itself, then for the bare name near the model.
        std::string bare = name.substr(
            name.find_first_not_of("\\/") == std::string::npos ? 0 : name.find_first_not_of("\\/"));
        std::replace(bare.begin(), bare.end(), '\\', '/');
        const fs::path leaf = fs::path(bare).filename();
        for (const fs::path& candidate : {fs::path(bare), leaf, ".." / leaf, "textures" / leaf})
            if (const fs::path file = find(folder_, candidate); !file.empty())
                if (read_picture(file.string(), largest_texture_, out).empty())
                    return true;
        return false;
    }

    /// Reads a picture within the model's file, which is in a format of pictures, or plain texels.
    bool read_embedded(const aiTexture& t, ModelImage& out) const {
        return (t.mHeight == 0 ? read_picture(t.pcData, t.mWidth, largest_texture_, out)
                               : read_texels(t.pcData, t.mWidth, t.mHeight, largest_texture_, out))
            .empty();
    }
};

bool is_finite(const ModelVertex& v) {
    return std::isfinite(v.position[0]) && std::isfinite(v.position[1]) && std::isfinite(v.position[2]);
}

/// Moves and scales the model into the unit sphere. Returns false when the model has no extent.
bool fit_to_view(Model& model) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (const ModelPart& part : model.parts)
        for (const ModelVertex& v : part.vertices)
            if (is_finite(v))
                for (int i = 0; i < 3; ++i) {
                    low[i] = std::min(low[i], static_cast<double>(v.position[i]));
                    high[i] = std::max(high[i], static_cast<double>(v.position[i]));
                }
    double radius2 = 0.0;
    for (int i = 0; i < 3; ++i)
        radius2 += (high[i] - low[i]) * (high[i] - low[i]) / 4.0;
    if (!(radius2 > 0.0) || !std::isfinite(radius2))
        return false;
    const double scale = 1.0 / std::sqrt(radius2);
    for (ModelPart& part : model.parts)
        for (ModelVertex& v : part.vertices)
            for (int i = 0; i < 3; ++i)
                v.position[i] =
                    is_finite(v)
                        ? static_cast<float>((static_cast<double>(v.position[i]) - (low[i] + high[i]) / 2.0) *
                                             scale)
                        : 0.0f;
    return true;
}

/// Reads the file, in a process of its own.
std::string read_scene(const std::string& path, int largest_texture, Model& model) {
    Assimp::Importer importer;
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, sharpest_smooth_edge);
    const aiScene* const scene = importer.ReadFile(
        path, aiProcess_Triangulate | aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices |
                  aiProcess_FindDegenerates | aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr) {
        const std::string why = importer.GetErrorString();
        if (why == "std::bad_alloc")
            throw std::bad_alloc();
        return "cannot read model '" + path + "': " + why;
    }
    model.name = fs::path(path).filename().string();
    Reader reader(*scene, path, largest_texture, model);
    reader.read();
    if (reader.too_much())
        return "model '" + path + "' has " + reader.how_much();
    return model.parts.empty()   ? "model '" + path + "' holds nothing to draw"
           : !fit_to_view(model) ? "model '" + path + "' has no extent"
                                 : "";
}

/// Lets a process of its own fill a result; `what` is "picture" or "model".
ModelResult read_apart(const char* what, const std::string& path, const ReadLimits& limits,
                       const std::function<std::string(Model&)>& read) {
    ModelResult result;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        result.error = std::string("cannot read ") + what + " '" + path +
                       "': " + (fs::is_directory(path, ignored) ? "it is a folder" : "no such file");
        return result;
    }
    const auto work = [&]() {
        ModelResult there;
        try {
            there.error = read(there.model);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& problem) {
            there.error = std::string("cannot read ") + what + " '" + path + "': " + problem.what();
        }
        if (!there.error.empty())
            there.model = {};
        return pack(there);
    };
    std::string bytes;
    std::string problem = run_confined(work, limits, bytes);
    if (problem.empty())
        problem = unpack(bytes, result);
    if (!problem.empty())
        result.error = one_line(std::string("cannot read ") + what + " '" + path + "': it " + problem);
    return result;
}

} // namespace

ImageResult load_image(const std::string& path, int largest, const ReadLimits& limits) {
    ModelResult read = read_apart("picture", path, limits, [&](Model& model) {
        const std::string problem = read_picture(path, largest, model.images.emplace_back());
        return problem.empty() ? "" : "cannot read picture '" + path + "': " + problem;
    });
    ImageResult result{{}, std::move(read.error)};
    if (result.error.empty())
        result.image = std::move(read.model.images.at(0));
    return result;
}

ModelResult load_model(const std::string& path, int largest_texture, const ReadLimits& limits) {
    return read_apart("model", path, limits,
                      [&](Model& model) { return read_scene(path, largest_texture, model); });
}

bool is_model_name(const std::string& path) {
    const std::string dot = fs::path(path).extension().string();
    return !dot.empty() && Assimp::Importer().IsExtensionSupported(dot);
}

} // namespace spangle::cli
