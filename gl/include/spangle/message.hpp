// Messages: sentences about errors and remarks, for people. The library itself prints nothing.
#pragma once

#ifndef SPANGLE_MESSAGES
#define SPANGLE_MESSAGES 1 ///< 0 compiles every text out; the sink is then never called.
#endif

namespace spangle {

/// Receives one sentence without a line end, which begins with the command's name. `code` is a GL or EGL
/// error, or 0 for a remark. The sink is called on the thread of the failing command, before the command
/// returns. The sink must therefore not call GL or EGL. On a host, several threads may call the sink at the
/// same time. If a vertex between glBegin and glEnd raises an error, the next command that is not a vertex
/// reports it, at the latest glEnd.
using MessageSink = void (*)(unsigned code, const char* text);

/// Sets the sink of the whole program and returns the previous one. If the sink is null, as it is initially,
/// no messages are sent.
MessageSink on_message(MessageSink sink);

/// Hands a sentence to the sink. For use inside the library only.
void message(unsigned code, const char* text);

} // namespace spangle
