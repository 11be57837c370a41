// What messages say of a command: its name, its arguments and where its rules stand. Builds without messages
// hold none of it.
#pragma once

#include <cstdint>

#include <spangle/GL/gl.h>
#include <spangle/message.hpp>

namespace spangle::gl {

struct Context;

/// An argument on its way through what all commands share: a word, or where it lies when it is more.
using Arg = std::uintptr_t;

#if SPANGLE_MESSAGES

/// Which values of an argument are legal by the argument's own rule.
enum class ArgRule : std::uint8_t {
    any,
    token,   ///< one of those that are listed
    count,   ///< not negative
    range,   ///< from low to high
    address, ///< not null
    array,   ///< not null, in the Values that the command takes
    pname,   ///< a parameter of the command; its values come last
};

struct ArgText {
    const char* name;
    ArgRule rule = ArgRule::any;
    const char* kind = nullptr; ///< what a token has to be: "a blend factor"
    const std::uint16_t* tokens = nullptr;
    std::uint16_t count = 0; ///< of these tokens, or of the parameters
    std::int32_t low = 0, high = 0;
};

/// A parameter of a command with pnames.
struct PnameText {
    std::uint16_t token;
    const char* name;
};

struct CommandText {
    const char* name;    ///< "glBlendFunc"
    const char* section; ///< of the specification: "GL 1.3, 4.1.7"
    const ArgText* args = nullptr;
    std::uint8_t count = 0;
    bool image = false; ///< the arguments come as one ImageCommand
    const PnameText* pnames = nullptr;
};

/// An error has a sentence to come: which command raised it is known where the command was called.
struct Unexplained {
    GLenum code = GL_NO_ERROR;
    const char* rule = nullptr; ///< or null: an argument breaks its own rule
    bool drawing = false;       ///< raised while a primitive was drawn, by whatever brought its vertices
};

/// A command whose record is being written: an error of its arguments is recorded with them.
struct Compiled {
    const CommandText* text = nullptr;
    const Arg* args = nullptr;
};

/// Says which command raised the error that waits for its sentence, and which rule was broken: that of the
/// first argument which breaks its own, or the one that the command named. `args` are `count` words, as the
/// command takes them.
[[gnu::cold]] void explain(Context& context, const CommandText& text, const Arg* args, unsigned count);

#else

struct CommandText;

#endif

} // namespace spangle::gl
