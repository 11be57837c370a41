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

void error(Context& context, GLenum code) {
    if (context.error_code == GL_NO_ERROR)
        context.error_code = code;
}

void error(Context& context, GLenum code, const char* text) {
    error(context, code);
    message(code, text);
}

bool allowed_outside(Context& context, const char* refusal) {
    if (!context.inside_begin_end())
        return true;
    error(context, GL_INVALID_OPERATION, refusal);
    return false;
}

} // namespace spangle::gl
