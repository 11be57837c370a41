// Composes messages about errors from the command, the argument and the rule.
#include "gl/context/command_text.hpp"

#if SPANGLE_MESSAGES

#include "gl/api/explain.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/sentence.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

namespace {

/// True if a value of the argument is a size, which must not be negative.
bool is_size(ArgRule rule) {
    return rule == ArgRule::count || rule == ArgRule::bytes;
}

bool accepts_token(const ArgText& arg, GLenum token) {
    for (unsigned i = 0; i < arg.count; ++i)
        if (arg.tokens[i] == token)
            return true;
    return false;
}

const PnameText* find_pname(const CommandText& text, const ArgText& arg, GLenum token) {
    for (unsigned i = 0; i < arg.count; ++i)
        if (text.pnames[i].token == token)
            return &text.pnames[i];
    return nullptr;
}

/// Describes an argument that is wrong for all values of the other arguments and of the state. Returns false
/// if the argument is not wrong in this way.
bool name_wrong(Sentence& out, GLenum code, const CommandText& text, const ArgText& arg, Arg value) {
    const auto token = static_cast<GLenum>(value);
    const auto number = static_cast<std::int32_t>(value);
    const auto size = static_cast<std::intptr_t>(value);
    if (code == GL_INVALID_ENUM && arg.rule == ArgRule::token && !accepts_token(arg, token)) {
        (out << arg.name << " ").hexadecimal(token) << " is not " << arg.kind;
        return true;
    }
    if (code == GL_INVALID_ENUM && arg.rule == ArgRule::pname && find_pname(text, arg, token) == nullptr) {
        (out << "pname ").hexadecimal(token) << " is not a parameter of this command";
        return true;
    }
    if (code == GL_INVALID_VALUE &&
        ((arg.rule == ArgRule::count && number < 0) || (arg.rule == ArgRule::bytes && size < 0))) {
        (out << arg.name << " ").decimal(arg.rule == ArgRule::count ? number : size) << " is negative";
        return true;
    }
    if (code == GL_INVALID_VALUE && arg.rule == ArgRule::range && (number < arg.low || number > arg.high)) {
        (out << arg.name << " ").decimal(number) << " is not ";
        if (arg.high == INT32_MAX)
            (out << "at least ").decimal(arg.low);
        else
            ((out << "between ").decimal(arg.low) << " and ").decimal(arg.high);
        return true;
    }
    return false;
}

/// Describes an argument that is probably wrong, for commands that give no other rule. The description may be
/// false, because some commands accept null, and because the table does not have the values of pnames.
bool name_suspect(Sentence& out, GLenum code, const CommandText& text, const ArgText& arg, Arg value) {
    if (code == GL_INVALID_VALUE && (arg.rule == ArgRule::address || arg.rule == ArgRule::array) &&
        value == 0) {
        out << arg.name << " is a null pointer";
        return true;
    }
    if (arg.rule == ArgRule::pname && (code == GL_INVALID_VALUE || code == GL_INVALID_ENUM)) {
        if (const PnameText* const pname = find_pname(text, arg, static_cast<GLenum>(value));
            pname != nullptr) {
            out << (code == GL_INVALID_VALUE ? "the value is out of the range of "
                                             : "the value is none that ")
                << pname->name << (code == GL_INVALID_VALUE ? "" : " takes");
            return true;
        }
    }
    return false;
}

/// Describes the first argument that `says` finds wrong. Returns false if no argument is wrong.
bool name_argument(Sentence& out, GLenum code, const CommandText& text, const Arg* args, unsigned count,
                   decltype(name_wrong)& says) {
    for (unsigned i = 0; i < text.count && i < count; ++i)
        if (says(out, code, text, text.args[i], args[i]))
            return true;
    return false;
}

/// Returns the rest of `text` from the first blank on if `text` begins with `word` and a blank. Otherwise
/// returns null.
const char* behind(const char* text, const char* word) {
    while (*word != 0)
        if (*text++ != *word++)
            return nullptr;
    return *text == ' ' ? text : nullptr;
}

/// Whether a name ends in "format". Formats are tokens, although internal formats may be numbers of
/// components.
bool is_format(const char* name) {
    const char* end = name;
    while (*end != 0)
        ++end;
    constexpr char word[] = "format";
    const char *at = word + sizeof word - 1, *from = end;
    while (at > word && from > name && from[-1] == at[-1])
        --at, --from;
    return at == word;
}

/// Appends a rule. If it begins with an argument's name, the argument's value is inserted after that.
void tell_rule(Sentence& out, const char* rule, const CommandText& text, const Arg* args, unsigned count) {
    for (unsigned i = 0; i < count && i < text.count; ++i) {
        const ArgText& arg = text.args[i];
        const bool token = arg.rule == ArgRule::token || is_format(arg.name);
        const char* const rest = behind(rule, arg.name);
        if (rest == nullptr || (!token && !is_size(arg.rule) && arg.rule != ArgRule::range))
            continue;
        out << arg.name << " ";
        if (token)
            out.hexadecimal(static_cast<std::uint32_t>(args[i]));
        else
            out.decimal(static_cast<std::int32_t>(args[i]));
        rule = rest;
        break;
    }
    out << rule;
}

/// Returns the rule for an error where no argument is wrong by itself.
const char* rule_of(GLenum code) {
    switch (code) {
    case GL_INVALID_ENUM:
        return "a token is none that the command takes";
    case GL_INVALID_VALUE:
        return "a number is out of its range";
    case GL_STACK_OVERFLOW:
        return "the stack is full";
    case GL_STACK_UNDERFLOW:
        return "the stack has nothing to pop";
    case GL_OUT_OF_MEMORY:
        return "no room in the arena";
    default:
        return "the state does not allow it";
    }
}

/// Unpacks an ImageCommand into arguments in the order of the GL command.
void unpack_image(const CommandText& text, const ImageCommand& image, Arg (&out)[most_explained]) {
    unsigned beside = 0, sizes = 0, tokens = 0;
    for (unsigned i = 0; i < text.count; ++i)
        if (is_size(text.args[i].rule))
            out[i] = static_cast<Arg>(image.size[sizes++]);
        else if (i + 3 < text.count)
            out[i] = static_cast<Arg>(image.arguments[beside++]);
        else if (i + 1 < text.count)
            out[i] = tokens++ == 0 ? image.format : image.type;
        else
            out[i] = reinterpret_cast<Arg>(image.pixels);
}

} // namespace

void explain_unpacked(Context& context, const CommandText& text, const Arg* args, unsigned count) {
    const PendingError error = context.pending_error;
    context.pending_error = {};
    Sentence out;
    // If a primitive is still open, an earlier vertex command raised the error.
    const CommandText& of = error.drawing && context.inside_begin_end() ? texts::Vertex : text;
    out << of.name << ": ";
    if (error.drawing || !name_argument(out, error.code, text, args, count, name_wrong)) {
        if (error.rule != nullptr)
            tell_rule(out, error.rule, text, args, error.drawing ? 0 : count);
        else if (!name_argument(out, error.code, text, args, count, name_suspect))
            out << rule_of(error.code);
    }
    message(error.code, (out << " (" << of.section << ")").text());
}

void explain(Context& context, const CommandText& text, const Arg* args, unsigned count) {
    Arg unpacked[most_explained];
    count = unpack(text, args, count, unpacked);
    explain_unpacked(context, text, unpacked, count);
}

unsigned unpack(const CommandText& text, const Arg* args, unsigned count, Arg (&out)[most_explained]) {
    if (text.image && count != 0) {
        unpack_image(text, *reinterpret_cast<const ImageCommand*>(args[0]), out);
        return text.count;
    }
    const unsigned known = count < text.count ? count : text.count;
    for (unsigned i = 0; i < known; ++i)
        out[i] = text.args[i].rule != ArgRule::array
                     ? args[i]
                     : reinterpret_cast<Arg>(reinterpret_cast<const Values*>(args[i])->at);
    return known;
}

} // namespace spangle::gl

#endif
