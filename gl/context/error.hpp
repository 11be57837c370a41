// How a command says no: the first error is kept until GetError reads it (GL 1.3, 2.5).
#pragma once

#include "gl/context/command_text.hpp"

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

/// Records `code` unless an earlier error waits. The command that calls this must change nothing else. `rule`
/// is a SPANGLE_TEXT for spangle::on_message: the rule that was broken, without the command's name, which
/// whoever called the command puts in front (explain). An argument that breaks its own rule in the command
/// table is named instead; without `rule` the sentence is about such an argument.
#if SPANGLE_MESSAGES
void error(Context& context, GLenum code, const char* rule = nullptr);
#else
inline void error(Context& context, GLenum code, const char* = nullptr) {
    set_error(context, code - GL_INVALID_ENUM);
}
#endif

/// An error of a primitive that is being drawn. Vertices between Begin and End pay nothing for sentences:
/// theirs comes with the next command that is no vertex, End at the latest.
#if SPANGLE_MESSAGES
void drawing_error(Context& context, GLenum code, const char* rule);
#else
inline void drawing_error(Context& context, GLenum code, const char*) {
    error(context, code);
}
#endif

/// False, and INVALID_OPERATION, between Begin and End, where they do not allow what is asked
/// (GL 1.3, 2.6.3). `text` is that of the command.
bool allowed_outside(Context& context, const CommandText* text);

} // namespace spangle::gl
