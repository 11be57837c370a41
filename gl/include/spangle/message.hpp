// Where Spangle's words go. The library prints nothing by itself.
#pragma once

#ifndef SPANGLE_MESSAGES
#define SPANGLE_MESSAGES 1 ///< 0 compiles every text out; the sink is then never called.
#endif

namespace spangle {

/// Receives one sentence without a line end. `code` is a GL or EGL error, or 0 for a remark. Called on the
/// thread of the failing command, which has not returned yet: it must not call GL or EGL. Threads of a host
/// may call it at once. A sentence begins with the command's name. What a vertex between glBegin and glEnd
/// raises while it is drawn is told by the next command that is no vertex, glEnd at the latest.
using MessageSink = void (*)(unsigned code, const char* text);

/// Sets the sink of the whole program; null (the start) means silence. Returns the one before.
MessageSink on_message(MessageSink sink);

/// Hands a sentence to the sink. For the rooms of the library.
void message(unsigned code, const char* text);

} // namespace spangle
