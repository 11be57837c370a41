#include "gl/api/issue.hpp"

#include <cstring>

namespace spangle::gl {

namespace {

void refuse(GLenum code, const char* text) {
    if (Context* context = current_context(); context != nullptr)
        error(*context, code, text);
}

} // namespace

void refuse_null(const char* text) {
    refuse(GL_INVALID_VALUE, text);
}

void refuse_feature(const char* text) {
    refuse(GL_INVALID_OPERATION, text);
}

bool allowed(Context& context, const Gated& command) {
    return (command.stops & gate_inside) == 0 || allowed_outside(context, command.refusal);
}

#if SPANGLE_FEATURE_LISTS
bool admit_words(Context& context, const Gated& command, const list::Word* words, std::uint32_t count) {
    if ((context.gate & gate_compiling) != 0) { // words are of commands that lists take
        list::write(context, command, words, count);
        if (!context.list.execute)
            return false;
    }
    return allowed(context, command);
}

#if !SPANGLE_ARGUMENTS_INLINE
void issue_words(const Gated& command, list::Word* words, std::uint32_t count) {
    Context* const context = current_context();
    if (context == nullptr)
        return;
    if ((context->gate & gate_compiling) != 0) {
        list::write(*context, command, words, count);
        if (!context->list.execute)
            return;
    }
    const list::Player* const player = &command;
    std::memcpy(words - list::player_words, &player, sizeof player);
    command.play(*context, words);
}

Step next_step(Context* context, const Gated& command, Step done) {
    if (context == nullptr || done == Step::run)
        return Step::none;
    if (done == Step::none && (context->gate & gate_compiling) != 0)
        return Step::record;
    return (done == Step::none || context->list.execute) && allowed(*context, command) ? Step::run
                                                                                       : Step::none;
}
#endif
#else
Context* admitted(const Gated& command) {
    Context* const context = current_context();
    return context != nullptr && allowed(*context, command) ? context : nullptr;
}
#endif

Context* outside_begin_end(const char* refusal) {
    Context* const context = current_context();
    return context != nullptr && allowed_outside(*context, refusal) ? context : nullptr;
}

} // namespace spangle::gl
