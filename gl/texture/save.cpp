// What the texture attribute group saves beside the state table (GL 1.3, 6.1.12): of every unit its
// environment, the name of its binding, and the parameters of the bound object.
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/share_group.hpp"

namespace spangle::gl {

namespace {

struct SavedUnit {
    TexEnvState env;
    GLuint binding[texture_kinds];
    TextureParameters parameters[texture_kinds];
};

constexpr GLenum targets[texture_kinds] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
constexpr bool present[texture_kinds] = {SPANGLE_FEATURE_TEXTURE_1D != 0, true,
                                         SPANGLE_FEATURE_TEXTURE_3D != 0,
                                         SPANGLE_FEATURE_TEXTURE_CUBE_MAP != 0};

/// Binds the name again: an object that was deleted meanwhile is made anew, as BindTexture does.
void restore_binding(Context& context, std::size_t kind, const SavedUnit& saved) {
    cmd::BindTexture(context, targets[kind], saved.binding[kind]);
    TextureObject& bound =
        context.texture.bound(context.texture.active_unit(), static_cast<TextureKind>(kind));
    if (bound.name != saved.binding[kind])
        return; // no memory for a new object: the error is set, the parameters have nowhere to go
    bound.parameters = saved.parameters[kind];
    bound.view_valid = false;
    ++context.share->texture_changes;
}

} // namespace

std::size_t saved_texture_bytes() {
    return texture_units * sizeof(SavedUnit);
}

void save_textures(const Context& context, void* to) {
    auto* out = static_cast<unsigned char*>(to);
    for (unsigned u = 0; u < texture_units; ++u, out += sizeof(SavedUnit)) {
        SavedUnit saved{context.texture.unit[u].env, {}, {}};
        for (std::size_t kind = 0; kind < texture_kinds; ++kind) {
            const TextureObject& bound = context.texture.bound(u, static_cast<TextureKind>(kind));
            saved.binding[kind] = bound.name;
            saved.parameters[kind] = bound.parameters;
        }
        std::memcpy(out, &saved, sizeof saved);
    }
}

void restore_textures(Context& context, const void* from) {
    const unsigned active = context.texture.active;
    const auto* in = static_cast<const unsigned char*>(from);
    for (unsigned u = 0; u < texture_units; ++u, in += sizeof(SavedUnit)) {
        SavedUnit saved;
        std::memcpy(&saved, in, sizeof saved);
        context.texture.unit[u].env = saved.env;
        context.texture.active = u;
        for (std::size_t kind = 0; kind < texture_kinds; ++kind)
            if (present[kind])
                restore_binding(context, kind, saved);
    }
    context.texture.active = active;
}

} // namespace spangle::gl
