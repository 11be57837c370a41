#include "host_sim/cli/bake.hpp"

#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host_sim/bake/header.hpp"
#include "host_sim/cli/model.hpp"
#include "host_sim/cli/say.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

bake::Number number_of(const std::string& name) {
    return name == "fixed"   ? bake::Number::fixed
           : name == "short" ? bake::Number::short_integer
                             : bake::Number::byte;
}

bake::MeshOptions mesh_options(const BakeOptions& o) {
    bake::MeshOptions out;
    out.position = number_of(o.positions);
    out.normal = number_of(o.normals);
    out.texcoord = number_of(o.texcoords);
    out.with_normals = !o.no_normals;
    out.strips = o.strips == "smaller"  ? bake::Strips::smaller
                 : o.strips == "always" ? bake::Strips::always
                                        : bake::Strips::never;
    out.cache = o.cache;
    return out;
}

/// The command as the header names it: without folders, so that it is the same on every machine, and without
/// options that have their usual value.
std::string command_of(const BakeOptions& o) {
    const BakeOptions usual;
    // Names of files may hold line breaks, but in the header this is a comment of one line.
    std::string out = fmt::format("spangle bake {} -o {}", one_line(fs::path(o.input).filename().string()),
                                  one_line(fs::path(o.output).filename().string()));
    const auto add = [&out](const char* option, const auto& value, const auto& normally) {
        if (value != normally)
            out += fmt::format(" {} {}", option, value);
    };
    add("--name", o.name, bake::identifier_of(fs::path(o.output).stem().string()));
    add("--texture", o.texture_format, usual.texture_format);
    add("--texture-size", o.texture_size, usual.texture_size);
    add("--positions", o.positions, usual.positions);
    add("--normals", o.normals, usual.normals);
    add("--texcoords", o.texcoords, usual.texcoords);
    add("--strips", o.strips, usual.strips);
    add("--cache", o.cache, usual.cache);
    out += o.no_mipmaps ? " --no-mipmaps" : "";
    out += o.no_normals ? " --no-normals" : "";
    return out;
}

struct Baked {
    std::vector<std::string> notes;
    bool is_model = false;
    Model model;
    bake::BakedMesh mesh;
    std::vector<bake::BakedTexture> textures;
    std::vector<bool> translucent;
};

std::string read_input(const BakeOptions& o, Baked& out) {
    ImageResult picture = load_image(o.input, o.texture_size);
    if (picture.error.empty()) {
        out.model.images.push_back(std::move(picture.image));
        return "";
    }
    ModelResult model = load_model(o.input, o.texture_size);
    if (!model.error.empty())
        return is_model_name(o.input) ? model.error : picture.error;
    out.is_model = true;
    out.model = std::move(model.model);
    return "";
}

std::string bake_all(const BakeOptions& o, Baked& out) {
    if (std::string problem = read_input(o, out); !problem.empty())
        return problem;
    bake::TextureOptions texture;
    texture.format = bake::find_format(o.texture_format);
    texture.mipmaps = !o.no_mipmaps;
    for (const ModelImage& image : out.model.images) {
        out.textures.push_back(bake::bake_texture(image, texture));
        out.translucent.push_back(image.translucent);
    }
    if (out.is_model)
        out.mesh = bake::bake_mesh(out.model, mesh_options(o));
    return out.is_model && out.mesh.parts.empty()
               ? fmt::format("nothing of '{}' is left: with {} positions every triangle has lost a corner",
                             o.input, o.positions)
               : "";
}

nlohmann::ordered_json to_json(const Baked& b) {
    nlohmann::ordered_json out;
    const bake::MeshReport& r = b.mesh.report;
    if (b.is_model)
        out["mesh"] = {{"parts", b.mesh.parts.size()},
                       {"triangles", r.triangles},
                       {"vertices", r.vertices},
                       {"vertices_before", r.vertices_before},
                       {"indices", r.indices},
                       {"vertex_bytes", r.vertex_bytes},
                       {"index_bytes", r.index_bytes},
                       {"float_bytes", r.float_bytes},
                       {"cache_misses", r.misses},
                       {"cache_misses_before", r.misses_before},
                       {"position_error", r.position_error},
                       {"normal_error_degrees", r.normal_error},
                       {"texcoord_error", r.texcoord_error}};
    for (const bake::BakedTexture& t : b.textures)
        out["textures"].push_back({{"format", t.format->name},
                                   {"width", t.levels[0].width},
                                   {"height", t.levels[0].height},
                                   {"levels", t.chain},
                                   {"bytes", t.bytes()},
                                   {"psnr_db", t.psnr_db}});
    return out;
}

std::string to_table(const Baked& b, unsigned cache) {
    std::string out;
    const bake::MeshReport& r = b.mesh.report;
    if (b.is_model)
        out +=
            fmt::format("  mesh        {:>10} triangles  {:>10} vertices ({} in the file)   {} part{}\n"
                        "  flash       {:>10} bytes of vertices  {:>8} of indices ({} as floats)\n"
                        "  vertices    {:>10} processed in one drawing ({} as in the file), cache of {}\n"
                        "  error       {:>10.2e} of the radius at most; normals {:.2f} degrees; texture "
                        "coordinates {:.2e}\n",
                        r.triangles, r.vertices, r.vertices_before, b.mesh.parts.size(),
                        b.mesh.parts.size() == 1 ? "" : "s", r.vertex_bytes, r.index_bytes, r.float_bytes,
                        r.misses, r.misses_before, cache, r.position_error, r.normal_error, r.texcoord_error);
    for (const bake::BakedTexture& t : b.textures)
        out +=
            fmt::format("  texture     {:>10} bytes, {} {}x{}, {} level{}, {}\n", t.bytes(), t.format->name,
                        t.levels[0].width, t.levels[0].height, t.chain, t.chain == 1 ? "" : "s",
                        t.psnr_db >= 99.0 ? "exact" : fmt::format("PSNR {:.1f} dB", t.psnr_db));
    return out;
}

std::vector<std::string> texture_format_names() {
    std::vector<std::string> names{"auto"};
    for (const bake::TextureFormat& format : bake::texture_formats())
        names.emplace_back(format.name);
    return names;
}

} // namespace

CLI::App* add_bake(CLI::App& app, BakeOptions& o) {
    CLI::App* const bake = app.add_subcommand("bake", "write a model or a picture as constants for flash");
    bake->description(
        "Writes a model (any format libassimp reads) with its textures, or a picture, as a C++ header of\n"
        "constexpr arrays that GL draws from where they lie: no loading, no RAM. <spangle/baked.hpp> has "
        "the\n"
        "calls: load(texture), point_arrays(part), draw(part).");
    bake->add_option("input", o.input, "a model or a picture")->required();
    bake->add_option("-o,--output", o.output, "the header to write")->required();
    bake->add_option("--name", o.name, "namespace inside of spangle::baked; else the name of the header");
    const auto choice = [bake](const char* option, std::string& value, const char* text,
                               std::vector<std::string> values) {
        bake->add_option(option, value, text)->check(CLI::IsMember(std::move(values)))->capture_default_str();
    };
    choice("--positions", o.positions, "what a coordinate is kept as: 4, 2 or 1 bytes",
           {"fixed", "short", "byte"});
    choice("--normals", o.normals, "the same of normals", {"fixed", "short", "byte"});
    choice("--texcoords", o.texcoords, "the same of texture coordinates", {"fixed", "short", "byte"});
    bake->add_flag("--no-normals", o.no_normals, "for models that are not lit");
    choice("--strips", o.strips, "one strip of a part's triangles", {"smaller", "always", "never"});
    bake->add_option("--cache", o.cache, "vertices that the library keeps (SPANGLE_VERTEX_CACHE)")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    choice("--texture", o.texture_format, "texels; auto: rgb565, or rgba4444 where the picture has alpha",
           texture_format_names());
    bake->add_option("--texture-size", o.texture_size,
                     "longest side of a texture; sides become powers of two")
        ->check(CLI::Range(1, 2048))
        ->capture_default_str();
    bake->add_flag("--no-mipmaps", o.no_mipmaps, "only the largest level");
    bake->add_flag("--json", o.json, "print the figures as one JSON object");
    return bake;
}

int bake(const BakeOptions& options) {
    BakeOptions o = options;
    o.name = bake::identifier_of(o.name.empty() ? fs::path(o.output).stem().string() : o.name);
    if (o.name.empty())
        return refuse(fmt::format("'{}' gives no name for a namespace; use --name", options.output));
    sim::Output header;
    if (std::string problem = open(header, "--output", o.output); !problem.empty())
        return refuse(problem);
    if (o.json && !claiming_option().empty())
        return refuse("--json prints on standard output, which --output takes; name a file for the header");
    Baked baked;
    if (std::string problem = bake_all(o, baked); !problem.empty())
        return refuse(problem);
    header.write(bake::write_header({o.name, command_of(o), baked.is_model ? &baked.mesh : nullptr,
                                     &baked.textures, &baked.translucent}));
    if (std::string problem = header.commit(); !problem.empty())
        return refuse(problem, not_done);
    for (const std::string& note : baked.model.notes)
        tell(note + "\n");
    if (o.json)
        print("{}\n", to_json(baked).dump());
    else
        print("{}: namespace spangle::baked::{}\n{}", o.output, o.name, to_table(baked, o.cache));
    return 0;
}

} // namespace spangle::cli
