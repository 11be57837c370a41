"""The parts of messages about each command: names of arguments, their rules, the section of the specification."""
import json

from command_table import API, STATE_QUERIES
from emit_code import NOTICE

MOST_NAMED = 12 # tokens; a message does not list more than these


def token_kind(family, arg):
    """Says in words for a message what a token has to be."""
    if family.name in STATE_QUERIES:
        return "a state that the command returns"
    if arg.name == "cap":
        return "a capability"
    if arg.group:
        words = arg.group.replace("_", " ")
        return ("an " if words[0] in "aeio" else "a ") + words
    named = [f"GL_{token}" for token in arg.accepted]
    if len(named) > MOST_NAMED:
        return "a value that the command takes"
    return named[0] if len(named) == 1 else ", ".join(named[:-1]) + " or " + named[-1]


def arg_rows(family, pool, out):
    """The rows of ArgText of a family. The arrays of tokens that they refer to are appended to `out`."""
    rows = []
    for arg in family.args:
        if arg.type == "enum" and arg.accepted:
            tokens = ", ".join("GL_" + t for t in arg.accepted)
            if tokens not in pool:
                pool[tokens] = f"tokens_{len(pool)}"
                out.append(f"const std::uint16_t {pool[tokens]}[] = {{{tokens}}};\n")
            rows.append(f"{{\"{arg.name}\", ArgRule::token, \"{token_kind(family, arg)}\", {pool[tokens]}, {len(arg.accepted)}}}")
        elif arg.type in ("sizei", "sizeiptr"):
            rows.append(f"{{\"{arg.name}\", ArgRule::{'count' if arg.type == 'sizei' else 'bytes'}}}")
        elif arg.type in ("int", "intptr") and arg.low is not None:
            rows.append(f"{{\"{arg.name}\", ArgRule::range, nullptr, nullptr, 0, {arg.low}, {arg.high or 'INT32_MAX'}}}")
        elif arg.pointer or arg.array:
            rows.append(f"{{\"{arg.name}\", ArgRule::{'array' if arg.array else 'address'}}}")
        else:
            rows.append(f"{{\"{arg.name}\"}}")
    if family.kind in ("params", "get_params"):
        rows.append(f"{{\"pname\", ArgRule::pname, nullptr, nullptr, {len(family.pnames)}}}")
    return rows


def longest_sentence(family, section):
    """The number of characters of the longest message about a token of this command (gl/api/explain.cpp)."""
    return max((len(f"gl{family.name}: {arg.name} 0xFFFFFFFF is not {token_kind(family, arg)} ({section})")
                for arg in family.args if arg.type == "enum" and arg.accepted), default=0)


def texts(chapters):
    sections = {row["id"]: row.get("section", "GL 1.3") for row in json.loads((API / "commands" / "rows.json").read_text())}
    out = ["// What messages say of each command.\n", NOTICE, "#include \"gl/api/generated/commands.hpp\"\n#include \"gl/context/sentence.hpp\"\n\n#if SPANGLE_MESSAGES\n\n"
           "namespace spangle::gl::texts {\n\nnamespace {\n\n"]
    pool, commands, longest = {}, [], 0
    for _, families in chapters:
        for f in families:
            rows = arg_rows(f, pool, out)
            longest = max(longest, longest_sentence(f, sections[f.row]))
            if rows:
                out.append(f"const ArgText args_of_{f.name}[] = {{{', '.join(rows)}}};\n")
            if f.pnames:
                pnames = ", ".join(f"{{GL_{n}, \"GL_{n}\"}}" for n in f.pnames)
                out.append(f"const PnameText pnames_of_{f.name}[] = {{{pnames}}};\n")
            args = f"args_of_{f.name}, {len(rows)}" if rows else "nullptr, 0"
            commands.append(f"const CommandText {f.name}{{\"gl{f.name}\", \"{sections[f.row]}\", {args}, "
                            f"{str(bool(f.image)).lower()}, {f'pnames_of_{f.name}' if f.pnames else 'nullptr'}}};\n")
    out.append(f"\nstatic_assert(Sentence::most >= {longest}, \"the longest sentence about an argument is cut\");\n")
    out.append("\n} // namespace\n\n" + "".join(commands) + "\n} // namespace spangle::gl::texts\n\n#endif\n")
    return "".join(out)
