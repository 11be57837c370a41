// Unpacks the arguments of commands into words, which messages about errors are made of.
#pragma once

#include "gl/context/command_text.hpp"

#if SPANGLE_MESSAGES

namespace spangle::gl {

inline constexpr unsigned most_explained = 12;

/// Unpacks `count` argument words into the arguments of the GL command, one for each ArgText. Images become
/// their parts, and arrays their addresses. Returns the number of arguments.
unsigned unpack(const CommandText& text, const Arg* args, unsigned count, Arg (&out)[most_explained]);

/// Does what explain() does, for arguments that are already unpacked.
[[gnu::cold]] void explain_unpacked(Context& context, const CommandText& text, const Arg* args,
                                    unsigned count);

} // namespace spangle::gl

#endif
