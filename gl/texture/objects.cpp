// Texture objects: names, bindings, lifetime (GL 1.3, 3.8.11).
#include <new>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/share_group.hpp"

namespace spangle::gl {

namespace {

void free_images(Arena& arena, TextureObject& texture) {
    for (LevelImage*& image : texture.level) {
        arena.free(image);
        image = nullptr;
    }
    texture.view_valid = false;
}

/// The unit goes back to the default texture. A deleted object goes with its last binding.
void unbind(Arena& arena, TextureUnitState& unit) {
    TextureObject* texture = unit.bound_2d;
    unit.bound_2d = nullptr;
    if (texture != nullptr && --texture->bindings == 0 && texture->deleted)
        destroy_texture(arena, texture);
}

/// The object of a name, made when the name has none yet; null without memory.
TextureObject* object_of(ShareGroup& share, GLuint name) {
    void** slot = share.textures.find(name);
    if (slot != nullptr && *slot != nullptr)
        return static_cast<TextureObject*>(*slot);
    void* memory = share.arena.allocate(sizeof(TextureObject));
    if (memory == nullptr)
        return nullptr;
    if (slot == nullptr && !share.textures.insert(share.arena, name, memory)) {
        share.arena.free(memory);
        return nullptr;
    }
    if (slot != nullptr)
        *slot = memory;
    auto* texture = new (memory) TextureObject;
    texture->name = name;
    return texture;
}

void delete_name(Context& context, GLuint name) {
    auto* texture = static_cast<TextureObject*>(context.share->textures.remove(name));
    if (texture == nullptr)
        return;
    texture->deleted = true;
    ++texture->bindings; // ours, so that the loop's last unbind does not free what it still compares
    for (TextureUnitState& unit : context.texture.unit)
        if (unit.bound_2d == texture)
            unbind(context.share->arena, unit);
    if (--texture->bindings == 0)
        destroy_texture(context.share->arena, texture);
}

} // namespace

GLuint texture_binding_2d(const Context& context) {
    return context.texture.bound(context.texture.active).name;
}

void release_textures(Context& context) {
    for (TextureUnitState& unit : context.texture.unit)
        unbind(context.share->arena, unit);
    free_images(context.share->arena, context.texture.default_2d);
}

void destroy_texture(Arena& arena, void* object) {
    if (object == nullptr)
        return;
    free_images(arena, *static_cast<TextureObject*>(object));
    arena.free(object);
}

namespace cmd {

void GenTextures(Context& context, GLsizei n, GLuint* textures) {
    gen_names(context, context.share->textures, n, textures);
}

void DeleteTextures(Context& context, GLsizei n, const GLuint* textures) {
    if (n < 0 || (n > 0 && textures == nullptr))
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i)
        if (textures[i] != 0)
            delete_name(context, textures[i]);
    context.changed(dirty_fragment);
}

void BindTexture(Context& context, GLenum target, GLuint texture) {
    if (target != GL_TEXTURE_2D)
        return error(context, GL_INVALID_ENUM);
    TextureUnitState& unit = context.texture.unit[context.texture.active];
    TextureObject* object = texture == 0 ? nullptr : object_of(*context.share, texture);
    if (texture != 0 && object == nullptr)
        return error(context, GL_OUT_OF_MEMORY,
                     SPANGLE_TEXT("glBindTexture: no room in the arena for a new object"));
    if (object == unit.bound_2d)
        return;
    if (object != nullptr)
        ++object->bindings;
    unbind(context.share->arena, unit);
    unit.bound_2d = object;
    context.changed(dirty_fragment);
}

GLboolean IsTexture(Context& context, GLuint texture) {
    void** slot = texture == 0 ? nullptr : context.share->textures.find(texture);
    return slot != nullptr && *slot != nullptr ? GL_TRUE : GL_FALSE;
}

} // namespace cmd

} // namespace spangle::gl
