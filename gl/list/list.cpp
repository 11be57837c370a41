// NewList, EndList, CallList, and commands for names of lists (GL 1.3, 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include "gl/api/generated/commands.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/share_group.hpp"
#include "gl/list/call_offsets.hpp"
#include "gl/list/chunk.hpp"
#include "gl/list/play.hpp"

namespace spangle::gl::cmd {

void NewList(Context& context, GLuint list, GLenum mode) {
    if (list == 0)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("list is 0"));
    if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE)
        return error(context, GL_INVALID_ENUM);
    if (context.list.index != 0)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("another list is being compiled"));
    context.list.index = list;
    context.list.mode = mode;
    context.list.execute = mode == GL_COMPILE_AND_EXECUTE;
    context.gate = static_cast<std::uint8_t>(context.gate | gate_compiling);
    list::begin_recording(context);
}

void EndList(Context& context) {
    ListState& state = context.list;
    if (state.index == 0)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("no glNewList came before"));
    const GLuint name = state.index;
    state.index = 0;
    state.mode = 0;
    state.execute = false;
    context.gate = static_cast<std::uint8_t>(context.gate & ~gate_compiling);
    list::Chunk* const chain = list::end_recording(context);
    NameTable& names = context.share->lists;
    if (chain == nullptr || (names.find(name) == nullptr && !names.insert(*context.arena, name, nullptr))) {
        list::free_chain(*context.arena, chain);
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no memory for the list; the old one stays"));
    }
    void** const object = names.find(name);
    list::Chunk* const old = static_cast<list::Chunk*>(*object);
    *object = chain;
    list::free_chain(*context.arena, old);
}

void CallList(Context& context, GLuint list) {
    if (list == 0)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("list is 0"));
    list::execute(context, list);
}

void CallLists(Context& context, GLsizei n, GLenum type, const void* lists) {
    if (n < 0)
        return error(context, GL_INVALID_VALUE);
    if (!list::is_name_type(type))
        return error(context, GL_INVALID_ENUM);
    if (lists == nullptr && n > 0)
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i)
        list::execute(context, context.list.base + list::name_offset(type, lists, i));
}

void ListBase(Context& context, GLuint base) {
    context.list.base = base;
}

GLuint GenLists(Context& context, GLsizei range) {
    if (range < 0) {
        error(context, GL_INVALID_VALUE);
        return 0;
    }
    return range == 0 ? 0 : take_names(context, context.share->lists, static_cast<GLuint>(range));
}

void DeleteLists(Context& context, GLuint list, GLsizei range) {
    if (range < 0)
        return error(context, GL_INVALID_VALUE);
    NameTable& names = context.share->lists;
    auto count = static_cast<GLuint>(range);
    if (list != 0 && count > 0 - list)
        count = 0 - list; // the largest name is 2^32 - 1
    if (count <= names.capacity()) {
        for (GLuint i = 0; i < count; ++i)
            list::free_chain(*context.arena, static_cast<list::Chunk*>(names.remove(list + i)));
        return;
    }
    // If the range is wider than the table, walking the table is shorter. A removal may move another entry
    // into the slot, so the slot is checked again.
    for (std::uint32_t i = 0; i < names.capacity();) {
        const GLuint name = names.slot(i).name;
        if (name != 0 && name - list < count)
            list::free_chain(*context.arena, static_cast<list::Chunk*>(names.remove(name)));
        else
            ++i;
    }
}

GLboolean IsList(Context& context, GLuint list) {
    return context.share->lists.find(list) != nullptr;
}

} // namespace spangle::gl::cmd

namespace spangle::gl::encode {

void CallList(Context& context, GLuint list) {
    if (list::Word* to = list::record(context, &list::player<&list::play_call, family::CallList>, 1);
        to != nullptr)
        *to = list;
}

void CallLists(Context& context, GLsizei n, GLenum type, const void* lists) {
    if (n < 0 || !list::is_name_type(type) || (lists == nullptr && n > 0))
        return list::record_error(
            context, n >= 0 && !list::is_name_type(type) ? GL_INVALID_ENUM : GL_INVALID_VALUE, true);
    for (GLsizei i = 0; i < n && !context.list.recorder.out_of_memory; ++i)
        if (list::Word* to = list::record(context, &list::player<&list::play_call_offset>, 1); to != nullptr)
            *to = list::name_offset(type, lists, i);
}

} // namespace spangle::gl::encode

#endif
