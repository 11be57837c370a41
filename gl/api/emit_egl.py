"""Makes the public header of EGL from its table (egl.json), which has sections of tokens and commands with their comments."""
import json
import textwrap

from command_table import API

WIDTH = 110
TOP = """/* EGL 1.4 as Spangle has it: it connects rendering contexts with displays. Types are those of Khronos'
 * headers with EGL_NO_X11. For C89 and up, and C++.
 * Written by gl/api/generate.py from gl/api/egl.json: change that, not this.
 *
 * A comment holds for all that stands below it, up to the next comment or empty line. A function that fails
 * returns EGL_FALSE, null or 0, does nothing else, and leaves an error for eglGetError. Where a comment names
 * no other errors: EGL_BAD_DISPLAY, EGL_NOT_INITIALIZED (eglInitialize did not succeed), EGL_BAD_CONFIG,
 * EGL_BAD_SURFACE, EGL_BAD_CONTEXT, for handles that are none, and EGL_BAD_PARAMETER for null pointers
 * (EGL 1.4, 3.1). Attribute lists end with EGL_NONE, may be null, and are read before the call returns. */
#ifndef SPANGLE_EGL_EGL_H
#define SPANGLE_EGL_EGL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How functions are declared and called; a build may define them. */
#ifndef EGLAPI
#define EGLAPI extern
#endif
#ifndef EGLAPIENTRY
#define EGLAPIENTRY
#endif
"""


def comment(paragraphs):
    """A comment whose lines, but for the first, begin with an asterisk."""
    lines = []
    for n, text in enumerate(paragraphs):
        last = n + 1 == len(paragraphs)
        lines += [""] if n else []
        lines += textwrap.wrap(text + (" */" if last else ""), WIDTH - 3, break_long_words=False, break_on_hyphens=False)
    return "/* " + "\n".join(" */" if line == "*/" else (" * " + line if n else line).rstrip() for n, line in enumerate(lines)) + "\n"


def declaration(command):
    """A declaration, wrapped at its parameters."""
    returns = command["returns"]
    out = line = f"EGLAPI {returns} EGLAPIENTRY {command['name']}("
    column = len(line)
    parameters = command["parameters"] or ["void"]
    for n, parameter in enumerate(parameters):
        text = parameter + (");" if n + 1 == len(parameters) else ",")
        if n and len(line) + 1 + len(text) > WIDTH:
            out += "\n" + " " * column + text
            line = " " * column + text
        else:
            out += (" " if n else "") + text
            line += (" " if n else "") + text
    return out + "\n"


def egl_header():
    """The text of spangle/EGL/egl.h. If a token or a command is in the table several times, the header declares it once."""
    data = json.loads((API / "egl.json").read_text())
    seen = set()
    out = [TOP]
    for section in data["sections"]:
        if not section.get("follows"):
            out.append("\n")
        if "comment" in section:
            out.append(comment(section["comment"]))
        names = [*section.get("types", {}), *section.get("tokens", {}), *(row["name"] for row in section.get("commands", []))]
        twice = [name for name in names if name in seen or names.count(name) > 1]
        if twice:
            raise SystemExit(f"egl.json: {twice[0]} stands twice")
        seen.update(names)
        out += [f"typedef {text}\n" for text in section.get("types", {}).values()]
        out += [f"#define {name} {value}\n" for name, value in section.get("tokens", {}).items()]
        for command in section.get("commands", []):
            if "comment" in command:
                out.append(comment(command["comment"]))
            out.append(declaration(command))
    out.append("\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n")
    return "".join(out)
