// Names, bindings and lifetime of texture objects (GL 1.3, 3.8.11).
#include <cstring>
#include <new>
#include <type_traits>

#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/level_image.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

namespace {

void free_images(ShareGroup& share, TextureObject& texture) {
    for (unsigned face = 0; face < texture.faces(); ++face)
        for (GLint l = 0; l < texture_levels; ++l) {
            discard_image(share, texture.image(face, l));
            texture.image(face, l) = nullptr;
        }
    texture.view_valid = false;
}

/// Binds the default texture in place of an object. An object that was deleted is freed when its last binding
/// ends.
void unbind_texture(ShareGroup& share, TextureObject*& bound) {
    TextureObject* const texture = bound;
    bound = nullptr;
    if (texture != nullptr && --texture->bindings == 0 && texture->deleted)
        destroy_texture(share, texture);
}

TextureObject* make_object(Arena& arena, TextureKind kind) {
    // A copy of a texture object's bytes is therefore a texture object.
    static_assert(std::is_trivially_copyable_v<CubeTexture>);
    const std::size_t bytes =
        existing_kind(kind) == TextureKind::cube ? sizeof(CubeTexture) : sizeof(TextureObject);
    void* const memory = arena.allocate(bytes);
    if (memory == nullptr)
        return nullptr;
    // All other members begin as 0; derived members are not read before they are computed.
    auto* const texture = std::launder(static_cast<TextureObject*>(std::memset(memory, 0, bytes)));
    texture->kind = kind;
    static constexpr TextureParameters initial;
    std::memcpy(&texture->parameters, &initial, sizeof initial);
    return texture;
}

/// Returns the object of a name, which is made if the name has none yet. Returns null if the arena is full.
TextureObject* object_of(ShareGroup& share, GLuint name, TextureKind kind) {
    void** slot = share.textures.find(name);
    if (slot != nullptr && *slot != nullptr)
        return static_cast<TextureObject*>(*slot);
    TextureObject* const texture = make_object(share.arena, kind);
    if (texture == nullptr)
        return nullptr;
    if (slot == nullptr && !share.textures.insert(share.arena, name, texture)) {
        share.arena.free(texture);
        return nullptr;
    }
    if (slot != nullptr)
        *slot = texture;
    texture->name = name;
    return texture;
}

void delete_name(Context& context, GLuint name) {
    auto* texture = static_cast<TextureObject*>(context.share->textures.remove(name));
    if (texture == nullptr)
        return;
    texture->deleted = true;
    // The binding keeps the object alive until the loop has compared it for the last time.
    ++texture->bindings;
    for (TextureUnitState& unit : context.texture.unit)
        if (TextureObject*& bound = unit.bound[index_of(texture->kind)]; bound == texture)
            unbind_texture(*context.share, bound);
    if (--texture->bindings == 0)
        destroy_texture(*context.share, texture);
}

/// Undoes object_of() for an object that it has just made. `reserved` is true if GenTextures had reserved the
/// name before.
void unmake(ShareGroup& share, TextureObject* texture, bool reserved) {
    if (reserved)
        *share.textures.find(texture->name) = nullptr;
    else
        share.textures.remove(texture->name);
    share.arena.free(texture);
}

} // namespace

bool find_named_objects(Context& context, const GLuint (&names)[texture_bindings],
                        TextureObject* (&found)[texture_bindings]) {
    ShareGroup& share = *context.share;
    std::uint32_t made = 0, reserved = 0;
    for (unsigned i = 0; i < texture_bindings; ++i) {
        const auto kind = static_cast<TextureKind>(i % texture_kinds);
        found[i] = nullptr;
        if (names[i] == 0 || !texture_kind_is_there[i % texture_kinds])
            continue;
        void** const slot = share.textures.find(names[i]);
        if (slot == nullptr || *slot == nullptr) {
            reserved |= slot != nullptr ? 1u << i : 0;
            found[i] = object_of(share, names[i], kind);
            if (found[i] == nullptr) {
                while (i-- > 0)
                    if ((made >> i & 1) != 0)
                        unmake(share, found[i], (reserved >> i & 1) != 0);
                return false;
            }
            made |= 1u << i;
        } else if (auto* const texture = static_cast<TextureObject*>(*slot);
                   existing_kind(texture->kind) == kind) {
            found[i] = texture;
        }
    }
    return true;
}

void bind_object(Context& context, TextureObject*& bound, TextureObject* object) {
    if (object == bound)
        return;
    if (object != nullptr)
        ++object->bindings;
    unbind_texture(*context.share, bound);
    bound = object;
    context.changed(dirty_fragment);
}

GLuint texture_binding(const Context& context, TextureKind kind) {
    return context.texture.bound(context.texture.active_unit(), kind).name;
}

void release_textures(Context& context) {
    for (TextureUnitState& unit : context.texture.unit)
        for (TextureObject*& bound : unit.bound)
            unbind_texture(*context.share, bound);
    for (std::size_t kind = 0; kind < texture_kinds; ++kind)
        free_images(*context.share, context.texture.default_texture(static_cast<TextureKind>(kind)));
}

void destroy_texture(ShareGroup& share, void* object) {
    if (object == nullptr)
        return;
    free_images(share, *static_cast<TextureObject*>(object));
    share.arena.free(object);
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
    TextureKind kind;
    if (!find_texture_target(context, target, kind))
        return;
    TextureObject*& bound =
        context.texture.unit[context.texture.active_unit()].bound[index_of(existing_kind(kind))];
    TextureObject* object = texture == 0 ? nullptr : object_of(*context.share, texture, kind);
    if (texture != 0 && object == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for a new object"));
    if (object != nullptr && existing_kind(object->kind) != existing_kind(kind))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("the texture was bound to another target before"));
    bind_object(context, bound, object);
}

GLboolean IsTexture(Context& context, GLuint texture) {
    void** slot = texture == 0 ? nullptr : context.share->textures.find(texture);
    return slot != nullptr && *slot != nullptr ? GL_TRUE : GL_FALSE;
}

GLboolean AreTexturesResident(Context& context, GLsizei n, const GLuint* textures, GLboolean* residences) {
    if (n < 0 || (n > 0 && (textures == nullptr || residences == nullptr))) {
        error(context, GL_INVALID_VALUE);
        return GL_FALSE;
    }
    for (GLsizei i = 0; i < n; ++i)
        if (IsTexture(context, textures[i]) == GL_FALSE) {
            error(context, GL_INVALID_VALUE, SPANGLE_TEXT("textures has a name that is no texture"));
            return GL_FALSE;
        }
    return GL_TRUE; // all textures are resident, and `residences` is not written then (GL 1.3, 3.8.12)
}

void PrioritizeTextures(Context& context, GLsizei n, const GLuint* textures, const GLclampf* priorities) {
    if (n < 0 || (n > 0 && (textures == nullptr || priorities == nullptr)))
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i)
        if (IsTexture(context, textures[i]) != GL_FALSE) // names without a texture, and 0, are ignored
            static_cast<TextureObject*>(*context.share->textures.find(textures[i]))->parameters.priority =
                numeric::clamp01(convert::array_value({priorities, GL_FLOAT}, static_cast<std::size_t>(i)));
}

} // namespace cmd

} // namespace spangle::gl
