// Executes display lists. A call of a list does not recurse, but stores where the calling list continues. 64
// levels therefore take 64 pointers in the context and no stack. Deeper calls are ignored, as GL allows,
// since its nesting limit exists to bound recursion (GL 1.3, 5.4). Builds with fewer levels raise an error
// for deeper calls, because other builds may draw the lists that they leave out.
#include "gl/list/play.hpp"

#if SPANGLE_FEATURE_LISTS

#include <new>

#include "gl/api/command.hpp"
#include "gl/context/share_group.hpp"
#include "gl/list/chunk.hpp"

namespace spangle::gl::list {

namespace {

/// Returns the first record of a list. Null: the list is empty, or the name is no list.
const Word* body_of_list(const Context& context, GLuint name) {
    void** const found = context.share->lists.find(name);
    return found != nullptr && *found != nullptr ? static_cast<Chunk*>(*found)->data() : nullptr;
}

/// Calls a list. Returns the first record to play, which is `next` if there is nothing to call.
const Word* enter(Context& context, GLuint name, const Word* next) {
    const Word* const target = body_of_list(context, name);
    ListState& state = context.list;
    if (target == nullptr)
        return next;
    // The outermost list counts as a level.
    if (state.depth >= max_list_nesting - 1) {
        constexpr int of_gl = 64;
        if constexpr (max_list_nesting < of_gl)
            error(
                context, GL_INVALID_OPERATION,
                SPANGLE_TEXT("the lists call each other deeper than this build goes (SPANGLE_LIST_NESTING)"));
        return next;
    }
    state.return_to[state.depth++] = next;
    return target;
}

const Player* player_at(const Word* at) {
    const Player* player;
    // The builtin compiles without a call of memcpy, even in freestanding builds.
    __builtin_memcpy(&player, at, sizeof player);
    return player;
}

/// Plays a command of any form, with arguments made from the record's words.
[[gnu::noinline]] const Word* play_any(Context& context, const Command& command, const Word* words) {
    Arg args[most_args] = {};
    alignas(Params) alignas(Matrix16) unsigned char room[sizeof(Matrix16)]; // room for Params or Matrix16
    static_assert(sizeof(Params) <= sizeof(Matrix16));
    Arg* arg = args;
    for (unsigned left = words_of(command); left != 0; --left)
        *arg++ = *words++;
    if (command.form == Form::params) {
        auto& params = *new (room) Params;
        params.count = *words++;
        __builtin_memcpy(static_cast<void*>(params.v), words, params.count * sizeof(Word));
        words += params.count;
        *arg = Passed<const Params&>::arg(params);
    } else if (command.form == Form::matrix) {
        auto& matrix = *new (room) Matrix16;
        __builtin_memcpy(static_cast<void*>(matrix.m), words, sizeof matrix.m);
        words += sizeof matrix.m / sizeof(Word);
        *arg = Passed<const Matrix16&>::arg(matrix);
    }
    if (may_run_here(context, command)) {
        call(context, command.run, command.args, args);
        explain_error(context, command.text, args, command.args);
    }
    return words;
}

const Word* play_own(Context& context, const OwnPlayer& player, const Word* words) {
    const Word* const next = player.play(context, words);
#if SPANGLE_MESSAGES
    if (player.text != nullptr)
        explain_error(context, player.text, nullptr, 0);
#endif
    return next;
}

const Word* play(Context& context, const Player& player, const Word* words) {
    return player.form == Form::own ? play_own(context, static_cast<const OwnPlayer&>(player), words)
                                    : play_command(context, static_cast<const Command&>(player), words);
}

} // namespace

const Word* play_command(Context& context, const Command& command, const Word* words) {
    tell_watcher(context, command.text, nullptr, 0);
    // Most commands are played here.
    if (converts_in_line && command.args <= few_args && command.form <= Form::encoded) {
        Arg a = 0, b = 0, c = 0;
        switch (command.args) {
        case 3:
            c = words[2];
            [[fallthrough]];
        case 2:
            b = words[1];
            [[fallthrough]];
        case 1:
            a = words[0];
        }
        if ((context.gate & command.stops & gate_inside) == 0 || may_run_here(context, command)) {
            command.run.few(context, a, b, c);
            const Arg given[] = {a, b, c};
            explain_error(context, command.text, given, command.args);
        }
        return words + command.args;
    }
    return play_any(context, command, words);
}

void execute(Context& context, GLuint name) {
    const Word* at = body_of_list(context, name);
    if (at == nullptr)
        return;
    for (;;) {
        const Player* player = player_at(at);
        if constexpr (converts_in_line)
            // Most records are runs.
            for (; player == &list::player<&play_run>; player = player_at(at))
                at = play_run(context, at + player_words);
        if (player != nullptr) {
            at = play(context, *player, at + player_words);
            continue;
        }
        if (context.list.depth == 0)
            return;
        at = context.list.return_to[--context.list.depth];
    }
}

const Word* play_call(Context& context, const Word* words) {
    if (*words == 0)
        error(context, GL_INVALID_VALUE, SPANGLE_TEXT("list is 0"));
    return enter(context, *words, words + 1);
}

const Word* play_call_offset(Context& context, const Word* words) {
    return enter(context, context.list.base + *words, words + 1);
}

} // namespace spangle::gl::list

#endif
