// What the texture attribute group saves beside the state table (GL 1.3, 6.1.12): of every unit its
// environment, the name of its binding, and the parameters of the bound object.
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

namespace {

/// What is saved of a unit: its environment, and of each kind the name and the parameters.
constexpr std::size_t unit_bytes =
    sizeof(TexEnvState) + texture_kinds * (sizeof(GLuint) + sizeof(TextureParameters));

constexpr GLenum targets[texture_kinds] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};

/// Binds the name again: an object that was deleted meanwhile is made anew, as BindTexture does.
void restore_binding(Context& context, std::size_t kind, GLuint name, const unsigned char* parameters) {
    cmd::BindTexture(context, targets[kind], name);
    TextureObject& bound = bound_texture(context, static_cast<TextureKind>(kind));
    if (bound.name != name)
        return; // no memory for a new object: the error is set, the parameters have nowhere to go
    std::memcpy(&bound.parameters, parameters, sizeof bound.parameters);
    texture_changed(context, bound);
}

} // namespace

std::size_t saved_texture_bytes() {
    return texture_units * unit_bytes;
}

void save_textures(const Context& context, void* to) {
    auto* out = static_cast<unsigned char*>(to);
    const auto put = [&out](const void* from, std::size_t bytes) {
        std::memcpy(out, from, bytes);
        out += bytes;
    };
    for (unsigned u = 0; u < texture_units; ++u) {
        put(&context.texture.unit[u].env, sizeof(TexEnvState));
        for (std::size_t kind = 0; kind < texture_kinds; ++kind) {
            const TextureObject& bound = context.texture.bound(u, static_cast<TextureKind>(kind));
            put(&bound.name, sizeof bound.name);
            put(&bound.parameters, sizeof bound.parameters);
        }
    }
}

void restore_textures(Context& context, const void* from) {
    const unsigned active = context.texture.active;
    const auto* in = static_cast<const unsigned char*>(from);
    for (unsigned u = 0; u < texture_units; ++u) {
        std::memcpy(&context.texture.unit[u].env, in, sizeof(TexEnvState));
        in += sizeof(TexEnvState);
        context.texture.active = u;
        for (std::size_t kind = 0; kind < texture_kinds; ++kind) {
            GLuint name = 0;
            std::memcpy(&name, in, sizeof name);
            in += sizeof name;
            if (texture_kind_is_there[kind])
                restore_binding(context, kind, name, in);
            in += sizeof(TextureParameters);
        }
    }
    context.texture.active = active;
}

} // namespace spangle::gl
