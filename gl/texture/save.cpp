// Saves the part of the texture attribute group that is not in the state table (GL 1.3, 6.1.12). That part is
// the environment of every unit and, for each target of a unit, the bound name and the parameters of the
// object.
#include <cstring>

#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

namespace {

/// Bytes saved for a unit: its environment, and a name and parameters for each kind of texture.
constexpr std::size_t unit_bytes =
    sizeof(TexEnvState) + texture_kinds * (sizeof(GLuint) + sizeof(TextureParameters));

/// Restores `to` from saved bytes. Returns whether it has changed.
template <class T> bool restore_saved(T& to, const unsigned char* saved) {
    if (std::memcmp(static_cast<const void*>(&to), saved, sizeof to) == 0)
        return false;
    std::memcpy(&to, saved, sizeof to);
    return true;
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

bool restore_textures(Context& context, const void* from) {
    const auto* const units = static_cast<const unsigned char*>(from);
    // Returns the address of saved name i, which belongs to kind i % texture_kinds. The parameters follow it.
    const auto binding = [units](unsigned i) {
        return units + i / texture_kinds * unit_bytes + sizeof(TexEnvState) +
               i % texture_kinds * (sizeof(GLuint) + sizeof(TextureParameters));
    };
    GLuint names[texture_bindings];
    TextureObject* objects[texture_bindings];
    for (unsigned i = 0; i < texture_bindings; ++i)
        std::memcpy(&names[i], binding(i), sizeof names[i]);
    // Objects that were deleted in the meantime are made again. This happens before any state changes,
    // because it may fail.
    if (!find_named_objects(context, names, objects))
        return false;
    for (unsigned u = 0; u < texture_units; ++u)
        if (restore_saved(context.texture.unit[u].env, units + u * unit_bytes))
            context.changed(dirty_fragment);
    for (unsigned i = 0; i < texture_bindings; ++i) {
        const auto kind = static_cast<TextureKind>(i % texture_kinds);
        if (!texture_kind_is_there[i % texture_kinds])
            continue;
        bind_object(context, context.texture.unit[i / texture_kinds].bound[index_of(existing_kind(kind))],
                    objects[i]);
        if (objects[i] == nullptr && names[i] != 0)
            continue; // the name now belongs to another kind of texture, so the parameters have no object
        TextureObject& bound = objects[i] != nullptr ? *objects[i] : context.texture.default_texture(kind);
        if (restore_saved(bound.parameters, binding(i) + sizeof(GLuint)))
            texture_changed(context, bound);
    }
    return true;
}

} // namespace spangle::gl
