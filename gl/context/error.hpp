// Reports errors of commands. The first error is kept until GetError reads it (GL 1.3, 2.5).
#pragma once

#include "gl/context/command_text.hpp"

/// A text for messages; null in builds without messages.
#if SPANGLE_MESSAGES
#define SPANGLE_TEXT(text) (text)
#else
#define SPANGLE_TEXT(text) (static_cast<const char*>(nullptr))
#endif

namespace spangle::gl {

struct Context;

/// Records the error GL_INVALID_ENUM + `number`, unless an earlier one waits. Small numbers make calls
/// shorter.
void set_error(Context& context, unsigned number);

/// Records `code` unless an earlier error waits. The command that calls this must change nothing else. `rule`
/// is a SPANGLE_TEXT for spangle::on_message: the broken rule without the command's name, which explain()
/// puts in front. If an argument breaks its own rule in the command table, the message is about that
/// argument, and `rule` may be null.
#if SPANGLE_MESSAGES
void error(Context& context, GLenum code, const char* rule = nullptr);
#else
inline void error(Context& context, GLenum code, const char* = nullptr) {
    set_error(context, code - GL_INVALID_ENUM);
}
#endif

/// Records an error of a primitive that is being drawn. Vertex commands send no messages, so that they stay
/// fast. The next other command, End at the latest, sends the message.
#if SPANGLE_MESSAGES
void drawing_error(Context& context, GLenum code, const char* rule);
#else
inline void drawing_error(Context& context, GLenum code, const char*) {
    error(context, code);
}
#endif

/// True outside of Begin/End. Between Begin and End, it records INVALID_OPERATION and returns false (GL 1.3,
/// 2.6.3). `text` is the text of the command, or null.
bool allowed_outside(Context& context, const CommandText* text);

} // namespace spangle::gl
