#include "gl/context/error.hpp"

#include "gl/context/context.hpp"
#include "gl/context/threads.hpp"

namespace spangle {

namespace {
#if SPANGLE_THREADS
constinit std::atomic<MessageSink> sink = nullptr;
#else
constinit MessageSink sink = nullptr;
#endif
} // namespace

MessageSink on_message(MessageSink next) {
#if SPANGLE_THREADS
    return sink.exchange(next);
#else
    const MessageSink before = sink;
    sink = next;
    return before;
#endif
}

void message(unsigned code, const char* text) {
    const MessageSink to = sink;
    if (to != nullptr && text != nullptr)
        to(code, text);
}

} // namespace spangle

namespace spangle::gl {

[[gnu::noinline]] void set_error(Context& context, unsigned number) {
    if (context.error_code == GL_NO_ERROR)
        context.error_code = GL_INVALID_ENUM + number;
}

#if SPANGLE_MESSAGES
void error(Context& context, GLenum code, const char* rule) {
    set_error(context, code - GL_INVALID_ENUM);
    // Only the first error of a command gets a message.
    if (context.pending_error.code == GL_NO_ERROR)
        context.pending_error = {code, rule};
}

void drawing_error(Context& context, GLenum code, const char* rule) {
    const bool first = context.pending_error.code == GL_NO_ERROR;
    error(context, code, rule);
    context.pending_error.drawing = context.pending_error.drawing || first;
}
#endif

bool allowed_outside(Context& context, [[maybe_unused]] const CommandText* text) {
    if (!context.inside_begin_end())
        return true;
    error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("not between glBegin and glEnd"));
#if SPANGLE_MESSAGES
    if (text != nullptr)
        explain(context, *text, nullptr, 0);
#endif
    return false;
}

} // namespace spangle::gl
