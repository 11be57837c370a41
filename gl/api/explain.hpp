// The arguments of commands as words that sentences about errors are made of.
#pragma once

#include "gl/context/command_text.hpp"

#if SPANGLE_MESSAGES

namespace spangle::gl {

inline constexpr unsigned most_explained = 12;

/// The arguments of a command in the order that GL has, images and arrays taken apart: of these each has a
/// row in the text. `args` are `count` words, as the command takes them. Returns how many there are now.
unsigned unpack(const CommandText& text, const Arg* args, unsigned count, Arg (&out)[most_explained]);

/// explain(), of arguments that are unpacked.
[[gnu::cold]] void explain_unpacked(Context& context, const CommandText& text, const Arg* args,
                                    unsigned count);

} // namespace spangle::gl

#endif
