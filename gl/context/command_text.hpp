// The texts that messages need about a command: its name, its arguments and the section with its rules.
// Builds without messages have none of them.
#pragma once

#include <cstdint>

#include <spangle/GL/gl.h>
#include <spangle/message.hpp>

namespace spangle::gl {

struct Context;

/// An argument in the form that all commands share: one word, or the address of a larger argument.
using Arg = std::uintptr_t;

#if SPANGLE_MESSAGES

/// The values of an argument that are legal by the argument's own rule.
enum class ArgRule : std::uint8_t {
    any,
    token,   ///< the value must be one of the listed tokens
    count,   ///< the value has 32 bits and must not be negative
    bytes,   ///< the value has as many bits as an address, and must not be negative
    range,   ///< the value must be from `low` to `high`
    address, ///< the address must not be null
    array,   ///< the address in a Values argument must not be null
    pname,   ///< the value must be a parameter name; the last argument has its values
};

struct ArgText {
    const char* name;
    ArgRule rule = ArgRule::any;
    const char* kind = nullptr; ///< what a token has to be, such as "a blend factor"
    const std::uint16_t* tokens = nullptr;
    std::uint16_t count = 0; ///< number of `tokens`, or of the command's parameter names
    std::int32_t low = 0, high = 0;
};

/// A parameter of a command with pnames.
struct PnameText {
    std::uint16_t token;
    const char* name;
};

struct CommandText {
    const char* name;    ///< name, such as "glBlendFunc"
    const char* section; ///< section of the specification, such as "GL 1.3, 4.1.7"
    const ArgText* args = nullptr;
    std::uint8_t count = 0;
    bool image = false; ///< true if the arguments come as one ImageCommand
    const PnameText* pnames = nullptr;
};

/// An error whose message has not been sent yet. Only the caller of the command knows its name, and sends the
/// message.
struct PendingError {
    GLenum code = GL_NO_ERROR;
    const char* rule = nullptr; ///< the broken rule; null: an argument breaks its own rule
    /// True if the error was raised while drawing a primitive, so that any vertex command may have raised it.
    bool drawing = false;
};

/// The command that is being compiled into a display list. An error of the command is recorded with its
/// arguments.
struct Compiled {
    const CommandText* text = nullptr;
    const Arg* args = nullptr;
};

/// Sends the message of an unexplained error: the command's name and the broken rule. The rule is that of the
/// first bad argument, or else the one that the command gave. `args` are `count` words in the form that the
/// command takes.
[[gnu::cold]] void explain(Context& context, const CommandText& text, const Arg* args, unsigned count);

#else

struct CommandText;

#endif

} // namespace spangle::gl
