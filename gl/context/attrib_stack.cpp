// PushAttrib, PopAttrib, PushClientAttrib and PopClientAttrib (GL 1.3, 6.1.12). The state table says what
// each group saves. A stack entry holds the bytes of the requested groups and nothing else.
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/reach.hpp"
#include "gl/context/saved_runs.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_ATTRIB_STACKS

/// Header of a stack entry. The saved bytes follow in the order of the runs, and those of the texture group
/// come last.
struct SavedAttributes {
    SavedAttributes* below;
    GLbitfield groups;
    std::uint32_t bytes; ///< bytes of the header and of the saved runs
    GLuint vertex_array; ///< vertex array object that saved client arrays belong to
};

namespace {

constexpr GLbitfield bit(Group group) {
    return 1u << static_cast<unsigned>(group);
}

// Other bits of a mask than those of server_groups are ignored.
static_assert(bit(Group::scissor) == GL_SCISSOR_BIT && bit(Group::multisample) == GL_MULTISAMPLE_BIT);

GLbitfield client_groups(GLbitfield mask) {
    return ((mask & GL_CLIENT_PIXEL_STORE_BIT) != 0 ? bit(Group::client_pixel_store) : 0) |
           ((mask & GL_CLIENT_VERTEX_ARRAY_BIT) != 0 ? bit(Group::client_vertex_array) : 0);
}

/// True if whole chunks are saved, not runs. Few comparisons then tell that most groups have not changed.
bool saves_chunks(GLbitfield groups) {
    return joins_saved_runs && groups == server_groups;
}

/// Returns the number of bytes of the context that the groups save.
std::size_t kept_bytes(GLbitfield groups) {
    std::size_t all = 0;
    if (saves_chunks(groups)) {
        for (const SavedChunk& chunk : saved_chunks())
            all += units_of(chunk.unit_step) * chunk.bytes;
        return all;
    }
    each_saved_run(groups, [&](const SavedRun& run) { all += units_of(run.unit_step) * run.bytes; });
    return all;
}

enum class Move : bool { save, restore };

/// Copies bytes from the context to a stack entry, or back. Restoring bytes that differ marks the state
/// derived from them as changed.
SPANGLE_INLINE void move_bytes(Context& context, unsigned char* held, unsigned char* saved, std::size_t bytes,
                               Dirty dirty, Move move) {
    if (move == Move::save) {
        std::memcpy(saved, held, bytes);
    } else if (std::memcmp(held, saved, bytes) != 0) {
        std::memcpy(held, saved, bytes);
        context.changed(dirty);
    }
}

/// Saves or restores the chunks of all server groups. The runs of a chunk are compared only if the chunk
/// differs.
void move_chunks(Context& context, unsigned char* saved, Move move) {
    for (const SavedChunk& chunk : saved_chunks()) {
        unsigned char* held = reinterpret_cast<unsigned char*>(&context) + chunk.offset;
        std::uint32_t units = units_of(chunk.unit_step);
        do {
            if (move == Move::save)
                std::memcpy(saved, held, chunk.bytes);
            else if (std::memcmp(held, saved, chunk.bytes) != 0)
                for (const SavedRun& run : saved_runs().subspan(chunk.first, chunk.count)) {
                    const std::size_t at = std::size_t{run.offset} - chunk.offset;
                    move_bytes(context, held + at, saved + at, run.bytes, run.dirty, move);
                }
            held += chunk.unit_step;
            saved += chunk.bytes;
        } while (--units != 0);
    }
}

/// Saves or restores all bytes of the context that the groups save.
void move_kept(Context& context, GLbitfield groups, unsigned char* saved, Move move) {
    if (saves_chunks(groups))
        return move_chunks(context, saved, move);
    each_saved_run(groups, [&](const SavedRun& run) {
        unsigned char* held = reinterpret_cast<unsigned char*>(&context) + run.offset;
        std::uint32_t units = units_of(run.unit_step);
        do {
            // Copies of a constant size need no function call.
            if (joins_saved_runs && run.bytes == sizeof(std::uint32_t))
                move_bytes(context, held, saved, sizeof(std::uint32_t), run.dirty, move);
            else if (joins_saved_runs && run.bytes == 1)
                move_bytes(context, held, saved, 1, run.dirty, move);
            else
                move_bytes(context, held, saved, run.bytes, run.dirty, move);
            held += run.unit_step;
            saved += run.bytes;
        } while (--units != 0);
    });
}

void push(Context& context, AttribStack& stack, GLbitfield groups) {
    if (stack.depth == attrib_stack_entries)
        return error(context, GL_STACK_OVERFLOW);
    const std::size_t bytes = sizeof(SavedAttributes) + kept_bytes(groups);
    const bool textures = (groups & bit(Group::texture)) != 0;
    auto* const entry = static_cast<SavedAttributes*>(
        context.arena->allocate(bytes + (textures ? saved_texture_bytes() : 0)));
    if (entry == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for an attribute group"));
    entry->below = stack.top;
    entry->groups = groups;
    entry->bytes = static_cast<std::uint32_t>(bytes);
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

/// Pops an entry. Without memory for objects that must be made again, the entry stays and nothing changes.
void pop(Context& context, AttribStack& stack) {
    SavedAttributes* const entry = stack.top;
    if (entry == nullptr)
        return error(context, GL_STACK_UNDERFLOW);
    const GLbitfield groups = entry->groups;
    auto* const from = reinterpret_cast<unsigned char*>(entry + 1);
    const bool textures = (groups & bit(Group::texture)) != 0,
               arrays = (groups & bit(Group::client_vertex_array)) != 0;
    if ((textures && !restore_textures(context, reinterpret_cast<unsigned char*>(entry) + entry->bytes)) ||
        (arrays && !bind_vertex_array(context, entry->vertex_array)))
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for what was deleted"));
    stack.top = entry->below;
    --stack.depth;
    if (arrays)
        release_arrays(context);
    move_kept(context, groups, from, Move::restore);
    context.arena->free(entry);
#if SPANGLE_FEATURE_LIGHTING
    // A tracked material equals the current colour, whichever of the two was popped.
    if (has_color_material && context.lighting.color_material)
        color_material_enabled(context);
#endif
}

} // namespace

GLint saved_attributes(const Context& context, bool client) {
    return (client ? context.attrib.client : context.attrib.server).depth;
}

void release_attributes(Context& context) {
    while (SavedAttributes* const entry = context.attrib.client.top) {
        entry->vertex_array = bound_vertex_array(context); // pop() therefore binds no other object
        pop(context, context.attrib.client);               // pop() releases the buffers of the saved arrays
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
