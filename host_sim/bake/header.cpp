#include "host_sim/bake/header.hpp"

#include <cctype>

#include <fmt/format.h>

namespace spangle::bake {

namespace {

using Kind = cli::ModelPart::Kind;

constexpr std::size_t widest = 116;

/// Writes values into rows of text, each followed by a comma.
std::string list_of(const std::vector<std::string>& values) {
    std::string out, line = "   ";
    for (const std::string& value : values) {
        if (line.size() + value.size() + 2 > widest) {
            out += line + "\n";
            line = "   ";
        }
        line += " " + value + ",";
    }
    return out + line + "\n";
}

template <class T> std::string number_list(const T* first, std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i)
        out += fmt::format("{}{}", i != 0 ? ", " : "", first[i]);
    return "{" + out + "}";
}

const char* type_of(Number number) {
    constexpr const char* names[] = {"GLfixed", "GLshort", "GLbyte"};
    return names[static_cast<unsigned>(number)];
}
const char* token_of(Number number) {
    constexpr const char* names[] = {"GL_FIXED", "GL_SHORT", "GL_BYTE"};
    return names[static_cast<unsigned>(number)];
}

/// A float as text that C++ reads back to the bit.
std::string real(double v) {
    std::string text = fmt::format("{}", static_cast<float>(v));
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text + "f";
}
std::string reals(const std::array<float, 4>& v) {
    return fmt::format("{{{}, {}, {}, {}}}", real(static_cast<double>(v[0])), real(static_cast<double>(v[1])),
                       real(static_cast<double>(v[2])), real(static_cast<double>(v[3])));
}

/// The texels of a level as an array of bytes. Texels of 16 bits make an array of words, which is aligned
/// whatever the linker does.
std::string texels(const std::string& name, const TextureFormat& format, const BakedLevel& level) {
    std::vector<std::string> values;
    const bool words = format.kind == TexelKind::packed && format.texel_bytes == 2;
    for (std::size_t i = 0; i < level.bytes.size(); i += words ? 2 : 1)
        values.push_back(words ? fmt::format("0x{:04X}", level.bytes[i] | level.bytes[i + 1] << 8)
                               : fmt::format("{}", level.bytes[i]));
    return fmt::format("{}inline constexpr {} {}[] = {{\n{}}};\n", words ? "" : "alignas(4) ",
                       words ? "GLushort" : "GLubyte", name, list_of(values));
}

std::string texture_arrays(const BakedTexture& texture, std::size_t n) {
    std::string out, levels;
    for (std::size_t l = 0; l < texture.levels.size(); ++l) {
        const std::string name = fmt::format("texture{}_level{}", n, l);
        const BakedLevel& level = texture.levels[l];
        out += texels(name, *texture.format, level);
        levels +=
            fmt::format("    {{{}, {}, {}, {}}},\n", level.width, level.height, level.bytes.size(), name);
    }
    return out + fmt::format("inline constexpr Level texture{}_levels[] = {{\n{}}};\n", n, levels);
}

std::string texture_entry(const BakedTexture& texture, bool translucent, std::size_t n) {
    const TextureFormat& f = *texture.format;
    const int first = f.kind == TexelKind::palette ? 1 - texture.chain : 0;
    return fmt::format("    {{{}, {}, {}, {}, {}, texture{}_levels, {}, {}}},\n", f.internal_format,
                       f.format != nullptr ? f.format : "0", f.type != nullptr ? f.type : "0", first,
                       texture.levels.size(), n, texture.chain > 1, translucent);
}

class MeshText {
  public:
    explicit MeshText(const BakedMesh& mesh) : mesh_(mesh) {}

    std::string run() {
        std::string arrays, entries;
        for (std::size_t n = 0; n < mesh_.parts.size(); ++n) {
            arrays += vertices(mesh_.parts[n], n) + indices(mesh_.parts[n], n);
            entries += part_entry(mesh_.parts[n], n);
        }
        const auto scale = [](Number number, double step) {
            return number == Number::fixed ? "1.0f" : real(step);
        };
        return arrays +
               fmt::format("inline constexpr Part parts[] = {{\n{}}};\n"
                           "inline constexpr Mesh mesh{{{}, {}, {}, parts}};\n",
                           entries, scale(mesh_.options.position, mesh_.position_step),
                           mesh_.textured ? scale(mesh_.options.texcoord, mesh_.texcoord_step) : "1.0f",
                           mesh_.parts.size());
    }

  private:
    std::string vertices(const BakedPart& part, std::size_t n) const {
        const MeshOptions& o = mesh_.options;
        const bool normals = has_normals(mesh_, part), texcoords = has_texcoords(part),
                   colors = part.from->colored;
        std::string members = fmt::format("    {} position[3];\n", type_of(o.position));
        if (normals)
            members += fmt::format("    {} normal[3];\n", type_of(o.normal));
        if (colors)
            members += "    GLubyte color[4];\n";
        if (texcoords)
            members += fmt::format("    {} texcoord[2];\n", type_of(o.texcoord));
        std::vector<std::string> values;
        for (const BakedVertex& v : part.vertices) {
            std::string value = "{" + number_list(v.position, 3);
            value += normals ? ", " + number_list(v.normal, 3) : "";
            value += colors ? ", " + number_list(v.color, 4) : "";
            value += texcoords ? ", " + number_list(v.texcoord, 2) : "";
            values.push_back(value + "}");
        }
        return fmt::format(
            "struct Vertex{0} {{\n{1}}};\ninline constexpr Vertex{0} vertices{0}[] = {{\n{2}}};\n", n,
            members, list_of(values));
    }

    static const char* index_type(const BakedPart& part) {
        return index_bytes(part) == 1 ? "GLubyte" : index_bytes(part) == 2 ? "GLushort" : "GLuint";
    }
    static const char* index_token(const BakedPart& part) {
        return index_bytes(part) == 1   ? "GL_UNSIGNED_BYTE"
               : index_bytes(part) == 2 ? "GL_UNSIGNED_SHORT"
                                        : "GL_UNSIGNED_INT";
    }

    static std::string indices(const BakedPart& part, std::size_t n) {
        std::vector<std::string> values;
        for (const std::uint32_t index : part.indices)
            values.push_back(std::to_string(index));
        return fmt::format("inline constexpr {} indices{}[] = {{\n{}}};\n", index_type(part), n,
                           list_of(values));
    }

    static const char* mode(const BakedPart& part) {
        return part.from->kind == Kind::points  ? "GL_POINTS"
               : part.from->kind == Kind::lines ? "GL_LINES"
               : part.strip                     ? "GL_TRIANGLE_STRIP"
                                                : "GL_TRIANGLES";
    }

    std::string part_entry(const BakedPart& part, std::size_t n) const {
        const auto array = [n](bool has, const char* token, const char* member) {
            return has ? fmt::format("{{{}, vertices{}[0].{}}}", token, n, member)
                       : std::string("{0, nullptr}");
        };
        const MeshOptions& o = mesh_.options;
        const cli::ModelPart& from = *part.from;
        return fmt::format("    {{{}, {}, {}, indices{}, sizeof(Vertex{}),\n     {}, {}, {}, {},\n     {}, "
                           "{}, {}, {}, {}}},\n",
                           mode(part), part.indices.size(), index_token(part), n, n,
                           array(true, token_of(o.position), "position"),
                           array(has_normals(mesh_, part), token_of(o.normal), "normal"),
                           array(has_texcoords(part), token_of(o.texcoord), "texcoord"),
                           array(from.colored, "GL_UNSIGNED_BYTE", "color"), reals(from.diffuse),
                           reals(from.specular), reals(from.emission),
                           real(static_cast<double>(from.shininess)),
                           from.image >= 0 ? fmt::format("&textures[{}]", from.image) : "nullptr");
    }

    const BakedMesh& mesh_;
};

} // namespace

std::string write_header(const HeaderInput& input) {
    std::string out = fmt::format(
        "// clang-format off\n// Written by `{}`: change what it reads, not this.\n#pragma once\n\n"
        "#include <spangle/baked.hpp>\n\nnamespace spangle::baked::{} {{\n\n",
        input.command, input.name);
    std::string entries;
    for (std::size_t n = 0; n < input.textures->size(); ++n) {
        out += texture_arrays((*input.textures)[n], n);
        entries += texture_entry((*input.textures)[n], (*input.translucent)[n], n);
    }
    if (!entries.empty())
        out += "inline constexpr Texture textures[] = {\n" + entries + "};\n";
    if (input.mesh != nullptr)
        out += MeshText(*input.mesh).run();
    return out + fmt::format("\n}} // namespace spangle::baked::{}\n", input.name);
}

std::string identifier_of(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool kept = c == '_' || (std::isalnum(static_cast<unsigned char>(c)) != 0);
        if (kept || (!out.empty() && out.back() != '_'))
            out += kept ? c : '_';
    }
    while (!out.empty() && out.back() == '_')
        out.pop_back();
    return !out.empty() && std::isdigit(static_cast<unsigned char>(out[0])) != 0 ? "_" + out : out;
}

} // namespace spangle::bake
