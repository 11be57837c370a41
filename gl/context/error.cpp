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
void error(Context& context, GLenum code, const char* text) {
    error(context, code);
    message(code, text);
}
#endif

bool allowed_outside(Context& context, const char* refusal) {
    if (!context.inside_begin_end())
        return true;
    error(context, GL_INVALID_OPERATION, refusal);
    return false;
}

} // namespace spangle::gl
