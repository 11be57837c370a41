#include "host_sim/bake/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "host_sim/bake/vertex_cache.hpp"

namespace spangle::bake {

namespace {

using Kind = cli::ModelPart::Kind;

constexpr double fixed_one = 65536.0;

double most_of(Number number) {
    return number == Number::byte ? 127.0 : 32767.0;
}

std::int32_t nearest(double v, Number number) {
    const double most = number == Number::fixed ? 2147483647.0 : most_of(number);
    return static_cast<std::int32_t>(std::lround(std::clamp(v, -most, most)));
}

/// The largest magnitude of any component of `get(vertex)` in the whole model.
template <class Get> double largest_component(const cli::Model& model, const Get& get) {
    double most = 0.0;
    for (const cli::ModelPart& part : model.parts)
        for (const cli::ModelVertex& v : part.vertices)
            for (const float c : get(v))
                most = std::max(most, static_cast<double>(std::fabs(c)));
    return most;
}

/// The value that GL reads from a normal's component (GL 1.3, table 2.6): (2 c + 1) / (2^b - 1).
double normal_of(std::int32_t c, Number number) {
    return number == Number::fixed ? c / fixed_one : (2.0 * c + 1.0) / (2.0 * most_of(number) + 1.0);
}
std::int32_t normal_code(double v, Number number) {
    return number == Number::fixed ? nearest(v * fixed_one, number)
                                   : nearest((v * (2.0 * most_of(number) + 1.0) - 1.0) / 2.0, number);
}

std::uint8_t color_code(float v) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f));
}

class Quantizer {
  public:
    explicit Quantizer(BakedMesh& mesh) : mesh_(mesh), report_(mesh.report) {}

    BakedVertex vertex(const cli::ModelVertex& v, const BakedPart& part) const {
        BakedVertex out{};
        const MeshOptions& o = mesh_.options;
        double off = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double given = static_cast<double>(v.position[c]);
            out.position[c] = nearest(given / mesh_.position_step, o.position);
            const double d = out.position[c] * mesh_.position_step - given;
            off += d * d;
        }
        report_.position_error = std::max(report_.position_error, std::sqrt(off));
        if (has_normals(mesh_, part))
            normal(v, out);
        for (int c = 0; c < 2 && has_texcoords(part); ++c) {
            const double given = static_cast<double>(v.texcoord[c]);
            out.texcoord[c] = nearest(given / mesh_.texcoord_step, o.texcoord);
            report_.texcoord_error =
                std::max(report_.texcoord_error, std::fabs(out.texcoord[c] * mesh_.texcoord_step - given));
        }
        for (int c = 0; c < 4; ++c)
            out.color[c] = part.from->colored ? color_code(v.color[c]) : std::uint8_t{0};
        return out;
    }

  private:
    void normal(const cli::ModelVertex& v, BakedVertex& out) const {
        double dot = 0.0, given = 0.0, kept = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double n = static_cast<double>(v.normal[c]);
            out.normal[c] = normal_code(n, mesh_.options.normal);
            const double k = normal_of(out.normal[c], mesh_.options.normal);
            dot += n * k;
            given += n * n;
            kept += k * k;
        }
        if (!(given > 0.0) || !(kept > 0.0)) // a normal without a direction has no error
            return;
        const double cosine = std::clamp(dot / std::sqrt(given * kept), -1.0, 1.0);
        report_.normal_error = std::max(report_.normal_error, std::acos(cosine) * 180.0 / std::numbers::pi);
    }

    BakedMesh& mesh_;
    MeshReport& report_;
};

struct ByValue {
    static auto words(const BakedVertex& v) {
        return std::tie(v.position[0], v.position[1], v.position[2], v.normal[0], v.normal[1], v.normal[2],
                        v.texcoord[0], v.texcoord[1], v.color[0], v.color[1], v.color[2], v.color[3]);
    }
    bool operator()(const BakedVertex& a, const BakedVertex& b) const { return words(a) < words(b); }
};

/// Quantizes the vertices of a part. Vertices that become equal are merged; triangles that lose a vertex
/// cover nothing and are dropped.
void take_vertices(const Quantizer& quantizer, const cli::ModelPart& from, BakedPart& part) {
    std::map<BakedVertex, std::uint32_t, ByValue> known;
    std::vector<std::uint32_t> place;
    for (const cli::ModelVertex& v : from.vertices) {
        const BakedVertex q = quantizer.vertex(v, part);
        const auto [at, fresh] = known.try_emplace(q, static_cast<std::uint32_t>(part.vertices.size()));
        if (fresh)
            part.vertices.push_back(q);
        place.push_back(at->second);
    }
    if (from.kind != Kind::triangles) {
        for (const std::uint32_t i : from.indices)
            part.indices.push_back(place[i]);
        return;
    }
    for (std::size_t i = 0; i + 2 < from.indices.size(); i += 3) {
        const std::uint32_t a = place[from.indices[i]], b = place[from.indices[i + 1]],
                            c = place[from.indices[i + 2]];
        if (a != b && b != c && c != a)
            part.indices.insert(part.indices.end(), {a, b, c});
    }
}

void number_by_first_use(BakedPart& part) {
    const std::vector<std::uint32_t> place = first_use_order(part.indices, part.vertices.size());
    std::vector<BakedVertex> vertices(part.vertices.size());
    std::size_t used = 0;
    for (std::size_t v = 0; v < place.size(); ++v)
        if (place[v] != unused) {
            vertices[place[v]] = part.vertices[v];
            ++used;
        }
    vertices.resize(used);
    part.vertices.swap(vertices);
    for (std::uint32_t& index : part.indices)
        index = place[index];
}

/// The number of vertices that the cache processes, once vertices are numbered in the order of their first
/// use.
std::size_t renumbered_misses(IndexList indices, std::size_t vertices, unsigned cache) {
    const std::vector<std::uint32_t> place = first_use_order(indices, vertices);
    for (std::uint32_t& index : indices)
        index = place[index];
    return cache_misses(indices, cache);
}

/// The shortest strip for which the cache processes hardly more vertices than for the list (at most 5
/// percent).
IndexList best_strip(const IndexList& triangles, std::size_t vertices, const MeshOptions& options) {
    const std::size_t allowed = renumbered_misses(triangles, vertices, options.cache) * 105 / 100;
    IndexList best;
    for (std::size_t reach = 4; reach < 2 * triangles.size(); reach *= 2) {
        IndexList strip = make_strip(triangles, reach);
        if (best.empty() ||
            (strip.size() < best.size() && renumbered_misses(strip, vertices, options.cache) <= allowed))
            best.swap(strip);
    }
    return best;
}

/// The better of the given order and the computed one: grids often come in good order already.
IndexList best_list(const IndexList& given, std::size_t vertices, const MeshOptions& options) {
    IndexList ordered = order_triangles(given, vertices, options.cache);
    const auto misses = [&](const IndexList& list) {
        return renumbered_misses(list, vertices, options.cache);
    };
    return misses(ordered) < misses(given) ? ordered : given;
}

void order(BakedPart& part, const MeshOptions& options) {
    if (part.from->kind == Kind::triangles) {
        part.indices = best_list(part.indices, part.vertices.size(), options);
        IndexList strip;
        if (options.strips != Strips::never)
            strip = best_strip(part.indices, part.vertices.size(), options);
        part.strip =
            !strip.empty() && (options.strips == Strips::always || strip.size() < part.indices.size());
        if (part.strip)
            part.indices.swap(strip);
    }
    number_by_first_use(part);
}

void add_up(BakedMesh& mesh, const cli::Model& model) {
    MeshReport& r = mesh.report;
    r.triangles = model.triangles;
    for (const BakedPart& part : mesh.parts) {
        r.vertices_before += part.from->vertices.size();
        r.vertices += part.vertices.size();
        r.indices += part.indices.size();
        r.misses_before += cache_misses(part.from->indices, mesh.options.cache);
        r.misses += cache_misses(part.indices, mesh.options.cache);
        r.vertex_bytes += part.vertices.size() * vertex_bytes(mesh, part);
        r.index_bytes += part.indices.size() * index_bytes(part);
        const std::size_t floats = 3u + (has_normals(mesh, part) ? 3u : 0u) +
                                   (has_texcoords(part) ? 2u : 0u) + (part.from->colored ? 4u : 0u);
        r.float_bytes += part.from->vertices.size() * floats * 4 + part.from->indices.size() * 4;
    }
}

} // namespace

unsigned bytes_of(Number number) {
    return number == Number::fixed ? 4 : number == Number::short_integer ? 2 : 1;
}

unsigned index_bytes(const BakedPart& part) {
    return part.vertices.size() <= 256 ? 1 : part.vertices.size() <= 65536 ? 2 : 4;
}

bool has_normals(const BakedMesh& mesh, const BakedPart& part) {
    return mesh.options.with_normals && part.from->kind == Kind::triangles;
}

bool has_texcoords(const BakedPart& part) {
    return part.from->image >= 0;
}

unsigned vertex_bytes(const BakedMesh& mesh, const BakedPart& part) {
    const MeshOptions& o = mesh.options;
    unsigned bytes = 3 * bytes_of(o.position), align = bytes_of(o.position);
    if (has_normals(mesh, part)) {
        bytes += 3 * bytes_of(o.normal);
        align = std::max(align, bytes_of(o.normal));
    }
    if (has_texcoords(part)) {
        bytes += 2 * bytes_of(o.texcoord);
        align = std::max(align, bytes_of(o.texcoord));
    }
    if (part.from->colored)
        bytes += 4;
    return (bytes + align - 1) / align * align;
}

BakedMesh bake_mesh(const cli::Model& model, const MeshOptions& options) {
    BakedMesh mesh;
    mesh.options = options;
    const auto step = [](Number number, double most) {
        return number == Number::fixed ? 1.0 / fixed_one : most > 0.0 ? most / most_of(number) : 1.0;
    };
    mesh.position_step =
        step(options.position,
             largest_component(model, [](const cli::ModelVertex& v) { return std::to_array(v.position); }));
    mesh.texcoord_step =
        step(options.texcoord,
             largest_component(model, [](const cli::ModelVertex& v) { return std::to_array(v.texcoord); }));
    // GL is given the steps as floats, so errors are measured with the floats.
    const auto as_float = [](double step) {
        const auto kept = static_cast<float>(step);
        // A step too small for any float belongs to numbers that are all 0.
        return kept > 0.0f ? static_cast<double>(kept) : 1.0;
    };
    mesh.position_step = as_float(mesh.position_step);
    mesh.texcoord_step = as_float(mesh.texcoord_step);
    for (const cli::ModelPart& from : model.parts) {
        BakedPart part;
        part.from = &from;
        take_vertices(Quantizer(mesh), from, part);
        mesh.textured = mesh.textured || has_texcoords(part);
        order(part, options);
        if (!part.indices.empty())
            mesh.parts.push_back(std::move(part));
    }
    add_up(mesh, model);
    return mesh;
}

} // namespace spangle::bake
