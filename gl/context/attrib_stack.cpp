// PushAttrib, PopAttrib and their like for the client (GL 1.3, 6.1.12). What a group holds stands in the
// state table; an entry has the bytes of the groups that were asked for and nothing else.
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/reach.hpp"
#include "gl/context/state_table.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_ATTRIB_STACKS

/// Header of an entry; saved bytes follow, in the order of the table, then what the texture group adds.
struct SavedAttributes {
    SavedAttributes* below;
    GLbitfield groups;
    GLuint vertex_array; ///< with the client's arrays: whose they are
};

namespace {

constexpr GLbitfield bit(Group group) {
    return 1u << static_cast<unsigned>(group);
}

constexpr GLbitfield server_groups = 0x200FFFFF; // the 21 of GL 1.3, table 6.4; other bits mean nothing
static_assert(bit(Group::scissor) == GL_SCISSOR_BIT && bit(Group::multisample) == GL_MULTISAMPLE_BIT);

GLbitfield client_groups(GLbitfield mask) {
    return ((mask & GL_CLIENT_PIXEL_STORE_BIT) != 0 ? bit(Group::client_pixel_store) : 0) |
           ((mask & GL_CLIENT_VERTEX_ARRAY_BIT) != 0 ? bit(Group::client_vertex_array) : 0);
}

bool belongs(const StateRow& row, Group group, GLbitfield groups) {
    return (groups & (bit(group) | (row.toggle == Switch::server ? bit(Group::enable) : 0))) != 0;
}

enum class Move : std::uint8_t {
    none, ///< how many bytes there are
    save,
    restore,
};

/// Between the context and an entry, `bytes` bytes from `offset` on, and the same of other units. Returns
/// where in the entry the next ones lie.
std::size_t move_bytes(Context& context, std::uint32_t offset, std::uint32_t bytes, std::uint32_t unit_step,
                       unsigned char* saved, std::size_t at, Move move) {
    for (std::uint32_t unit = 0; unit < units_of(unit_step); ++unit, at += bytes) {
        unsigned char* const held = reinterpret_cast<unsigned char*>(&context) + offset + unit * unit_step;
        if (move == Move::save)
            std::memcpy(saved + at, held, bytes);
        else if (move == Move::restore)
            std::memcpy(held, saved + at, bytes);
    }
    return at;
}

/// Everything that the groups keep in the context. Returns how many bytes that are.
std::size_t move_kept(Context& context, GLbitfield groups, unsigned char* saved, Move move) {
    std::size_t at = 0;
    for (const GroupedRows& part : all_state()) {
        const Group* group = part.groups;
        for (const StateRow& row : part.rows)
            if (belongs(row, *group++, groups))
                at =
                    move_bytes(context, row.where, row.names * kept_by(row), unit_step(row), saved, at, move);
    }
    for (const HeldRow& row : all_held())
        if ((groups & bit(row.group)) != 0)
            at = move_bytes(context, row.offset, row.bytes, row.unit_step(), saved, at, move);
    return at;
}

void push(Context& context, AttribStack& stack, GLbitfield groups) {
    if (stack.depth == attrib_stack_entries)
        return error(context, GL_STACK_OVERFLOW);
    const std::size_t bytes = sizeof(SavedAttributes) + move_kept(context, groups, nullptr, Move::none);
    const bool textures = (groups & bit(Group::texture)) != 0;
    auto* const entry = static_cast<SavedAttributes*>(
        context.arena->allocate(bytes + (textures ? saved_texture_bytes() : 0)));
    if (entry == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for an attribute group"));
    entry->below = stack.top;
    entry->groups = groups;
    entry->vertex_array = bound_vertex_array(context);
    auto* const to = reinterpret_cast<unsigned char*>(entry + 1);
    move_kept(context, groups, to, Move::save);
    if (textures)
        save_textures(context, reinterpret_cast<unsigned char*>(entry) + bytes);
    if ((groups & bit(Group::client_vertex_array)) != 0)
        hold_arrays(context);
    stack.top = entry;
    ++stack.depth;
    if constexpr (tells_reach)
        reach(context, Range::ATTRIB_STACK, static_cast<std::uint32_t>(stack.depth));
}

/// Without memory for what it would make anew an entry stays on the stack, and nothing is changed.
void pop(Context& context, AttribStack& stack) {
    SavedAttributes* const entry = stack.top;
    if (entry == nullptr)
        return error(context, GL_STACK_UNDERFLOW);
    const GLbitfield groups = entry->groups;
    auto* const from = reinterpret_cast<unsigned char*>(entry + 1);
    const bool textures = (groups & bit(Group::texture)) != 0,
               arrays = (groups & bit(Group::client_vertex_array)) != 0;
    if ((textures && !restore_textures(context, from + move_kept(context, groups, from, Move::none))) ||
        (arrays && !bind_vertex_array(context, entry->vertex_array)))
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for what was deleted"));
    stack.top = entry->below;
    --stack.depth;
    if (arrays)
        release_arrays(context);
    move_kept(context, groups, from, Move::restore);
    context.arena->free(entry);
    context.changed(dirty_all);
#if SPANGLE_FEATURE_LIGHTING
    if (has_color_material &&
        context.lighting.color_material) // a tracked material is the current colour, whichever was popped
        color_material_enabled(context);
#endif
}

} // namespace

GLint saved_attributes(const Context& context, bool client) {
    return (client ? context.attrib.client : context.attrib.server).depth;
}

void release_attributes(Context& context) {
    while (SavedAttributes* const entry = context.attrib.client.top) {
        entry->vertex_array = bound_vertex_array(context); // whose arrays they are does not matter any more
        pop(context, context.attrib.client);               // buffers are let go of on the way
    }
    while (SavedAttributes* const entry = context.attrib.server.top) {
        context.attrib.server.top = entry->below;
        context.arena->free(entry);
    }
}

namespace cmd {

void PushAttrib(Context& context, GLbitfield mask) {
    push(context, context.attrib.server, mask & server_groups);
}

void PopAttrib(Context& context) {
    pop(context, context.attrib.server);
}

void PushClientAttrib(Context& context, GLbitfield mask) {
    push(context, context.attrib.client, client_groups(mask));
}

void PopClientAttrib(Context& context) {
    pop(context, context.attrib.client);
}

} // namespace cmd

#else

GLint saved_attributes(const Context&, bool) {
    return 0;
}

void release_attributes(Context&) {}

#endif

} // namespace spangle::gl
