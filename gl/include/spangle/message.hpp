// Messages: sentences about errors and remarks, for people. The library itself prints nothing.
#pragma once

#ifndef SPANGLE_MESSAGES
#define SPANGLE_MESSAGES 1 ///< 0 compiles every text out; the sink is then never called.
#endif

namespace spangle {

/// Receives one sentence without a line end, which begins with the command's name. `code` is a GL or EGL
/// error, or 0 for a remark. The sink is called on the thread of the failing command, which has not returned
/// yet: the sink must not call GL or EGL. On a host, several threads may call the sink at the same time. An
/// error that a vertex between glBegin and glEnd raises is reported by the next command that is no vertex, at
/// the latest by glEnd.
using MessageSink = void (*)(unsigned code, const char* text);

/// Sets the sink of the whole program and returns the previous one. Null, as at the start, means silence.
MessageSink on_message(MessageSink sink);

/// Hands a sentence to the sink. For use inside the library only.
void message(unsigned code, const char* text);

} // namespace spangle
