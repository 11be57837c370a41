// How a command says no: the first error is kept until GetError reads it (GL 1.3, 2.5).
#pragma once

#include <spangle/GL/gl.h>

namespace spangle::gl {

struct Context;

/// Records `code` unless an earlier error waits. The command that calls this must change nothing else.
void error(Context& context, GLenum code);

/// The same, with a sentence for spangle::on_message that names the call and what to do. The text is compiled out
/// with SPANGLE_MESSAGES=0.
void error(Context& context, GLenum code, const char* message);

} // namespace spangle::gl
