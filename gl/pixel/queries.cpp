// Occlusion queries (GL 1.5, 4.1.7, 6.1.12).
#include "gl/context/batches.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"

#if SPANGLE_FEATURE_QUERIES

#include <limits>
#include <new>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"

namespace spangle::gl {

namespace {

/// The result of a query, or null if it has never begun.
GLuint* result_of(const Context& context, GLuint id) {
    void** const slot = context.query.objects.find(id);
    return slot != nullptr ? static_cast<GLuint*>(*slot) : nullptr;
}

/// Returns the result of a query, which is made if it is missing. Returns null if the arena is full.
GLuint* make_result(Context& context, GLuint id) {
    NameTable& objects = context.query.objects;
    if (GLuint* const there = result_of(context, id); there != nullptr)
        return there;
    void* const memory = context.arena->allocate(sizeof(GLuint));
    if (memory == nullptr)
        return nullptr;
    auto* const result = new (memory) GLuint(0);
    if (void** const slot = objects.find(id); slot != nullptr) {
        *slot = result;
    } else if (!objects.insert(*context.arena, id, result)) {
        context.arena->free(memory);
        return nullptr;
    }
    return result;
}

/// The samples that have passed so far, including those of recorded primitives.
std::uint32_t passed(const Context& context) {
#if SPANGLE_HAS_RECORDS
    if (const Recording* const recording = context.drawable.recording; recording != nullptr)
        recording->count();
#endif
    const raster::Counters* const tool = context.fragments.counters;
    return tool != nullptr ? tool->passed : context.query.counters.passed;
}

/// Writes a value of a query object as a T. A result that is too large for a signed type becomes the largest
/// number of the type.
template <class T> void get_object(Context& context, GLuint id, GLenum pname, T* params) {
    const GLuint* const result = result_of(context, id);
    if (pname != GL_QUERY_RESULT && pname != GL_QUERY_RESULT_AVAILABLE)
        return error(context, GL_INVALID_ENUM);
    if (params == nullptr)
        return error(context, GL_INVALID_VALUE);
    if (result == nullptr || id == context.query.active)
        return error(context, GL_INVALID_OPERATION,
                     result == nullptr ? SPANGLE_TEXT("id is not a query object")
                                       : SPANGLE_TEXT("the query is active"));
    distrust_batches(context);
    constexpr auto most = static_cast<GLuint>(std::numeric_limits<T>::max());
    *params = static_cast<T>(pname == GL_QUERY_RESULT_AVAILABLE ? GL_TRUE : *result < most ? *result : most);
}

} // namespace

raster::Counters* counters_of(Context& context) {
    raster::Counters* const tool = context.fragments.counters;
    return tool != nullptr || context.query.active == 0 ? tool : &context.query.counters;
}

void change_counters(Context& context, raster::Counters* counters) {
    QueryState& query = context.query;
    query.counted += passed(context) - query.start;
    context.fragments.counters = counters;
    query.start = passed(context);
}

bool counts_passed(const Context& context) {
    return context.fragments.count_passed || context.query.active != 0;
}

void release_queries(Context& context) {
    NameTable& objects = context.query.objects;
    for (std::uint32_t i = 0; i < objects.capacity(); ++i)
        if (objects.slot(i).name != 0)
            context.arena->free(objects.slot(i).object);
    objects.clear(*context.arena);
}

namespace cmd {

void GenQueries(Context& context, GLsizei n, GLuint* ids) {
    gen_names(context, context.query.objects, n, ids);
}

/// Deletes queries. An active query is ended first.
void DeleteQueries(Context& context, GLsizei n, const GLuint* ids) {
    if (n < 0 || (n > 0 && ids == nullptr))
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i) {
        if (ids[i] == 0)
            continue;
        if (ids[i] == context.query.active)
            EndQuery(context, GL_SAMPLES_PASSED);
        context.arena->free(context.query.objects.remove(ids[i]));
    }
}

GLboolean IsQuery(Context& context, GLuint id) {
    return result_of(context, id) != nullptr ? GL_TRUE : GL_FALSE;
}

void BeginQuery(Context& context, GLenum target, GLuint id) {
    QueryState& query = context.query;
    if (target != GL_SAMPLES_PASSED)
        return error(context, GL_INVALID_ENUM);
    if (id == 0 || query.active != 0)
        return error(context, GL_INVALID_OPERATION,
                     id == 0 ? SPANGLE_TEXT("id is 0") : SPANGLE_TEXT("a query is active already"));
    if (make_result(context, id) == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena"));
    query.active = id;
    query.counted = 0;
    query.start = passed(context);
    context.changed(dirty_fragment);
}

void EndQuery(Context& context, GLenum target) {
    QueryState& query = context.query;
    if (target != GL_SAMPLES_PASSED)
        return error(context, GL_INVALID_ENUM);
    if (query.active == 0)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("no query is active"));
    *result_of(context, query.active) = query.counted + passed(context) - query.start;
    query.active = 0;
    context.changed(dirty_fragment);
}

void GetQueryiv(Context& context, GLenum target, GLenum pname, GLint* params) {
    if (params == nullptr)
        return error(context, GL_INVALID_VALUE);
    if (target != GL_SAMPLES_PASSED || (pname != GL_CURRENT_QUERY && pname != GL_QUERY_COUNTER_BITS))
        return error(context, GL_INVALID_ENUM);
    *params = pname == GL_CURRENT_QUERY ? static_cast<GLint>(context.query.active) : 32;
}

void GetQueryObjectiv(Context& context, GLuint id, GLenum pname, GLint* params) {
    get_object(context, id, pname, params);
}

void GetQueryObjectuiv(Context& context, GLuint id, GLenum pname, GLuint* params) {
    get_object(context, id, pname, params);
}

} // namespace cmd

} // namespace spangle::gl

#else

namespace spangle::gl {

raster::Counters* counters_of(Context& context) {
    return context.fragments.counters;
}
void change_counters(Context& context, raster::Counters* counters) {
    context.fragments.counters = counters;
}
bool counts_passed(const Context& context) {
    return context.fragments.count_passed;
}
void release_queries(Context&) {}

} // namespace spangle::gl

#endif
