// How a command says no: the first error is kept until GetError reads it (GL 1.3, 2.5).
#pragma once

#include <spangle/GL/gl.h>
#include <spangle/message.hpp>

/// A text for people; null when texts are compiled out.
#if SPANGLE_MESSAGES
#define SPANGLE_TEXT(text) (text)
#else
#define SPANGLE_TEXT(text) (static_cast<const char*>(nullptr))
#endif

namespace spangle::gl {

struct Context;

/// Of GL_INVALID_ENUM and the codes behind it: a call says so with a small number.
void set_error(Context& context, unsigned number);

/// Records `code` unless an earlier error waits. The command that calls this must change nothing else.
inline void error(Context& context, GLenum code) {
    set_error(context, code - GL_INVALID_ENUM);
}

/// The same, with a SPANGLE_TEXT for spangle::on_message that names the call and what to do.
#if SPANGLE_MESSAGES
void error(Context& context, GLenum code, const char* text);
#else
inline void error(Context& context, GLenum code, const char*) {
    error(context, code);
}
#endif

/// False, and INVALID_OPERATION, between Begin and End, where they do not allow what is asked
/// (GL 1.3, 2.6.3).
bool allowed_outside(Context& context, const char* refusal);

} // namespace spangle::gl
