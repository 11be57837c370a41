#include "gl/context/create.hpp"

#include <cstring>
#include <new>

#include "gl/context/hooks.hpp"
#include "gl/context/initial.hpp"
#include "gl/context/share_group.hpp"
#include "gl/list/chunk.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::gl {

namespace detail {
constinit SPANGLE_THREAD_LOCAL Context* current = nullptr;
}

#if SPANGLE_THREADS
SharedObjects::SharedObjects(Context& context) : lock_(context.share->lock) {
    lock_.take();
}
#endif

void set_current_context(Context* context) {
    detail::current = context;
}

namespace {

void destroy_group(ShareGroup* group) {
    Arena& arena = group->arena;
#if SPANGLE_FEATURE_LISTS
    for (std::uint32_t i = 0; i < group->lists.capacity(); ++i)
        if (group->lists.slot(i).name != 0)
            list::free_chain(arena, static_cast<list::Chunk*>(group->lists.slot(i).object));
#endif
    for (std::uint32_t i = 0; i < group->textures.capacity(); ++i)
        if (group->textures.slot(i).name != 0 && group->textures.slot(i).object != nullptr)
            destroy_texture(*group, group->textures.slot(i).object);
#if SPANGLE_HAS_RECORDS
    forget_kept_images(*group);
#endif
#if SPANGLE_FEATURE_BUFFERS
    for (std::uint32_t i = 0; i < group->buffers.capacity(); ++i)
        if (group->buffers.slot(i).name != 0)
            destroy_buffer(arena, group->buffers.slot(i).object);
#endif
    group->buffers.clear(arena);
    group->lists.clear(arena);
    group->textures.clear(arena);
    arena.free(group);
}

/// Releases the context's references to shared objects.
void release_shared(Context& context) {
    const SharedObjects held(context);
    release_attributes(context);
    release_vertex_arrays(context);
    release_textures(context);
}

} // namespace

GLuint take_names(Context& context, NameTable& table, GLuint count) {
    const GLuint first = table.unused(count);
    if (first == 0)
        return 0;
    if (!table.reserve(context.share->arena, count)) {
        error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no memory for so many names"));
        return 0;
    }
    for (GLuint i = 0; i < count; ++i)
        table.insert(context.share->arena, first + i, nullptr);
    return first;
}

void gen_names(Context& context, NameTable& table, GLsizei n, GLuint* names) {
    if (n < 0 || (n > 0 && names == nullptr))
        return error(context, GL_INVALID_VALUE);
    if (n == 0)
        return;
    const GLuint first = take_names(context, table, static_cast<GLuint>(n));
    if (first == 0)
        return error(context, GL_OUT_OF_MEMORY);
    for (GLuint i = 0; i < static_cast<GLuint>(n); ++i)
        names[i] = first + i;
}

Context* create_context(Arena& arena, const ContextConfig& config, Context* share) {
    // The engine's pipeline follows the context in the same block.
    constexpr std::size_t own =
        (sizeof(Context) + Arena::alignment - 1) / Arena::alignment * Arena::alignment;
    const std::size_t bytes = own + config.engine->pipeline_bytes;
    auto* const memory = static_cast<unsigned char*>(arena.allocate(bytes));
    if (memory == nullptr)
        return nullptr;
    ShareGroup* group = share != nullptr ? share->share : nullptr;
    if (group == nullptr) {
        void* const group_memory = arena.allocate(sizeof(ShareGroup));
        if (group_memory == nullptr) {
            arena.free(memory);
            return nullptr;
        }
        group = new (group_memory) ShareGroup(arena);
    }
    std::memset(memory, 0, bytes);
    Context* const context = begin_context(memory);
    context->arena = &arena;
    context->tier = config.tier;
    context->engine = config.engine;
    context->pipeline = memory + own;
    config.engine->construct(context->pipeline);
    context->share = group;
    ++group->references;
    return context;
}

void destroy_context(Context* context) {
    if (context == nullptr)
        return;
    if (current_context() == context)
        set_current_context(nullptr);
#if SPANGLE_FEATURE_LISTS
    list::free_chain(*context->arena, context->list.recorder.first); // a list may still lack its EndList
#endif
#if SPANGLE_GATHERS_POLYGONS
    context->arena->free(context->render.gathered);
#endif
#if SPANGLE_GROWS_CACHE
    context->arena->free(context->render.kept_vertices);
#endif
    release_evaluators(*context);
    release_pixel_maps(*context);
    release_queries(*context);
    release_shared(*context);
    if (--context->share->references == 0)
        destroy_group(context->share);
    context->arena->free(context);
}

void make_current(Context& context) {
    set_current_context(&context);
    Drawable& drawable = context.drawable;
    const raster::Surface& surface = drawable.surface;
    drawable.index_bits =
        raster::drawn_indexed(surface.format) ? format_info(surface.format).index_bits : std::uint8_t{0};
#if SPANGLE_HAS_RECORDS
    drawable.recording = nullptr;
#endif
#if SPANGLE_FEATURE_BANDS
    drawable.batches = nullptr;
#endif
    context.changed(dirty_all);
    if (drawable.bound_before)
        return;
    drawable.bound_before = true;
    const GLenum buffer = drawable.double_buffered ? GL_BACK : GL_FRONT;
    context.fragment_ops.draw_buffer = context.fragment_ops.read_buffer = buffer;
    for (auto* box : {&context.transform.viewport, &context.fragment_ops.scissor_box}) {
        (*box)[0] = (*box)[1] = 0;
        (*box)[2] = surface.width;
        (*box)[3] = surface.height;
    }
}

void make_current(Context* context, const raster::Surface& surface, bool double_buffered) {
    Drawable& drawable = context->drawable;
    drawable.surface = drawable.read = surface;
    drawable.double_buffered = drawable.read_double_buffered = double_buffered;
    drawable.front_buffered = drawable.read_front_buffered = !double_buffered;
    make_current(*context);
}

#if SPANGLE_HAS_RECORDS

ShareGroup* hold_objects(Context& context) {
    ++context.share->references;
    return context.share;
}

bool has_objects(const Context& context, const ShareGroup& share) {
    return context.share == &share;
}

void forget_images(Context& context) {
    forget_kept_images(*context.share);
}

void release_objects(ShareGroup* share) {
    if (share != nullptr && --share->references == 0)
        destroy_group(share);
}

#endif

void move_drawable(Context& context, const raster::Surface& surface, bool read_too,
                   [[maybe_unused]] const Recording* recording, [[maybe_unused]] raster::BatchRows* batches) {
    context.drawable.surface = surface;
    if (read_too)
        context.drawable.read = surface;
#if SPANGLE_HAS_RECORDS
    context.drawable.recording = recording;
#endif
#if SPANGLE_FEATURE_BANDS
    context.drawable.batches = batches;
#endif
    context.changed(dirty_fragment);
}

} // namespace spangle::gl
