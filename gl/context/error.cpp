#include "gl/context/error.hpp"

#include "gl/context/context.hpp"

namespace spangle {

namespace {
constinit MessageSink sink = nullptr;
}

MessageSink on_message(MessageSink next) {
    const MessageSink before = sink;
    sink = next;
    return before;
}

void message(unsigned code, const char* text) {
    if (sink != nullptr && text != nullptr)
        sink(code, text);
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
