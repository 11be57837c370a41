// Unpacks the arguments of commands into words, from which messages about errors are composed.
#pragma once

#include "gl/context/command_text.hpp"

#if SPANGLE_MESSAGES

namespace spangle::gl {

inline constexpr unsigned most_explained = 12;

/// Unpacks `count` argument words into the arguments of the GL command, one for each ArgText. An image
/// becomes several arguments, and an array becomes its address. Returns the number of arguments.
unsigned unpack(const CommandText& text, const Arg* args, unsigned count, Arg (&out)[most_explained]);

/// Does what explain() does, for arguments that are already unpacked.
[[gnu::cold]] void explain_unpacked(Context& context, const CommandText& text, const Arg* args,
                                    unsigned count);

} // namespace spangle::gl

#endif
