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
    GLuint binding_2d;
    TextureParameters parameters_2d;
};

/// Binds the name again: an object that was deleted meanwhile is made anew, as BindTexture does.
void restore_unit(Context& context, unsigned u, const SavedUnit& saved) {
    TextureUnitState& unit = context.texture.unit[u];
    unit.env = saved.env;
    context.texture.active = u;
    cmd::BindTexture(context, GL_TEXTURE_2D, saved.binding_2d);
    TextureObject& bound = context.texture.bound(u);
    if (bound.name != saved.binding_2d)
        return; // no memory for a new object: the error is set, the parameters have nowhere to go
    bound.parameters = saved.parameters_2d;
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
        const TextureObject& bound = context.texture.bound(u);
        const TextureUnitState& unit = context.texture.unit[u];
        const SavedUnit saved = {unit.env, bound.name, bound.parameters};
        std::memcpy(out, &saved, sizeof saved);
    }
}

void restore_textures(Context& context, const void* from) {
    const unsigned active = context.texture.active;
    const auto* in = static_cast<const unsigned char*>(from);
    for (unsigned u = 0; u < texture_units; ++u, in += sizeof(SavedUnit)) {
        SavedUnit saved;
        std::memcpy(&saved, in, sizeof saved);
        restore_unit(context, u, saved);
    }
    context.texture.active = active;
}

} // namespace spangle::gl
