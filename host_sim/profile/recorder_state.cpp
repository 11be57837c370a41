// What a recorder reads from the state of contexts, after each command.
#include "host_sim/profile/recorder.hpp"

#if SPANGLE_WATCHED

#include <algorithm>

#include <spangle/GL/gl.h>

#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"

namespace spangle::profile {

using numeric::Real;

namespace {

bool exceeds_sixteen(const Real (&color)[4]) {
    constexpr std::uint32_t sixteen = 0x41800000;
    return std::any_of(color, color + 3, [](Real c) { return (c.bits & 0x7FFFFFFF) >= sixteen; });
}

bool is_black(const Real (&color)[4]) {
    return std::all_of(color, color + 3, [](Real c) { return numeric::is_zero(c); });
}

} // namespace

void Recorder::inspect_textures(gl::Context& context) {
    const auto look = [&](const gl::TextureObject* object) {
        for (unsigned face = 0; object != nullptr && face < object->faces(); ++face)
            for (int level = 0; level < gl::texture_levels; ++level) {
                const gl::LevelImage* const image = object->image(face, level);
                if (image == nullptr || image->shape.empty())
                    continue;
                record_.texture_formats |= 1u << static_cast<unsigned>(image->shape.format);
                int levels = level + 1;
                for (unsigned side = 0; side < 3; ++side)
                    for (unsigned texels = image->shape.size_without_border(side);
                         texels > 1u << (levels - 1 - level);)
                        ++levels;
                record_.texture_levels = std::max(record_.texture_levels, levels);
            }
    };
    gl::NameTable& textures = context.share->textures;
    for (std::uint32_t i = 0; i < textures.capacity(); ++i)
        if (textures.slot(i).name != 0)
            look(static_cast<const gl::TextureObject*>(textures.slot(i).object));
    for (const gl::TextureKind kind :
         {gl::TextureKind::one, gl::TextureKind::two, gl::TextureKind::three, gl::TextureKind::cube})
        look(&context.texture.default_texture(kind));
}

/// Notes the limits that the state has reached through the commands before.
void Recorder::note_state(gl::Context& context) {
    Record& r = record_;
    if (context.drawable.surface.color != nullptr) {
        const raster::Surface surface = target(context);
        r.color_formats |= 1u << static_cast<unsigned>(surface.format);
        r.depth_formats |= 1u << static_cast<unsigned>(surface.depth_format);
        if (surface.samples != nullptr)
            r.features.insert("MULTISAMPLE");
    }
    r.modelview_stack = std::max(r.modelview_stack, context.transform.modelview.top + 1);
    r.projection_stack = std::max(r.projection_stack, context.transform.projection.top + 1);
    for (const auto& stack : context.transform.texture)
        r.texture_stack = std::max(r.texture_stack, stack.top + 1);
    r.list_nesting = std::max(r.list_nesting, static_cast<int>(context.list.depth) + 1);

    const gl::LightingState& lighting = context.lighting;
    const auto kind = [&](unsigned bit, bool used) { r.light_kinds |= used ? bit : 0u; };
    constexpr unsigned specular = 1, local = 2, sides = 4; // bits of SPANGLE_LIGHT_KINDS
    kind(local, lighting.local_viewer);
    kind(sides, lighting.two_side);
    kind(light_follows_colors, lighting.color_material);
    r.full_lighting = r.full_lighting || context.transform.normalize || context.transform.rescale_normal ||
                      lighting.color_material;
    for (const gl::Light& light : lighting.light) {
        kind(local, !numeric::is_zero(light.position[3]) || !(light.spot_cutoff == gl::no_spot_cutoff));
        r.full_lighting = r.full_lighting || exceeds_sixteen(light.diffuse);
    }
    for (const gl::Material& material : lighting.material) {
        kind(specular, !is_black(material.specular));
        r.full_lighting = r.full_lighting || exceeds_sixteen(material.diffuse);
    }
    gl::each_array(context.arrays, [&](const gl::ClientArray& array) {
        if (array.enabled && array.type - GL_BYTE < 13)
            r.array_types |= 1u << (array.type - GL_BYTE);
    });
    const auto [seen, first] = texture_ids_.try_emplace(context.share, 0);
    if (first || seen->second != context.share->texture_changes) {
        seen->second = context.share->texture_changes;
        inspect_textures(context);
    }
}

} // namespace spangle::profile

#endif
