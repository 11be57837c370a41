#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include <sys/resource.h>

#include <SDL2/SDL_image.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "host_sim/cli/model.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_triangles = 2'000'000; // beyond this no board, and no patience, follows
constexpr float sharpest_smooth_edge = 66.0f;     // degrees; cubes stay cubes where a file has no normals
constexpr rlim_t most_memory = rlim_t{2} << 30;   // of a model while it is read

// AddressSanitizer's own memory is beyond every limit.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// Box-filters an RGBA surface to powers of two no larger than `largest`.
ModelImage shrink(const SDL_Surface& s, int largest) {
    ModelImage out;
    const auto fit = [largest](int n) {
        return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::min(n, largest))));
    };
    out.width = fit(s.w);
    out.height = fit(s.h);
    out.rgba.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4);
    const auto* pixels = static_cast<const std::uint8_t*>(s.pixels);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int x0 = x * s.w / out.width, x1 = std::max(x0 + 1, (x + 1) * s.w / out.width);
            const int y0 = y * s.h / out.height, y1 = std::max(y0 + 1, (y + 1) * s.h / out.height);
            unsigned sum[4] = {};
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u)
                    for (int c = 0; c < 4; ++c)
                        sum[c] += pixels[v * s.pitch + 4 * u + c];
            const auto n = static_cast<unsigned>((x1 - x0) * (y1 - y0));
            // GL's t runs upwards, image files downwards.
            std::uint8_t* to =
                &out.rgba[static_cast<std::size_t>(((out.height - 1 - y) * out.width + x) * 4)];
            for (int c = 0; c < 4; ++c)
                to[c] = static_cast<std::uint8_t>((sum[c] + n / 2) / n);
            out.translucent = out.translucent || to[3] != 255;
        }
    return out;
}

/// What was decoded, in bytes of RGBA; takes the surface. False: there is nothing to see.
bool take(SDL_Surface* raw, int largest, ModelImage& out) {
    if (raw == nullptr)
        return false;
    SDL_Surface* const rgba = SDL_ConvertSurfaceFormat(raw, SDL_PIXELFORMAT_RGBA32, 0);
    SDL_FreeSurface(raw);
    const bool seen = rgba != nullptr && rgba->w > 0 && rgba->h > 0;
    if (seen)
        out = shrink(*rgba, largest);
    SDL_FreeSurface(rgba);
    return seen;
}

class Reader {
  public:
    Reader(const aiScene& scene, const fs::path& file, int largest_texture, Model& model)
        : scene_(scene), folder_(file.parent_path()), largest_texture_(largest_texture), model_(model) {}

    void read() { node(*scene_.mRootNode, aiMatrix4x4()); }

  private:
    const aiScene& scene_;
    fs::path folder_;
    int largest_texture_;
    Model& model_;
    std::map<std::string, int> images_;

    void node(const aiNode& n, const aiMatrix4x4& parent) {
        const aiMatrix4x4 world = parent * n.mTransformation;
        // A few nodes can repeat a mesh without end: stop as soon as there is too much.
        for (unsigned i = 0; i < n.mNumMeshes && model_.triangles <= most_triangles; ++i)
            mesh(*scene_.mMeshes[n.mMeshes[i]], world);
        for (unsigned i = 0; i < n.mNumChildren; ++i)
            node(*n.mChildren[i], world);
    }

    /// Has colours of its own. Old exporters write an empty, black layer that was never shown.
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
                {{p.x, p.y, p.z}, {n.x, n.y, n.z}, {t.x, t.y}, {c.r * d[0], c.g * d[1], c.b * d[2], d[3]}});
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
                model_.parts.push_back(part);
            }
    }

    void material(const aiMaterial& m, ModelPart& part) {
        const auto color = [&m](const char* key, unsigned type, unsigned index, std::array<float, 4>& into) {
            aiColor4D c;
            if (m.Get(key, type, index, c) == AI_SUCCESS)
                into = {c.r, c.g, c.b, c.a};
        };
        color(AI_MATKEY_COLOR_DIFFUSE, part.diffuse);
        color(AI_MATKEY_COLOR_SPECULAR, part.specular);
        color(AI_MATKEY_COLOR_EMISSIVE, part.emission);
        float value = 0.0f;
        if (m.Get(AI_MATKEY_SHININESS, value) == AI_SUCCESS)
            part.shininess = std::clamp(value, 0.0f, 128.0f);
        if (part.shininess <= 0.0f) // no highlight was meant; an exponent of 0 would light everything
            part.specular = {0.0f, 0.0f, 0.0f, 1.0f};
        if (m.Get(AI_MATKEY_OPACITY, value) == AI_SUCCESS)
            part.diffuse[3] = std::clamp(value, 0.0f, 1.0f);
        if (part.diffuse[3] <= 0.0f) // exporters write 0 for opaque; nobody models what cannot be seen
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
        if (ModelImage picture; take(decode(name), largest_texture_, picture)) {
            index = static_cast<int>(model_.images.size());
            model_.images.push_back(std::move(picture));
        }
        if (index < 0)
            model_.notes.push_back("texture " + name + " cannot be read; drawn without it");
        return images_[name] = index;
    }

    static bool same_letters(const std::string& a, const std::string& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
            return std::tolower(x) == std::tolower(y);
        });
    }

    /// The file at `path` from `folder` on whatever the case of its letters; empty when there is none.
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

    SDL_Surface* decode(const std::string& name) const {
        if (const aiTexture* t = scene_.GetEmbeddedTexture(name.c_str())) {
            if (t->mHeight == 0)
                return IMG_Load_RW(SDL_RWFromConstMem(t->pcData, static_cast<int>(t->mWidth)), 1);
            return SDL_CreateRGBSurfaceWithFormatFrom(
                t->pcData, static_cast<int>(t->mWidth), static_cast<int>(t->mHeight), 32,
                static_cast<int>(t->mWidth * 4), SDL_PIXELFORMAT_BGRA32);
        }
        // Exporters leave Windows paths, absolute paths and odd case behind: look for what they name, then
        // for the bare name near the model.
        std::string bare = name.substr(
            name.find_first_not_of("\\/") == std::string::npos ? 0 : name.find_first_not_of("\\/"));
        std::replace(bare.begin(), bare.end(), '\\', '/');
        const fs::path leaf = fs::path(bare).filename();
        for (const fs::path& candidate : {fs::path(bare), leaf, ".." / leaf, "textures" / leaf})
            if (const fs::path file = find(folder_, candidate); !file.empty())
                if (SDL_Surface* s = IMG_Load(file.c_str()))
                    return s;
        return nullptr;
    }
};

bool finite(const ModelVertex& v) {
    return std::isfinite(v.position[0]) && std::isfinite(v.position[1]) && std::isfinite(v.position[2]);
}

/// Moves and scales the model into the unit sphere; false when it has no extent at all.
bool fit(Model& model) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (const ModelPart& part : model.parts)
        for (const ModelVertex& v : part.vertices)
            if (finite(v))
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
                    finite(v) ? static_cast<float>(
                                    (static_cast<double>(v.position[i]) - (low[i] + high[i]) / 2.0) * scale)
                              : 0.0f;
    return true;
}

/// A few bytes of a broken file can ask for all memory there is, and the system would end the program for it.
class MemoryLimit {
  public:
    MemoryLimit() {
        getrlimit(RLIMIT_DATA, &before_);
        rlimit during = before_;
        during.rlim_cur = std::min<rlim_t>(before_.rlim_cur, most_memory);
        if (!sanitized)
            setrlimit(RLIMIT_DATA, &during);
    }
    ~MemoryLimit() { setrlimit(RLIMIT_DATA, &before_); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

  private:
    rlimit before_{};
};

} // namespace

ImageResult load_image(const std::string& path, int largest) {
    ImageResult result;
    std::error_code ignored;
    const MemoryLimit limit;
    if (!fs::is_regular_file(path, ignored) || !take(IMG_Load(path.c_str()), largest, result.image))
        result.error = "cannot read picture '" + path + "'";
    return result;
}

ModelResult load_model(const std::string& path, int largest_texture) {
    ModelResult result;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        result.error = "cannot read model '" + path +
                       "': " + (fs::is_directory(path, ignored) ? "it is a folder" : "no such file");
        return result;
    }
    Assimp::Importer importer;
    const aiScene* scene = nullptr;
    const MemoryLimit limit;
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, sharpest_smooth_edge);
    try {
        scene = importer.ReadFile(path, aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                                            aiProcess_JoinIdenticalVertices | aiProcess_FindDegenerates |
                                            aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    } catch (const std::exception& problem) {
        result.error = "cannot read model '" + path + "': " + problem.what();
        return result;
    }
    if (scene == nullptr || scene->mRootNode == nullptr) {
        const std::string why = importer.GetErrorString();
        result.error = "cannot read model '" + path +
                       "': " + (why == "std::bad_alloc" ? "it asks for more than 2 GiB of memory" : why);
        return result;
    }
    result.model.name = fs::path(path).filename().string();
    Reader(*scene, path, largest_texture, result.model).read();
    if (result.model.parts.empty())
        result.error = "model '" + path + "' holds nothing to draw";
    else if (result.model.triangles > most_triangles)
        result.error = "model '" + path + "' has " + std::to_string(result.model.triangles) +
                       " triangles; at most 2000000 are drawn";
    else if (!fit(result.model))
        result.error = "model '" + path + "' has no extent";
    return result;
}

} // namespace spangle::cli
