#include "gl/api/issue.hpp"

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
#endif

Context* outside_begin_end(const char* refusal) {
    Context* const context = current_context();
    return context != nullptr && allowed_outside(*context, refusal) ? context : nullptr;
}

} // namespace spangle::gl
